"""Chain of n uniform rods pinned end to end: our equations of motion against sympy's, in one run.

    python benchmarks/chains.py

Ours: the statement in the ordinary grammar is loaded, assembled, and M q̈ = f written. Sympy's:
KanesMethod and LagrangesMethod with the same angles (absolute, from the vertical; or relative, of
each rod to the one before), up to mass matrix and forcing. Each measurement is a process of its
own (no warm caches), imports not counted; medians. Operations are `sympy.count_ops` of all entries
of M and f; those of ours are counted of what we print.
"""

from __future__ import annotations

import subprocess
import sys
from statistics import median
from time import perf_counter

RUNS = {"rbpsym": 5, "kane": 3, "lagrange": 1}
CASES = (  # angles, n, methods, how many times faster than KanesMethod
    ("absolute", 4, ("rbpsym", "kane", "lagrange"), 5.0),
    ("absolute", 8, ("rbpsym", "kane", "lagrange"), 5.0),
    ("absolute", 12, ("rbpsym", "kane"), 10.0),
    ("absolute", 24, ("rbpsym",), 0.0),
    ("relative", 4, ("rbpsym", "kane"), 5.0),
    ("relative", 8, ("rbpsym", "kane"), 20.0),
)
GROWTH = 9.0  # of the time from 8 to 24 rods: the square of their ratio


def statement(n: int, angles: str = "absolute") -> str:
    """The chain as a problem file."""
    lines = ["[parameters]", 'm = "mass: of each rod"', 'l = "length: of each rod"', 'g = "acceleration: gravity"']
    for k in range(1, n + 1):
        lines += [f"[coordinates.q{k}]", 'meaning = "angle from the downward vertical"']
    for k in range(1, n + 1):
        lines += [
            f"[bodies.r{k}]",
            'shape = "rod"',
            'mass = "m"',
            'length = "l"',
            f'angle = "{_angle(k, angles)} - pi/2"',
        ]
    lines += ["[interactions.W]", 'type = "gravity"']
    lines += ["[constraints.P1]", 'type = "pivot"', 'point = "r1.start"', 'at = "O"']
    for k in range(2, n + 1):
        lines += [f"[constraints.P{k}]", 'type = "pin"', f'points = ["r{k - 1}.end", "r{k}.start"]']
    return "\n".join(lines) + "\n"


def _angle(k: int, angles: str) -> str:
    return f"q{k}" if angles == "absolute" else " + ".join(f"q{j}" for j in range(1, k + 1))


def rbpsym(n: int, angles: str) -> tuple[float, int]:
    """(seconds, operations) of ours."""
    from rbpsym.mechanics.assemble import assemble
    from rbpsym.mechanics.dynamics import equations_of_motion
    from rbpsym.statement.loader import load_text

    text, start = statement(n, angles), perf_counter()
    mass, forcing, _ = equations_of_motion(assemble(load_text(text)))
    seconds = perf_counter() - start
    return seconds, _operations([entry for row in mass for entry in row] + list(forcing))


def _operations(values) -> int:
    from sympy import count_ops, sympify

    from rbpsym.present.forms import present
    from rbpsym.typeset.machine import to_machine

    return int(sum(count_ops(sympify(to_machine(present(value)))) for value in values))


def _rods(n: int, angles: str):
    """Angles, speeds, and the rods' centres and velocities in sympy's frames."""
    from sympy import symbols
    from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

    q, u = dynamicsymbols(f"q1:{n + 1}"), dynamicsymbols(f"u1:{n + 1}")
    m, length, g = symbols("m l g", positive=True)
    space, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(space, 0)
    frames = [space]
    for k, angle in enumerate(q):
        before = space if angles == "absolute" else frames[-1]
        frames.append(before.orientnew(f"A{k}", "Axis", (angle, space.z)))
        frames[-1].set_ang_vel(before, u[k] * space.z)
    frames = frames[1:]
    return q, u, (m, length, g), space, origin, frames


def kane(n: int, angles: str) -> tuple[float, int]:
    """(seconds, operations) of KanesMethod."""
    import sympy as s
    from sympy.physics.mechanics import KanesMethod, Point, RigidBody, dynamicsymbols, inertia

    start = perf_counter()
    q, u, (m, length, g), space, joint, frames = _rods(n, angles)
    bodies, loads = [], []
    for k, frame in enumerate(frames):
        center, end = joint.locatenew(f"C{k}", -length / 2 * frame.y), joint.locatenew(f"J{k}", -length * frame.y)
        center.v2pt_theory(joint, space, frame)
        end.v2pt_theory(joint, space, frame)
        spin = inertia(frame, 0, 0, m * length**2 / 12)
        bodies.append(RigidBody(f"B{k}", center, frame, m, (spin, center)))
        loads.append((center, -m * g * space.y))
        joint = end
    rates = [speed - angle.diff(dynamicsymbols._t) for speed, angle in zip(u, q, strict=True)]
    method = KanesMethod(space, q_ind=q, u_ind=u, kd_eqs=rates)
    method.kanes_equations(bodies, loads)
    mass, forcing = method.mass_matrix, method.forcing
    seconds = perf_counter() - start
    assert isinstance(joint, Point)
    return seconds, int(s.count_ops(mass) + s.count_ops(forcing))


def lagrange(n: int, angles: str) -> tuple[float, int]:
    """(seconds, operations) of LagrangesMethod."""
    import sympy as s
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    start = perf_counter()
    q, _, (m, length, g), *_ = _rods(n, angles)
    time, x, y, energy = dynamicsymbols._t, 0, 0, 0
    for angle in q:
        cx, cy = x + length / 2 * s.sin(angle), y - length / 2 * s.cos(angle)
        square = cx.diff(time) ** 2 + cy.diff(time) ** 2
        energy += m * square / 2 + m * length**2 / 24 * angle.diff(time) ** 2 - m * g * cy
        x, y = x + length * s.sin(angle), y - length * s.cos(angle)
    method = LagrangesMethod(energy, q)
    method.form_lagranges_equations()
    mass, forcing = method.mass_matrix, method.forcing
    seconds = perf_counter() - start
    return seconds, int(s.count_ops(mass) + s.count_ops(forcing))


METHODS = {"rbpsym": rbpsym, "kane": kane, "lagrange": lagrange}


def measured(method: str, n: int, angles: str) -> tuple[float, int]:
    """The median of several processes."""
    found = []
    for _ in range(RUNS[method]):
        out = subprocess.run(
            [sys.executable, __file__, "--one", method, str(n), angles], check=True, capture_output=True, text=True
        )
        seconds, operations = out.stdout.split()
        found.append((float(seconds), int(operations)))
    return median(seconds for seconds, _ in found), found[0][1]


def main() -> int:
    """Prints the table; 1 if a target is missed."""
    print(f"{'angles':>9} {'n':>3} {'method':>9} {'seconds':>8} {'operations':>11} {'times ours':>11} {'of ours':>8}")
    missed, times = [], {}
    for angles, n, methods, ahead in CASES:
        table = {method: measured(method, n, angles) for method in methods}
        seconds, operations = table["rbpsym"]
        times[angles, n] = seconds
        for method, (theirs, longer) in table.items():
            ratios = f"{theirs / seconds:>11.1f} {longer / operations:>8.1f}"
            print(f"{angles:>9} {n:>3} {method:>9} {theirs:>8.3f} {longer:>11} {ratios}", flush=True)
        if "kane" in table and (table["kane"][0] < ahead * seconds or table["kane"][1] <= operations):
            missed.append(f"{angles} {n}: not {ahead:g} times faster than KanesMethod with fewer operations")
    growth = times["absolute", 24] / times["absolute", 8]
    print(f"time from 8 to 24 rods: {growth:.1f} times (bound {GROWTH:g})")
    missed += [f"growth {growth:.1f}"] if growth > GROWTH else []
    print("missed: " + "; ".join(missed) if missed else "fine")
    return 1 if missed else 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        print(*METHODS[sys.argv[2]](int(sys.argv[3]), sys.argv[4]))
    else:
        sys.exit(main())

"""Systems at random, stated in TOML: chains, loops, contacts, rolling, strings, springs, dampers, friction, phases.

`statement(choose)` makes one; `choose` picks an entry of a sequence (of hypothesis, or of a seeded generator).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

Choose = Callable[[Sequence[Any]], Any]

PARAMETERS = """
[parameters]
m = "mass"
M = "mass"
n = "mass"
ell = "length"
L = "length"
R = "length"
a = "length"
g = "acceleration"
k = "stiffness"
kappa = "torsion stiffness"
c = "damping"
b = "rotary damping"
P = "force"
C = "torque"
mu = "number"
beta = "angle, acute"
v_0 = "speed"
omega_0 = "angular speed"
e = "number"
"""
GRAVITY = '[interactions.W]\ntype = "gravity"\n'
ROUND = ("disk", "ring", "ball", "shell")


def table(name: str, **entries: str) -> str:
    """A table of TOML; lists are given as they are written."""
    rows = (
        f"{key} = {value}" if value.startswith(("[", "{")) else f'{key} = "{value}"' for key, value in entries.items()
    )
    return f"[{name}]\n" + "\n".join(rows) + "\n"


def statement(choose: Choose) -> str:
    """A whole problem; the parameters that do not occur are left out."""
    return system(choose)[1]


def system(choose: Choose) -> tuple[str, str]:
    """The name of its family, and the problem."""
    name = choose(tuple(FAMILIES))
    return name, used(FAMILIES[name](choose))


def used(text: str) -> str:
    """With the fixed points and those of the parameters that occur."""
    spots = {"Q": '["L", "-L"]', "H": '["L", "2*L"]'}
    named = {name: place for name, place in spots.items() if f'"{name}"' in text}
    text = (table("points", **named) if named else "") + text
    names = set(re.findall(r"[A-Za-z_]\w*", text)) | {"g"}
    rows = [row for row in PARAMETERS.splitlines() if " = " not in row or row.split(" = ")[0] in names]
    return "\n".join(rows) + "\n" + text


# --- parts


def body(choose: Choose, name: str, mass: str, length: str, **pose: str) -> tuple[str, str]:
    """A long body with its mass, and its far end."""
    kind = choose(("rod", "rod", "rectangle"))
    if kind == "rectangle":
        return table(f"bodies.{name}", shape="rectangle", mass=mass, width=length, height="a", **pose), "right"
    return table(f"bodies.{name}", shape="rod", mass=mass, length=length, **pose), "end"


def near_end(text: str) -> str:
    return "left" if "rectangle" in text else "start"


def angle(choose: Choose, name: str, start: bool = True) -> str:
    """An angle with its start and speed, if it has them."""
    given = choose(("rest", "speed", "none")) if start else "none"
    rows = {"rest": {"start": f"{name}_0"}, "speed": {"start": f"{name}_0", "speed": "omega_0"}, "none": {}}[given]
    return table(f"coordinates.{name}", meaning="angle", **rows)


def extras(choose: Choose, long: Sequence[tuple[str, str]], most: int = 2) -> str:
    """Springs, dampers, forces and couples on bodies that have these (name, end)."""
    count = choose(range(most + 1))
    return "".join(ACTIONS[choose(tuple(ACTIONS))](choose, place, *choose(long)) for place in range(count))


def _spring(choose: Choose, place: int, name: str, end: str) -> str:
    ends = f'["{choose(("O", "Q", "H"))}", "{name}.{end}"]'
    slack = choose(({}, {"natural_length": "L"}))
    return table(f"interactions.S{place}", type="spring", between=ends, stiffness="k", **slack)


def _damper(choose: Choose, place: int, name: str, end: str) -> str:
    return table(f"interactions.D{place}", type="damper", between=f'["Q", "{name}.{end}"]', coefficient="c")


def _torsion(choose: Choose, place: int, name: str, end: str) -> str:
    return table(f"interactions.K{place}", type="torsion-spring", between=f'["ground", "{name}"]', stiffness="kappa")


def _rotary(choose: Choose, place: int, name: str, end: str) -> str:
    return table(f"interactions.B{place}", type="rotary-damper", between=f'["ground", "{name}"]', coefficient="b")


def _force(choose: Choose, place: int, name: str, end: str) -> str:
    push, frame = choose(('["P", "0"]', '["0", "-P"]')), choose(("space", "body"))
    return table(f"interactions.P{place}", type="force", on=f"{name}.{end}", force=push, frame=frame)


def _couple(choose: Choose, place: int, name: str, end: str) -> str:
    return table(f"interactions.C{place}", type="couple", on=name, couple=choose(("C", "-C")))


ACTIONS = {
    "spring": _spring, "damper": _damper, "torsion": _torsion, "rotary": _rotary, "force": _force, "couple": _couple,
}  # fmt: skip


# --- families


def chain(choose: Choose) -> str:
    """One to three bodies hung from each other, from a fixed point or from a cart."""
    count, relative, cart = choose((1, 1, 2, 2, 3)), choose((False, True)), choose((False, False, True))
    names = [f"q{k}" for k in range(1, count + 1)]
    text, long, last = "".join(angle(choose, name) for name in names), [], "O"
    if cart:
        text += table(
            "coordinates.x", dimension="length", **choose(({}, {"start": "0"}, {"start": "0", "speed": "v_0"}))
        )
        text += table("bodies.cart", shape="particle", mass="n", center='["x", "0"]')
        text += table("constraints.N", type=choose(("contact", "guide")), point="cart.center", line="y = 0")
        last = "cart.center"
    for place, name in enumerate(names):
        way = " + ".join(names[: place + 1]) if relative else name
        part, end = body(choose, f"r{place}", "mM"[place % 2], ("ell", "L", "2*ell")[place], angle=f"{way} - pi/2")
        text += part
        kind = "pivot" if last == "O" else "pin"
        ends = (
            {"point": f"r{place}.{near_end(part)}", "at": "O"}
            if last == "O"
            else {"points": f'["{last}", "r{place}.{near_end(part)}"]'}
        )
        text += table(f"constraints.J{place}", type=kind, **ends)
        last = f"r{place}.{end}"
        long.append((f"r{place}", end))
    if choose((False, True)):
        text += _bob(choose, last)
    return text + choose((GRAVITY, GRAVITY, "")) + extras(choose, long)


def _bob(choose: Choose, at: str) -> str:
    """Something at the end: a particle or a wheel, pinned or welded."""
    kind = choose(("particle", "pinned", "welded"))
    if kind == "particle":
        return table("bodies.bob", shape="particle", mass="n") + table(
            "constraints.E", type="pin", points=f'["{at}", "bob.center"]'
        )
    wheel = table(
        "bodies.bob", shape=choose(ROUND), mass="n", radius="R", **({"angle": "psi"} if kind == "pinned" else {})
    )
    joint = table("constraints.E", type="pin" if kind == "pinned" else "weld", points=f'["{at}", "bob.center"]')
    return (angle(choose, "psi") if kind == "pinned" else "") + wheel + joint


def ladder(choose: Choose) -> str:
    """A rod in a corner, in one coordinate or in three, with a spring, a rider or a phase after the wall."""
    three = choose((False, False, True))
    start = choose(({"start": "theta_0"}, {"start": "theta_0", "speed": "-omega_0"}))
    text = table("coordinates.theta", meaning="angle", range='["0", "pi/2"]', **start)
    pose = {"center": '["ell*cos(theta)", "ell*sin(theta)"]', "angle": "pi - theta"}
    if three:
        text += table("coordinates.x", dimension="length") + table("coordinates.y", dimension="length")
        pose = {"center": '["x", "y"]', "angle": "pi - theta"}
    text += table("bodies.rod", shape="rod", mass="m", length="2*ell", **pose) + GRAVITY
    text += table("constraints.N_1", type="contact", point="rod.start", line="y = 0")
    text += table("constraints.N_2", type="contact", point="rod.end", line="x = 0")
    text += choose(("", table("interactions.S", type="spring", between='["O", "rod.start"]', stiffness="k")))
    if choose((False, True)):
        text += table("bodies.rider", shape="particle", mass="M")
        text += table("constraints.B", type="pin", points=f'["rod.{choose(("center", "end"))}", "rider.center"]')
    return text


def slope(choose: Choose) -> str:
    """Something round or a block on a slope: rolling, sliding with friction or smooth."""
    way, kind = choose(("s", "-s")), choose(("rolling", "rolling", "touch", "slider"))
    where = f'["({way})*cos(beta) + R*sin(beta)", "-({way})*sin(beta) + R*cos(beta)"]'
    fast = choose(({}, {"speed": "v_0"})) if kind == "rolling" else {"speed": "v_0"}
    text = table("coordinates.s", dimension="length", start="0", **fast) + GRAVITY
    line = "y = -x*tan(beta)"
    if kind == "slider":
        foot = f'["({way})*cos(beta)", "-({way})*sin(beta)"]'
        text += table("bodies.b", shape="rectangle", mass="m", width="a", height="L", bottom=foot, angle="-beta")
        rough = choose(({}, {"coefficient": "mu"}))
        return text + table("constraints.N", type="slider", point="b.bottom", line=line, side="positive", **rough)
    turn = choose(({"start": "0", "speed": "omega_0"}, {"start": "0"})) if kind == "touch" else {}
    text += table("coordinates.phi", meaning="angle", **turn)
    text += table("bodies.b", shape=choose(ROUND), mass="m", radius="R", center=where, angle=choose(("phi", "-phi")))
    rough = choose(({}, {"coefficient": "mu"})) if kind == "touch" else choose(({}, {"friction": "f"}))
    text += table("constraints.N", type=kind, body="b", line=line, **rough)
    if kind == "rolling" and choose((False, True)):
        text += table("interactions.S", type="spring", between='["O", "b.center"]', stiffness="k")
    if kind == "rolling" and choose((False, False, True)):
        text += table("coordinates.q", meaning="angle", **choose(({}, {"start": "q_0"})))
        text += table("bodies.rod", shape="rod", mass="M", length="ell", angle="q - pi/2")
        text += table("constraints.E", type="pin", points='["b.center", "rod.start"]')
    return text


def bowl(choose: Choose) -> str:
    """A particle or something round inside or outside a fixed circle."""
    inside, rolls = choose((True, False)), choose(("contact", "rolling", "rolling"))
    side, sign = ("inside", "-") if inside else ("outside", "")
    reach = "L" if rolls == "contact" else "(L - R)" if inside else "(L + R)"
    ranged = {"range": '["-pi", "pi"]'} if inside else {"range": '["-pi/2", "pi/2"]'}
    start = choose(({"start": "theta_0"}, {"start": "0", "speed": "omega_0"}, {"start": "theta_0", "speed": "omega_0"}))
    text = table("coordinates.theta", meaning="angle", **ranged, **start) + GRAVITY
    where = f'["{reach}*sin(theta)", "{sign}{reach}*cos(theta)"]'
    if rolls == "contact":
        text += table("bodies.b", shape="particle", mass="m", center=where)
        text += table("constraints.N", type="contact", point="b.center", circle="O", radius="L", side=side)
    else:
        text += table("coordinates.phi", meaning="angle")
        text += table(
            "bodies.b", shape=choose(ROUND), mass="m", radius="R", center=where, angle=choose(("phi", "-phi"))
        )
        text += table("constraints.N", type="rolling", body="b", circle="O", radius="L", side=side)
    return text + choose(
        ("", table("interactions.S", type="spring", between='["H", "b.center"]', stiffness="k"))
    )


def pulley(choose: Choose) -> str:
    """Two weights over a pulley, or one weight and a block on a table; a drum with a couple or a damper."""
    text = table("coordinates.y", dimension="length", start="0", **choose(({}, {"speed": "v_0"}))) + GRAVITY
    text += table("bodies.w", shape="particle", mass="m", center='["R", "-L - y"]')
    text += table("coordinates.phi", meaning="angle")
    text += table("bodies.p", shape=choose(("disk", "ring")), mass="M", radius="R", center="O", angle="-phi")
    text += table("constraints.A", type="pivot", point="p.center")
    second = choose(("weight", "block", "none"))
    if second == "none":
        return (
            text
            + table("constraints.T", type="string", path='["p", "w.center"]'.replace('"p"', '"cw p"'))
            + extras(choose, [("p", "center")], 1)
        )
    place = {"weight": '["-R", "z"]', "block": '["-x", "R"]'}[second]
    name = {"weight": "z", "block": "x"}[second]
    text += table(f"coordinates.{name}", dimension="length", start={"weight": "-ell", "block": "ell"}[second])
    text += table("bodies.u", shape="particle", mass="n", center=place)
    if second == "block":
        text += table("constraints.N", type="contact", point="u.center", line="y = R", side="positive")
    return text + table("constraints.T", type="string", path='["u.center", "cw p", "w.center"]')


def loop(choose: Choose) -> str:
    """Crank, link and piston; or two cranks and a link."""
    text = angle(choose, "q") + table("bodies.crank", shape="rod", mass="m", length="ell", angle="q")
    text += table("constraints.A", type="pivot", point="crank.start", at="O")
    text += table("coordinates.p", meaning="angle") + table(
        "bodies.link", shape="rod", mass="M", length="3*ell", angle="p"
    )
    text += table("constraints.B", type="pin", points='["crank.end", "link.start"]')
    if choose((True, False)):
        text += table("coordinates.x", dimension="length") + table(
            "bodies.piston", shape="particle", mass="n", center='["x", "0"]'
        )
        text += table("constraints.E", type="pin", points='["link.end", "piston.center"]')
        text += table("constraints.N", type="guide", point="piston.center", line="y = 0")
    else:
        text += table("constraints.N", type="guide", point="link.end", line="y = 0")
    return text + choose((GRAVITY, "")) + extras(choose, [("crank", "end")], 1)


def skid(choose: Choose) -> str:
    """A round thing that slips on a level until it rolls."""
    text = table("coordinates.x", dimension="length", start="0", speed="v_0") + GRAVITY
    spin = choose(({}, {"speed": "omega_0"}, {"speed": "-omega_0"}))
    text += table("coordinates.phi", meaning="angle", start="0", **spin)
    text += table(
        "bodies.b", shape=choose(ROUND), mass="m", radius="R", center='["x", "R"]', angle=choose(("phi", "-phi"))
    )
    text += table("constraints.N", type="touch", body="b", line="y = 0", coefficient="mu")
    text += '[[phases]]\nname = "rolling"\nevent = "no slip"\nof = "N"\nconstraints = { N = { type = "rolling" } }\n'
    return text


def strike(choose: Choose) -> str:
    """A hung rod that is struck, or that swings against a ball."""
    kind = choose(("blow", "collision"))
    if kind == "blow":
        text = table("coordinates.q", meaning="angle", start="0", speed="0")
        text += table("bodies.r", shape="rod", mass="m", length="ell", angle="q - pi/2") + GRAVITY
        text += table("constraints.A", type="pivot", point="r.start", at="O")
        at = choose(("center", "end"))
        return text + (
            '[[phases]]\nname = "after"\nevent = "at once"\n'
            f'impulses = {{ J = {{ type = "blow", on = "r.{at}", impulse = ["m*v_0", "0"] }} }}\n'
        )
    text = table("coordinates.q", meaning="angle", start="pi/2", speed="0")
    text += table("bodies.r", shape="rod", mass="m", length="ell", angle="-q - pi/2") + GRAVITY
    text += table("coordinates.x", dimension="length", start="0", speed="0")
    text += table("bodies.b", shape="particle", mass="M", center='["x", "-ell"]')
    text += table("constraints.A", type="pivot", point="r.start", at="O")
    text += table("constraints.N", type="guide", point="b.center", line="y = -ell")
    return text + (
        '[[phases]]\nname = "after"\nevent = "reaches"\nof = "q"\nat = "0"\n'
        'impulses = { J = { type = "collision", points = ["r.end", "b.center"], along = ["1", "0"], restitution = "e" } }\n'
    )


def flight(choose: Choose) -> str:
    """What leaves a sphere."""
    text = table("coordinates.theta", meaning="angle", start="0", speed="omega_0", range='["0", "pi/2"]') + GRAVITY
    text += table("coordinates.r", dimension="length")
    text += table("bodies.b", shape="particle", mass="m", center='["r*sin(theta)", "r*cos(theta)"]')
    text += table("constraints.N", type="contact", point="b.center", circle="O", radius="L", side="outside")
    return text + '[[phases]]\nname = "flight"\nevent = "lost"\nof = "N"\nwithout = ["N"]\n'


FAMILIES: Mapping[str, Callable[[Choose], str]] = {
    "chain": chain, "ladder": ladder, "slope": slope, "bowl": bowl, "pulley": pulley, "loop": loop, "skid": skid,
    "strike": strike, "flight": flight,
}  # fmt: skip

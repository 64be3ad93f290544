"""Works and changes of kinetic energy since the start, as they are written beside works that are not known yet;
the theorem of work and energy about a fixed axis.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rbpsym.chapters.inertia import moment_about, turning_together
from rbpsym.chapters.methods.balances import outer_forces
from rbpsym.decide.equal import scalars_equal
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, UNITY, Scalar, at_start, depends_on, derivative, is_zero, names_in, short, substitute
from rbpsym.field.exponentials import with_squares
from rbpsym.mechanics.motion import ForceWork, Work
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import bodies_named


def over_coordinates(draft: Draft, parts: Mapping[str, Scalar]) -> t.Node:
    """Σ ∫ f dq from the start to now."""
    return t.add(*(integral(draft, name, part) for name, part in parts.items()))


def integral(draft: Draft, name: str, part: Scalar) -> t.Node:
    """∫_{q₀}^{q} part dq, a common sign in front."""
    shown = draft.show(part, factor=True)
    start = start_of(draft, name)
    if isinstance(shown, t.Neg):
        return t.neg(t.Integral(shown.arg, name, start, t.Sym(name)))
    return t.Integral(shown, name, start, t.Sym(name))


def start_of(draft: Draft, name: str) -> t.Node:
    """The start of a coordinate as the author wrote it, else a constant with index 0."""
    if name == "t":
        return t.ZERO
    coordinate = next(c for c in draft.study.problem.coordinates if c.name == name)
    return coordinate.start if coordinate.start is not None else t.Sym(f"{name}_0")


def started(draft: Draft) -> bool:
    """Whether the start of every coordinate is said, of those that conditions tie too, and how fast they begin."""
    system = draft.study.system
    return {*system.coordinates, *(f"{q}_dot" for q in system.independent)} <= system.scope.start.keys()


def is_of_position(draft: Draft, work: Work) -> bool:
    """Whether the integrands hold neither unknown forces nor speeds nor the time."""
    system = draft.study.system
    moving = {*system.unknowns, *system.speeds, *system.accelerations, "t"}
    return not any(moving & names_in(part) for part in work.parts.values())


def carried_out(draft: Draft, items: Iterable[ForceWork]) -> Scalar | None:
    """Both works of some forces together as a function of position; None where they are none."""
    total = NOTHING
    for item in items:
        for work in (item.translational, item.rotational):
            if work.value is None or not is_of_position(draft, work):
                return None
            total = total + work.value
    return short(total)


def since_start(draft: Draft, value: Scalar) -> t.Node:
    """A work as a change: what it is now less what it was at the start, U - U₀ and not U₀ - U."""
    shown, opposite = draft.show(value, factor=True), draft.show(-value, factor=True)
    return t.neg(opposite) if _begins_with_start(draft, shown) and not _begins_with_start(draft, opposite) else shown


def _begins_with_start(draft: Draft, node: t.Node) -> bool:
    """Does the sum in it begin with a term of the start?"""
    body = node.arg if isinstance(node, t.Neg) else node
    sums = [part for part in t.walk(body) if isinstance(part, t.Add)]
    starts = {name for q in draft.study.system.coordinates for name in names_in(draft.study.system.scope.start.get(q, NOTHING))}
    return bool(sums) and bool(t.names(sums[-1].terms[0]) & starts) and not _moves(draft, sums[-1].terms[0])


def _moves(draft: Draft, node: t.Node) -> bool:
    return bool(t.names(node) & set(draft.study.system.coordinates))


def steady(draft: Draft) -> dict[str, Scalar]:
    """The squares of speeds that stay what they were at the start, by coordinate."""
    start, accelerations = draft.study.system.scope.start, draft.study.dynamics.accelerations or {}
    names = (q for q in draft.study.system.independent if is_zero(accelerations.get(f"{q}_ddot", UNITY)))
    return {q: start[f"{q}_dot"] ** 2 for q in names}


def gained(draft: Draft, kinetic: Scalar) -> Scalar:
    """How much a kinetic energy has grown since the start; what the square of a constant speed gives to it drops out."""
    now = with_squares(kinetic, steady(draft))
    return short(now - at_start(now, draft.study.system.scope))


def show_gained(draft: Draft, value: Scalar) -> t.Node:
    """½ M (v² - v₀²), from rest ½ M v²; Δ(½ M v²) where the speed at the start is a formula."""
    start = draft.study.system.scope.start
    moving = [n for q in draft.study.system.independent if depends_on(value, n := f"{q}_dot") and start.get(n)]
    if not moving:
        return draft.show_brief(value)
    speed, squared = t.Sym(moving[0]), t.Pow(t.Sym(moving[0]), t.TWO)
    now = draft.show_brief(short(value - substitute(value, {speed.name: NOTHING})))
    if len(moving) > 1 or not isinstance(now, t.Mul) or now.factors[-1] != squared:
        return draft.show(value, factor=True)
    begun = draft.show(start[speed.name])
    grown = t.mul(*now.factors[:-1], t.add(squared, t.neg(t.power(begun, 2))))
    shown = grown if isinstance(begun, t.Sym | t.Num) else t.Delta(t.Group(now))
    found = draft.context.value(shown)
    same = isinstance(found, Scalar) and scalars_equal(found, value, draft.study.assumptions).is_proved
    return shown if same else draft.show(value, factor=True)


LONGEST = 60  # nodes of an integral that is simpler than two works


def about_axes(draft: Draft) -> None:
    """A step for the first fixed axis about which the whole system turns, if its torque is known there.

    None where the centres of mass stay on the axis: then W_θ about them is the same.
    """
    names, states = draft.study.system.independent, draft.study.system.bodies.values()
    if len(names) != 1 or draft.study.system.has_clock or not any(state.velocity for state in states):
        return
    for label in draft.study.origins:
        if turning_together(draft, label) and _about(draft, label, names[0]):
            return


def _about(draft: Draft, label: str, name: str) -> bool:
    """Whether the torque about the axis depends on the place alone, so that the step was made."""
    bodies = tuple(draft.study.system.bodies)
    omega = draft.study.system.bodies[bodies[0]].omega
    origin = draft.study.origins[label]
    forces = outer_forces(draft.study.system, bodies)
    torque = short(sum((f.torque(origin) for f in forces), NOTHING))
    along = short(torque * derivative(omega, f"{name}_dot"))
    if not torque or names_in(along) & {*draft.study.system.unknowns, f"{name}_dot", "t"}:
        return False
    shown = integral(draft, name, along)
    if length(shown) > LONGEST:
        return False
    _add(draft, label, torque * omega, shown)
    return True


def _add(draft: Draft, label: str, power: Scalar, shown: t.Node) -> None:
    letter = t.Sym(draft.free(f"cal_W_theta_{label}"))
    draft.context.works[letter.name] = power
    bodies = tuple(draft.study.system.bodies)
    draft.add(
        f"axis.{label}",
        "work_energy",
        t.equation(letter, shown, _growth(draft, label)),
        "work.axis",
        premises=draft.those(*(f"moment.{b}.{label}" for b in bodies), f"moment.together.{label}", "theorem.whole"),
        point=t.Sym(label),
        bodies=bodies_named(bodies),
        count=len(bodies),
    )


def _growth(draft: Draft, label: str) -> t.Node:
    """½ I_O (ω² - ω₀²), from rest ½ I_O ω²; Δ(½ I_O ω²) where no start is said."""
    half, moment = t.Div(t.ONE, t.TWO), moment_about(draft, label)
    square = next(iter(draft.study.system.bodies.values())).omega ** 2
    if not started(draft):
        return t.Delta(t.Group(t.mul(half, moment, draft.show(square))))
    begun = at_start(square, draft.study.system.scope)
    grown = t.add(draft.show(square), t.neg(draft.show(begun))) if not is_zero(begun) else draft.show(square)
    return t.mul(half, moment, grown)

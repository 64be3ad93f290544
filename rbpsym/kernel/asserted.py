"""What the steps of a rule assert beyond the rows that they print, or in place of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import short, symbol
from rbpsym.field.roots import without_roots_below
from rbpsym.kernel.claim import AHEAD, Proposition, letter, tree_of
from rbpsym.kernel.components import started
from rbpsym.proof.mass import power
from rbpsym.proof.step import Step

if TYPE_CHECKING:
    from rbpsym.kernel.claims import ClaimSource


def _conserved(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And it stays what it is at the start."""
    ends = [end for row in t.chains(step.statement) for end in (row.items[0], row.items[-1]) if isinstance(end, t.Sym)]
    return [*claims, *(Proposition(end, started(end, source.moving)) for end in ends)]


def _lost(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And its rate is minus the power of the forces."""
    rate = tree_of(-power(source.system, source.forces(step)))
    return [*claims, Proposition(t.chains(step.statement)[0].items[0], rate, "rate")]


def _at_rest(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    speeds = (name for name in source.rates if name.endswith("_dot"))
    still = tuple(Proposition(t.Sym(name), t.ZERO) for name in dict.fromkeys([*speeds, *source.system.accelerations]))
    return [Proposition(claim.left, claim.right, given=still) for claim in claims]


def _open_rest(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Where the body is at rest, the equation holds of its place."""
    item = step.data["balance"]
    there = {item.place: t.Sym(item.name)}
    at_rest = _at_rest(source, step, claims)
    return [Proposition(t.renamed(c.left, there), t.renamed(c.right, there), given=c.given) for c in at_rest]


def _equilibrium(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """The equation of rest holds at the place."""
    place = {letter(row.items[0]): row.items[-1] for row in t.chains(step.statement)}
    rest = (id for id, other in source.steps.items() if other.rule == "rest" and id in source.said)
    found = (claim for id in rest for claim in source.said[id].assertions)
    return [Proposition(t.renamed(c.left, place), t.renamed(c.right, place)) for c in found]


def _tangent(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """With the accelerations of the equations of motion, the sides of what is linear are alike at the place in value, and in
    the derivative on each straight way through it: they differ by what is small of higher order."""
    source.moves([WAY])
    found = []
    for row in t.chains(step.statement):
        solved = {name: t.chains(source.steps[f"motion.{name[:-5]}"].statement)[0].items[-1]
                  for name in t.names(row.items[0]) & set(source.system.accelerations)}  # fmt: skip
        apart = t.Add((t.renamed(row.items[0], solved), t.Neg(row.items[-1])))
        place, moved = _resting(source, step), sorted(filter(source.moving, t.names(apart)))
        place |= {each: t.ZERO for each in moved if each not in place}
        found.append(Proposition(t.renamed(apart, place), t.ZERO))
        way = {each: t.Add((place[each], t.Mul((t.Sym(WAY), t.Sym(f"towards_{each}"))))) for each in moved}
        found.append(Proposition(t.renamed(apart, {**place, **way}), t.ZERO, "slope", var=WAY))
    return found


WAY = "way"  # the letter of how far a straight way has gone


def _resting(source: ClaimSource, step: Step) -> dict[str, t.Node]:
    """The coordinates at the place of rest; one that may have any value there has a letter of its own."""
    free = {name: t.Sym(f"any_{name}") for name in source.system.independent if name not in step.data["at"]}
    return free | {name: t.renamed(tree_of(value), free) for name, value in step.data["at"].items()}


def _mode(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """If what is linear has a solution of this kind in which a coordinate takes part, the polynomial vanishes."""
    rate, linear = step.slots["letter"], source.steps.get(f"linear.{step.id.partition('.')[2]}")
    if linear is None:
        raise RbpsymError("a mode among others that die out has no words yet")
    if step.id.startswith(("decay", "damped")):
        return _dying(source, step, claims)
    square = t.Pow(rate, t.TWO)
    speed, gain = {"secular": (t.ZERO, t.Neg(rate)), "polynomial": (rate, square)}.get(step.rule, (t.ZERO, t.Neg(square)))
    source.own[step.id] = f"def.{rate.name}"
    sizes = {name: t.Sym(f"amplitude_{name}") for name in source.system.independent}
    solves = _solves(source, step, sizes, *({n: t.Mul((times, size)) for n, size in sizes.items()} for times in (speed, gain)))
    taking = (Proposition(size, t.ZERO, "differ") for name, size in sizes.items() if f"{name}_ddot" in t.names(linear.statement))
    return [replace(claim, given=(*solves, part)) for claim in claims for part in taking]


def _dying(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """If what is linear has the solutions a e^{-γt} cos ϑt and a e^{-γt} sin ϑt (as they are at t = 0), γ and ϑ are these."""
    name, *others = source.system.independent
    if others:
        raise RbpsymError("a motion of several coordinates that dies out has no words yet")
    rest = step.id.partition(".")[2]
    rate, swing = (source.steps[f"{kind}.{rest}"].slots["letter"] for kind in ("decay", "damped"))
    size = t.Sym(f"amplitude_{name}")
    source.own[step.id] = f"def.{swing.name}"
    slower, turned = t.Neg(t.Mul((rate, size))), t.Mul((swing, size))
    fast = t.Mul((t.Add((t.Pow(rate, t.TWO), t.Neg(t.Pow(swing, t.TWO)))), size))
    cosine = _solves(source, step, {name: size}, {name: slower}, {name: fast})
    sine = _solves(source, step, {name: t.ZERO}, {name: turned}, {name: t.Mul((t.TWO, rate, t.Neg(turned)))})
    given = (*cosine, *sine, Proposition(turned, t.ZERO, "differ"))
    return [replace(claim, given=given) for claim in claims]


def _solves(source: ClaimSource, step: Step, *moved: Mapping[str, t.Node]) -> tuple[Proposition, ...]:
    """That these deviations with these speeds and accelerations solve what is linear."""
    sizes, speeds, gains = moved
    image: dict[str, t.Node] = {name: t.Add((place, sizes[name])) for name, place in _resting(source, step).items()}
    image |= {f"{name}_dot": speed for name, speed in speeds.items()} | {f"{name}_ddot": gain for name, gain in gains.items()}
    rows = t.chains(source.steps[f"linear.{step.id.split('.')[1]}"].statement)
    return tuple(Proposition(t.renamed(row.items[0], image), t.renamed(row.items[-1], image)) for row in rows)


def _modes(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And the polynomial vanishes for each of the values."""
    polynomial = source.steps[f"characteristic.{step.id.partition('.')[2]}"]
    [(left, _, right)] = t.relations(polynomial.statement)
    values = [{polynomial.slots["letter"].name: claim.right} for claim in claims]
    return [*claims, *(Proposition(t.renamed(left, value), t.renamed(right, value)) for value in values)]


def _shape(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Amplitudes in these ratios, with the frequency of the mode, solve what is linear."""
    first, *others = (source.system.independent[k] for k in step.data["order"])
    size = t.Sym(f"amplitude_{first}")
    sizes: dict[str, t.Node] = {name: t.Mul((claim.right, size)) for name, claim in zip(others, claims, strict=False)}
    sizes[first], gain = size, t.Neg(tree_of(step.data["square"]))
    gains = {name: t.Mul((gain, each)) for name, each in sizes.items()}
    return [*claims[len(others) :], *_solves(source, step, sizes, dict.fromkeys(sizes, t.ZERO), gains)]


def _critical(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And with it the square of the damped frequency vanishes."""
    [(_, _, square)] = t.relations(source.steps[f"damped.{step.id.partition('.')[2]}"].statement)
    return [*claims, *(Proposition(t.renamed(square, {step.data["name"]: claim.right}), t.ZERO) for claim in claims)]


def _there(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """What a force is where another vanishes."""
    given = source.said[step.data["place"]].assertions[0].given
    return [Proposition(t.Sym(step.data["of"]), claim.right, given=given) for claim in claims]


def _vanishes(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Where the equation holds the force vanishes."""
    return [Proposition(t.Sym(step.data["force"]), t.ZERO, given=tuple(claims))]


def _stays(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """As long as the force that is lost first is not negative."""
    until = (Proposition(t.Sym(step.data["until"]), t.ZERO, "least"),) if step.data["until"] else ()
    return [replace(claim, given=until) for claim in claims]


def _asked(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """The force is a positive multiple of what is said not to be negative."""
    [(left, op, right)] = t.relations(step.statement)
    force, shown = t.Sym(step.data["force"]), t.add(left, t.neg(right)) if op == ">=" else t.add(right, t.neg(left))
    if shown == force:
        return [Proposition(force, force)]
    said = (row.items[-1] for id in step.premises if id in source.steps for row in t.chains(source.steps[id].statement)
            if row.items[0] == force)  # fmt: skip
    whole = next(map(source.letters.value, said), None) or source.letters.along(symbol(force.name))
    ratio = tree_of(short(without_roots_below(whole / source.letters.value(shown))))
    return [Proposition(force, t.Mul((ratio, shown))), Proposition(ratio, t.ZERO, "more")]


def _then(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """At the start, or at any time after it at which the event holds."""
    if step.data["moment"].how == "start":
        return [replace(c, left=started(c.left, source.moving), right=started(c.right, source.moving)) for c in claims]
    if step.data["moment"].how != "event" or source.event is None:
        raise RbpsymError("such a moment has no words yet")
    return [replace(claim, given=(Proposition(tree_of(source.event), t.ZERO), AHEAD)) for claim in claims]


def _told(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    raise RbpsymError("what a chapter tells has no words for it yet")


MORE: Mapping[str, Callable[[ClaimSource, Step, list[Proposition]], list[Proposition]]] = {
    "conservation": _conserved, "potential": _lost, "rest": _at_rest, "open_balance": _open_rest, "equilibrium": _equilibrium,
    "linearization": _tangent, "linear_system": _tangent, "secular": _mode, "polynomial": _mode, "motion_of_mode": _mode,
    "vanishing": _vanishes, "value_there": _there, "asked": _asked, "value_then": _then, "value_told": _told,
    "normal_modes": _modes, "mode_shape": _shape, "critical": _critical, "stays": _stays,
}  # fmt: skip

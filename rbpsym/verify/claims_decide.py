"""Whether a printed relation holds: as an identity, on the motion, or along it from the start.

A difference is zero if it is so as it stands, with the accelerations and forces of the motion,
with the speeds of the motion from the start, or if it is zero at the start and does not change.
It is refuted at a state of the motion at which the sides differ. All by `equality`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.evaluate import time_derivative
from rbpsym.algebra.integration import definite
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.algebra.vector import Space
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.constants import is_algebraic
from rbpsym.equality.decide import PLAIN, compare, cross_difference, find_witness, scalars_equal
from rbpsym.equality.domain import Condition
from rbpsym.equality.points import all_atoms
from rbpsym.equality.signs import sign
from rbpsym.equality.verdict import Verdict, all_of, proved, refuted, undecided
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.motion import along_motion, with_squares
from rbpsym.notation import tree as t
from rbpsym.verify.claims_bound import Motion, without_even_roots
from rbpsym.verify.claims_ground import Ground
from rbpsym.verify.claims_integrals import as_vector

DEPTHS = ("identity", "motion", "start")
HOW = {
    "identity": "identity",
    "motion": "on the motion",
    "start": "along the motion from the start",
    "rates": "equal at the start and in rate",
    "constant": "its rate vanishes on the motion",
}


@dataclass(frozen=True)
class Question:
    """Two values, and how deep one may look for their equality."""

    ground: Ground
    depth: str = ""
    witnesses: bool = True

    @property
    def motion(self) -> Motion:
        """What is true of the motion."""
        return self.ground.motion

    @property
    def depths(self) -> tuple[str, ...]:
        """The depths that may be tried, from the strongest claim to the weakest."""
        return DEPTHS[: DEPTHS.index(self.depth) + 1] if self.depth else DEPTHS

    def seen(self, found: Scalar, depth: str) -> Scalar:
        """A value at some depth."""
        if depth == "identity":
            return found
        found = self.motion.moved(found)
        return with_squares(found, self.motion.squares) if depth == "start" else found

    def rate(self, found: Scalar) -> Scalar:
        """d/dt, works and integrals included."""
        return time_derivative(found, self.ground.scope)

    def begin(self, found: Scalar) -> Scalar:
        """The value in the start state."""
        return substitute(self.motion.moved(found), self.ground.scope.start)


def equal_values(a: Scalar | Space, b: Scalar | Space, question: Question) -> Verdict:
    """Whether two values are equal, component by component for vectors."""
    if isinstance(a, Space) or isinstance(b, Space):
        pairs = zip(as_vector(a).components(), as_vector(b).components(), strict=True)
        return all_of(equal_scalars(x, y, question) for x, y in pairs)
    return equal_scalars(a, b, question)


def equal_scalars(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Whether two scalars are equal, from the strongest depth to the weakest."""
    for depth in question.depths:
        if _are_same(question.seen(a, depth), question.seen(b, depth), question):
            return proved(HOW[depth])
    if _by_rates(a, b, question):
        return proved(HOW["rates"])
    return _refuted(a, b, question) if question.witnesses else undecided("not proved")


def _are_same(a: Scalar, b: Scalar, question: Question) -> bool:
    """Whether equality is PROVED; no witness is looked for where the normal form says no."""
    gap = cross_difference(a, b)
    if not is_zero(gap) and _is_plain(gap):
        return False
    return scalars_equal(a, b, question.motion.assumptions).is_proved


def _is_plain(value: Scalar) -> bool:
    """Is the normal form that of a field, in which only 0 is zero?"""
    return all(atoms.atom(index).kind in PLAIN and not is_algebraic(index) for index in all_atoms([value]))


def _by_rates(a: Scalar, b: Scalar, question: Question) -> bool:
    """Equal at the start, and the difference does not change."""
    gap = a - b
    if not _are_same(question.begin(a), question.begin(b), question):
        return False
    return _is_constant(gap, question, question.depths)


def _is_constant(value: Scalar, question: Question, depths: Iterable[str]) -> bool:
    rate = question.rate(value)
    return any(_are_same(question.seen(rate, depth), NOTHING, question) for depth in depths)


def constant_value(value: Scalar, question: Question) -> Verdict:
    """Whether a value is a constant of the motion."""
    for depth in question.depths:
        if _is_constant(value, question, (depth,)):
            return proved(HOW["constant"])
    rate = question.rate(value)
    found = _refuted(rate, NOTHING, question) if question.witnesses else undecided("not proved")
    if found.is_refuted:
        return refuted("its rate of change is not zero", found.witness)
    return found


def up_to_constant(value: Scalar, other: Scalar, question: Question) -> Verdict:
    """Whether two values differ by a constant, as an identity in positions and speeds."""
    if _is_constant(value - other, question, ("identity",)):
        return proved("equal up to a constant")
    found = _refuted(question.rate(value), question.rate(other), Question(question.ground, "identity"))
    return found if found.is_refuted else undecided("the difference was not shown to be a constant")


# --- refutation


def _refuted(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """A state of the motion at which the sides differ."""
    for find in (_at_start, _at_any_state, _along):
        found = find(a, b, question)
        if found.is_refuted:
            return found
    return undecided("neither a proof nor a state of the motion at which the sides differ was found")


def _witness(a: Scalar, b: Scalar, assumptions: Assumptions, domain: Iterable[Condition] = ()) -> Verdict:
    try:
        point = find_witness(a, b, assumptions, domain)
    except (RbpsymError, ZeroDivisionError):
        point = None
    return refuted("the sides differ at a point", point) if point else undecided("no point was found")


def _at_start(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """The start is a state of the motion; only tried where start values or integrals are told."""
    if not (_tells_of_start(a, question) or _tells_of_start(b, question)):
        return undecided("")
    x, y = question.begin(a), question.begin(b)
    return undecided("") if _holds_unknowns(x - y, question) else _witness(x, y, question.motion.assumptions)


def _tells_of_start(value: Scalar, question: Question) -> bool:
    names = (*question.motion.starts, *question.motion.ledger)
    return any(depends_on(value, name) for name in names)


def _holds_unknowns(value: Scalar, question: Question) -> bool:
    return any(depends_on(value, name) for name in question.motion.unsettled)


def _at_any_state(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Every position and speed is a state of some motion, if nothing is said of the start."""
    if _tells_of_start(a, question) or _tells_of_start(b, question):
        return undecided("")
    x, y = (question.seen(v, "motion") for v in (a, b))
    if _holds_unknowns(x, question) or _holds_unknowns(y, question):
        return undecided("")
    return _witness(x, y, question.motion.assumptions)


def _along(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Values along the motion, integrals carried out; else the rates of both sides."""
    x, y = (carried_out(v, question) for v in (a, b))
    if x is not None and y is not None:
        found = _differ(x, y, question)
        if found.is_refuted:
            return found
    return _differ(*(question.seen(question.rate(v), "start") for v in (a, b)), question)


def _differ(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """Where a speed remains, both signs of its root are excluded: (a - b)(a' - b') is not zero."""
    squares = question.motion.squares
    left, right, gap = a, b, a - b
    for name, square in squares.items():
        speed = f"{name}_dot"
        if depends_on(gap, speed):
            slope = derivative(gap, speed)
            rest = substitute(gap, {speed: NOTHING})
            gap = with_squares(rest * rest - slope * slope * square, squares)
            left, right = rest * rest, with_squares(slope * slope * square, squares)
    bound_speeds = not question.motion.is_free and any(_is_speed(index) for index in gap.atoms())
    if bound_speeds or _holds_unknowns(gap, question):
        return undecided("")
    domain = [Condition(t.Sym(f"{name}_dot"), ">=", square) for name, square in squares.items()]
    found = _witness(left, right, question.motion.assumptions, domain)
    return found if found.is_refuted else _witness(left, right, question.motion.assumptions)


def _is_speed(index: int) -> bool:
    name = atoms.symbol_name(index)
    return bool(name) and name.endswith(("_dot", "_ddot"))


def carried_out(value: Scalar, question: Question) -> Scalar | None:
    """The value along the motion with every work and integral in closed form; None if one has none."""
    images: dict[str, Scalar] = {}
    for name, power in question.motion.ledger.items():
        if depends_on(value, name):
            done = _work_done(power, question)
            if done is None:
                return None
            images[name] = done
    return question.seen(substitute(value, images), "start")


def _work_done(power: Scalar, question: Question) -> Scalar | None:
    """∫ power dt over the one coordinate along which it is done."""
    motion = question.motion
    known = motion.moved(power)
    for name in motion.scope.start:
        speed = f"{name}_dot"
        if not depends_on(known, speed) or name not in motion.scope.rates:
            continue
        integrand = along_motion(substitute(known / symbol(speed), {}), motion.squares)
        if integrand is None or integrand.den is not ONE and depends_on(Scalar(integrand.den), name):
            return None
        return definite(integrand, name, motion.scope.start[name], symbol(name))
    return None


# --- inequalities and approximations


def ordered(a: Scalar, b: Scalar, op: str, question: Question) -> Verdict:
    """Whether a < b (<=, >, >=) in every state."""
    low, high = (a, b) if op in ("<", "<=") else (b, a)
    found = undecided("")
    for depth in question.depths:
        pair = _squared([question.seen(v, depth) for v in (low, high)], question)
        found = compare(*pair, question.motion.assumptions, strict=op in ("<", ">"))
        if found.is_proved:
            return found
    return found


def _squared(pair: list[Scalar], question: Question) -> list[Scalar]:
    """The squares of two roots that are not negative, which are ordered as these."""
    rooted = [any(atoms.atom(index).kind == "root" for index in value.atoms()) for value in pair]
    if all(rooted) and all(sign(value, question.motion.assumptions).is_nonnegative for value in pair):
        return [without_even_roots(value * value) for value in pair]
    return pair


def different(a: Scalar | Space, b: Scalar | Space, question: Question) -> Verdict:
    """Whether a is not identically b: there is a state in which they differ."""
    found = equal_values(a, b, question)
    if found.is_refuted:
        return proved(f"they differ {found.witness}")
    if found.is_proved:
        return undecided(f"they are equal: {found.how}")
    return found


def equal_to_first_order(a: Scalar, b: Scalar, question: Question) -> Verdict:
    """a ≈ b for small values of the one coordinate in which they differ."""
    gap = a - b
    names = [name for name in question.motion.scope.start if depends_on(gap, name)]
    if len(names) != 1:
        return undecided("it is not clear which quantity is small")
    at = {names[0]: NOTHING}
    slope = derivative(gap, names[0])
    pairs = ((substitute(a, at), substitute(b, at)), (substitute(slope, at), NOTHING))
    found = all_of(scalars_equal(x, y, question.motion.assumptions) for x, y in pairs)
    return proved(f"equal to first order in {names[0]}") if found.is_proved else found


RELATIONS: dict[str, Callable[..., Verdict]] = {
    "=": lambda a, b, op, question: equal_values(a, b, question),
    "!=": lambda a, b, op, question: different(a, b, question),
    "~": lambda a, b, op, question: equal_to_first_order(a, b, question),
    **dict.fromkeys(("<", "<=", ">", ">="), ordered),
}

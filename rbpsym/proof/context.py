"""What the names in a derivation mean, and the values of statements at three depths.

A statement may hold as an identity; on the motion (with the accelerations and unknown forces
that Newton's and Euler's equations give); or along the motion from the start (with the squares
of the speeds from the first integral as well).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.errors import Undecided
from rbpsym.expr.tree import Add, Bracket, Delta, Deriv, Integral, Limit, Node, PathIntegral, Sym, walk
from rbpsym.field import NOTHING, UNITY, Scalar, Space, Vector, atoms, depends_on
from rbpsym.field.evaluate import Meanings, Value, at_start, rate, time_derivative, value
from rbpsym.field.exponentials import with_squares
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import ConstraintCondition
from rbpsym.proof.facts import Fact
from rbpsym.proof.step import Step

# what asks how something changes -> the field that holds this
INNER: Mapping[type[Node], str] = {Deriv: "of", Bracket: "arg", Limit: "arg", Integral: "integrand"}


EXACT, DENIED, DECIDED = 0, 1, 2  # what numbers are trusted with: nothing; that a gap does not close; whether it does


class BareGround(Frozen):
    """What a check asks beside values: here nothing is tied or unsolved, and all may be used without being noted."""

    by_numbers = EXACT

    @property
    def ties(self) -> tuple[ConstraintCondition, ...]:
        """The conditions that tie coordinates to each other without an explicit solution."""
        return ()

    @property
    def unsolved(self) -> tuple[str, ...]:
        """The accelerations, where there is no closed formula for them."""
        return ()

    def use(self, id: str) -> None:
        """Notes that a premise is used."""

    def reach(self, goal: Scalar) -> None:
        """Notes what was found to vanish."""

    def agree_by_numbers(self, gap: Scalar, depth: str) -> bool | None:
        """Whether a gap seems to close at that depth; None if numbers do not tell."""
        return None


class Context(BareGround):
    """The meanings so far: `scalars` and `vectors` of defined quantities over the problem's own.

    `moments`: ∫ r^k dm of each body by k; `works`: the rate of each work by its name. `introduced`: by which step or
    fact a letter has its meaning, and the formula that says it (None if its value holds no other letter). `steps`,
    `facts`: by id; `rests`: on which introductions the letters of a step rest; `rows`: what is known of premises
    already. `assumed`: what a step assumes instead of the problem.
    """

    whole: Study
    scalars: dict[str, Scalar] = field(default_factory=dict)
    vectors: dict[str, Space] = field(default_factory=dict)
    moments: dict[str, Mapping[int, Scalar]] = field(default_factory=dict)
    works: dict[str, Scalar] = field(default_factory=dict)
    introduced: dict[str, tuple[str, Node | None]] = field(default_factory=dict)
    steps: dict[str, Step] = field(default_factory=dict)
    facts: dict[str, Fact] = field(default_factory=dict)
    rests: dict[str, frozenset[str]] = field(default_factory=dict)
    rows: dict[object, Any] = field(default_factory=dict)
    assumed: Assumptions | None = None

    @property
    def study(self) -> Study:
        """The mechanics of the problem."""
        return self.whole

    @property
    def ties(self) -> tuple[ConstraintCondition, ...]:
        """The conditions that tie coordinates to each other without an explicit solution."""
        return self.whole.ties

    @property
    def unsolved(self) -> tuple[str, ...]:
        """The accelerations, where there is no closed formula for them."""
        is_open = not self.whole.at_start and self.whole.dynamics.accelerations is None
        return self.whole.system.accelerations if is_open else ()

    @property
    def scope(self) -> Meanings:
        """The scope in which trees are evaluated; the time t goes on in it from the start."""
        base = self.whole.system.scope
        rates, start = {**base.rates, "t": UNITY}, {"t": NOTHING, **base.start}
        return Meanings(self.scalars, self.vectors, rates, start, self.body_integral, self.works)

    @property
    def radius(self) -> str:
        """The letter of the distance in ∫ r² dm."""
        return self.study.letters.free("r", "rho", "q")

    @property
    def assumptions(self) -> Assumptions:
        """The problem's declared signs and ranges, or those that a step assumes."""
        return self.assumed or self.study.assumptions

    def body_integral(self, integrand: Scalar, body: str) -> Scalar:
        """∫ f dm for f a polynomial in the distance from the centre of mass of a body."""
        parts = integrand.num.by_power(atoms.intern("symbol", self.radius))
        moments = self.moments[body]
        if unknown := parts.keys() - moments:
            raise Undecided(f"the mass moment of order {min(unknown)} of “{body}” is not known")
        return sum((Scalar(part) * moments[power] for power, part in parts.items()), NOTHING)

    def parts(self, node: Node, *kinds: type[Node]) -> tuple[Any, ...]:
        """The parts of a tree that are of these kinds; each tree is walked once."""
        key = ("parts", id(node))
        if key not in self.rows:
            found: dict[type[Node], list[Node]] = {}
            for part in walk(node):
                found.setdefault(type(part), []).append(part)
            self.rows[key] = (node, found)  # with the node, whose address is its name
        found = self.rows[key][1]
        return tuple(part for kind in kinds for part in found.get(kind, ()))

    def grows(self, node: Node) -> bool:
        """Whether it holds what is summed up along the motion: an integral, a change, a work."""
        summed = self.parts(node, Integral, PathIntegral, Delta)
        return bool(summed) or any(part.name in self.works for part in self.parts(node, Sym))

    def value(self, node: Node) -> Any:
        """The value of a tree in coordinates, speeds, accelerations and unknown forces: a number, or a vector."""
        for part in self.parts(node, *INNER):
            self._refuse_unknown(part)
        return value(node, self.scope)

    def rate(self, node: Node) -> Scalar:
        """d/dt of a tree that may hold integrals along the motion."""
        if isinstance(node, Add):
            return sum((self.rate(term) for term in node.terms), NOTHING)
        for part in self.parts(node, Delta) if self.grows(node) else (node,):
            self._refuse_unknown_rates(value(part.arg if isinstance(part, Delta) else part, self.scope))
        return rate(node, self.scope)

    def rate_of(self, found: Scalar) -> Scalar:
        """d/dt of a value."""
        self._refuse_unknown_rates(found)
        return time_derivative(found, self.scope)

    @property
    def unsettled(self) -> frozenset[str]:
        """Of what nobody knows how it changes: accelerations and unknown forces are no constants."""
        return self.study.system.unsettled

    def _refuse_unknown_rates(self, found: Value) -> None:
        """Raises Undecided for a value whose rate is not known."""
        self._refuse(found, self.study.system.unsettled, "with time")

    def _refuse_unknown(self, part: Node) -> None:
        """Raises Undecided for a derivative, or what is taken between places, of what is not known as a function."""
        inner = getattr(part, INNER[type(part)])
        if isinstance(part, Deriv) and part.wrt == "t":
            for order in range(part.order):
                self._refuse_unknown_rates(value(replace(part, order=order) if order else inner, self.scope))
            return
        free = self.study.system.accelerations if isinstance(part, Deriv) and part.partial else ()
        self._refuse(value(inner, self.scope), self.unsettled.difference(free), "from place to place")

    def _refuse(self, found: Value, names: frozenset[str], how: str) -> None:
        parts = found.components() if isinstance(found, Space) else (found,)
        held = sorted(n for n in names if any(depends_on(part, n) for part in parts))
        if held:
            raise Undecided(f"it is not known how {held[0]} changes {how}")

    def start(self, found: Scalar) -> Scalar:
        """The value in the start state."""
        return at_start(found, self.scope)

    def on_motion(self, found: Any) -> Any:
        """Accelerations and unknown forces replaced."""
        if isinstance(found, Space):
            plane = {angle: self.study.on_motion(length) for angle, length in found.plane.parts.items()}
            return Space(Vector(plane), self.study.on_motion(found.z))
        return self.study.on_motion(found)

    def along(self, found: Scalar) -> Scalar:
        """Squares of speeds replaced too, as far as they are known."""
        return with_squares(self.study.on_motion(found), self.study.squares)

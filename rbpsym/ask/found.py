"""What is found for a quantity, and the answer with its steps."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.ask.asked import Moment
from rbpsym.ask.question import Question
from rbpsym.decide.rooted import neat, rationalised
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict
from rbpsym.errors import StatementError, there
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, has_roots, is_rooted, names_in, root, short, with_exponentials_joined
from rbpsym.field.normal import in_one_angle
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.pushing import begins, begun_numbers
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.draft import length
from rbpsym.proof.step import Derivation, Step
from rbpsym.quantity.path import even
from rbpsym.typeset.machine import to_machine


class Found(Frozen):
    """What was found for a quantity: its values as they are named (one, or x and y of a vector), those of the answer, and
    of what these are functions: "" (a moment, or nothing), "position", "state". `works`: rate and closed form of the works in
    it; `ways`: in which sense a speed is taken, and what is `asked` for that; `told`: the chapter that says it;
    `speeds`: those that a resistance gives as functions of the place; `kept`: those that conserved momenta give; `places` that
    follow from one of them; whether it is `constant`, as at the start; `since`: what it was at the moment from which a change
    is counted, and the works of the phases between; `about`: how which mass is spread, about which point."""

    study: Study
    named: tuple[Scalar, ...]
    values: tuple[Scalar, ...]
    of: str = ""
    moment: Moment | None = None
    works: Mapping[str, tuple[Scalar, Scalar]] = field(default_factory=dict)
    ways: Mapping[str, int] = field(default_factory=dict)
    told: str = ""
    asked: tuple[Demand, ...] = ()
    speeds: Mapping[str, Scalar] = field(default_factory=dict)
    kept: Mapping[str, Scalar] = field(default_factory=dict)
    places: Mapping[str, Scalar] = field(default_factory=dict)
    constant: bool = False
    since: tuple[Found, ...] = ()
    about: tuple[str, str | None] | None = None

    @property
    def then(self) -> Moment:
        """The moment at which it is taken. Raises ValueError for what is told along the motion."""
        return there(self.moment)


class Answer(Frozen):
    """The answer to a question: one value, or the components along x and y of a vector, as they are and as they are
    printed; `holds`: of what they are functions; the conditions under which they hold; the steps from which they follow.

    Of a parameter: the `symbol` that was asked for, its `relation` to the values, `each` with conditions of its own; a
    sentence, yes or no (`holds_so`), the `equation` that it solves where that has no closed solution; `at`: where an
    extremum lies; what is `given` for letters of the question itself; the `conclusion`, and the `grounds` on which rules
    have checked it; the speeds that it takes to be `kept`, since no acceleration is stated; `derivations`: the steps with their
    letters, phase by phase, for the prover that is asked of them; `read_as`: what a book's words were taken to mean."""

    question: Question
    study: Study
    values: tuple[Scalar, ...]
    nodes: tuple[t.Node, ...]
    verdict: Verdict
    holds: str
    valid: tuple[t.Node, ...] = ()
    steps: tuple[Step, ...] = ()
    symbol: str = ""
    relation: str = "="
    says: str = ""
    holds_so: bool | None = None
    each: tuple[tuple[t.Node, ...], ...] = ()
    equation: t.Node | None = None
    at: tuple[str, t.Node] | None = None
    given: Mapping[str, str] = field(default_factory=dict)
    conclusion: Step | None = None
    grounds: tuple[Step, ...] = ()
    derivations: tuple[Derivation, ...] = field(default=(), compare=False, repr=False)
    kept: tuple[t.Node, ...] = ()
    read_as: str = ""

    @property
    def value(self) -> Scalar:
        """The value. Raises StatementError for a vector."""
        if len(self.values) == 1:
            return self.values[0]
        raise StatementError(f"“{self.question.quantity}” is a vector", instead="ask for its magnitude or a component.")

    @property
    def text(self) -> str:
        """The value as text that Python and sympy read, as printed if that has no letters of its own; a vector as a pair."""
        style = replace(self.study.style, tangents=False)
        pairs = list(zip(self.nodes, self.values, strict=False))
        is_plain = len(self.nodes) == len(self.values) and all(t.names(node) <= names_in(value) | {"pi"} for node, value in pairs)
        texts = [to_machine(node if is_plain else present(value, style)) for node, value in pairs]
        return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"

    @property
    def is_angle(self) -> bool:
        """Is it asked for an angle: a coordinate that is one, or a direction?"""
        return self.question.is_direction or self.question.quantity in {c.name for c in self.study.problem.coordinates}


def shortest(value: Scalar, study: Study) -> Scalar:
    """The value in the shortest of its forms: as it is, with short roots, as one root."""
    value = in_one_angle(with_exponentials_joined(value))
    if not has_roots(value):
        return value
    given, square = study.assumptions, short(even(value * value))
    forms, way = [value, neat(value, given), rationalised(neat(value, given))], sign(value, given).sense
    if way and not is_rooted(square.num) and not is_rooted(square.den):
        forms.append(neat(root(square), given) * way)
    return min(forms, key=lambda form: length(present(form, study.style, factor=True)))


def sense_stated(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push by what the statement supposes of the start; 0 where that does not tell it."""
    ratios = (push / demand.value for demand in begins(study) if demand.op != "!=" and demand.value)
    return next((found for ratio in ratios if (found := sign(short(ratio), study.assumptions).sense)), 0)


def sense_at_sample(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push at the first sample numbers at which it begins as stated; 0 where it has none there."""
    found = floating(push, begun_numbers(study))
    return (found > 0) - (found < 0)

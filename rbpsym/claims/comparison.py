"""Two problems beside each other: which oscillates, speeds up or moves faster, why, and where they agree.

Parameters of the same name are the same quantities.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Meanings, Scalar, Value, depends_on, is_zero, root, short, substitute, value
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState
from rbpsym.present.forms import present
from rbpsym.proof.assertions import told
from rbpsym.proof.checks import of_steps as c
from rbpsym.proof.context import BareGround
from rbpsym.proof.step import BodyRef, Certificate, Lesson, PhraseRef, Step, StepRef
from rbpsym.statement.course import CoursePart
from rbpsym.statement.source import did_you_mean


class Compared(Frozen):
    """One quantity of two problems.

    of: which one; names: its symbols in the two; power: 2 if squares are compared; values: what is
    compared, in common parameters (and the coordinate), and how each is printed.
    """

    of: str
    names: tuple[str, str]
    power: int
    values: tuple[Scalar, Scalar]
    shown: tuple[t.Node, t.Node]

    def letters(self) -> list[t.Node]:
        """The quantities as formulas: ϑ₁², or a₁."""
        return [t.Pow(t.Sym(name), t.TWO) if self.power == 2 else t.Sym(name) for name in self.names]

    def scalars(self) -> dict[str, Scalar]:
        """What the symbols stand for."""
        pairs = zip(self.names, self.values, strict=True)
        return {name: root(value) if self.power == 2 else value for name, value in pairs}


def compared(first: Study, second: Study, part: CoursePart) -> Compared:
    """What the part asks for, or the first that both problems have. Raises StatementError if there is none."""
    wanted = [part.of] if part.of else list(QUANTITIES)
    for of in wanted:
        if found := QUANTITIES[of]((first, second), part):
            return found
    what = "the same " + (" or ".join(SAID[of] for of in wanted))
    raise part.error(
        "of" if part.of else "comparison",
        f"“{first.problem.name}” and “{second.problem.name}” don't both have {what} to compare",
        "of = " + ", ".join(f'"{of}"' for of in QUANTITIES) + "; coordinate says along which.",
    )


def _oscillation(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    first, second = (_place(study, part.coordinate) for study in studies)
    if first is None or second is None:
        return None
    squares = first.frequencies_squared[0], second.frequencies_squared[0]
    return Compared("oscillation", ("vartheta_1", "vartheta_2"), 2, squares, _shown(squares, studies))


def _shown(values: tuple[Scalar, Scalar], studies: tuple[Study, Study]) -> tuple[t.Node, t.Node]:
    one, other = (present(value, study.style, factor=True) for study, value in zip(studies, values, strict=True))
    return one, other


def _place(study: Study, coordinate: str) -> Equilibrium | None:
    """The first stable position of rest about which the system oscillates with one frequency."""
    stable = (item for item in study.equilibria if item.stable and item.frequencies_squared)
    return next((item for item in stable if not coordinate or coordinate in item.at), None)


def _acceleration(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    """Accelerations that are functions of position alone."""
    name = common_coordinate(studies, part.coordinate)
    first, second = ((study.dynamics.accelerations or {}).get(f"{name}_ddot") for study in studies)
    speeds = {speed for study in studies for speed in study.system.speeds}
    if not first or not second or any(depends_on(value, speed) for value in (first, second) for speed in speeds):
        return None
    return _along("acceleration", f"{name}_ddot", 1, studies, (first, second))


def _speed(studies: tuple[Study, Study], part: CoursePart) -> Compared | None:
    """Squares of speeds as functions of position, from the start."""
    name = common_coordinate(studies, part.coordinate)
    first, second = (study.squares.get(name) for study in studies)
    return _along("speed", f"{name}_dot", 2, studies, (first, second)) if first and second else None


def _along(of: str, name: str, power: int, studies: tuple[Study, Study], found: tuple[Scalar, Scalar]) -> Compared:
    values = short(found[0]), short(found[1])
    names = indexed(name, studies[0], 1), indexed(name, studies[0], 2)
    return Compared(of, names, power, values, _shown(values, studies))


def indexed(name: str, study: Study, k: int) -> str:
    """The quantity with the number of the problem: a_1 where the notation says a, else x_1_ddot."""
    if drawn := study.problem.notation.get(name):
        return f"{drawn}_{k}"
    base, _, rate = name.rpartition("_")
    return f"{base}_{k}_{rate}" if rate in ("dot", "ddot") else f"{name}_{k}"


def common_coordinate(studies: tuple[Study, Study], named: str) -> str:
    """The coordinate that is named, else the first that both problems have."""
    first, second = ([c.name for c in study.problem.coordinates] for study in studies)
    return named or next((name for name in first if name in second), "")


QUANTITIES: Mapping[str, Callable[[tuple[Study, Study], CoursePart], Compared | None]] = {
    "oscillation": _oscillation, "acceleration": _acceleration, "speed": _speed,
}  # fmt: skip
SAID = {
    "oscillation": "small oscillation", "acceleration": "acceleration (as a function of position)",
    "speed": "speed (as a function of position)",
}  # fmt: skip


class _Context(BareGround):
    """Values of statements in the common parameters of both problems."""

    assumptions: Assumptions
    scalars: dict[str, Scalar] = field(default_factory=dict)

    def value(self, node: t.Node) -> Value:
        """The value of a tree."""
        return value(node, Meanings(self.scalars))


class _Pair(Frozen):
    studies: tuple[Study, Study]
    context: _Context
    compared: Compared
    steps: list[Step] = field(default_factory=list)

    def add(
        self,
        id: str,
        statement: t.Node,
        phrase: str,
        *premises: str,
        scalars: Mapping[str, Scalar] | None = None,
        check: str = c.identity.__name__,
        **slots: object,
    ) -> None:
        """Adds a checked step, which may know other values than those of the whole comparison."""
        rule = "inequality" if phrase.startswith("order.") else c.identity.__name__
        step = Step(id, rule, statement, "comparison", f"comparison.{phrase}", slots, premises)
        context: Any = self.context if scalars is None else replace(self.context, scalars=dict(scalars))
        verdict = c.guarded(lambda: c.identity(context, step))
        self.steps.append(told(replace(step, certificate=Certificate((check,), verdict))))

    def rows(self, letters: Iterable[t.Node], values: Iterable[Scalar]) -> t.Relations:
        """Each letter with its value in the one problem and in the other."""
        given = zip(letters, values, self.studies, strict=True)
        return t.Relations(tuple(t.equation(one, present(value, study.style, factor=True)) for one, value, study in given))


def compare_problems(first: Study, second: Study, part: CoursePart) -> Lesson:
    """The lesson. Raises StatementError if the problems have nothing that `part` can compare."""
    found, problems = compared(first, second, part), (first.problem, second.problem)
    pair = _Pair((first, second), _Context(_common(first, second), found.scalars()), found)
    for k, (problem, letter, shown) in enumerate(zip(problems, found.letters(), found.shown, strict=True), 1):
        title = dict(problem.title)
        pair.add(f"frequency.{k}", t.equation(letter, shown), found.of, title=title, problem=problem.name)
    _order(pair)
    _ratio(pair)
    _moments(pair)
    _reasons(pair)
    if part.limit:
        _limit(pair, part)
    titles = {name: dict(problem.title) for name, problem in zip(("first", "second"), problems, strict=True)}
    name = "-".join(problem.name for problem in problems)
    return Lesson("comparison", name, tuple(pair.steps), titles, first.problem.notation)


def _common(first: Study, second: Study) -> Assumptions:
    """What is declared of the quantities of both."""
    one, other = first.assumptions, second.assumptions
    return Assumptions({**other.signs, **one.signs}, {**other.ranges, **one.ranges}, other.reached | one.reached)


def _order(pair: _Pair) -> None:
    """ϑ₁ < ϑ₂, proved for all values that the assumptions allow; of negative values their sizes."""
    values, known = pair.compared.values, pair.context.assumptions
    turned = all(sign(value, known).kind == "negative" for value in values)
    found = sign(values[0] - values[1] if turned else values[1] - values[0], known).kind
    op = {"positive": "<", "negative": ">", "zero": "=", "nonnegative": "<=", "nonpositive": ">="}.get(found or "")
    if op is None:
        return
    first, second = (t.neg(t.Sym(name)) if turned else t.Sym(name) for name in pair.compared.names)
    both = ("frequency.1", "frequency.2")
    pair.add(
        "order",
        t.relation(first, op, second),
        f"order.{NAMES[op]}",
        *both,
        scalars=dict(zip(pair.compared.names, values, strict=True)),
        check="squares of positive numbers" if pair.compared.power == 2 else c.identity.__name__,
        sources=list(map(StepRef, both)),
        faster=dict(pair.studies[op in ("<", "<=")].problem.title),
    )


NAMES = {"<": "less", ">": "greater", "=": "equal", "<=": "less", ">=": "greater"}


def _ratio(pair: _Pair) -> None:
    """(ϑ₂/ϑ₁)² = 1 + what makes the difference."""
    first, second = pair.compared.values
    if is_zero(second - first):
        return
    letters = pair.compared.letters()
    ratio, style = short(second / first), pair.studies[0].style
    one_more = t.add(t.ONE, present(short(ratio - 1), style, factor=True))
    shown = one_more if pair.compared.of == "oscillation" else present(ratio, style, factor=True)
    phrase = "ratio.squares" if pair.compared.power == 2 else "ratio.plain"
    pair.add("ratio", t.equation(t.Div(letters[1], letters[0]), shown), phrase)


def _common_bodies(pair: _Pair) -> Iterator[tuple[str, list[BodyState]]]:
    """The bodies of one name, in the one problem and in the other."""
    first, second = (study.system.bodies for study in pair.studies)
    yield from ((name, [first[name], second[name]]) for name in first if name in second)


def _moments(pair: _Pair) -> None:
    """Bodies of one name that differ in their moments of inertia."""
    for name, states in _common_bodies(pair):
        own, other = moments = [state.moment for state in states]
        if own and other and not is_zero(own - other):
            names = [f"I_{name}_{k}" for k in (1, 2)]
            pair.context.scalars.update(zip(names, moments, strict=True))
            pair.add(f"moments.{name}", pair.rows(map(t.Sym, names), moments), "moments", body=BodyRef(name))


def _reasons(pair: _Pair) -> None:
    """Bodies whose spin part of L changes in one problem and not in the other."""
    for name, states in _common_bodies(pair):
        both = list(zip(pair.studies, states, strict=True))
        kept = [bool(state.moment) and is_zero(study.on_motion(state.moment * state.alpha)) for study, state in both]
        if kept[0] != kept[1]:
            _spin_steps(pair, name, both[::-1] if kept[0] else both)


def _spin_steps(pair: _Pair, name: str, bound_and_free: Sequence[tuple[Study, BodyState]]) -> None:
    """d(I ω)/dt = τ_cm in both problems."""
    for (study, state), word in zip(bound_and_free, ("bound", "free"), strict=True):
        torque = sum((torque_about_center(f, state) for f in study.system.on(name)), NOTHING)
        rate = study.on_motion(state.moment * state.alpha)
        letter = f"tau_cm_{name}"
        pair.add(
            f"spin.{word}.{name}",
            t.equation(t.Sym(letter), present(rate, study.style, factor=True)),
            f"spin.{word}",
            "order",
            scalars={letter: study.on_motion(torque)},
            body=BodyRef(name),
            spin=t.mul(t.Sym(f"I_{name}"), t.Vec(f"omega_{name}")),
            title=dict(study.problem.title),
            silent=PhraseRef("comparison.because", {}),
        )


def _limit(pair: _Pair, part: CoursePart) -> None:
    """What both tend to when the parameter tends to zero (both are continuous there)."""
    known = {q.name for study in pair.studies for q in study.problem.parameters}
    if part.limit not in known:
        raise part.error("limit", f"no parameter is called “{part.limit}”", did_you_mean(part.limit, known))
    try:
        ends = [substitute(value, {part.limit: NOTHING}) for value in pair.compared.values]
    except ZeroDivisionError:
        what = f"what is compared has no limit where “{part.limit}” tends to zero"
        raise part.error("limit", what, "name another parameter, or leave the limit out.") from None
    rows = pair.rows((t.Limit(letter, part.limit, t.ZERO) for letter in pair.compared.letters()), ends)
    pair.add("limit", rows, f"limit.{_limit_kind(pair, ends, part.limit)}", parameter=t.Sym(part.limit))


def _limit_kind(pair: _Pair, ends: list[Scalar], name: str) -> str:
    """Do both agree there, and because the moments of the bodies whose spins differ are gone?"""
    if not is_zero(ends[0] - ends[1]):
        return "differ"
    told = [step.id.rpartition(".")[2] for step in pair.steps if step.id.startswith("spin.")]
    states = [study.system.bodies[body] for body in told for study in pair.studies]
    gone = all(is_zero(substitute(state.moment, {name: NOTHING})) for state in states)
    return "agree_without_spin" if states and gone else "agree"

"""Two problems beside each other: whose small oscillations are faster, why, and where they agree.

Parameters of the same name are the same quantities.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import Scope, Value, value
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.present import present_ratio
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation import checks as c
from rbpsym.derivation.step import STANDARD, BodyRef, Certificate, Lesson, PhraseRef, Step, StepRef
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.errors import NotApplicable
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.course import CoursePart


@dataclass(frozen=True)
class _Context:
    """Values of statements in the common parameters of both problems."""

    assumptions: Assumptions
    scalars: dict[str, Scalar] = field(default_factory=dict)

    def value(self, node: t.Node) -> Value:
        """The value of a tree."""
        return value(node, Scope(self.scalars))


@dataclass(frozen=True)
class _Pair:
    first: Study
    second: Study
    context: _Context
    steps: list[Step] = field(default_factory=list)

    def add(self, id: str, statement: t.Node, phrase: str, check=c.identity, is_result: bool = False, **slots) -> None:
        """Adds a checked step."""
        step = Step(id, check.__name__, statement, "comparison", phrase, slots, (), STANDARD, is_result)
        verdict = c.guarded(lambda: check(self.context, step))
        self.steps.append(replace(step, certificate=Certificate((check.__name__,), verdict)))


def compare_problems(first: Study, second: Study, part: CoursePart) -> Lesson:
    """The lesson. Raises NotApplicable if one of them has no small oscillation of one coordinate."""
    pair = _Pair(first, second, _Context(Assumptions({**second.assumptions.signs, **first.assumptions.signs})))
    places = [_oscillation(study, part.coordinate) for study in (first, second)]
    squares = [place.frequencies_squared[0] for place in places]
    for k, (study, place, square) in enumerate(zip((first, second), places, squares, strict=True), 1):
        pair.context.scalars[f"Omega_{k}"] = square
        pair.context.scalars[f"vartheta_{k}"] = _root(square)
        pair.add(
            f"frequency.{k}",
            t.equation(t.Pow(t.Sym(f"vartheta_{k}"), t.TWO), _quotient(study, place, square)),
            "comparison.frequency",
            title=dict(study.problem.title),
            problem=study.problem.name,
        )
    _order(pair, squares)
    _ratio(pair, squares)
    _reasons(pair)
    if part.limit:
        _limit(pair, squares, part.limit)
    return Lesson(
        "comparison",
        f"{first.problem.name}-{second.problem.name}",
        tuple(pair.steps),
        {"first": dict(first.problem.title), "second": dict(second.problem.title)},
        first.problem.notation,
    )


def _root(value: Scalar) -> Scalar:
    from rbpsym.algebra.calculus import root

    return root(value)


def _oscillation(study: Study, coordinate: str) -> Equilibrium:
    for item in study.equilibria:
        if item.stable and item.frequencies_squared and (not coordinate or coordinate in item.at):
            return item
    raise NotApplicable(
        f"“{study.problem.name}” has no stable position of rest about which it oscillates with one frequency",
        instead="compare problems with small oscillations.",
    )


def _quotient(study: Study, place: Equilibrium, square: Scalar) -> t.Node:
    """Stiffness over inertia of the coordinate that oscillates, as the equation of motion has them."""
    for row, inertia in zip(place.stiffness, place.inertia, strict=True):
        for k, m in zip(row, inertia, strict=True):
            if k and m and k.den is ONE and m.den is ONE and is_zero(k / m - square):
                return present_ratio(k.num, m.num, study.style, as_ratio=True)
    from rbpsym.algebra.present import present

    return present(square, study.style, factor=True)


def _order(pair: _Pair, squares: list[Scalar]) -> None:
    """ϑ₁ < ϑ₂, proved for all values that the assumptions allow."""
    found = sign(squares[1] - squares[0], pair.context.assumptions).kind
    op = {"positive": "<", "negative": ">", "zero": "=", "nonnegative": "<=", "nonpositive": ">="}.get(found)
    if op is None:
        return
    letters = [t.Sym(f"vartheta_{k}") for k in (1, 2)]
    context = replace(pair.context, scalars={"vartheta_1": squares[0], "vartheta_2": squares[1]})
    step = Step(
        "order",
        "inequality",
        t.relation(letters[0], op, letters[1]),
        "comparison",
        f"comparison.order.{NAMES[op]}",
        {"sources": [StepRef("frequency.1"), StepRef("frequency.2")], "faster": _titles(pair, op)},
        ("frequency.1", "frequency.2"),
        STANDARD,
        True,
    )
    verdict = c.guarded(lambda: c.identity(context, step))
    pair.steps.append(replace(step, certificate=Certificate(("squares of positive numbers",), verdict)))


NAMES = {"<": "less", ">": "greater", "=": "equal", "<=": "less", ">=": "greater"}


def _titles(pair: _Pair, op: str) -> dict:
    faster = pair.second if op in ("<", "<=") else pair.first
    return dict(faster.problem.title)


def _ratio(pair: _Pair, squares: list[Scalar]) -> None:
    """(ϑ₂/ϑ₁)² = 1 + what makes the difference."""
    from rbpsym.algebra.present import present

    ratio = squares[1] / squares[0]
    excess = present(ratio - 1, pair.first.style, factor=True)
    left = t.Div(t.Pow(t.Sym("vartheta_2"), t.TWO), t.Pow(t.Sym("vartheta_1"), t.TWO))
    pair.add("ratio", t.equation(left, t.add(t.ONE, excess)), "comparison.ratio")


def _reasons(pair: _Pair) -> None:
    """Bodies whose spin part of L changes in one problem and not in the other."""
    for name in pair.first.system.bodies:
        if name not in pair.second.system.bodies:
            continue
        kept = [_spin_is_kept(study, name) for study in (pair.first, pair.second)]
        if kept[0] == kept[1]:
            continue
        study = pair.second if kept[1] else pair.first
        other = pair.first if kept[1] else pair.second
        _spin_steps(pair, name, study, other)


def _spin_is_kept(study: Study, name: str) -> bool:
    state = study.system.bodies[name]
    return bool(state.moment) and is_zero(study.on_motion(state.moment * state.alpha))


def _spin_steps(pair: _Pair, name: str, free: Study, bound: Study) -> None:
    """d(I ω)/dt = τ_cm in both problems."""
    from rbpsym.algebra.present import present

    for study, word in ((bound, "bound"), (free, "free")):
        state = study.system.bodies[name]
        torque = sum((torque_about_center(f, state) for f in study.system.on(name)), NOTHING)
        rate = study.on_motion(state.moment * state.alpha)
        letter = t.Vec(f"omega_{name}")
        moment = t.Sym(f"I_{name}")
        pair.context.scalars[f"rate_{name}_{word}"] = rate
        context = replace(pair.context, scalars={f"tau_cm_{name}": study.on_motion(torque)})
        statement = t.equation(t.Sym(f"tau_cm_{name}"), present(rate, study.style, factor=True))
        step = Step(
            f"spin.{word}.{name}",
            "identity",
            statement,
            "comparison",
            f"comparison.spin.{word}",
            {
                "body": BodyRef(name),
                "spin": t.mul(moment, letter),
                "title": dict(study.problem.title),
                "silent": PhraseRef("comparison.because", {}),
            },
            ("order",),
        )
        verdict = c.guarded(lambda context=context, step=step: c.identity(context, step))
        pair.steps.append(replace(step, certificate=Certificate(("identity",), verdict)))


def _limit(pair: _Pair, squares: list[Scalar], name: str) -> None:
    """Both frequencies agree when the parameter tends to zero (both are continuous there)."""
    from rbpsym.algebra.present import present

    ends = [substitute(square, {name: NOTHING}) for square in squares]
    rows = [
        t.equation(
            t.Limit(t.Pow(t.Sym(f"vartheta_{k}"), t.TWO), name, t.ZERO), present(end, pair.first.style, factor=True)
        )
        for k, end in enumerate(ends, 1)
    ]
    phrase = "comparison.limit.agree" if is_zero(ends[0] - ends[1]) else "comparison.limit.differ"
    pair.add("limit", t.System(tuple(rows)), phrase, parameter=t.Sym(name))

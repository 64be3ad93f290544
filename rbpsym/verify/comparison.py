"""Two problems beside each other: which oscillates, speeds up or moves faster, why, and where they agree.

Parameters of the same name are the same quantities.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import Scope, Value, value
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation import checks as c
from rbpsym.derivation.assertions import told
from rbpsym.derivation.step import STANDARD, BodyRef, Certificate, Lesson, PhraseRef, Step, StepRef
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.signs import sign
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.course import CoursePart
from rbpsym.statement.source import did_you_mean
from rbpsym.verify.compared import Compared, compared


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
    compared: Compared
    steps: list[Step] = field(default_factory=list)

    def add(self, id: str, statement: t.Node, phrase: str, check=c.identity, is_result: bool = False, **slots) -> None:
        """Adds a checked step."""
        step = Step(id, check.__name__, statement, "comparison", phrase, slots, (), STANDARD, is_result)
        verdict = c.guarded(lambda: check(self.context, step))
        self.steps.append(told(replace(step, certificate=Certificate((check.__name__,), verdict))))


def compare_problems(first: Study, second: Study, part: CoursePart) -> Lesson:
    """The lesson. Raises StatementError if the problems have nothing that `part` can compare."""
    found = compared(first, second, part)
    pair = _Pair(first, second, _Context(_common(first, second), found.scalars()), found)
    for k, (study, letter, shown) in enumerate(zip((first, second), found.letters(), found.shown, strict=True), 1):
        pair.add(
            f"frequency.{k}",
            t.equation(letter, shown),
            f"comparison.{found.of}",
            title=dict(study.problem.title),
            problem=study.problem.name,
        )
    _order(pair)
    _ratio(pair)
    _moments(pair)
    _reasons(pair)
    if part.limit:
        _limit(pair, part)
    return Lesson(
        "comparison",
        f"{first.problem.name}-{second.problem.name}",
        tuple(pair.steps),
        {"first": dict(first.problem.title), "second": dict(second.problem.title)},
        first.problem.notation,
    )


def _common(first: Study, second: Study) -> Assumptions:
    """What is declared of the quantities of both."""
    one, other = first.assumptions, second.assumptions
    return Assumptions({**other.signs, **one.signs}, {**other.ranges, **one.ranges})


def _order(pair: _Pair) -> None:
    """ϑ₁ < ϑ₂, proved for all values that the assumptions allow; of negative values their sizes."""
    values, known = pair.compared.values, pair.context.assumptions
    turned = all(sign(value, known).kind == "negative" for value in values)
    found = sign(values[0] - values[1] if turned else values[1] - values[0], known).kind
    op = {"positive": "<", "negative": ">", "zero": "=", "nonnegative": "<=", "nonpositive": ">="}.get(found)
    if op is None:
        return
    letters = [t.Sym(name) for name in pair.compared.names]
    step = Step(
        "order",
        "inequality",
        t.relation(*((t.neg(letters[0]), op, t.neg(letters[1])) if turned else (letters[0], op, letters[1]))),
        "comparison",
        f"comparison.order.{NAMES[op]}",
        {"sources": [StepRef("frequency.1"), StepRef("frequency.2")], "faster": _titles(pair, op)},
        ("frequency.1", "frequency.2"),
        STANDARD,
        True,
    )
    context = replace(pair.context, scalars=dict(zip(pair.compared.names, values, strict=True)))
    verdict = c.guarded(lambda: c.identity(context, step))
    checks = ("squares of positive numbers",) if pair.compared.power == 2 else (c.identity.__name__,)
    pair.steps.append(told(replace(step, certificate=Certificate(checks, verdict))))


NAMES = {"<": "less", ">": "greater", "=": "equal", "<=": "less", ">=": "greater"}


def _titles(pair: _Pair, op: str) -> dict:
    faster = pair.second if op in ("<", "<=") else pair.first
    return dict(faster.problem.title)


def _ratio(pair: _Pair) -> None:
    """(ϑ₂/ϑ₁)² = 1 + what makes the difference."""
    from rbpsym.algebra.present import present

    first, second = pair.compared.values
    if is_zero(second - first):
        return
    letters = pair.compared.letters()
    ratio, style = short(second / first), pair.first.style
    one_more = t.add(t.ONE, present(short(ratio - 1), style, factor=True))
    plain = present(ratio, style, factor=True)
    shown = one_more if pair.compared.of == "oscillation" else plain
    phrase = "comparison.ratio.squares" if pair.compared.power == 2 else "comparison.ratio.plain"
    pair.add("ratio", t.equation(t.Div(letters[1], letters[0]), shown), phrase)


def _moments(pair: _Pair) -> None:
    """Bodies of one name that differ in their moments of inertia."""
    from rbpsym.algebra.present import present

    for name in pair.first.system.bodies:
        other = pair.second.system.bodies.get(name)
        own = pair.first.system.bodies[name].moment
        if other is None or not own or not other.moment or is_zero(own - other.moment):
            continue
        names = [f"I_{name}_{k}" for k in (1, 2)]
        pair.context.scalars.update(zip(names, (own, other.moment), strict=True))
        rows = [
            t.equation(t.Sym(letter), present(value, study.style, factor=True))
            for letter, value, study in zip(names, (own, other.moment), (pair.first, pair.second), strict=True)
        ]
        pair.add(f"moments.{name}", t.System(tuple(rows)), "comparison.moments", body=BodyRef(name))


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
        pair.steps.append(told(replace(step, certificate=Certificate(("identity",), verdict))))


def _limit(pair: _Pair, part: CoursePart) -> None:
    """What both tend to when the parameter tends to zero (both are continuous there)."""
    from rbpsym.algebra.present import present

    known = {q.name for study in (pair.first, pair.second) for q in study.problem.parameters}
    if part.limit not in known:
        raise part.error("limit", f"no parameter is called “{part.limit}”", did_you_mean(part.limit, known))
    try:
        ends = [substitute(value, {part.limit: NOTHING}) for value in pair.compared.values]
    except ZeroDivisionError:
        what = f"what is compared has no limit where “{part.limit}” tends to zero"
        raise part.error("limit", what, "name another parameter, or leave the limit out.") from None
    rows = [
        t.equation(t.Limit(letter, part.limit, t.ZERO), present(end, pair.first.style, factor=True))
        for letter, end in zip(pair.compared.letters(), ends, strict=True)
    ]
    phrase = f"comparison.limit.{_limit_kind(pair, ends, part.limit)}"
    pair.add("limit", t.System(tuple(rows)), phrase, parameter=t.Sym(part.limit))


def _limit_kind(pair: _Pair, ends: list[Scalar], name: str) -> str:
    """Do both agree there, and because the moments of the bodies whose spins differ are gone?"""
    if not is_zero(ends[0] - ends[1]):
        return "differ"
    told = [step.id.rpartition(".")[2] for step in pair.steps if step.id.startswith("spin.")]
    states = [study.system.bodies[body] for body in told for study in (pair.first, pair.second)]
    gone = all(is_zero(substitute(state.moment, {name: NOTHING})) for state in states)
    return "agree_without_spin" if states and gone else "agree"

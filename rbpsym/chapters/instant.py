"""At the start: the rates of the conditions, the speeds, the second rates, Newton and Euler for each body, the solution.

For systems whose coordinates stay tied by conditions with formulas too long to be read for every position. Beer &
Johnston, Dynamics, 15.4 and 16.4; Meriam & Kraige, Dynamics, 5/6 and 6/5.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import Poly, Scalar, is_zero, lift, short, substitute, symbol_name, total
from rbpsym.mechanics.elimination import CONSTANT, linear_row
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.system import ConstraintCondition
from rbpsym.present.signs import positive_first
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL, STANDARD, BodyRef, Step, StepRef


def write(draft: Draft) -> None:
    """The chapter, for a study that tells the start alone."""
    draft.chapter = "instant"
    system, found = draft.study.system, draft.study.instant
    assert found is not None
    held = [_held(draft, condition) for condition in (*system.implicit, *system.speed_ties)]
    rates = _rates(draft, "rate", held, found.rates, found.sought, [])
    speeds = [_value(draft, "speed", name, found.speeds[name.removesuffix("_dot")], rates) for name in found.sought]
    seconds = _rates(draft, "second", held, found.seconds, system.accelerations, speeds)
    laws = [law for name in system.bodies for law in _laws(draft, name, speeds)]
    sources = [*seconds, *laws]
    for kind, names, values in (
        ("acceleration", system.accelerations, found.accelerations),
        ("force", system.unknowns, found.reactions),
    ):
        for name in names:
            _value(draft, kind, name, values[name], sources)


def at_start(node: t.Node) -> t.At:
    """The quantity at the start."""
    return t.At(node, t.equation(t.Sym("t"), t.ZERO))


def _held(draft: Draft, condition: ConstraintCondition) -> Step:
    """What the constraint asks of the coordinates (of the speeds, where it is no rate of a position)."""
    statement, factor = _stretched(draft, condition) or _vanishing(draft, condition)
    return draft.add(
        f"held.{condition.constraint}",
        "held",
        statement,
        "instant.held",
        level=FULL if draft.has(f"condition.{condition.constraint}") else STANDARD,
        force=t.Vec(condition.constraint),
        data={"constraint": condition.constraint, "factor": factor},
    )


def _vanishing(draft: Draft, condition: ConstraintCondition) -> tuple[t.Node, Scalar]:
    """(value = 0, by what the value is multiplied to give that of the condition)."""
    value, factor = _plain(draft, condition.value)
    shown = draft.show(value)
    return (t.equation(shown.arg, t.ZERO), -factor) if isinstance(shown, t.Neg) else (t.equation(shown, t.ZERO), factor)


def _stretched(draft: Draft, condition: ConstraintCondition) -> tuple[t.Node, Scalar] | None:
    """The same of a straight string: x² + y² between its ends as it is at the start."""
    system = draft.study.system
    path = system.element(condition.constraint).values.get("path", ())
    if len(path) != 2:
        return None
    first, second = (geometry_of(system).where(turn.center) for turn in path)
    parts = [part for part in ((second - first).x, (second - first).y) if part]
    square = total(part * part for part in parts)
    length = substitute(square, system.scope.start)
    factor = next((f for f in STRETCHES if is_zero((square - length) * f - condition.value)), None)
    if factor is None:
        return None
    return t.equation(t.add(*(t.Pow(draft.show(part), t.TWO) for part in parts)), draft.show(length)), factor


STRETCHES = tuple(lift(Fraction(*parts)) for parts in ((-1, 2), (1, 2), (1, 1), (-1, 1)))


def _plain(draft: Draft, value: Scalar) -> tuple[Scalar, Scalar]:
    """(the value without a positive constant that all its terms have as a factor, this factor)."""
    rational, powers = value.num.content()
    constant = tuple((i, e) for i, e in powers if draft.study.assumptions.sign_of(symbol_name(i) or "") == "positive")
    factor = Scalar(Poly({constant: rational}))
    return value / factor, factor


def _rates(
    draft: Draft, kind: str, held: list[Step], rows: tuple[ConstraintCondition, ...], names: tuple[str, ...], speeds: list[Step]
) -> list[Step]:
    """The first or second rate of each condition at the start; none where it says nothing."""
    found, places = [], len(draft.study.system.implicit)
    for number, (step, row) in enumerate(zip(held, rows, strict=False)):
        if is_zero(row.value):
            continue
        value, factor = _plain(draft, row.value)
        told = f"condition.{row.constraint}"
        order = ORDERS[kind] - (number >= places)
        statement = _equation(draft, value, names)
        if isinstance(statement.items[0], t.Neg):
            statement, factor = _equation(draft, -value, names), -factor
        found.append(
            draft.add(
                f"instant.{kind}.{row.constraint}",
                "start_rate",
                statement,
                f"instant.{kind}",
                premises=[step.id, *(other.id for other in speeds)],
                condition=StepRef(told if draft.has(told) else step.id),
                data={"of": step.id, "order": order, "factor": factor / step.data["factor"]},
            )
        )
    return found


ORDERS = {"rate": 1, "second": 2}


def _equation(draft: Draft, value: Scalar, names: tuple[str, ...], forces: tuple[str, ...] = ()) -> t.Chain:
    """value = 0 with these names on the left, at the start, and the forces and the rest on the right."""
    row = linear_row(value, (*names, *forces))
    left = [_term(draft, row[name], name) for name in names if name in row]
    right = [_term(draft, -row[name], name) for name in forces if name in row]
    rest = short(-row[CONSTANT])
    right += [draft.show(rest)] if rest else []
    if not left:
        return t.equation(t.add(*positive_first(right)), t.ZERO)
    return t.equation(t.add(*positive_first(left)), t.add(*positive_first(right)))


def _term(draft: Draft, coefficient: Scalar, name: str) -> t.Node:
    return t.mul(draft.show(coefficient, factor=True), at_start(t.Sym(name)))


def _laws(draft: Draft, body: str, speeds: list[Step]) -> list[Step]:
    """M a = F (x and y), and I α = τ_cm, of one body with the values of the start put in."""
    study: Any = draft.study  # of the start alone
    system, steps = study.system, []
    for part, rows in (("force", ("x", "y")), ("torque", ("rotation",))):
        values = [v for name, axis, v in draft.study.labelled_rows if name == body and axis in rows]
        shown = [study.tidied(substitute(value, system.scope.start)) for value in values]
        statements = [_equation(draft, value, system.accelerations, system.unknowns) for value in shown if value]
        if statements:
            steps.append(
                draft.add(
                    f"instant.{part}.{body}",
                    "start_law",
                    t.system(statements),
                    f"instant.{part}",
                    premises=[f"law.{part}.{body}", *draft.those(f"moment.{body}")[: part == "torque"], *(s.id for s in speeds)],
                    body=BodyRef(body),
                    data={"law": f"law.{part}.{body}"},
                )
            )
    return steps


def _value(draft: Draft, kind: str, name: str, value: Scalar, sources: list[Step]) -> Step:
    return draft.add(
        f"instant.{kind}.{name}",
        "solution",
        t.equation(at_start(t.Sym(name)), draft.show(value, factor=True) if not is_zero(value) else t.ZERO),
        f"instant.{kind}_found",
        premises=[step.id for step in sources],
        is_result=True,
        quantity=t.Sym(name),
    )

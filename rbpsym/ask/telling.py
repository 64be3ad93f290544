"""Answers told: as a record for programs, and their numbers in lines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Answer
from rbpsym.ask.integrated import HOW, integrated
from rbpsym.ask.numbers import GivenNumbers, bracket, rounded, unit_for, unmet, value_at
from rbpsym.ask.question import Question
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import NOTHING, depends_on, derivative, names_in, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.sympy_bridge import plain_names
from rbpsym.frozen import replace
from rbpsym.proof.step import Step
from rbpsym.statement.units import unit_text
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.machine import machine_name, to_machine


def record(found: Answer, given: GivenNumbers | None = None) -> dict[str, Any]:
    """The answer as keys of JSON: question, answer (text for sympy, a vector as "(x, y)"), latex, verdict, valid_where, steps,
    symbols; with numbers their value and unit, or a table of them over a range."""
    notation = Notation(found.study.problem.notation)
    given = given and given.beside(found.study.problem, found.given)
    names = sorted({name for node in (*found.nodes, *found.valid) for name in t.names(node)} - {"pi"})
    return {
        "question": found.question.text,
        **({"read_as": found.read_as} if found.read_as else {}),
        **({"given": dict(found.given)} if found.given else {}),
        "answer": _answer(found),
        "latex": latex_of(found) or None,
        **(_of_parameter(found) if is_of_parameter(found) else {}),
        "verdict": str(found.verdict.kind),
        "reason": found.verdict.reason or None,
        "function_of": found.holds or None,
        "valid_for": valid_for(found) or None,
        "valid_where": [to_machine(node) for node in found.valid],
        "steps": [_step(step, notation) for step in found.steps],
        "symbols": {name: {"sympy": plain} for name, plain in plain_names(map(machine_name, names)).items()},
        **(numbers(found, given) if given and is_number(found, given) else {}),
    }


def valid_for(found: Answer) -> str:
    """For what an answer holds that rests on a relation that only holds nearly, as the motion is not linear, or on speeds that
    are taken to be kept; else nothing."""
    ops = {op for step in found.steps for _, op, _ in t.relations(step.statement)}
    rates = found.study.system.scope.rates if "~" in ops else {}
    pulls = (found.study.dynamics.accelerations or {}).values() if rates else ()
    is_linear = not any(depends_on(derivative(pull, name), other) for pull in pulls for name in rates for other in rates)
    speeds = f"kept speeds: {', '.join(map(to_machine, found.kept))}" if found.kept else ""
    return speeds if is_linear else "small oscillations"


YES_OR_NO = re.compile(r"(yes|no) where this is met(, else (?:yes|no))?")


def is_number(found: Answer, given: GivenNumbers) -> bool:
    """Does it have a value at these numbers: not a function of a place that has none of them, not a mere sentence?"""
    moving = {"t", *found.study.system.scope.rates, *(c.name for c in found.study.problem.coordinates)} - given.values.keys()
    is_function = bool(found.holds) and any(names_in(value) & moving for value in found.values)
    return not is_function and bool(found.values or found.equation or YES_OR_NO.match(found.says))


def is_of_parameter(found: Answer) -> bool:
    """Is it more than a plain value?"""
    return bool(found.symbol or found.says or found.at) or found.relation != "="


def _answer(found: Answer) -> str | None:
    """A value, a relation, several values, True or False; None for a mere sentence."""
    if found.holds_so is not None:
        return str(found.holds_so)
    if found.relation in ("<", ">", "<=", ">="):
        return f"{machine_name(found.symbol)} {found.relation} {found.text}" if found.values else None
    return found.text if found.values else None


def _of_parameter(found: Answer) -> dict[str, Any]:
    each = [[to_machine(node) for node in nodes] for nodes in found.each]
    return {
        "symbol": found.symbol or None,
        "relation": found.relation,
        "says": found.says or None,
        "each_valid_where": each or None,
        "vanishes_there": None if found.equation is None else to_machine(found.equation),
        "at": None if found.at is None else {found.at[0]: to_machine(found.at[1])},
    }


def record_integrated(asked: Asked, question: Question, given: GivenNumbers) -> dict[str, Any]:
    """The record of what has no closed form: its value alone."""
    rows = [integrated(asked, question, row) for row in given.rows()]
    values = [value[0] if len(value) == 1 else list(value) for value, _ in rows]
    return {**unanswered(question.text, HOW), **_valued(given, values, unit_for(rows[0][1], asked.first, question.quantity))}


def unanswered(question: str, reason: str) -> dict[str, Any]:
    """The record of a question without an answer, and why there is none."""
    told = {"question": question, "answer": None, "latex": None, "verdict": "UNDECIDED", "reason": reason}
    return {**told, "function_of": None, "valid_for": None, "valid_where": [], "steps": [], "symbols": {}}


def latex_of(found: Answer) -> str:
    """The value in LaTeX; several, as of a vector, in brackets."""
    latex = [to_latex(node, Notation(found.study.problem.notation)) for node in found.nodes]
    return rf"\left({', '.join(latex)}\right)" if len(latex) > 1 else "".join(latex)


def _step(step: Step, notation: Notation) -> dict[str, str]:
    verdict = step.certificate.verdict
    return {"id": step.id, "latex": to_latex(step.statement, notation), "verdict": str(verdict.kind)}


def numbers(found: Answer, given: GivenNumbers) -> dict[str, Any]:
    """value and unit, or the table over the names of a range."""
    values = [_at(found, row) for row in given.rows()]
    return _valued(given, [row[0] if len(row) == 1 else row for row in values], unit_of_answer(found))


def _valued(given: GivenNumbers, values: list[Any], unit: str) -> dict[str, Any]:
    if len(values) == 1:
        return {"value": values[0], "unit": unit}
    places = [{name: row[name] for name in given.ranges} for row in given.rows()]
    return {"table": [{**place, "value": value} for place, value in zip(places, values, strict=True)], "unit": unit}


def _at(found: Answer, row: Mapping[str, float]) -> list[float]:
    """The values at some numbers, those of several whose own conditions are met there; yes or no; what has no closed form
    between two numbers close to each other."""
    if said := YES_OR_NO.match(found.says):
        is_met = unmet(found.study, found.valid, row, wholly=True) is None
        if not is_met and said[2] is None:
            value_at(found.study, (), found.valid, row)
        return [is_met == (said[1] == "yes")]
    if found.each:
        kept = [v for v, own in zip(found.values, found.each, strict=True) if unmet(found.study, own, row) is None]
        found = replace(found, values=tuple(kept)) if kept else replace(found, valid=(*found.valid, *found.each[0]))
    if found.equation is None or found.values:
        return value_at(found.study, found.values, found.valid, row)
    equation = scalar(found.equation, found.study.system.scope)
    value_at(found.study, [substitute(equation, {found.symbol: NOTHING})], found.valid, row)  # a missing number is told
    ends = bracket(equation, found.symbol, found.study.assumptions, row)
    if ends is None:
        raise StatementError(f"no {found.symbol} is found in its range at these numbers", instead="change a number.")
    return [float(sum(ends) / 2)]


def unit_of_answer(found: Answer) -> str:
    """The unit of the value: that of its dimension, rad for a coordinate that is an angle."""
    node = next((node for node in found.nodes if node != t.ZERO), t.Sym(found.symbol) if found.symbol else t.ZERO)
    return unit_for(node, found.study, found.symbol or found.question.text, is_angle=found.is_angle)


def numbered(record: Mapping[str, Any], given: GivenNumbers) -> Iterator[str]:
    """The value of a record with its unit; a line each over a range."""
    for row in record.get("table", [record]):
        values = row["value"] if isinstance(row["value"], list) else [row["value"]]
        place = ", ".join(f"{name} = {rounded(row[name], given.digits)}" for name in given.ranges)
        told = ", ".join(["no", "yes"][value] if isinstance(value, bool) else rounded(value, given.digits) for value in values)
        told = told if len(values) == 1 else f"({told})"
        yield f"{f'{place}: ' if place else ''}{told} {unit_text(record['unit'])}".rstrip()

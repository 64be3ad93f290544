"""Answers told: as a record for programs, and their numbers in lines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.present import present
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.sympy_bridge import plain_names
from rbpsym.ask.answer import Answer
from rbpsym.ask.brackets import bracket
from rbpsym.ask.numbers import Given, rounded, unit_for, value_at
from rbpsym.derivation.step import Step
from rbpsym.errors import StatementError
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.latex import to_latex
from rbpsym.notation.machine import machine_name, to_machine


def record(found: Answer, given: Given | None = None) -> dict[str, Any]:
    """The answer as keys of JSON: question, answer (text for sympy, a vector as "(x, y)"), latex, verdict, valid_where, steps,
    symbols; with numbers their value and unit, or a table of them over a range."""
    study, notation = found.study, Notation(found.study.problem.notation)
    texts = [_machine(value, study) for value in found.values]
    latex = [to_latex(node, notation) for node in found.nodes]
    names = sorted({name for node in (*found.nodes, *found.valid) for name in t.names(node)} - {"pi"})
    return {
        "question": found.question.text,
        "answer": _answer(found, texts),
        "latex": latex[0] if len(latex) == 1 else rf"\left({', '.join(latex)}\right)" if latex else None,
        **(_of_parameter(found) if is_of_parameter(found) else {}),
        "verdict": str(found.verdict.kind),
        "reason": found.verdict.reason or None,
        "function_of": found.holds or None,
        "valid_where": [to_machine(node) for node in found.valid],
        "steps": [_step(step, notation) for step in found.steps],
        "symbols": {name: {"sympy": plain} for name, plain in plain_names(map(machine_name, names)).items()},
        **(_numbers(found, given) if given else {}),
    }


def is_of_parameter(found: Answer) -> bool:
    """Is it more than a plain value?"""
    return bool(found.symbol or found.says or found.at) or found.relation != "="


def _answer(found: Answer, texts: list[str]) -> str | None:
    """A value, a relation, several values, True or False; None for a mere sentence."""
    if found.holds_so is not None:
        return str(found.holds_so)
    if found.relation in ("<", ">", "<=", ">="):
        return f"{machine_name(found.symbol)} {found.relation} {texts[0]}" if texts else None
    return _joined(texts) if texts else None


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


def _step(step: Step, notation: Notation) -> dict[str, str]:
    verdict = step.certificate.verdict
    return {"id": step.id, "latex": to_latex(step.statement, notation), "verdict": str(verdict.kind)}


def _machine(value: Scalar, study: Study) -> str:
    return to_machine(present(value, replace(study.style, tangents=False)))


def _joined(texts: list[str]) -> str:
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def _numbers(found: Answer, given: Given) -> dict[str, Any]:
    """value and unit, or the table over the names of a range."""
    rows, unit = given.rows(), unit_of_answer(found)
    values = [_at(found, row) for row in rows]
    plain = [row[0] if len(row) == 1 else row for row in values]
    if len(rows) == 1:
        return {"value": plain[0], "unit": unit}
    places = [{name: row[name] for name in given.ranges} for row in rows]
    return {"table": [{**place, "value": value} for place, value in zip(places, plain, strict=True)], "unit": unit}


def _at(found: Answer, row: Mapping[str, float]) -> list[float]:
    """The values at some numbers; what has no closed form between two numbers close to each other."""
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
    return unit_for(node, found.study, is_angle=found.is_angle)


def numbered(found: Answer, given: Given) -> Iterator[str]:
    """The value at the numbers, with its unit; a line each over a range."""
    unit = unit_of_answer(found)
    for row in given.rows():
        values = _at(found, row)
        place = ", ".join(f"{name} = {rounded(row[name], given.digits)}" for name in given.ranges)
        told = _joined([rounded(value, given.digits) for value in values])
        yield f"{f'{place}: ' if place else ''}{told} {unit.replace('*', '·')}".rstrip()

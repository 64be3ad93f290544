"""How the textbook tests are stated: a system as TOML text, and what a textbook says of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from typing import Any

from rbpsym.derive import derive
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.field.scalar import Scalar
from rbpsym.proof.step import Derivation
from rbpsym.solve import results
from rbpsym.statement.loader import load_problem


@dataclass(frozen=True)
class Textbook:
    """A system, and its known results by their path in the answer of `rbpsym solve`."""

    name: str
    text: str
    results: dict[str, str] = field(hash=False)
    stable: tuple[bool | None, ...] | None = None


@cache
def derivation(text: str) -> Derivation:
    """The whole derivation of a problem, with both oracles."""
    return derive(load_problem(text.lstrip() + "\n"))


@cache
def answer(text: str) -> dict[str, Any]:
    """The results of a problem as `rbpsym solve` gives them."""
    return results(derivation(text).study)


def at(found: Any, path: str) -> str:
    """The part of an answer under a path such as equilibria/0/at/theta."""
    for key in path.split("/"):
        found = found[int(key)] if isinstance(found, list) else found[key]
    return found


def names(text: str) -> set[str]:
    """Every name that an answer or an expectation about the problem may use."""
    study = derivation(text).study
    problem, moving = study.problem, [c.name for c in study.problem.coordinates]
    own = {*(q.name for q in problem.parameters), *problem.implicit, *study.system.unknowns, *moving, "t"}
    return own | {f"{n}_dot" for n in moving} | {f"{n}_ddot" for n in moving} | {f"d_{n}" for n in moving}


def read(text: str, expression: str) -> Scalar:
    """The value of an expression in the names of a problem."""
    return scalar(read_infix(expression, names(text)))


def differences(system: Textbook) -> list[str]:
    """What the engine and the textbook do not agree on."""
    found, wrong = answer(system.text), []
    for path, expected in system.results.items():
        value = at(found, path)
        if value is None or not same(read(system.text, value), read(system.text, expected)):
            wrong.append(f"{path}: {value}, not {expected}")
    stable = tuple(item["stable"] for item in found["equilibria"])
    if system.stable is not None and stable != system.stable:
        wrong.append(f"stable: {stable}, not {system.stable}")
    return wrong


def complaints(text: str) -> list[str]:
    """What is not as it must be in a derivation: a step not proved, a road that does not agree."""
    found = derivation(text)
    verdicts = found.summary()
    wrong = [f"{s.id}: {s.certificate.verdict}" for s in found.steps if not s.certificate.verdict.is_proved]
    if not verdicts["methods_agree"]:
        wrong.append(f"methods: {verdicts['methods']}")
    if verdicts["lagrange"] != "PROVED":
        wrong.append(f"Lagrange: {found.lagrange}")
    if found.simulation is None or not found.simulation.max_relative_error <= 1e-8:
        wrong.append(f"simulation: {found.simulation}")
    return wrong

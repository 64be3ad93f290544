"""Derivations that are kept while a process watches files: only what an edit changes is derived anew."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from rbpsym.derivation.step import Derivation
from rbpsym.derive import derive
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem

# What only the words and the drawing of a problem depend on.
WORDS: Mapping[str, object] = {
    "title": {}, "source": "", "notation": {}, "meanings": {}, "claims": (), "level": "", "topic": "", "example": {},
}  # fmt: skip


@dataclass(frozen=True)
class Kept:
    """The derivations of files, by path."""

    simulation: bool
    found: dict[Path, Derivation] = field(default_factory=dict)

    def derivation(self, path: Path) -> Derivation:
        """The derivation of a problem file as it is now. Raises what loading and deriving raise."""
        problem, before = load_problem(path), self.found.get(path)
        known = before is not None and core(before.study.problem) == core(problem)
        self.found[path] = reworded(before, problem) if known else derive(problem, simulation=self.simulation)
        return self.found[path]


def core(problem: Problem) -> Problem:
    """What the derivation depends on: the problem without its words."""
    return replace(problem, **WORDS, parameters=tuple(replace(q, meaning="") for q in problem.parameters))


def reworded(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation of a problem of which only the words have changed: all that was worked out is taken over."""
    study = Study(problem)
    worked_out = {name: value for name, value in vars(derivation.study).items() if name != "problem"}
    worked_out["system"] = replace(derivation.study.system, problem=problem)
    vars(study).update(worked_out)
    return replace(derivation, study=study)

"""The world of a setting: a theory, or a problem of the library or beside the claims file."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from rbpsym.errors import ReadError, StatementError
from rbpsym.statement.source import did_you_mean
from rbpsym.verify.claims_bound import World
from rbpsym.verify.claims_model import Setting

THEORIES = ("plane-motion",)


@dataclass(frozen=True)
class Worlds:
    """Worlds by name, each made once; `folder` is that of the claims file."""

    folder: Path = Path()
    problems: dict[str, World] = field(default_factory=dict)
    theories: dict[bool, World] = field(default_factory=dict)

    def __call__(self, setting: Setting) -> World:
        """The world of a setting. Raises ReadError or StatementError."""
        if setting.problem:
            return phase_of(self.problem(setting.problem, setting), setting)
        if setting.theory not in THEORIES:
            raise StatementError(
                f"unknown theory “{setting.theory}”", instead=f"known: {', '.join(THEORIES)}.", place=setting.place
            )
        if setting.fixed_axis not in self.theories:
            from rbpsym.verify.claims_theory import TheoryWorld

            self.theories[setting.fixed_axis] = TheoryWorld(setting.fixed_axis)
        return self.theories[setting.fixed_axis]

    def problem(self, name: str, setting: Setting | None = None) -> World:
        """A problem by its name in the library or the path of its file, from the claims file's folder."""
        if name not in self.problems:
            from rbpsym.mechanics.study import Study
            from rbpsym.statement.loader import load_problem
            from rbpsym.verify.claims_problem import ProblemWorld

            path = problem_path(name, self.folder, setting)
            self.problems[name] = ProblemWorld(Study(load_problem(path)), self.problem)
        return self.problems[name]


def phase_of(world: World, setting: Setting) -> World:
    """The world of the phase of a setting; the whole problem's if it names none. Raises StatementError."""
    if not setting.phase:
        return world
    names = [stage.name for stage in world.stages]
    if setting.phase not in names:
        hint = did_you_mean(setting.phase, names, "phases")
        raise StatementError(f"there is no phase “{setting.phase}”", instead=hint, place=setting.place)
    return world.phase(names.index(setting.phase))


def problem_path(name: str, folder: Path, setting: Setting | None = None) -> Path:
    """The file of a problem. Raises ReadError told at the setting."""
    from rbpsym.statement.library import find_problem

    beside = folder / name
    try:
        return beside if name.endswith(".toml") and beside.is_file() else find_problem(name)
    except ReadError as error:
        raise ReadError(error.what, instead=error.instead, place=setting.place if setting else None) from None

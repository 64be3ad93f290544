"""A run over claims files and papers: the worlds of their settings, and the certificates of earlier runs."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from rbpsym.errors import RbpsymError, ReadError, StatementError
from rbpsym.statement.source import did_you_mean
from rbpsym.verify.claims_bound import World
from rbpsym.verify.claims_cache import Certificates, as_told, key_of
from rbpsym.verify.claims_check import Checker
from rbpsym.verify.claims_model import Claim, ClaimsFile, Printed, Result, Setting

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


@dataclass(frozen=True)
class Remembering(Checker):
    """A checker that asks the certificates first."""

    cache: Certificates = field(default_factory=lambda: Certificates(None))
    folder: Path = Path()

    def check(self, claim: Claim, printed: Printed | None = None) -> Result:
        """The result, remembered or found now."""
        key = self._key(claim, printed)
        known = self.cache.get(key) if key else None
        if known is not None:
            return as_told(known, claim)
        found = super().check(claim, printed)
        self.cache.put(key, found)
        return found

    def _key(self, claim: Claim, printed: Printed | None) -> str:
        if self.cache.folder is None:
            return ""
        try:
            return key_of(claim, printed, self._problems(claim.setting), self.cache.engine)
        except (RbpsymError, OSError):
            return ""

    def _problems(self, setting: Setting) -> bytes:
        """The content of the problem and of others that a phrase names."""
        if not setting.problem:
            return b""
        phrases = (re.fullmatch(r".+ in ([\w./-]+)", meaning.phrase) for meaning in setting.symbols.values())
        names = [setting.problem, *sorted({found[1] for found in phrases if found})]
        return b"\0".join(problem_path(name, self.folder).read_bytes() for name in names)


def checker(file: ClaimsFile, cache: Certificates) -> Remembering:
    """The checker of a claims file."""
    folder = Path(file.file).parent
    return Remembering(Worlds(folder), _diagnosed, draws=cache.draws, cache=cache, folder=folder)


def _diagnosed(relation, claim: Claim, ground) -> str:
    from rbpsym.verify.diagnosis import diagnosis

    return diagnosis(relation, claim, ground)


def check_claims(
    file: ClaimsFile, cache: Certificates, progress: Callable[[str], None] = lambda name: None
) -> Iterator[Result]:
    """The results of all claims of a file."""
    own = checker(file, cache)
    for claim in file.claims:
        progress(claim.id)
        yield own.check_safely(claim)


def check_paper(path: Path, files: Iterable[ClaimsFile], cache: Certificates) -> tuple[list[Result], list[Result]]:
    """(the results of a paper in its order, remarks on its labels as results)."""
    from rbpsym.verify.paper_check import PaperChecker, Scope, bound
    from rbpsym.verify.paper_walk import read_paper

    paper, files = read_paper(path), list(files)
    own = {file.file: checker(file, cache) for file in files}
    checkers = {claim.id: own[file.file] for file in files for claim in file.claims}
    claims = [claim for file in files for claim in file.claims]
    for file in files:
        if file.setting is not None:
            own[file.file].world(file.setting)  # a problem that can't be read is no matter of one formula
    scopes = tuple(Scope(file, own[file.file]) for file in files)
    found = list(PaperChecker(paper, checkers, scopes).results(bound(paper, claims)))
    return found, list(paper.remarks)


def names_of_problem(path: Path) -> ClaimsFile:
    """A problem without claims: its own names are what the printed symbols mean."""
    return ClaimsFile(path.stem, "", "", "", (), str(path), setting=Setting(path.stem, problem=str(path.resolve())))

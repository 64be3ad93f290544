"""A run over claims files and papers: the worlds of their settings, and the certificates of earlier runs.

Certificates are keyed by the content of all they depend on: a key is the digest of the engine's own source, of the
problem's file, and of the claim (formula, meanings, what is given). Nothing is taken over from a run that saw anything else.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict
from hashlib import blake2b
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rbpsym.claims.check import MOST_REPAIR, Checker, Neighbours, unread
from rbpsym.claims.ground import Ground
from rbpsym.claims.model import Claim, ClaimsFile, Link, Outcome, Printed, Result, Setting, told_of
from rbpsym.errors import RbpsymError, ReadError, StatementError, WorkSpent
from rbpsym.expr.tree import Chain, Node
from rbpsym.field import granted
from rbpsym.frozen import Frozen, field, replace
from rbpsym.quantity.bound import World

if TYPE_CHECKING:
    from rbpsym.claims.diagnosis import Diagnosis
    from rbpsym.quantity.problem import ProblemWorld

MOST = 20_000
MOST_WORK = 200_000_000  # products of terms for a formula: a limit that is the same on every machine
NAME = "certificates.json"
Entry = dict[str, Any]  # a result as JSON
_PACKAGE = Path(__file__).resolve().parent.parent


def default_folder() -> Path:
    """The folder of the user's caches."""
    root = os.environ.get("XDG_CACHE_HOME")
    return (Path(root) if root else Path.home() / ".cache") / "rbpsym"


def digest(*parts: str | bytes) -> str:
    """The digest of some texts."""
    whole = blake2b(digest_size=16)
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        whole.update(len(data).to_bytes(8) + data)
    return whole.hexdigest()


def engine() -> str:
    """The digest of the engine: any change of its source makes all certificates void."""
    return digest(*(part for path in sorted(_PACKAGE.rglob("*.py")) for part in (path.name, path.read_bytes())))


class Certificates(Frozen):
    """The certificates of a folder; `store` writes them back whole. notary: is told of each formula that is proved, and
    gives what stands in its result for what a prover says."""

    folder: Path | None
    engine: str = ""
    draws: bool = False
    entries: dict[str, Entry] = field(default_factory=dict)
    new: list[str] = field(default_factory=list)
    notary: Callable[[Ground, Node, str], str] | None = None

    @classmethod
    def opened(
        cls, folder: Path | None, draws: bool = False, notary: Callable[[Ground, Node, str], str] | None = None
    ) -> Certificates:
        """The certificates of a folder; None remembers nothing. `draws`: formulas in MathML are wanted."""
        if folder is None:
            return cls(None, draws=draws, notary=notary)
        return cls(folder, engine(), draws, _loaded(folder / NAME), notary=notary)

    def get(self, key: str) -> Result | None:
        """The result under a key."""
        entry = self.entries.get(key)
        try:
            found = None if entry is None else _result(entry)
        except (KeyError, TypeError, ValueError):
            return None
        drawn = found is None or not self.draws or all(link.mathml for link in found.links)
        return found if drawn else None

    def put(self, key: str, result: Result) -> None:
        """Remember a result."""
        if self.folder is not None and key:
            self.entries[key] = _entry(result)
            self.new.append(key)

    def store(self) -> None:
        """Write the certificates back, the newest if they are too many; a folder that can't be written is no error."""
        if self.folder is None or not self.new:
            return
        kept = dict(list(self.entries.items())[-MOST:])
        target = self.folder / NAME
        waiting = target.with_suffix(f".{os.getpid()}.part")
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            waiting.write_text(json.dumps(kept, ensure_ascii=False), encoding="utf-8")
            waiting.replace(target)
        except OSError:
            with suppress(OSError):
                waiting.unlink(missing_ok=True)


def _loaded(path: Path) -> dict[str, Entry]:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _entry(result: Result) -> Entry:
    kept = asdict(result)
    for key in ("cached", "seconds", "declared", "rocq"):
        kept.pop(key)
    return kept


def _result(entry: Entry) -> Result:
    links = tuple(Link(**{**link, "outcome": Outcome(link["outcome"])}) for link in entry["links"])
    return Result(**{**entry, "outcome": Outcome(entry["outcome"]), "links": links, "cached": True})


def key_of(claim: Claim, printed: Printed | None, problem: bytes, made_by: str) -> str:
    """The key of a claim; "" for one that depends on what another claim defines."""
    setting, formula = claim.setting, printed or claim.printed
    if formula is None or not made_by or _uses_definition(setting, formula.latex):
        return ""
    where = (setting.theory, setting.phase, str(setting.fixed_axis), *_symbols(setting))
    right = claim.right.latex if claim.right else ""
    return digest(made_by, problem, *where, formula.latex, claim.holds, claim.expect, right, claim.not_computed)


def _symbols(setting: Setting) -> Iterable[str]:
    for latex, meaning in sorted(setting.symbols.items()):
        yield from (latex, meaning.phrase)
    yield from (given.latex for given in setting.given)


def _uses_definition(setting: Setting, latex: str) -> bool:
    plain = "".join(latex.split())
    defined = (name for name, meaning in setting.symbols.items() if meaning.phrase.strip() == "defined here")
    return any("".join(name.split()) in plain for name in defined)


THEORIES = ("plane-motion",)


class Worlds(Frozen):
    """Worlds by name, each made once; `folder` is that of the claims file. `closed`: no file outside it is read."""

    folder: Path = Path()
    problems: dict[str, ProblemWorld] = field(default_factory=dict)
    theories: dict[bool, World] = field(default_factory=dict)
    closed: bool = False

    def __call__(self, setting: Setting) -> World:
        """The world of a setting. Raises ReadError or StatementError."""
        if setting.problem:
            return phase_of(self.problem(setting.problem, setting), setting)
        if setting.theory not in THEORIES:
            raise StatementError(
                f"unknown theory “{setting.theory}”", instead=f"known: {', '.join(THEORIES)}.", place=setting.place
            )
        if setting.fixed_axis not in self.theories:
            from rbpsym.claims.theory import TheoryWorld

            self.theories[setting.fixed_axis] = TheoryWorld(setting.fixed_axis)
        return self.theories[setting.fixed_axis]

    def problem(self, name: str, setting: Setting | None = None) -> ProblemWorld:
        """A problem by its name in the library or the path of its file, from the claims file's folder."""
        if name not in self.problems:
            from rbpsym.ask.asking import meant_by
            from rbpsym.mechanics.at_start import study_of
            from rbpsym.quantity.problem import ProblemWorld
            from rbpsym.statement.loader import load_problem

            path = problem_path(name, self.folder, setting)
            if self.closed:
                check_closed(path, self.folder)
            self.problems[name] = ProblemWorld(study_of(load_problem(path)), self.problem, meant_by)
        return self.problems[name]


def phase_of(world: ProblemWorld, setting: Setting) -> ProblemWorld:
    """The world of the phase of a setting; the whole problem's if it names none. Raises StatementError."""
    if not setting.phase:
        return world
    try:
        return world.phase(world.named(setting.phase))
    except StatementError as error:
        raise StatementError(error.what, instead=error.instead, place=setting.place) from None


def problem_path(name: str, folder: Path, setting: Setting | None = None) -> Path:
    """The file of a problem. Raises ReadError told at the setting."""
    from rbpsym.statement.library import find_problem

    try:
        return find_problem(name, folder)
    except ReadError as error:
        raise ReadError(error.what, instead=error.instead, place=setting.place if setting else None) from None


def check_closed(path: Path, folder: Path) -> None:
    """Raises ReadError for the file of a problem that neither ships nor lies in the folder."""
    from rbpsym.statement.library import problem_files

    if path not in problem_files().values() and not path.resolve().is_relative_to(folder.resolve()):
        raise ReadError(f"“{path.name}” is outside the folder of the text")


class Remembering(Checker):
    """A checker that asks the certificates first."""

    cache: Certificates = field(default_factory=lambda: Certificates(None))
    folder: Path = Path()
    contents: dict[str, bytes] = field(default_factory=dict)

    def check(self, claim: Claim, printed: Printed | None = None) -> Result:
        """The result, remembered or found now."""
        key = self._key(claim, printed)
        known = self.cache.get(key) if key else None
        if known is not None:
            return self._filed(replace(known, **told_of(claim)), claim, printed)
        try:
            with granted(MOST_WORK):
                found = super().check(claim, printed)
        except WorkSpent as error:
            return replace(unread(claim, error.what), outcome=Outcome.UNDECIDED)
        self.cache.put(key, found)
        return self._filed(found, claim, printed)

    def _filed(self, found: Result, claim: Claim, printed: Printed | None) -> Result:
        if self.cache.notary is None or found.outcome is not Outcome.PROVED:
            return found
        node, ground = self.opened(claim, printed or claim.printed)
        return replace(found, rocq=self.cache.notary(ground, node, found.latex))

    def look_at(self, setting: Setting) -> None:
        """Raises ReadError or StatementError where the problem of a setting can't be read; one that could be is remembered."""
        parts: tuple[str | bytes, ...] = ()
        with suppress(RbpsymError, OSError):
            parts = (self._problems(setting), setting.theory, setting.phase)
        if setting.problem and isinstance(self.world, Worlds) and self.world.closed:
            check_closed(problem_path(setting.problem, self.folder, setting), self.folder)
        key = digest(self.cache.engine, "read", *parts) if parts and self.cache.folder else ""
        if not key or self.cache.get(key) is None:
            self.world(setting)
            self.cache.put(key, Result("read", "", "", 0, "", "", Outcome.DEFINITION, True))

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
        for name in names:
            if name not in self.contents:
                self.contents[name] = problem_path(name, self.folder).read_bytes()
        return b"\0".join(self.contents[name] for name in names)


def checker(file: ClaimsFile, cache: Certificates) -> Remembering:
    """The checker of a claims file."""
    folder = Path(file.file).parent
    return Remembering(Worlds(folder), _diagnosed, draws=cache.draws, cache=cache, folder=folder)


def _diagnosed(relation: Chain, claim: Claim, ground: Ground, near: Neighbours) -> Diagnosis:
    from rbpsym.claims.diagnosis import Diagnosis, diagnosis

    try:
        with granted(MOST_REPAIR):
            return diagnosis(relation, claim, ground, near)
    except WorkSpent:
        return Diagnosis()


def check_claims(file: ClaimsFile, cache: Certificates) -> Iterator[Result]:
    """The results of all claims of a file."""
    return map(checker(file, cache).check_safely, file.claims)


def check_paper(
    path: Path, files: Iterable[ClaimsFile], cache: Certificates, *, everything: bool = False
) -> tuple[list[Result], list[tuple[str, int, str]]]:
    """(the results of a paper in its order, remarks on it: file, line, what is to be said).

    The claims are those of the files and those beside the formulas; `everything`: formulas without a claim are
    judged too, in the setting in force where they stand.
    """
    from rbpsym.claims.papers.check import OpenClaims, PaperChecker, bound
    from rbpsym.claims.papers.claims import beside
    from rbpsym.claims.papers.walk import read_paper

    paper, files, folder = read_paper(path), list(files), path.resolve().parent
    own = {file.file: checker(file, cache) for file in files}
    here = Remembering(Worlds(folder, closed=True), _diagnosed, draws=cache.draws, cache=cache, folder=folder)
    said = beside(paper, folder)
    checkers: dict[str, Checker] = {claim.id: own[file.file] for file in files for claim in file.claims}
    checkers |= {claim.id: here for _, claim in said.pairs}
    claims = [claim for file in files for claim in file.claims]
    known = [(own[file.file], file.setting) for file in files] + [(here, scope.setting) for scope in said.scopes]
    for one, setting in known:
        if setting is not None:
            one.look_at(setting)  # a problem that can't be read is no matter of one formula
    scopes = tuple(OpenClaims(file, own[file.file]) for file in files)
    judged = everything or bool(files and not (claims or said.pairs))
    walker = PaperChecker(paper, checkers, scopes, said, here, judged, everything)
    return list(walker.results(bound(paper, claims, said.pairs))), [*paper.text.remarks, *paper.remarks]


def names_of_problem(path: Path) -> ClaimsFile:
    """A problem without claims: its own names are what the printed symbols mean."""
    return ClaimsFile(path.stem, "", "", "", (), str(path), setting=Setting(path.stem, problem=str(path.resolve())))

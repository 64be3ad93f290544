r"""Claims beside the formulas: what the comments of a text say, `% rbpsym: ...`, as settings and claims.

% rbpsym: problem = ladder.toml         what follows is about this problem (or theory = plane-motion)
% rbpsym: \omega is the speed of theta  from here on, in the words of claims
% rbpsym: claim                         the next display is claimed; claim eq:12, that with this label
% rbpsym: expect = refuted              of the claim above, as in a claims file
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Mapping
from itertools import islice, takewhile
from pathlib import Path
from typing import Any

from rbpsym.claims.ground import glossary
from rbpsym.claims.loader import HOLDS
from rbpsym.claims.model import EXPECTATIONS, Claim, Meaning, Printed, Setting
from rbpsym.claims.papers.macros import expanded
from rbpsym.claims.papers.source import Note
from rbpsym.claims.papers.walk import Formula, Paper
from rbpsym.errors import RbpsymError, ReadError
from rbpsym.frozen import Frozen, replace
from rbpsym.statement.library import problem_files
from rbpsym.statement.source import did_you_mean

_CLAIM = re.compile(r"claim(?:\s+(?P<inline>inline)|\s+(?P<label>\S+))?")
_KEY = re.compile(r"(?P<key>[a-z]+(?:[_ ][a-z]+)?)\s*=\s*(?P<value>.*)", re.S)
_MEANING = re.compile(r"(?P<symbol>\S.*?)\s+(?:is|means|=)\s+(?:the\s+|an?\s+(?!constant))?(?P<phrase>\S.*)", re.S)
OF_SETTING = ("problem", "theory", "phase", "fixed_axis", "given")
OF_CLAIM: Mapping[str, tuple[str, ...]] = {  # with the words that it may have, if not any
    "id": (), "expect": tuple(EXPECTATIONS), "holds": HOLDS, "right": (), "erratum": (), "says": (), "not_computed": (),
}  # fmt: skip
_WRITE = "Write “problem = NAME”, “SYMBOL is MEANING”, “claim” or “expect = refuted”."


class SettingFrom(Frozen):
    """The setting in force from a place of the text on; None where nothing is said."""

    offset: int
    setting: Setting | None


class Beside(Frozen):
    """What the comments of a text say: the claims with their formulas, and the settings from place to place."""

    pairs: tuple[tuple[Formula, Claim], ...]
    scopes: tuple[SettingFrom, ...]

    def setting(self, formula: Formula) -> Setting | None:
        """The setting in force where a formula stands."""
        return next((scope.setting for scope in reversed(self.scopes) if scope.offset <= formula.offset), None)


def beside(paper: Paper, folder: Path) -> Beside:
    """The claims beside the formulas of a paper; problems lie in `folder`. Raises ReadError with the place of a comment."""
    read = _Reader(paper, folder.resolve())
    for note in paper.text.notes:
        read.obey(note)
    return Beside(tuple(read.claims()), tuple(read.scopes))


class _Reader:
    """One pass over the comments; `latest` are the claims that the last of them made."""

    def __init__(self, paper: Paper, folder: Path) -> None:
        self.paper, self.folder = paper, folder
        self.scopes: list[SettingFrom] = []
        self.found: list[tuple[Formula, Claim]] = []
        self.latest: list[int] = []
        self.offsets = [formula.offset for formula in paper.formulas]

    @property
    def setting(self) -> Setting | None:
        """The setting in force."""
        return self.scopes[-1].setting if self.scopes else None

    def obey(self, note: Note) -> None:
        """What one comment says. Raises ReadError."""
        said = " ".join(note.said.split())
        if claimed := _CLAIM.fullmatch(said):
            self._claim(note, claimed)
            return
        keyed = _KEY.fullmatch(said)
        key = keyed["key"].replace(" ", "_") if keyed else ""
        value = keyed["value"] if keyed else ""
        if key in OF_CLAIM and self.latest:
            self._add(note, key, value)
        elif key in OF_SETTING:
            self._set(note, key, value)
        elif meaning := _MEANING.fullmatch(said):
            self._mean(note, meaning["symbol"], meaning["phrase"])
        else:
            near = did_you_mean(said.split()[0], (*OF_SETTING, *OF_CLAIM, "claim"), "words") if said else ""
            raise ReadError(f"“{said[:60]}” says nothing here", instead=f"{_WRITE} {near}".strip(), place=note.place)

    def _set(self, note: Note, key: str, value: str) -> None:
        """What a key says of the formulas that follow; a problem or theory begins anew."""
        if key in ("problem", "theory"):
            name = f"{note.place.file}:{note.place.line}"
            problem, theory = (self._inside(note, value), "") if key == "problem" else ("", value)
            made = Setting(name, problem, theory, place=note.place)
        elif key == "given":
            self._given(note, value)
            return
        else:
            now = self._current(note)
            made = replace(now, phase=value) if key == "phase" else replace(now, fixed_axis=value == "true")
        self.latest.clear()
        self.scopes.append(SettingFrom(note.offset, made))

    def _given(self, note: Note, value: str) -> None:
        """An equation that is assumed: by the claim above it, or by all that follows."""
        printed = Printed(self._own(note, value), note.place)
        for place in self.latest:
            formula, claim = self.found[place]
            setting = replace(claim.setting, given=(*claim.setting.given, printed))
            self.found[place] = formula, replace(claim, setting=setting)
        if not self.latest:
            setting = self._current(note)
            self.scopes.append(SettingFrom(note.offset, replace(setting, given=(*setting.given, printed))))

    def _current(self, note: Note) -> Setting:
        if self.setting is None:
            raise ReadError("no problem is named above", instead="Begin with “problem = NAME”.", place=note.place)
        return self.setting

    def _inside(self, note: Note, name: str) -> str:
        """A name of the library, or the path of a file in the folder of the text."""
        is_file = name.endswith(".toml") or "/" in name
        tried = [(base / f"{name.removesuffix('.toml')}.toml").resolve() for base in (Path(note.place.file).parent, self.folder)]
        if not is_file and (name in problem_files() or not any(one.is_file() for one in tried)):
            return name
        target = next((one for one in tried if one.is_file()), tried[0])
        if not target.is_relative_to(self.folder):
            raise ReadError(f"“{name[:60]}” is outside the folder of the text", place=note.place)
        if not target.is_file():
            raise ReadError(f"there is no problem “{name[:60]}” beside the text", place=note.place)
        return str(target)

    def _own(self, note: Note, latex: str) -> str:
        """What a comment prints, with the macros of the text put in. Raises ReadError."""
        try:
            return expanded(latex, self.paper.macros)
        except RbpsymError as error:
            raise ReadError(error.what, instead=error.instead, place=note.place) from None

    def _mean(self, note: Note, symbol: str, phrase: str) -> None:
        setting = self._current(note)
        drawn = self._own(note, symbol.strip("$ "))
        symbols = {**setting.symbols, drawn: Meaning(phrase.rstrip("."), note.place)}
        made = replace(setting, symbols=symbols)
        glossary(made.symbols)  # a symbol that is none is told here
        self.scopes.append(SettingFrom(note.offset, made))

    def _claim(self, note: Note, said: re.Match[str]) -> None:
        setting, label = self._current(note), said["label"]
        formulas = self._labelled(label) if label else self._next(note, bool(said["inline"]))
        if not formulas:
            what = f"no formula has the label “{label}”" if label else "no displayed relation follows"
            raise ReadError(f"{what}, so nothing is claimed here", place=note.place)
        self.latest = list(range(len(self.found), len(self.found) + len(formulas)))
        for formula in formulas:
            self.found.append((formula, Claim("", setting, None, place=note.place)))

    def _labelled(self, label: str) -> list[Formula]:
        return [formula for formula in self.paper.formulas if label in formula.labels]

    def _next(self, note: Note, inline: bool) -> list[Formula]:
        """The next relation, or that in which the comment stands; all of a display of several numbers that begins behind it."""
        start = bisect_left(self.offsets, note.offset)
        around = self.paper.formulas[start - 1] if start and not inline else None
        if around is not None and around.is_relation and around.displayed and note.offset < around.offset + len(around.latex):
            return [around]
        behind = (f for f in islice(self.paper.formulas, start, None) if f.displayed is not inline and f.is_relation)
        first = next(behind, None)
        if first is None:
            return []
        block, whole = first.block, first.block >= note.offset and not inline
        return [first, *(takewhile(lambda f: f.block == block, behind) if whole else ())]

    def _add(self, note: Note, key: str, value: str) -> None:
        """What is said of the claim above. Raises ReadError for a word that it can't have."""
        words = OF_CLAIM[key]
        if words and value not in words:
            raise ReadError(f"“{key}” can't be “{value[:40]}”", instead=did_you_mean(value, words, "words"), place=note.place)
        for place in self.latest:
            formula, claim = self.found[place]
            said: Any = Printed(self._own(note, value), note.place) if key == "right" else value
            self.found[place] = formula, replace(claim, **{key: said})

    def claims(self) -> Iterator[tuple[Formula, Claim]]:
        """The claims with names that stay while the text around them changes: label, or the place in their file."""
        seen: dict[str, int] = {}
        taken: dict[str, Claim] = {}
        for formula, claim in self.found:
            seen[formula.file] = seen.get(formula.file, 0) + 1
            name = claim.id or next(iter(formula.labels), "") or f"{Path(formula.file).stem} {seen[formula.file]}"
            if name in taken:
                name = f"{name} {seen[formula.file]}"
            made = replace(claim, id=name, number=formula.number, label=next(iter(formula.labels), ""), line=formula.line)
            _check(made)
            taken[name] = made
            yield formula, made


def _check(claim: Claim) -> None:
    """Raises ReadError where the words of a claim contradict each other."""
    for key, wanted in (("right", ("refuted",)), ("erratum", ("refuted", "not computed"))):
        if getattr(claim, key) and claim.expect not in wanted:
            what = f"“{key}” belongs to a claim that is refuted"
            raise ReadError(what, instead="Say “expect = refuted” too.", place=claim.place)

"""The author's own words in a course: paragraphs of sentences, each bound to the claims by which it stands.

`{claim:ID}` in a sentence, or right behind it, binds it to a claim; `$...$` in such a sentence is a formula in its claim's
symbols; a paragraph that is `{display:ID}` alone prints the formula of a claim. docs/courses.md shows all of it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cached_property
from itertools import chain, count

from rbpsym.errors import Place, StatementError
from rbpsym.expr.glyphs import ACCENTS, DOTS, Notation, notation_for
from rbpsym.expr.symbol_table import Drawn, drawn_glyph
from rbpsym.frozen import Frozen, field
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Problem
from rbpsym.statement.source import SourceTable, did_you_mean


class OwnFormula(Frozen):
    """A formula in a sentence, as it is written."""

    latex: str


class Sentence(Frozen):
    """Words and formulas in turn, and the ids of the claims to which they are bound; `display`: its claim's formula alone."""

    pieces: tuple[str | OwnFormula, ...]
    claims: tuple[str, ...] = ()
    display: bool = False
    place: Place | None = field(default=None, compare=False)

    @property
    def words(self) -> str:
        """What is said in words."""
        return "".join(piece for piece in self.pieces if isinstance(piece, str))

    @property
    def told(self) -> str:
        """The beginning of it, with its formulas as they are written."""
        told = "".join(piece if isinstance(piece, str) else f"${piece.latex}$" for piece in self.pieces).strip()
        return told if len(told) <= MOST else told[:MOST].rsplit(" ", 1)[0] + " …"

    def error(self, what: str, instead: str) -> StatementError:
        """An error about the sentence."""
        return StatementError(what, instead=instead, place=self.place)


MOST = 90  # characters
OwnParagraph = tuple[Sentence, ...]

TOKEN = re.compile(r"\{([^{}]*)\}|\$([^$]*)\$|([{}$])")
MARK, FORMULA = "\ue000", "\ue001"  # stand for a mark and for a formula while a text is cut into sentences
SENTENCE = re.compile(rf".+?(?:[.!?…][”»\"')]*(?:\s*{MARK})*(?=\s*$|\s+[^\W\d_a-záéíóúñü]|\s+[¿¡“«{FORMULA}])|$)", re.DOTALL)
HOW = "write {claim:ID} in a sentence, or {display:ID} as a paragraph of its own; ID is that of a [[claim]]."


def own_paragraphs(text: str, place: Place | None = None) -> tuple[OwnParagraph, ...]:
    """The paragraphs of a text, which are parted by empty lines. Raises StatementError."""
    parts = (" ".join(part.split()) for part in re.split(r"\n\s*\n", text))
    return tuple(tuple(_sentences(part, place)) for part in parts if part)


def _sentences(text: str, place: Place | None) -> Iterator[Sentence]:
    marks, formulas = list[str](), list[OwnFormula]()

    def kept(found: re.Match[str]) -> str:
        inner, latex, loose = found.groups()
        if loose or (latex is not None and not latex.strip()):
            raise StatementError(f"“{loose or '$$'}” opens nothing that is closed in its paragraph", instead=HOW, place=place)
        if latex is None:
            marks.append(inner)
            return MARK
        formulas.append(OwnFormula(latex))
        return FORMULA

    plain = TOKEN.sub(kept, text)
    if "\\" in plain:
        raise StatementError("a backslash stands outside a formula", instead="put formulas between $ and $.", place=place)
    is_display = plain == MARK and marks[0].startswith("display:")
    named, shown = iter(marks), iter(formulas)
    for part in (found[0] for found in SENTENCE.finditer(plain)):
        kind = "display" if is_display else "claim"
        claims = tuple(_id(next(named), kind, place) for _ in range(part.count(MARK)))
        words = re.split(f"({FORMULA})", re.sub(rf"\s*{MARK}", "", part))
        pieces = tuple(next(shown) if word == FORMULA else word for word in words if word)
        yield Sentence(pieces, claims, is_display, place)


def _id(mark: str, kind: str, place: Place | None) -> str:
    named, colon, id = mark.partition(":")
    if named.strip() != kind or not colon or not id.strip():
        raise StatementError(f"“{{{mark}}}” is no mark of a sentence", instead=HOW, place=place)
    return id.strip()


# what a part of a name means, unless it is what a body or a force is called
_SPECIAL = (*ACCENTS, *DOTS, "prime")


class Letters(Frozen):
    """The names of a problem's quantities and of its things, and how the quantities are drawn."""

    quantities: frozenset[str]
    things: frozenset[str]
    forces: frozenset[str]
    notation: Notation
    drawn: Mapping[Drawn, str]

    @property
    def names(self) -> frozenset[str]:
        """What is written as a letter: quantities, and vectors of forces."""
        return self.quantities | self.forces

    def free(self, wanted: str, *others: str, mark: str = "b", taken: Collection[str] | None = None) -> str:
        """`wanted`, one of `others`, or `wanted` with a mark: the first that nothing else is called or drawn as.

        `taken` are names besides those of quantities: the vectors of forces, unless it is said otherwise.
        """
        taken = self.forces if taken is None else taken
        marks = (each for each in chain((mark,), (f"{mark}{k}" for k in count(1))) if each not in self.things)
        names = (self.spelled(name) for name in chain((wanted, *others), (f"{wanted}_{each}" for each in marks)))
        return next(n for n in names if self._is_free(n) and n not in taken)

    def _is_free(self, name: str) -> bool:
        return name not in self.quantities and drawn_glyph(self.notation.glyph(name)) not in self.drawn

    @cached_property
    def _doubtful(self) -> frozenset[str]:
        """Parts of names of things that would be accents."""
        return frozenset(part for thing in self.things for part in thing.split("_") if part in _SPECIAL)

    def spelled(self, name: str) -> str:
        """The name with two underscores before what is a thing, and no accent: I__bar for the body “bar”."""
        for part in self._doubtful:
            name = re.sub(rf"(?<=[^_])_{part}(?=_|$)", f"__{part}", name)
        return name


def letters_of(problem: Problem) -> Letters:
    """The letters of a problem, those of its later phases among them. Raises StatementError for two that look alike."""
    coordinates = [c.name for c in problem.coordinates]
    found = [q.name for q in problem.parameters] + [f"{c}{rate}" for c in coordinates for rate in ("", "_dot", "_ddot")]
    forces: set[str] = set()
    for each in (problem, *(phase.problem for phase in problem.phases)):
        found += [name for element in each.constraints for name in unknowns_of(element) if not problem.unstated]
        forces |= {element.name for element in each.elements}
    notation = notation_for((*found, *forces), problem.notation)
    things = forces | {*problem.body_names, *problem.points}
    forces |= {f"{e.name}_{body}" for e in problem.interactions for body in problem.body_names}  # gravity on each body
    return Letters(frozenset(found), frozenset(things), frozenset(forces), notation, _drawn(found, notation))


def _drawn(names: Iterable[str], notation: Notation) -> Mapping[Drawn, str]:
    found: dict[Drawn, str] = {}
    for name in names:
        other = found.setdefault(drawn_glyph(notation.glyph(name)), name)
        if other != name:
            what = f"“{other}” and “{name}” are printed alike"
            raise StatementError(what, instead="give one of them another name, or another print under [notation].")
    return found


def worded(table: SourceTable, key: str, default: str = "") -> Mapping[str, str]:
    """A text by language; one that is not told apart is taken for English."""
    if not isinstance(table.data.get(key), Mapping):
        return {"en": table.string(key, default)}
    texts = strings(table, key)
    check_languages(table.table(key, key), f'write {key} = {{ en = "...", es = "..." }}')
    return texts


def check_languages(section: SourceTable, cure: str) -> None:
    """The keys of a table by language are codes of languages."""
    for language in section.names():
        if not re.fullmatch(r"[a-z]{2,3}", language):
            raise section.error(f"“{language}” is no language", cure, language)


def strings(table: SourceTable, key: str) -> dict[str, str]:
    """A table of texts."""
    section = table.table(key, f"“{key}”")
    return {name: section.string(name) for name in section.names()}


_WORD = re.compile(r"[^\W\d_]\w*")


def check_translated_names(problem: Problem, table: SourceTable) -> None:
    """[names] speaks of what exists; in a language no two bodies or forces are called alike."""
    section = table.table("names", "names")
    in_formulas = (*problem.body_names, *(e.name for e in problem.elements))
    elsewhere = (*problem.points, *(p for body in problem.bodies for p in body.points), *(p.name for p in problem.phases))
    for language in section.names():
        own = section.table(language, f"names.{language}")
        for name in own.names():
            _check_known(name, (*in_formulas, *elsewhere), own)
            if name in in_formulas:
                _check_word(name, own)
    for language in {*problem.meanings, *problem.names}:
        _check_distinct(problem.names_in(language), in_formulas, language, table)


def _check_known(name: str, known: tuple[str, ...], own: SourceTable) -> None:
    if name not in known:
        what = f"[{'.'.join(map(str, own.path))}] speaks of “{name}”, which is no body, force, point or phase"
        raise own.error(what, did_you_mean(name, known, "names"), name)


def _check_word(name: str, own: SourceTable) -> None:
    word = own.string(name)
    if not _WORD.fullmatch(word):
        raise own.error(
            f"“{word}” can't stand in a formula as the name of “{name}”",
            "give one word; the words of sentences stand in [meanings].",
            name,
        )


def _check_distinct(names: Mapping[str, str], in_formulas: tuple[str, ...], language: str, table: SourceTable) -> None:
    """Two things that are called alike could not be told apart in a formula."""
    called = {name: names.get(name, name) for name in in_formulas}
    for name, word in called.items():
        others = [other for other, said in called.items() if said == word and other != name]
        if others:
            raise table.error(
                f"in “{language}” both “{name}” and “{others[0]}” are called “{word}”",
                f'give each a name of its own: [names.{language}] and, below it, {name} = "..."',
                "names" if "names" in table else "meanings",
            )

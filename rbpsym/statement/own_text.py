"""The author's own words in a course: paragraphs of sentences, each bound to the claims by which it stands.

`{claim:ID}` in a sentence, or right behind it, binds it to a claim; `$...$` in such a sentence is a formula in its claim's
symbols; a paragraph that is `{display:ID}` alone prints the formula of a claim. docs/courses.md shows all of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from rbpsym.errors import Place, StatementError
from rbpsym.frozen import Frozen, field


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

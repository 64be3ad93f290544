"""The document tree: what a page says, before any format is chosen.

A formula stands in it only as a display tree (`Math` in a sentence, `Display` on a line of its
own), a drawing only as a `Scene`; all else is text. Writers print this tree and nothing else.
"""

from __future__ import annotations

from rbpsym.errors import RbpsymError
from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen
from rbpsym.pictures.figures.scene import Scene
from rbpsym.showing import Shown


class DocumentError(RbpsymError):
    """A document that can't be written: a reference without a target, a phrase without a slot."""


class Text(Frozen):
    """Plain words; writers escape them."""

    text: str


class Math(Frozen):
    """A formula within a sentence."""

    node: Node


class Ref(Frozen):
    """The number of the block or section labelled `label`; `numbered` fills in `mark`.

    With `page`, formats that have pages print the page where it stands.
    """

    label: str
    mark: str = ""
    page: bool = False


class Emph(Frozen):
    """Italic words."""

    inlines: Inlines


class Strong(Frozen):
    """Bold words."""

    inlines: Inlines


Inline = Text | Math | Ref | Emph | Strong
Inlines = tuple[Inline, ...]


def words(text: str) -> Inlines:
    """Plain text as inlines."""
    return (Text(text),) if text else ()


class Paragraph(Frozen):
    """A paragraph of prose."""

    inlines: Inlines


class Display(Frozen):
    """A formula on lines of its own: a chain, a system or an expression.

    `reason` is printed beside it (or below where there is no room); a boxed one is a result, and so is one that
    `is_result` though it has no box, since the problem asks for others.
    References to the labels in `also` show its number too. One that stands elsewhere already
    `repeats` it: that one's number is printed, as a link.
    """

    node: Node
    label: str = ""
    numbered: bool = True
    boxed: bool = False
    reason: Inlines | None = None
    number: str = ""
    also: tuple[str, ...] = ()
    repeats: Ref | None = None
    is_result: bool = False

    @property
    def mark(self) -> str:
        """What stands at its right: "(7)", "" if it has no number."""
        return self.repeats.mark if self.repeats else f"({self.number})" if self.number else ""


class Table(Frozen):
    """Rows of inlines under a header; `align` has one of "lcr" for each column, or "p"
    for a narrow one of words that wrap."""

    header: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]
    caption: Inlines = ()
    align: str = ""
    label: str = ""
    number: str = ""

    @property
    def columns(self) -> str:
        """The alignment of each column, left where nothing is said."""
        return self.align.ljust(len(self.header), "l")


class FigureBlock(Frozen):
    """Scenes side by side with a caption; `alt` says what is seen."""

    scenes: tuple[Scene, ...]
    caption: Inlines
    alt: str
    label: str = ""
    number: str = ""


class ItemList(Frozen):
    """A list with bullets or, if `ordered`, numbers."""

    items: tuple[Inlines, ...]
    ordered: bool = False


class Callout(Frozen):
    """A framed remark; `kind` is “result”, “why”, “note” or “check”."""

    kind: str
    title: Inlines
    blocks: tuple[Block, ...]


class OwnBlock(Frozen):
    """The base of blocks that another room has beside these; its writers know them."""


Block = Paragraph | Display | Table | FigureBlock | ItemList | Callout | OwnBlock


class Section(Frozen):
    """A part (level 0, unnumbered), section (1), subsection (2) or unnumbered heading (3).

    `notation` is that of the document if None.
    """

    title: Inlines
    blocks: tuple[Block, ...]
    label: str = ""
    level: int = 1
    number: str = ""
    notation: Notation | None = None


class Live(Frozen):
    """A problem that the document speaks of, for formats that run: its TOML text.

    The labels of its parts begin with `prefix`; what follows in the label of a formula is the id of its step.
    """

    name: str
    text: str
    prefix: str = ""


class Document(Shown):
    """A whole text. `notation` is handed to the formula printers as it is.

    A book begins with its contents, and numbers equations, figures and tables by section: (3.12).
    """

    title: Inlines
    sections: tuple[Section, ...]
    subtitle: Inlines = ()
    source: Inlines = ()
    language: str = "en"
    notation: Notation = DEFAULT
    live: tuple[Live, ...] = ()
    is_book: bool = False

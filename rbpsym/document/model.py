"""The document tree: what a page says, before any format is chosen.

A formula stands in it only as a display tree (`Math` in a sentence, `Display` on a line of its
own), a drawing only as a `Scene`; all else is text. Writers print this tree and nothing else.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from rbpsym.document import model as d
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
    """A paragraph of prose; one that says what a problem asks stands on slides too."""

    inlines: Inlines
    is_question: bool = False


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


# --- the pass that gives equations, figures, tables and sections their numbers


WITHIN = ("equation", "figure", "table")


class LabelCounters:
    """How many equations, figures, tables and sections have been numbered so far."""

    def __init__(self, by_section: bool = False) -> None:
        self.by_section = by_section
        self.counts: Counter[str] = Counter()
        self.marks: dict[str, str] = {}
        self.targets: dict[str, str] = {}

    def next(self, kind: str) -> str:
        """The next number of a kind; in a book after that of its section."""
        self.counts[kind] += 1
        inside = self.by_section and kind in WITHIN
        return f"{self.counts['level 1']}.{self.counts[kind]}" if inside else str(self.counts[kind])

    def begin_section(self) -> None:
        """What is numbered within a section begins with 1 again."""
        for kind in ("level 2", *(WITHIN if self.by_section else ())):
            self.counts[kind] = 0

    def label(self, label: str, mark: str) -> None:
        """Remember what a reference to `label` prints."""
        if label in self.marks:
            raise d.DocumentError(f"two parts of the document are labelled “{label}”")
        if label:
            self.marks[label] = mark

    def label_also(self, labels: tuple[str, ...], target: str, mark: str) -> None:
        """Remember further labels of the block that is labelled `target`."""
        for label in labels:
            self.label(label, mark)
            self.targets[label] = target


def number_display(block: d.Display, counters: LabelCounters) -> d.Display:
    """The display with its equation number; a labelled one is always numbered."""
    if not (block.numbered or block.label):
        return block
    number = counters.next("equation")
    counters.label(block.label, f"({number})")
    counters.label_also(block.also, block.label, f"({number})")
    return replace(block, number=number, numbered=True)


def number_figure(block: d.FigureBlock, counters: LabelCounters) -> d.FigureBlock:
    """The figure with its number."""
    number = counters.next("figure")
    counters.label(block.label, number)
    return replace(block, number=number)


def number_table(block: d.Table, counters: LabelCounters) -> d.Table:
    """The table with its number; one without a caption has none."""
    number = counters.next("table") if block.caption else ""
    counters.label(block.label, number)
    return replace(block, number=number)


NUMBERED: Mapping[type, Callable[[Any, LabelCounters], Any]] = {
    d.Display: number_display,
    d.FigureBlock: number_figure,
    d.Table: number_table,
    d.Callout: lambda block, counters: replace(block, blocks=number_blocks(block.blocks, counters)),
}


def number_blocks(blocks: tuple[d.Block, ...], counters: LabelCounters) -> tuple[d.Block, ...]:
    """The blocks with numbers, in reading order."""
    return tuple(NUMBERED[type(block)](block, counters) if type(block) in NUMBERED else block for block in blocks)


def section_number(level: int, counters: LabelCounters) -> str:
    """ "3" for a section, "3.2" for a subsection, "" below."""
    if level not in (1, 2):
        return ""
    own = counters.next(f"level {level}")
    if level == 1:
        counters.begin_section()
        return own
    return f"{counters.counts['level 1']}.{own}"


def number_section(section: d.Section, counters: LabelCounters) -> d.Section:
    """The section with its number and its blocks numbered."""
    number = section_number(section.level, counters)
    counters.label(section.label, number)
    return replace(section, number=number, blocks=number_blocks(section.blocks, counters))


def resolve(part: Any, counters: LabelCounters) -> Any:
    """The same part of a document with each Ref's mark filled in."""
    if isinstance(part, d.Ref):
        return resolve_ref(part, counters)
    if isinstance(part, tuple):
        return once_each(tuple(resolve(item, counters) for item in part))
    if is_dataclass(part) and not isinstance(part, type) and type(part).__module__.endswith("document.model"):
        values = {item.name: getattr(part, item.name) for item in fields(part)}
        return type(part)(**{name: resolve(value, counters) for name, value in values.items()})
    return part


def once_each(parts: tuple[Any, ...]) -> tuple[Any, ...]:
    """A list of references without those that print the same number again: (7), (7) and (8) is (7) and (8)."""
    found: list[Any] = []
    for part in parts:
        if isinstance(part, d.Ref) and len(found) > 1 and part == found[-2] and is_joint(found[-1]):
            joint = found.pop()
            if len(found) > 2 and is_joint(found[-2]) and isinstance(found[-3], d.Ref):
                found[-2] = joint
            continue
        found.append(part)
    return tuple(found)


def is_joint(part: object) -> bool:
    """Is it what stands between two parts of a list?"""
    return isinstance(part, d.Text) and len(part.text) <= len(" and ")


def resolve_ref(ref: d.Ref, counters: LabelCounters) -> d.Ref:
    """The reference with its mark. Raises DocumentError if nothing has that label."""
    if ref.label not in counters.marks:
        raise d.DocumentError(f"nothing in the document is labelled “{ref.label}”")
    mark = counters.marks[ref.label]
    return d.Ref(counters.targets.get(ref.label, ref.label), f"§\u202f{mark}" if ref.page else mark, ref.page)


def numbered(document: d.Document) -> d.Document:
    """The document with all numbers given and all references resolved."""
    counters = LabelCounters(document.is_book)
    sections = tuple(number_section(section, counters) for section in document.sections)
    resolved: d.Document = resolve(replace(document, sections=sections), counters)
    return resolved


def parts(value: object) -> Iterator[object]:
    """All parts of a document, in reading order (formulas and scenes are not entered)."""
    if isinstance(value, tuple):
        for item in value:
            yield from parts(item)
    elif is_dataclass(value) and not isinstance(value, Node):
        yield value
        if type(value).__module__.endswith("document.model"):
            for item in fields(value):
                yield from parts(getattr(value, item.name))

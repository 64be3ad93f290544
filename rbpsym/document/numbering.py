"""The pass that gives equations, figures, tables and sections their numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from rbpsym.document import model as d
from rbpsym.expr.tree import Node

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

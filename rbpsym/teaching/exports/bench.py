"""What all exports work with: a platform, one worksheet on its way to it, and what could not be carried so far."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from hashlib import sha256
from itertools import islice
from typing import Any

from rbpsym.document.model import Block, FigureBlock, Inlines
from rbpsym.document.writers.page import Page, plain_text
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, field
from rbpsym.teaching.exports.page import TEX, PictureTag, SetFormula, image, slug, svg, table, zipped
from rbpsym.teaching.formats import Exported
from rbpsym.teaching.model import Item, OrderKey, SignsKey, Slip, Worksheet
from rbpsym.teaching.wording import feedback, left_out, word

# what a format may be unable to carry; a platform may say it in other words, and "" where it is able to
LACKS: Mapping[str, str] = {
    "carried": "an error carried forward from an earlier answer is not recognised",
    "figures": "the unit is printed in the question; unit and significant figures are not marked",
    "slips of numbers": "",
    "slips of formulas": "",
    "reason": "the reason of a comparison is not asked in a second field",
    "correction": "the corrected formula is not asked",
    "cancelling": "which works cancel is not asked",
    "pairs": "the order is asked pair by pair, since several orders may be right",
    "formula": "a formula can't be compared: it is asked as a choice among the known wrong results",
    "formula as text": "a formula can't be compared: it is asked as a text that the teacher marks",
    "blanks": "a formula can't be compared: the blanks are asked as a text that the teacher marks",
    "rubric": "",
}


Asking = Callable[[Any, Item, "ExportDesk"], Any]  # how a key is asked of an item
Missing = list[tuple[Item, str]]  # items with what a format can't carry of them
Drawn = dict[int, tuple[FigureBlock, bytes]]  # pictures by the identity of their blocks


class Platform(Frozen):
    """A learning platform: how it sets formulas, shows pictures and where these lie, how it asks keys for which it has a
    way of its own (by type), what it lacks in other words than `LACKS`, and how it shows a drop-down within text."""

    name: str
    formula: SetFormula = TEX
    tag: PictureTag = image
    folder: str = ""
    kinds: Mapping[type, Asking] = field(default_factory=dict)
    lacks: Mapping[str, str] = field(default_factory=dict)
    dropdown: Callable[[Any], str] = lambda field: f"[{field.name}]"


ANY = Platform("")


class ExportDesk(Frozen):
    """A worksheet on its way into a format.

    `missing` collects (item, what the format can't carry), `pictures` the files by name, `marks` the numbers of the
    figures of one question; `drawn` are pictures that many students get, by the identity of their blocks.
    """

    worksheet: Worksheet
    platform: Platform = ANY
    missing: Missing = field(default_factory=list)
    drawn: Drawn = field(default_factory=dict)
    pictures: dict[str, bytes] = field(default_factory=dict)
    marks: dict[str, str] = field(default_factory=dict)

    @cached_property
    def page(self) -> Page:
        """The page on which formulas and words are set."""
        printed = table(self.platform.formula, self._picture, self.marks)
        return Page(printed, self.worksheet.notation, self.worksheet.language)

    def _picture(self, block: FigureBlock) -> str:
        """A figure as a picture with its file."""
        if id(block) not in self.drawn:
            self.drawn[id(block)] = (block, svg(block.scenes, self.worksheet.notation))
        data = self.drawn[id(block)][1]
        name = f"figure-{sha256(data).hexdigest()[:10]}.svg"
        self.pictures[name] = data
        return self.platform.tag(self.platform.folder + name, block.alt)

    def lacks(self, item: Item, what: str) -> None:
        """Note what the format can't carry: a key of `LACKS`, or of the platform's own table."""
        sentence = {**LACKS, **self.platform.lacks}[what]
        self.missing.extend([(item, sentence)] if sentence else [])

    def word(self, key: str) -> str:
        """A word in the language of the worksheet."""
        return word(key, self.worksheet.language)

    def html(self, blocks: Iterable[Block]) -> str:
        """Blocks as HTML."""
        shown = tuple(blocks)
        labels = (block.label for block in shown if isinstance(block, FigureBlock))
        self.marks.clear()
        self.marks.update((label, str(place)) for place, label in enumerate(labels, start=1) if label)
        return self.page.blocks(shown, "\n")

    def inlines(self, inlines: Inlines) -> str:
        """Inlines as HTML."""
        return self.page.inlines(inlines)

    def formula(self, node: Node) -> str:
        """A formula within a sentence."""
        return self.platform.formula(node, self.worksheet.notation, False)

    def plain(self, inlines: Inlines) -> str:
        """Inlines as plain text."""
        return plain_text(inlines, self.worksheet.notation, self.worksheet.language)

    def question(self, item: Item) -> str:
        """The statement of the problem and what is asked, so that each question stands alone; of signs what has a field."""
        is_of_signs, statement = isinstance(item.key, SignsKey), self.worksheet.part_of(item.id).statement
        text = self.html((*statement, *item.prompt[: 1 if is_of_signs else None]))
        return ON_PAPER.sub("", text) if is_of_signs else text

    def solution(self, item: Item) -> str:
        """The way to the answer, "" if none is given."""
        return self.html(item.solution)

    def feedback(self, slip: Slip | None) -> str:
        """The feedback of a wrong answer as HTML."""
        return f"<p>{self.inlines(feedback(slip, self.worksheet))}</p>"


ON_PAPER = re.compile(r"\(a\) [^<]*?\(b\) | \(c\) [^<]*?(?=</p>)")  # what one draws, and the letters of what cancels


def in_packages(
    worksheets: tuple[Worksheet, ...], platform: Platform, package: Callable[[ExportDesk], dict[str, bytes]]
) -> Exported:
    """A zip package for each student; `package` gives its files by path."""
    files: dict[str, str | bytes] = {}
    missing: Missing = []
    drawn: Drawn = {}
    for sheet in worksheets:
        desk = ExportDesk(sheet, platform, missing, drawn)
        files[f"{slug(sheet.code)}.{platform.name.split()[0].lower()}.zip"] = zipped(package(desk))
    return Exported(files, left_out(platform.name, missing))


def by_items(worksheets: tuple[Worksheet, ...], platform: Platform, missing: Missing) -> Iterator[list[tuple[Item, ExportDesk]]]:
    """For each place on the paper the items of all students, each on a page of its own."""
    drawn: Drawn = {}
    for place in range(max((len(sheet.items) for sheet in worksheets), default=0)):
        sheets = (sheet for sheet in worksheets if place < len(sheet.items))
        yield [(sheet.items[place], ExportDesk(sheet, platform, missing, drawn)) for sheet in sheets]


def nearest_pairs(key: OrderKey) -> list[tuple[int, int]]:
    """The conditions on the order that do not follow from others."""
    follows = {(i, k) for i, j in key.before for h, k in key.before if h == j}
    return sorted(key.before - follows)


def free_pairs(key: OrderKey, most: int = 2) -> list[tuple[int, int]]:
    """Some pairs that may stand either way, so that not every pair is bound."""
    closed = set(key.before)
    while more := {(i, k) for i, j in closed for h, k in closed if h == j} - closed:
        closed |= more
    count = len(key.pieces)
    found = [(i, j) for i in range(count) for j in range(i + 1, count) if not {(i, j), (j, i)} & closed]
    return found[:most]


def orders(key: OrderKey, most: int = 24) -> list[tuple[int, ...]] | None:
    """All right orders; None if they are more than `most`."""

    def grown(order: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
        places = [place for place in range(len(key.pieces)) if place not in order]
        yield from () if places else [order]
        for place in places:
            if all(i in order for i, j in key.before if j == place):
                yield from grown((*order, place))

    found = list(islice(grown(()), most + 1))
    return found if len(found) <= most else None

"""What all writers share: the walk over the tree, and the templates of the page shells."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from rbpsym.document import model as d
from rbpsym.document.files import data_folder
from rbpsym.document.model import Emph, Inlines, Math, Ref, Strong, Text
from rbpsym.document.phrases import plain
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, replace
from rbpsym.typeset.text import to_text

Print = Callable[[Any, Any], str]  # of a part, on a page


class Page(Frozen):
    """How a format prints (a table of functions by type) and what it prints with.

    `column` is the width of the text in em; the widest formula is broken to it.
    """

    table: Mapping[type, Print]
    notation: Notation
    language: str
    column: float = 36.0

    def show(self, part: Any) -> str:
        """One inline or block."""
        try:
            show = self.table[type(part)]
        except KeyError:
            raise d.DocumentError(f"no writer for {type(part).__name__}") from None
        return show(part, self)

    def inlines(self, inlines: d.Inlines) -> str:
        """Inlines side by side."""
        return "".join(map(self.show, inlines))

    def blocks(self, blocks: tuple[d.Block, ...], between: str = "\n\n") -> str:
        """Blocks below each other."""
        return between.join(map(self.show, blocks))

    def is_lead(self, block: d.Block, after: d.Block | None) -> bool:
        """Does a paragraph lead to the formula below it, or is it a heading, so that no page may end after it?"""
        if not isinstance(block, d.Paragraph):
            return False
        return isinstance(after, d.Display) or (after is not None and [*map(type, block.inlines)] == [d.Emph])

    def word(self, key: str, **slots: object) -> str:
        """A phrase that is only text, in the document's language, unescaped."""
        return plain(key, self.language, **slots)


KINDS: Mapping[str, type] = {
    "text": d.Text, "math": d.Math, "reference": d.Ref, "emph": d.Emph, "strong": d.Strong, "paragraph": d.Paragraph,
    "display": d.Display, "table": d.Table, "figure": d.FigureBlock, "item_list": d.ItemList, "callout": d.Callout,
    "section": d.Section,
}  # fmt: skip


def prints(*functions: Print, **more: Print) -> Mapping[type, Print]:
    """The table of a format: a function for each kind above, under the name of the kind."""
    named = {function.__name__: function for function in functions} | more
    named.setdefault("paragraph", lambda block, page: page.inlines(block.inlines))
    return {kind: named.pop(name) for name, kind in KINDS.items()}


def alone(cell: d.Inlines) -> Node | None:
    """The formula that a cell holds and nothing else, which stands in display style."""
    return cell[0].node if len(cell) == 1 and isinstance(cell[0], d.Math) else None


def page_for(document: d.Document, table: Mapping[type, Print], column: float) -> Page:
    """The page that a numbered document is printed on."""
    return Page(table, document.notation, document.language, column)


def body(document: d.Document, page: Page) -> str:
    """All sections."""
    return "\n\n".join(page.table[d.Section](section, page_of(section, page)) for section in document.sections)


def page_of(section: d.Section, page: Page) -> Page:
    """The page with the notation of a section."""
    return page if section.notation is None else replace(page, notation=section.notation)


@cache
def environment(autoescape: bool) -> Any:
    """The Jinja2 environment of the page shells; LaTeX and Typst shells use << >> and <% %>."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    marks: Mapping[str, Any] = {} if autoescape else BRACKETS
    return Environment(
        loader=FileSystemLoader(data_folder("templates")),
        undefined=StrictUndefined,
        autoescape=autoescape,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        **marks,
    )


BRACKETS = {
    "block_start_string": "<%",
    "block_end_string": "%>",
    "variable_start_string": "<<",
    "variable_end_string": ">>",
    "comment_start_string": "<#",
    "comment_end_string": "#>",
}


def shell(name: str, /, *, autoescape: bool = False, **values: Any) -> str:
    """A page shell with its places filled."""
    return str(environment(autoescape).get_template(name).render(**values))


# --- inlines as plain text: for titles in metadata, alt texts and terminals


PLAIN: Mapping[type, Print] = {
    Text: lambda inline, page: inline.text,
    Math: lambda inline, page: to_text(inline.node, page.notation),
    Ref: lambda inline, page: inline.mark,
    Emph: lambda inline, page: page.inlines(inline.inlines),
    Strong: lambda inline, page: page.inlines(inline.inlines),
}


def plain_text(inlines: Inlines, notation: Notation, language: str = "en") -> str:
    """The inlines without any markup."""
    return Page(PLAIN, notation, language).inlines(inlines)

"""A worksheet as one HTML file: no server, no network, nothing that is typed is run.

The paper holds fields and nothing of the key. With its key it checks itself: its script gets values of the key at some
points, and a typed formula is right if it has the same values there; the key stands behind a fold, also where scripts are off.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from markupsafe import Markup, escape

from rbpsym.document.files import data_folder
from rbpsym.document.model import Display, Document, Section, numbered
from rbpsym.document.writers.html import HTML, display_math, font, style
from rbpsym.document.writers.html import section as titled_section
from rbpsym.document.writers.page import Page, Print, page_for, shell
from rbpsym.document.writers.page import plain_text as bare
from rbpsym.teaching import model as m
from rbpsym.teaching.papers.blocks import Form, Lead, Marked
from rbpsym.teaching.papers.html_fields import fields_of
from rbpsym.teaching.papers.layout import key_document, paper_document, points_text
from rbpsym.teaching.wording import plain_text

COLUMN = 34.0
VERDICTS = {"right": "correct", "wrong": "wrong", "invalid": "invalid", "unit": "wrong_unit",
            "few": "too_few_digits", "many": "too_many_digits"}  # fmt: skip


def write_html(worksheet: m.Worksheet, *, is_key: bool = False) -> str:
    """The file; with the key it checks itself."""
    document = numbered(_without_areas(paper_document(worksheet)))
    page = page_for(document, PAPER, COLUMN)
    keys: dict[str, object] = {}
    body = "\n".join(_sections(document, worksheet, page, keys, is_key=is_key))
    language, student = worksheet.language, worksheet.student
    words = {verdict: plain_text(f"paper.{key}", language) for verdict, key in VERDICTS.items()}
    found = json.dumps({"keys": keys, "words": words}, ensure_ascii=False)
    return shell(
        "worksheet.html",
        autoescape=True,
        title=Markup(page.inlines(document.title)),
        plain_title=bare(document.title, document.notation),
        language=language,
        student=(student.name or student.id) if student else "",
        points=points_text(worksheet.points, language),
        code=plain_text("paper.form", language, code=worksheet.code),
        noscript=plain_text("paper.noscript", language) if is_key else "",
        style=Markup(style()),
        font=Markup(font()),
        body=Markup(body),
        keys=Markup(found.replace("<", "\\u003c").replace("&", "\\u0026")),  # it can't close the script element it stands in
        script=Markup((data_folder("templates") / "worksheet.js").read_text(encoding="utf-8")) if is_key else "",
    )


def _without_areas(document: Document) -> Document:
    """The paper without the room for answers: the page has fields for them."""
    from dataclasses import replace

    def kept(part: Section) -> Section:
        shown = (b for b in part.blocks if not type(b).__module__.endswith("papers.blocks") or isinstance(b, (Lead, Marked)))
        return replace(part, blocks=tuple(shown))

    return replace(document, sections=tuple(map(kept, document.sections)))


def _sections(document: Document, worksheet: m.Worksheet, page: Page, keys: dict[str, object], *, is_key: bool) -> Iterator[str]:
    """Statements and tasks; under each task its fields and, with the key, the fold with it."""
    tasks = filter(_number, numbered(key_document(worksheet)).sections) if is_key else ()
    solved = {_number(part): part for part in tasks}
    for part in document.sections:
        if not (number := _number(part)):
            yield titled_section(part, page)
            continue
        item = worksheet.item(number)
        yield page.blocks(part.blocks, "\n")
        if not is_key:
            yield from (f'<div class="answer">{fields}</div>' for fields, _ in fields_of(item, worksheet, page))
            continue
        yield from _areas(item, page, worksheet, keys)
        fold = page.blocks(solved[item.id].blocks, "\n")
        yield f'<details class="key"><summary>{escape(plain_text("paper.key", page.language))}</summary>{fold}</details>'


def _number(part: Section) -> str:
    """The number of the task that a section is; "" for another section."""
    return part.blocks[0].number if part.blocks and isinstance(part.blocks[0], Lead) else ""


def _areas(item: m.Item, page: Page, worksheet: m.Worksheet, keys: dict[str, object]) -> Iterator[str]:
    """The fields of a task, each group with a button and what it is checked against."""
    button = escape(plain_text("paper.show", page.language))
    for place, (fields, key) in enumerate(fields_of(item, worksheet, page)):
        name = f"{item.id}.{place}"
        if key is None:
            yield f'<div class="answer">{fields}</div>'
            continue
        keys[name] = key
        told = '<p class="verdict" role="status"></p>'
        yield f'<div class="answer" data-key="{name}">{fields}<button type="button">{button}</button>{told}</div>'


# --- blocks


def lead(block: Lead, page: Page) -> str:
    """The number, question and points of a task."""
    return (
        f'<div class="task"><span class="number">{escape(block.number)}.</span>'
        f'<span class="question">{page.inlines(block.inlines)}</span><span class="points">{escape(block.points)}</span></div>'
    )


def marked(block: Marked, page: Page) -> str:
    """Formulas with their marks."""
    rows = "".join(f"<b>{mark}</b><div>{display_math(Display(node, numbered=False), page)}</div>" for mark, node in block.lines)
    return f'<div class="marked">{rows}</div>'


def form(block: Form, page: Page) -> str:
    """A table, filled in."""
    head = "".join(f'<th scope="col">{page.inlines(cell)}</th>' for cell in block.header)
    rows = "".join(f"<tr>{''.join(f'<td>{page.inlines(cell)}</td>' for cell in row)}</tr>" for row in block.rows)
    return f'<div class="table"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>'


PAPER: Mapping[type, Print] = {**HTML, Lead: lead, Marked: marked, Form: form}

"""Jupyter: a live notebook. Words and formulas are Markdown; cells build the problem, derive it and check it."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterator
from typing import Any

from rbpsym.document.model import Block, Callout, Display, Document, FigureBlock, Live, Section, numbered
from rbpsym.document.pictures import easiest, pictures
from rbpsym.document.writers.markdown import MarkdownPage, head, markdown_page
from rbpsym.document.writers.page import Page, page_of, plain_text
from rbpsym.frozen import Frozen

SCREEN = 110.0  # dots an inch
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}


MIME = {"png": "image/png", "svg": "image/svg+xml"}


class NotebookCell(Frozen):
    """A cell: words (Markdown) or code; `files` are pictures that it holds, by name."""

    source: str
    is_code: bool = False
    files: tuple[tuple[str, bytes], ...] = ()


def write_notebook(document: Document) -> str:
    """The document as a notebook (nbformat 4.5)."""
    document = numbered(document)
    drawn = {number: found.content for number, found in pictures(document, easiest(), SCREEN).items()}
    page = markdown_page(document, {number: f"attachment:{name(number)}" for number in drawn})
    cells = [as_json(cell, place) for place, cell in enumerate(cells_of(document, page, drawn), 1)]
    title = plain_text(document.title, document.notation)
    about = {"kernelspec": KERNEL, "language_info": {"name": "python"}, "title": title}
    content = {"cells": cells, "metadata": about, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(content, ensure_ascii=False, indent=1) + "\n"


def name(number: str) -> str:
    """What a picture is called inside the notebook."""
    return f"figure-{number}.{easiest()}"


def as_json(cell: NotebookCell, place: int) -> dict[str, Any]:
    """The cell as the format has it."""
    found: dict[str, Any] = {"id": f"cell-{place}", "metadata": {}, "source": cell.source.splitlines(keepends=True)}
    if cell.is_code:
        return {"cell_type": "code", "execution_count": None, "outputs": [], **found}
    if cell.files:
        held = {name: {MIME[name[-3:]]: base64.b64encode(data).decode()} for name, data in cell.files}
        found["attachments"] = held
    return {"cell_type": "markdown", **found}


def cells_of(document: Document, page: MarkdownPage, drawn: dict[str, bytes]) -> Iterator[NotebookCell]:
    """The whole notebook; each problem is built before its first section."""
    intro = [page.word("notebook.intro")] if document.live else []
    yield NotebookCell("\n\n".join([*head(document, page), *intro]))
    waiting = list(document.live)
    for section in document.sections:
        live = owner(section, document.live)
        heading, *rest = section_cells(section, live, page_of(section, page), drawn)
        yield heading
        if live is not None and live in waiting:
            waiting.remove(live)
            yield from building(live, page)
        yield from rest
        if live and section.label == f"{live.prefix}section.checks":
            yield from checking(page)


def owner(section: Section, live: tuple[Live, ...]) -> Live | None:
    """The problem that a section is about."""
    return next((problem for problem in live if section.label.startswith(problem.prefix)), None)


def building(live: Live, page: MarkdownPage) -> Iterator[NotebookCell]:
    """The cells that build a problem and derive it."""
    speaks = page.language != "en"
    head = "from rbpsym import derive, load_text" + (f", speak\n\nspeak({page.language!r})" if speaks else "")
    yield NotebookCell(f"{head}\n\nproblem = load_text({quoted(live.text)}, name={live.name!r})", True)
    yield NotebookCell(page.word("notebook.derive"))
    yield NotebookCell("derivation = derive(problem)\nderivation", True)


def quoted(text: str) -> str:
    """The text as a literal of Python, on several lines where it can be."""
    plain = '"""' not in text and all(char.isprintable() or char in "\n\t" for char in text)
    return f'r"""\n{text.strip()}\n"""' if plain else repr(text)


def checking(page: MarkdownPage) -> Iterator[NotebookCell]:
    """The cells that ask for the outcome."""
    counts = {name: f"{{summary[{name!r}]}}" for name in ("proved", "steps")}
    told = page.word("notebook.proved", **counts)
    yield NotebookCell(page.word("notebook.check"))
    yield NotebookCell(
        "summary = derivation.summary()\n"
        'assert summary["refuted"] == 0 and summary["methods_agree"]\n'
        f"f{told!r}",
        True,
    )


def section_cells(section: Section, live: Live | None, page: Page, drawn: dict[str, bytes]) -> Iterator[NotebookCell]:
    """A section cut behind each result, which is shown again by the derivation of the reader's own machine."""
    number = f"{section.number} " if section.number else ""
    files: tuple[tuple[str, bytes], ...] = ()
    held = [f"{'#' * (min(section.level, 3) + 1)} {number}{page.inlines(section.title)}"]
    for block in section.blocks:
        held.append(page.show(block))
        files = (*files, *((name(n), drawn[n]) for n in figures(block) if n in drawn))
        ids = results(block, live)
        if ids:
            yield NotebookCell("\n\n".join(held), files=files)
            yield NotebookCell(shown(ids), True)
            held, files = [], ()
    if held:
        yield NotebookCell("\n\n".join(held), files=files)


def figures(block: Block) -> Iterator[str]:
    """The numbers of the figures in a block."""
    if isinstance(block, FigureBlock):
        yield block.number
    for inner in block.blocks if isinstance(block, Callout) else ():
        yield from figures(inner)


OF_ANSWER = re.compile(r"ask\d+\.")


def results(block: Block, live: Live | None) -> list[str]:
    """The ids of the steps whose result a block shows in a box; those of answers are no steps of the derivation."""
    if live is None or not (isinstance(block, Display) and (block.boxed or block.is_result)):
        return []
    labels = (label for label in (block.label, *block.also) if label.startswith(live.prefix))
    return [id for label in labels if (id := label.removeprefix(live.prefix)) and not OF_ANSWER.match(id)]


def shown(ids: list[str]) -> str:
    """The code that shows steps."""
    return f"derivation.show({', '.join(f'{chr(34)}{id}{chr(34)}' for id in ids)})"

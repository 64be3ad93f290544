"""Writes the gallery: for each problem of the library a page with its figure, statement and results, beside it the
notes and the page in which it moves. `make docs` runs it; nothing that it writes is committed.
"""

from __future__ import annotations

import html
import shutil
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import groupby
from pathlib import Path

import click

from rbpsym.commands.arguments import Entry, shelf
from rbpsym.commands.list import place
from rbpsym.commands.solve import lines
from rbpsym.derive import derive
from rbpsym.document.model import Live, numbered
from rbpsym.document.notes import notes
from rbpsym.document.pictures import drawings, figures_of
from rbpsym.document.twin import address
from rbpsym.document.writers import writer
from rbpsym.explorer.page import explorer
from rbpsym.proof.step import Derivation
from rbpsym.solve import answer_of
from rbpsym.statement.loader import load_problem

HERE = Path(__file__).parent


def write(pages: Path, extra: Path, studio: Path) -> None:
    """All pages into `pages`, what they lead to into `extra`, with the studio where it is built."""
    if has_studio := (studio / "index.html").is_file():
        shutil.copytree(studio, extra / "studio", dirs_exist_ok=True)
    problems = sorted((entry for entry in shelf() if entry.kind == "problem"), key=place)
    (extra / "problems").mkdir(parents=True, exist_ok=True)
    pages.mkdir(exist_ok=True)
    with ProcessPoolExecutor() as crew:
        list(crew.map(partial(write_one, pages=pages, extra=extra, has_studio=has_studio), problems))
    (pages / "index.md").write_text("\n".join(index(problems)), encoding="utf-8")


def write_one(entry: Entry, *, pages: Path, extra: Path, has_studio: bool) -> None:
    """The page of a problem with its figure, and what it leads to."""
    derivation = derive(load_problem(entry.path), simulation=False)
    document = numbered(notes(derivation))
    figure, notation = figures_of(document)[0]
    [drawn] = drawings([(figure.scenes, notation)], "svg", 0)
    (pages / f"{entry.name}.svg").write_bytes(drawn)
    (extra / "problems" / f"{entry.name}.html").write_text(writer("html")(document), encoding="utf-8")
    if moves(derivation):
        moving = explorer((derivation.study.problem,))
        (extra / "problems" / f"{entry.name}-explorer.html").write_text(moving, encoding="utf-8")
    (pages / f"{entry.name}.md").write_text("\n".join(page(entry, derivation, figure.alt, has_studio)), encoding="utf-8")


def moves(derivation: Derivation) -> bool:
    """Whether a motion is told, not the start alone or how mass is spread."""
    return not (derivation.study.at_start or derivation.study.problem.is_at_rest)


def page(entry: Entry, derivation: Derivation, alt: str, has_studio: bool) -> Iterator[str]:
    """The page of a problem."""
    problem = derivation.study.problem
    title, *told = (click.unstyle(line) for line in lines(answer_of(derivation), problem))
    yield f"# {title}\n"
    yield f"```{{image}} {entry.name}.svg\n:alt: {' '.join(alt.split())}\n:width: 24em\n```\n"
    notes_, moving = (f"../problems/{entry.name}{end}.html" for end in ("", "-explorer"))
    see = f' · <a href="{moving}">See it move</a>' if moves(derivation) else ""
    own = html.escape(address("../studio/index.html", Live("", problem.text)))
    change = f' · <a href="{own}">Change this problem</a>' if has_studio else ""
    yield f'```{{raw}} html\n<p><a href="{notes_}">The derivation</a>{see}{change}</p>\n```\n'
    if has_studio:  # a frame in what is closed is loaded when it is opened
        frame = f'<iframe src="{own}" title="{html.escape(title)}" width="100%" height="720" loading="lazy"></iframe>'
        yield f"```{{raw}} html\n<details><summary>Change it here</summary>{frame}</details>\n```\n"
    yield f"Source: {problem.source}.\n" if problem.source else ""
    yield "## Results\n\n```text\n" + "\n".join(told) + "\n```\n"
    yield f"## Statement\n\n```toml\n{problem.text.rstrip()}\n```\n"
    yield f"In the terminal: `rbpsym derive {entry.name}`.\n"


def index(problems: list[Entry]) -> Iterator[str]:
    """The page that leads to all of them, by topic and from easy to hard."""
    yield "# Gallery\n"
    yield "Every problem that ships: its figure, statement, results, its derivation, "
    yield "and (where the motion is known) a page in which it moves.\n"
    for topic, group in groupby(problems, key=lambda entry: entry.topic()):
        yield f"## {topic[:1].upper()}{topic[1:]}\n\n```{{toctree}}\n:maxdepth: 1\n"
        yield from (entry.name for entry in group)
        yield "```\n"


if __name__ == "__main__":
    write(HERE / "gallery", *map(Path, sys.argv[1:3]))

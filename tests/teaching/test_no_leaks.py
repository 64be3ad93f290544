"""A paper made without its key tells nothing of it: whatever the key is, the paper is the same to the last byte."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from rbpsym.document.model import FigureBlock
from rbpsym.expr import tree as t
from rbpsym.teaching import model as m
from rbpsym.teaching.formats import Options, exporter
from rbpsym.teaching.papers import latex_paper, typst_paper
from rbpsym.teaching.papers.html_paper import write_html
from rbpsym.teaching.papers.layout import paper_document
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.ranges import measure_text
from rbpsym.typeset.text import to_text

SOURCES = ["rod-and-disk-fixed", "sliding-ladder", "rod-and-disk-free", "works-that-cancel", "spin-part", "half-ring-rocking"]
OTHER = t.Mul((t.Num(17), t.Sym("g")))
FLIPPED = {"+": "-", "-": "0", "0": "+"}


@cache
def sheet(name: str) -> m.Worksheet:
    return plan_of(name).worksheet(m.Student("ana", "Ana"), "secret")


def other(key: m.Key) -> m.Key:
    """A key of the same task with another answer: what is printed of it as a question stays."""
    match key:
        case m.FormulaKey():
            return replace(key, value=OTHER, anticipated=(), follows=())
        case m.NumberKey(measure=measure):
            return replace(key, measure=replace(measure, value=measure.value + 7), exact=key.exact + 7, formula=OTHER,
                           anticipated=(), follows=())  # fmt: skip
        case m.ChoiceKey(options=options) | m.ComparisonKey(options=options):
            plain = tuple(replace(option, slip=None) for option in options)
            return replace(key, options=plain, right=(key.right + 1) % len(options))
        case m.OrderKey(pieces=pieces):
            return replace(key, before=frozenset({(0, len(pieces) - 1)}), sample=tuple(reversed(key.sample)))
        case m.SlipKey(lines=lines):
            return replace(key, wrong=(key.wrong + 1) % len(lines), corrected=OTHER)
        case m.SignsKey(rows=rows):
            flipped = (replace(r, translational=FLIPPED[r.translational], rotational=FLIPPED[r.rotational]) for r in rows)
            return replace(key, rows=tuple(replace(row, cancels="") for row in flipped))
        case m.BlanksKey(blanks=blanks):
            return replace(key, blanks=tuple(replace(blank, value=OTHER, anticipated=()) for blank in blanks))
        case m.ExplanationKey():
            return replace(key, sample=())
    raise AssertionError(type(key))


def with_other_keys(worksheet: m.Worksheet) -> m.Worksheet:
    parts = tuple(
        replace(
            part,
            items=tuple(replace(item, key=other(item.key), rubric=(), solution=()) for item in part.items),
            solution=(),
        )
        for part in worksheet.parts
    )
    return replace(worksheet, parts=parts)


PAPERS = {
    "html": write_html,
    "tex": lambda sheet: latex_paper.write_paper(paper_document(sheet), sheet),
    "typst": lambda sheet: typst_paper.write_paper(paper_document(sheet), sheet, is_key=False),
}


def test_a_paper_leads_to_the_tutor_of_a_studio() -> None:
    pytest.importorskip("segno", reason="needs segno (pip install 'rbpsym[qr]')")
    paper = paper_document(sheet("sliding-ladder"), "https://example.org/studio/")
    alts = [block.alt for section in paper.sections for block in section.blocks if isinstance(block, FigureBlock)]
    assert any(alt.endswith("#n=sliding-ladder&only=tutor") for alt in alts)


def test_every_kind_of_task_is_looked_at() -> None:
    assert {item.kind for name in SOURCES for item in sheet(name).items} == set(m.KINDS)


@pytest.mark.parametrize("name", SOURCES)
@pytest.mark.parametrize("paper", PAPERS)
def test_the_paper_does_not_depend_on_the_key(name: str, paper: str) -> None:
    assert PAPERS[paper](sheet(name)) == PAPERS[paper](with_other_keys(sheet(name)))


@pytest.mark.parametrize("name", SOURCES)
def test_no_key_is_found_in_the_source(name: str) -> None:
    source = write_html(sheet(name))
    assert "<details" not in source and "<script" not in source
    for item in sheet(name).items:
        if isinstance(item.key, m.NumberKey):
            assert measure_text(item.key.measure) not in source and f"{item.key.exact:.9g}" not in source
        if isinstance(item.key, m.FormulaKey) and len(to_text(item.key.value)) > 4:
            assert to_text(item.key.value, sheet(name).notation) not in source


def test_the_key_is_a_file_of_its_own() -> None:
    made = exporter("html")((sheet("sliding-ladder"),), Options(key=True)).files
    assert sorted(name.partition("/")[0] for name in made) == sorted(["keys", next(n for n in made if "/" not in n)])
    [practice] = [text for name, text in made.items() if name.startswith("keys/")]
    assert "<script" in practice and '<details class="key">' in practice
    assert not any(name.startswith("keys/") for name in exporter("html")((sheet("sliding-ladder"),), Options()).files)

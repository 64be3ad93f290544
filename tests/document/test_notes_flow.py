"""What notes leave out and put together, so that a page reads like one of a book."""

from __future__ import annotations

from functools import cache

import pytest

import rbpsym
from rbpsym.document.model import Display, Document, Math, Paragraph, Section, Text
from rbpsym.document.numbering import numbered, parts
from rbpsym.notation import tree as t

NAMES = ("rod-struck-off-center", "ball-slipping-to-rolling", "yo-yo", "spool-pulled-at-angle")


@cache
def page(name: str) -> Document:
    problem = rbpsym.load_problem(rbpsym.find_problem(name))
    return numbered(rbpsym.notes(rbpsym.derive(problem, simulation=False)))


def displays(document: Document) -> list[Display]:
    return [part for part in parts(document.sections) if isinstance(part, Display)]


def section(document: Document, chapter: str) -> Section | None:
    return next((found for found in document.sections if found.label == f"section.{chapter}"), None)


def text(document: Document) -> str:
    found = (part for part in parts(document.sections) if isinstance(part, Paragraph))
    return "\n".join("".join(i.text for i in part.inlines if isinstance(i, Text)) for part in found)


@pytest.mark.parametrize("name", NAMES)
def test_a_speed_that_stays_zero_is_not_a_result(name: str) -> None:
    for shown in displays(page(name)):
        if isinstance(shown.node, t.Chain) and isinstance(shown.node.items[0], t.Pow):
            assert shown.node.items[-1] != t.ZERO


def test_where_no_force_is_unknown_none_is_looked_for() -> None:
    free, rolling = page("rod-struck-off-center"), page("spool-pulled-at-angle")
    assert section(free, "reactions") is None
    assert section(rolling, "reactions") is not None
    assert "fewest unknown forces" not in text(free)
    assert "fewest unknown forces" in text(rolling)
    assert "No force acts, so nothing changes the energy" in text(free)
    assert "Every force has a potential energy" not in text(free)


def test_a_moment_that_is_given_is_not_called_an_integral() -> None:
    assert "integral over the mass" not in text(page("spool-pulled-at-angle"))
    assert "integral over the mass" in text(page("yo-yo"))


@pytest.mark.parametrize(("name", "count"), [("ball-slipping-to-rolling", 2), ("rod-struck-off-center", 3)])
def test_accelerations_from_the_same_equations_stand_together(name: str, count: int) -> None:
    motion = section(page(name), "motion")
    boxes = [block for block in motion.blocks if isinstance(block, Display) and block.boxed]
    assert [len(block.node.rows) for block in boxes] == [count]
    lead = motion.blocks[motion.blocks.index(boxes[0]) - 1]
    assert sum(isinstance(inline, Math) for inline in lead.inlines) == count


def test_forces_that_stay_the_same_are_not_called_functions_of_position() -> None:
    for name in ("yo-yo", "ball-slipping-to-rolling"):
        assert "function of position alone" not in text(page(name))
        assert "constant:" in text(page(name))


def test_methods_that_were_left_out_are_told_after_those_that_agree() -> None:
    checks = section(page("ball-slipping-to-rolling"), "checks")
    assert isinstance(checks.blocks[-1], Paragraph)
    items = [inline.text for item in checks.blocks[-2].items for inline in item if isinstance(inline, Text)]
    assert not any("cannot" in item or "does not apply" in item for item in items)

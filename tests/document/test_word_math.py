"""A formula in Word: the box round a result, what stands at the right, and widths that fill the page."""

import re
from io import BytesIO
from zipfile import ZipFile

import pytest

from rbpsym.document.model import Display, Document, Section, words
from rbpsym.document.writers import writer
from rbpsym.document.writers.word import NUMBER, TEXT_WIDTH, borders, frame
from rbpsym.expr import tree as t
from tests.document.samples import sample

SIDES = ("top", "left", "bottom", "right")


@pytest.mark.parametrize("count", [1, 2, 3])
def test_the_cells_of_a_result_make_one_box(count):
    for place in range(count):
        edges = frame(place, count)
        ends = {side for side, last in (("top", 0), ("bottom", count - 1)) if place == last}
        assert set(edges) == {"left", "right"} | ends
        for sides in (("left",), ("right",), ("left", "right")):
            drawn = re.findall(r"<w:(top|left|bottom|right) ", borders(edges, *sides))
            assert set(drawn) == set(sides) | ends
            assert drawn == sorted(drawn, key=SIDES.index)
    assert borders({}, "left") == ""


def page_of(document: Document) -> str:
    with ZipFile(BytesIO(writer("docx")(document))) as file:
        return file.read("word/document.xml").decode()


def formulas(*reasons: str, numbered: bool = False) -> Document:
    node = t.relation(t.Sym("E"), "=", t.add(t.Sym("K"), t.Sym("U")))
    shown = tuple(Display(node, numbered=numbered, reason=words(reason) if reason else None) for reason in reasons)
    return Document(words("x"), (Section(words("y"), shown),))


def test_a_formula_with_its_number_fills_the_width_of_the_page():
    grids = re.findall(r"<w:tblGrid>(.*?)</w:tblGrid>", page_of(sample()))
    widths = [list(map(int, re.findall(r'w:w="(\d+)"', grid))) for grid in grids]
    of_formulas = [found for found in widths if len(found) in (3, 4) and sum(found) == TEXT_WIDTH]
    assert len(of_formulas) >= 3
    assert all(found[-1] >= NUMBER for found in of_formulas)
    beside = [found for found in of_formulas if abs(found[0] - found[-1]) > 1]
    assert len(beside) <= 1  # a formula stands in the middle (one of these is a table of the sample)


def test_a_short_reason_stands_where_the_number_would_a_long_one_below():
    def at_the_right(reason: str) -> str:
        cells = re.findall(r"<w:tc>.*?</w:tc>", page_of(formulas(reason)))
        return re.sub("<[^>]*>", "", cells[-1])

    numbered = re.findall(r"<w:tc>.*?</w:tc>", page_of(formulas("given", numbered=True)))
    assert re.sub("<[^>]*>", "", numbered[-1]) == "(1)"
    assert at_the_right("given") == "given"
    assert at_the_right("") == "" and at_the_right("as the energy is constant along the whole motion") == ""

"""A formula in Word: the box round a result, what stands at the right, and widths that fill the page."""

import re

import pytest

from rbpsym.document.writers.word_math import borders, frame

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

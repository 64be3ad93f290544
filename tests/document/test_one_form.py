"""One form for one quantity: no two displayed lines of standard notes end in equal values that are printed in two ways."""

from collections.abc import Iterator

import pytest

from rbpsym.document.model import Display, Document
from rbpsym.document.notes import notes
from rbpsym.expr import tree as t
from rbpsym.field.evaluate import value
from rbpsym.proof.forms import PLAIN
from rbpsym.typeset.text import to_text
from tests.library.derived import NAMES, unsimulated

pytestmark = pytest.mark.heavy


def ends(document: Document) -> Iterator[t.Node]:
    """What the equations come to that are displayed, but for single letters and numbers."""
    for section in document.sections:
        for block in section.blocks:
            for row in t.rows(block.node) if isinstance(block, Display) else ():
                last = row.items[-1] if isinstance(row, t.Chain) and set(row.ops) == {"="} else t.ZERO
                if not isinstance(last, (t.Sym, t.Num)) and all(isinstance(part, PLAIN) for part in t.walk(last)):
                    yield last


@pytest.mark.parametrize("name", NAMES)
def test_equal_quantities_are_printed_in_one_form(name: str) -> None:
    document = notes(unsimulated(name))
    known: dict[object, str] = {}
    for node in ends(document):
        shown = to_text(node, document.notation)
        assert known.setdefault(value(node), shown) == shown
        assert not any(is_stacked(part) for part in t.walk(node)), shown


def is_stacked(node: t.Node) -> bool:
    """Has a fraction another one below its bar, or a sum of fractions above it?"""
    sums = [part for part in t.walk(node.num) if isinstance(part, t.Add)] if isinstance(node, t.Div) else []
    below = [node.den] if isinstance(node, t.Div) else []
    return any(isinstance(part, t.Div) for whole in (*sums, *below) for part in t.walk(whole))

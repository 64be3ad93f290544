"""The way from paper to the page: a code that holds the address, an address that holds the problem."""

from __future__ import annotations

import html
import re
import sys
import zlib
from base64 import urlsafe_b64decode
from importlib.util import module_from_spec, spec_from_file_location

import pytest

from rbpsym.commands.arguments import shelf
from rbpsym.derive import derive
from rbpsym.document.model import Document, Live, Text
from rbpsym.document.twin import MODULE, address, with_twins
from rbpsym.errors import RbpsymError
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.architecture.source import ROOT

LADDER = problem_files()["sliding-ladder"].read_text(encoding="utf-8")
CHANGED = LADDER.replace("70 deg", "60 deg")
SITE = "https://example.org/studio/index.html"


def held(link: str) -> str:
    """The statement in an address."""
    code = link.partition("#p=")[2]
    return zlib.decompress(urlsafe_b64decode(code + "=" * (-len(code) % 4)), -zlib.MAX_WBITS).decode()


def document(text: str) -> Document:
    return Document((Text("A"),), (), live=(Live("sliding-ladder", text),))


def test_an_address_names_the_problem_or_holds_it() -> None:
    assert address(SITE, Live("sliding-ladder", LADDER)) == f"{SITE}#n=sliding-ladder"
    assert held(address(SITE, Live("sliding-ladder", CHANGED))) == CHANGED


@pytest.mark.parametrize("text", [LADDER, CHANGED])
def test_the_code_that_is_drawn_is_that_of_the_address(text: str) -> None:
    segno = pytest.importorskip("segno", reason="needs segno (pip install 'rbpsym[qr]')")
    [section] = with_twins(document(text), SITE).sections
    [figure] = section.blocks
    link = figure.alt.split()[-1]
    assert link == address(SITE, Live("sliding-ladder", text)) and len(link) < 1500
    wanted = [list(map(bool, row)) for row in segno.make_qr(link, error="l").matrix_iter(border=4)]
    seen = [[False] * len(wanted) for _ in wanted]
    for bar in figure.scenes[0].items[1:]:
        (left, low), (right, _), _, _ = ((round(x / MODULE), round(y / MODULE)) for x, y in bar.points)
        for across in range(left, right):
            seen[len(wanted) - 1 - low][across] = True
    assert seen == wanted


def test_what_is_no_address_and_what_is_missing_get_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(RbpsymError, match="is no address"):
        with_twins(document(LADDER), "studio")
    monkeypatch.setitem(sys.modules, "segno", None)
    with pytest.raises(RbpsymError, match="need segno"):
        with_twins(document(LADDER), SITE)


def test_the_gallery_leads_into_the_studio_with_the_problem() -> None:
    """“Change this problem” and the frame hold the statement; without a studio there is neither."""
    spec = spec_from_file_location("gallery", ROOT / "docs" / "gallery.py")
    gallery = module_from_spec(spec)
    spec.loader.exec_module(gallery)
    [entry] = [entry for entry in shelf() if entry.name == "sliding-ladder" and entry.kind == "problem"]
    derivation = derive(load_problem(entry.path), simulation=False)
    text = "\n".join(gallery.page(entry, derivation, "a ladder", True))
    links = [html.unescape(found) for found in re.findall(r'(?:href|src)="([^"]*#p=[^"]*)"', text)]
    assert len(links) == 2 and {held(link) for link in links} == {derivation.study.problem.text}
    assert "Change this problem" in text and "<iframe" in text
    assert "studio" not in "\n".join(gallery.page(entry, derivation, "a ladder", False))

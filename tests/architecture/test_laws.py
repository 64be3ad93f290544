"""The table of findings and laws: each law that it names is a test that is there."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
ROWS = re.findall(r"`([\w/]+\.py)::(\w+)`", (ROOT / "laws.md").read_text(encoding="utf-8"))
KINDS = ("A1 A2 A3 A4 A5 A6 A7 A8 A9 B1 B2 B3 B4 B5 B6 B7 B8 C1 C2 C3 C4 C5 C6 D1 D2 D3 D4 D5 D6 D7 D8 D9 D10 E "
         "Q1 Q2 Q3 Q4 W1 W2 W3 W7 K1 K2 K3 K4 K5 K6 K7 K8").split()  # fmt: skip


@pytest.mark.parametrize(("file", "test"), sorted(set(ROWS)))
def test_each_law_is_a_test(file: str, test: str) -> None:
    assert re.search(rf"^def {test}\(", (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)


def test_each_finding_has_its_law() -> None:
    rows = [line.split("|")[1].split()[0] for line in (ROOT / "laws.md").read_text(encoding="utf-8").splitlines() if "::" in line]
    assert rows == KINDS

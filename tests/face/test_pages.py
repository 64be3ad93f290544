"""The page on Python and sympy says what is so; the notebook of the ladder runs."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from tests.architecture.source import ROOT

PAGE = (ROOT / "docs" / "python-and-sympy.md").read_text(encoding="utf-8")
NOTEBOOK = ROOT / "docs" / "ladder.ipynb"


def test_the_page_says_what_is_so() -> None:
    """A line with a comment has what it tells as the beginning of its value."""
    space: dict[str, Any] = {}
    for code in re.findall(r"```python\n(.*?)```", PAGE, re.S):
        exec(compile("\n".join(line for line in code.splitlines() if "  # " not in line), "page", "exec"), space)
        for line in code.splitlines():
            expression, found, told = line.partition("  # ")
            if found:
                assert str(eval(expression, space)).startswith(told), f"{line}\n{eval(expression, space)}"


def test_the_page_tells_every_answer() -> None:
    from rbpsym.face.model import SymbolicModel

    public = [name for name in vars(SymbolicModel) if not name.startswith("_") and name not in ("study", "derivation")]
    assert [name for name in public if f"`{name}" not in PAGE] == []


def test_the_notebook_runs() -> None:
    nbformat, client = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("matplotlib")
    notebook = nbformat.reads(NOTEBOOK.read_text(encoding="utf-8"), 4)
    nbformat.validate(notebook)
    client.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(ROOT)}}).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    assert any("image/png" in output.get("data", {}) for output in shown), "the curves are drawn"
    assert any("text/latex" in output.get("data", {}) for output in shown), "the equations are shown"


def test_the_notebook_is_kept_without_outputs() -> None:
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    assert all(not cell.get("outputs") and cell.get("execution_count") is None for cell in cells)

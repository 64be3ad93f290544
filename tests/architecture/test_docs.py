"""The reference page is what the registries say, and its tutorial runs."""

import importlib.util
import re
from pathlib import Path

from rbpsym.derive import derive
from rbpsym.statement.loader import load_text

DOCS = Path(__file__).parents[2] / "docs"


def _page() -> str:
    spec = importlib.util.spec_from_file_location("docs_build", DOCS / "build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.page()


def test_the_reference_is_up_to_date():
    assert (DOCS / "statement.md").read_text(encoding="utf-8") == _page(), "run make docs"


def test_the_tutorial_is_a_problem_that_is_derived():
    pieces = re.findall(r"```toml\n(.*?)```", (DOCS / "statement.intro.md").read_text(encoding="utf-8"), re.S)
    derivation = derive(load_text("\n".join(pieces)), simulation=False)
    summary = derivation.summary()
    assert summary["proved"] == summary["steps"] > 20 and summary["methods_agree"]

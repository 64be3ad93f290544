"""What stands beside the README: a listed set of files, none that a command has written there by accident."""

from __future__ import annotations

import subprocess

import pytest

from tests.architecture.source import ROOT

FILES = {
    "ARCHITECTURE.md", "CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "LICENSE", "Makefile", "README.md", "action.yml",
    "pyproject.toml", ".gitattributes", ".gitignore", ".pre-commit-hooks.yaml",
}  # fmt: skip
FOLDERS = {"benchmarks", "derivations", "docs", "rbpsym", "studio", "templates", "tests", ".ci"}


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="no git checkout")
def test_the_root_holds_what_is_listed_and_nothing_else() -> None:
    """What git ignores (build, .venv) is no matter."""
    listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    done = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=True)
    paths = [name.split("/") for name in done.stdout.splitlines()]
    assert paths
    assert {path[0] for path in paths if len(path) == 1} <= FILES
    assert {path[0] for path in paths if len(path) > 1} <= FOLDERS

"""`rbpsym doctor` tells of everything that it knows, whether it is there or not."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.commands.doctor import PACKAGES, PROGRAMS


def rows() -> dict[str, str]:
    found = CliRunner().invoke(main, ["doctor"])
    assert found.exit_code == 0
    return {line.split()[1]: line for line in found.output.splitlines()}


def test_all_is_told() -> None:
    assert set(rows()) == {"Python", *PACKAGES, *PROGRAMS}
    assert all(gives in rows()[name] for name, (gives, _) in (PACKAGES | PROGRAMS).items())


def test_what_is_not_there_comes_with_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    for name, (_, get) in PROGRAMS.items():
        assert rows()[name].startswith("–") and rows()[name].endswith(get)


def test_packages_are_those_of_the_project() -> None:
    """What is told here is a dependency or an extra of pyproject.toml."""
    import tomllib
    from pathlib import Path

    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = [*project["dependencies"], *(each for extra in project["optional-dependencies"].values() for each in extra)]
    assert set(PACKAGES) <= {each.split(">=")[0] for each in wanted}

"""The JSON schema of problem files: all that ship are in it, and what is spoilt is not."""

import copy
import tomllib
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from rbpsym.commands.schema import schema
from rbpsym.statement.library import problem_files

SCHEMA = schema()
VALIDATOR = Draft202012Validator(SCHEMA)
EXAMPLES = {f"{path.parent.name}/{path.stem}": path for path in (Path(__file__).parents[2] / "docs/examples").glob("*/*.toml")}


def test_it_is_a_schema_and_all_problems_that_ship_are_in_it():
    Draft202012Validator.check_schema(SCHEMA)
    told = {name: [error.message for error in VALIDATOR.iter_errors(tomllib.loads(path.read_text("utf-8")))]
            for name, path in {**problem_files(), **EXAMPLES}.items()}  # fmt: skip
    assert len(told) > len(problem_files())
    assert {name: errors for name, errors in told.items() if errors} == {}


def _spoilt():
    whole = tomllib.loads(problem_files()["sliding-ladder"].read_text("utf-8"))
    body, wall = next(iter(whole["bodies"])), next(iter(whole["constraints"]))
    for section, name, key, value in (
        ("bodies", body, "mas", "M"),
        ("bodies", body, "shape", "rodd"),
        ("bodies", body, "angle", None),
        ("constraints", wall, "type", "tuch"),
        ("constraints", wall, "frction", "mu"),
        ("bodys", body, "shape", "rod"),
        ("phases", "x", "event", "no such event"),
    ):
        spoilt = copy.deepcopy(whole)
        if section == "phases":
            spoilt["phases"] = [{"name": name, key: value}]
        else:
            spoilt.setdefault(section, {}).setdefault(name, {})[key] = value if value is not None else {"a": 1}
        yield pytest.param(spoilt, id=f"{section}.{key}")


@pytest.mark.parametrize("spoilt", [*_spoilt()])
def test_what_is_spoilt_is_refused(spoilt):
    assert list(VALIDATOR.iter_errors(spoilt))

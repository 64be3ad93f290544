"""The engine behind the page: strings in, strings out; nothing of the terminal, of numpy or of Typst is needed."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from rbpsym.studio import api

ABSENT = ("click", "rich", "typst", "numpy", "scipy", "flint", "pygments", "docx")
NAMES = ("sliding-ladder", "rod-and-disk-free", "atwood-with-massive-pulley", "ball-slipping-to-rolling", "slider-crank")
BARE = f"""
import json, sys
for name in {ABSENT!r}:
    sys.modules[name] = None  # to import it is an error
from rbpsym.studio import api

def asked(**told):
    found = json.loads(api.call(json.dumps(told)))
    assert "ok" in found, (told["do"], found)
    return found["ok"]

problems = {{card["name"] for card in asked(do="gallery")}}
for name in {NAMES!r}:
    if name not in problems:
        continue
    text = asked(do="statement", name=name)["text"]
    assert asked(do="notes", text=text)["summary"]["refuted"] == 0
    asked(do="answers", text=text)
    asked(do="explorer", text=text)
    for format in api.FORMATS:
        asked(do="export", text=text, format=format)
[page] = asked(do="export", text=text, format="html")["files"]
print("numpy" in page["content"])
[formula] = asked(do="check", text=asked(do="statement", name="sliding-ladder")["text"],
                  paper=r"\\[ \\ddot\\theta = -\\frac{{3g}}{{2\\ell}}\\cos\\theta \\]")
print(formula["outcome"], bool(formula["fix"]))
sheet = asked(do="worksheet", text=asked(do="statement", name="sliding-ladder")["text"], format="moodle")
print([file["name"] for file in sheet["files"]])
"""


def asked(**told: Any) -> Any:
    return json.loads(api.call(json.dumps(told)))


@pytest.fixture
def ladder() -> str:
    return asked(do="statement", name="sliding-ladder")["ok"]["text"]


def test_derives_and_writes_with_nothing_but_sympy_and_jinja() -> None:
    done = subprocess.run([sys.executable, "-c", BARE], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr[-1500:]
    assert done.stdout.splitlines() == ["True", "REFUTED True", "['moodle.xml']"]  # “True”: that plots are left out is said


def test_an_error_is_told_with_its_place(ladder: str) -> None:
    found = asked(do="notes", text=ladder.replace("length = ", "lenght = "))["error"]
    assert found["what"] == "unknown key “lenght” in the body “ladder”"
    assert ladder.splitlines()[found["line"] - 1].startswith("length")
    assert (found["column"], found["width"]) == (1, 6)
    assert found["instead"] == "did you mean “length”?"
    assert found["told"].splitlines()[2].strip() == "^^^^^^"


@pytest.mark.parametrize(
    "request_", ["", "{", "[]", '{"do": "eval"}', '{"do": "notes"}', '{"do": "notes", "text": 1}',
                 '{"do": "notes", "text": "", "x": 1}',
                 '{"do": "export", "text": "a = 1", "format": "exe"}', '{"do": "statement", "name": "../../etc/passwd"}',
                 '{"do": "check", "text": "", "paper": "", "suffix": "/../x"}'])  # fmt: skip
def test_a_bad_request_gets_a_sentence(request_: str) -> None:
    assert json.loads(api.call(request_))["error"]["what"]


def test_the_schema_tells_every_operation() -> None:
    found = asked(do="schema")["ok"]
    assert set(found) == set(api.OPERATIONS)
    assert all(one["answers"] for one in found.values())
    assert found["export"]["takes"]["format"] == {"kind": "str"}


def test_completions_tell_what_the_registries_hold() -> None:
    found = asked(do="completions")["ok"]
    assert found["kinds"]["bodies"]["names"]["rod"]["points"] == ["center", "start", "end", "cm"]
    assert "stiffness" in found["kinds"]["interactions"]["names"]["spring"]["keys"]
    assert found["sections"]["bodies"] and found["dimensions"]["force"]
    assert "velocity of BODY.cm" in found["quantities"]


def test_answers_come_with_the_drawing(ladder: str) -> None:
    found = asked(do="answers", text=ladder)["ok"]
    assert found["figure"].startswith("<svg")
    assert [one["verdict"] for one in found["answers"]] == ["PROVED", "PROVED"]

"""The engine behind the page: strings in, strings out; nothing of the terminal, of numpy or of Typst is needed."""

from __future__ import annotations

import json
import subprocess
import sys
from base64 import b64decode
from io import BytesIO
from typing import Any
from zipfile import ZipFile

import pytest

from rbpsym.derive import derive
from rbpsym.studio import api, kept

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


def test_a_sheet_travels_as_a_list_of_lines(ladder: str) -> None:
    line = "theta_ddot = 3*g/(4*ell)*cos(theta)"
    assert asked(do="judge", text=ladder, line=line, lines=[line])["ok"]["verdict"] == "wrong"
    assert asked(do="record", text=ladder, lines=[line])["ok"]["lines"][0]["verdict"] == "wrong"
    assert "of another kind" in asked(do="record", text=ladder, lines=[1])["error"]["what"]


def test_a_line_is_seen_as_it_is_printed_while_it_is_typed(ladder: str) -> None:
    line = "theta_ddot = 3*g/(4*ell)*cos(theta)"
    whole, part = (asked(do="typed", text=ladder, line=typed)["ok"]["math"] for typed in (line, line[:15]))
    assert "<mfrac>" in whole and part == "" and asked(do="judge", text=ladder, line=line)["ok"]["math"] == whole
    found = asked(do="letters", text=ladder)["ok"]
    assert all(one.startswith("<math") for one in found["shown"]) and len(found["shown"]) == len(found["letters"])


def test_a_question_that_an_edit_adds_is_known_to_the_tutor(ladder: str) -> None:
    """The derivation is kept from the statement before, its words are not."""
    asked(do="letters", text=ladder)
    more = f'{ladder}\n[[ask]]\nquestion = "time until N_w = 0"\n\n[[ask]]\nquestion = "N_f at the start"\n'
    assert asked(do="judge", text=more, line="N = M*g*(4 - 3*cos(theta_0)^2)/4")["ok"]["verdict"] != "undecided"


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


def test_a_pasted_sentence_is_decided(ladder: str) -> None:
    paper = (
        r"As $\theta$ falls, $\ddot\theta = -\frac{3g}{4\ell}\cos\theta$, and not $\ddot\theta = -\frac{3g}{2\ell}\cos\theta$."
    )
    assert [one["outcome"] for one in asked(do="check", text=ladder, paper=paper)["ok"]] == ["PROVED", "REFUTED"]


def test_answers_are_proved(ladder: str) -> None:
    assert [one["verdict"] for one in asked(do="answers", text=ladder)["ok"]] == ["PROVED", "PROVED"]
    others = asked(do="answers", text=ladder, questions=["N_f at the start", "F at the start"])["ok"]
    assert [one["verdict"] for one in others] == ["PROVED", ""] and "means nothing" in others[1]["says"]
    assert asked(do="picture", name="sliding-ladder")["ok"]["figure"] == asked(do="glance", text=ladder)["ok"]["figure"]


def test_at_a_glance_are_drawing_motion_and_forces(ladder: str) -> None:
    found = asked(do="glance", text=ladder)["ok"]
    assert found["figure"].startswith("<svg") and found["alt"]
    assert (len(found["motion"]), len(found["forces"])) == (1, 2)
    assert "<mfrac>" in found["motion"][0]


def _edited(text: str, *, title: str = "", question: str = "", mass: str = "", meaning: str = "") -> str:
    told = text.replace("Sliding ladder", title) if title else text
    told = told.replace('= "M"', f'= "{mass}"') if mass else told
    told = told.replace("angle between", meaning) if meaning else told
    return told + (f'\n[[ask]]\nquestion = "{question}"\n' if question else "")


@pytest.mark.parametrize(
    ("edit", "derives"),
    [({"title": "Another name"}, 0), ({"meaning": "its angle"}, 0), ({"question": "N_f at the start"}, 0), ({"mass": "2*M"}, 1)],
)
def test_what_an_edit_does_not_change_is_not_derived_again(
    ladder: str, edit: dict[str, str], derives: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And what is kept makes no difference: the page is the one of a statement that is seen for the first time."""
    asked(do="notes", text=ladder)
    calls: list[object] = []
    monkeypatch.setattr(kept, "derive", lambda *args, **keys: (calls.append(args), derive(*args, **keys))[1])
    text = _edited(ladder, **edit)
    found = asked(do="notes", text=text)["ok"]
    assert len(calls) == derives
    kept._WORKED.clear()
    api.call.cache_clear()
    assert asked(do="notes", text=text)["ok"] == found


def test_many_files_come_as_one_archive(ladder: str) -> None:
    told = {"do": "worksheet", "text": ladder, "format": "prairielearn"}
    several, [one] = (asked(**told, packed=packed)["ok"]["files"] for packed in (False, True))
    names = ZipFile(BytesIO(b64decode(one["content"]))).namelist()
    assert one["name"] == "problem.zip" and names == [file["name"] for file in several] and len(names) > 2


def test_another_problem_moves_beside_it(ladder: str) -> None:
    assert asked(do="explorer", text=ladder, beside="rod-pendulum")["ok"]["html"].count('class="picture"') == 2
    assert "no problem" in asked(do="explorer", text=ladder, beside="../x")["error"]["what"]

"""Findings for other programs: SARIF, a baseline, a page of coloured texts; paths are from here, the same input is told alike."""

import json
import re
from pathlib import Path

import jsonschema
import pytest

from rbpsym.cli import main
from rbpsym.commands.check import command
from rbpsym.errors import RbpsymError
from tests.claims.test_beside import RIGHT, TEX, WRONG

NEXT = f"% rbpsym: claim\n\\begin{{equation}}\\label{{a}} {RIGHT} \\end{{equation}}\n"
PART = f"% rbpsym: claim\n\\[ {WRONG} \\]\nMore \\label{{b}} text\n{NEXT}"
WHOLE = f"{TEX}\n\\input{{part/b}}\n% rbpsym: claim\n\\[ V = Q \\]\n"
TEXT, PLACE = {"type": "object", "required": ["text"]}, {"type": "integer", "minimum": 1}
FILE = {"type": "object", "required": ["uri"], "properties": {"uri": {"type": "string", "pattern": r"^[\w./-]+$"}}}
REGION = {"type": "object", "required": ["startLine"], "properties": {"startLine": PLACE}}
PHYSICAL = {"type": "object", "required": ["artifactLocation"], "properties": {"artifactLocation": FILE, "region": REGION}}
RESULT = {"type": "object", "required": ["message", "ruleId", "locations"], "properties": {
    "message": TEXT, "level": {"enum": ["none", "note", "warning", "error"]},
    "locations": {"type": "array", "items": {"type": "object", "properties": {"physicalLocation": PHYSICAL}}},
    "partialFingerprints": {"type": "object", "additionalProperties": {"type": "string"}},
    "suppressions": {"type": "array", "items": {"required": ["kind"], "properties": {"kind": {"const": "external"}}}},
}}  # fmt: skip
DRIVER = {"type": "object", "required": ["name"], "properties": {"rules": {"type": "array", "items": {"required": ["id"]}}}}
RUN = {"type": "object", "required": ["tool"], "properties": {
    "tool": {"type": "object", "required": ["driver"], "properties": {"driver": DRIVER}},
    "results": {"type": "array", "items": RESULT}, "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
}}  # fmt: skip
SARIF = {"type": "object", "required": ["version", "runs"], "properties": {
    "version": {"const": "2.1.0"}, "runs": {"type": "array", "items": RUN}}}  # fmt: skip


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "book" / "part").mkdir(parents=True)
    (tmp_path / "book" / "a.tex").write_text(WHOLE)
    (tmp_path / "book" / "part" / "b.tex").write_text(PART)
    return tmp_path


def check(*more):
    return main.main(["check", "book/a.tex", "--no-cache", *more], standalone_mode=False)


def test_sarif_is_what_its_schema_asks_for(folder):
    """The required shape of 2.1.0, places that can be found from here, rules that are declared."""
    assert check("--sarif", "a.sarif") == 2
    whole = json.loads((folder / "a.sarif").read_text())
    jsonschema.validate(whole, SARIF)
    [run] = whole["runs"]
    rows = run["results"]
    assert {row["ruleId"] for row in rows} == {"refuted", "unread"} <= {rule["id"] for rule in run["tool"]["driver"]["rules"]}
    places = [row["locations"][0]["physicalLocation"] for row in rows]
    assert {place["artifactLocation"]["uri"] for place in places} == {"book/a.tex", "book/part/b.tex"}
    assert [place["region"]["startLine"] for place in places] == [2, 6]


def test_paths_are_from_here_in_every_report(folder, capsys):
    check("--junit", "a.xml", "--github", "--html", "a.html")
    told = capsys.readouterr().out + (folder / "a.xml").read_text() + (folder / "a.html").read_text()
    assert "file=book/part/b.tex,line=2" in told and 'classname="book/part/b.tex"' in told and str(folder) not in told


def test_the_same_text_has_the_same_reports(folder, capsys):
    made = []
    for _ in range(2):
        check("--json", "--sarif", "a.sarif", "--html", "a.html", "--fix", "a.patch", "--baseline", "a.json", "--write-baseline")
        files = [(folder / name).read_text() for name in ("a.sarif", "a.html", "a.patch", "a.json")]
        made.append([capsys.readouterr().out, *files])
        assert f"+\\[ {RIGHT} \\]" in files[2]  # what a baseline holds is repaired all the same
    assert made[0] == made[1]


def test_what_is_known_is_no_fault_wherever_it_has_moved(folder, capsys):
    assert check("--baseline", "known.json", "--write-baseline") == 0
    path = folder / "book" / "part" / "b.tex"
    path.write_text("New\n\n\\[ a=b \\]\n" + PART.replace("omega^3", "omega ^3"))
    assert check("--baseline", "known.json", "--sarif", "a.sarif") == 0
    assert all(row["suppressions"] for row in json.loads((folder / "a.sarif").read_text())["runs"][0]["results"])
    path.write_text(PART.replace(RIGHT, WRONG))
    assert check("--baseline", "known.json") == 1  # a second one of the same kind is new
    path.write_text(PART.replace("omega^3", "omega^4"))
    capsys.readouterr()
    assert check("--baseline", "known.json") == 1 and "1 findings of the baseline are gone" in capsys.readouterr().out


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"findings": [1]}', '{"findings": [{"file": 1}]}', "[" * 100_000])
def test_what_is_no_baseline_is_told(folder, text):
    (folder / "known.json").write_text(text)
    with pytest.raises(RbpsymError, match="no baseline"):
        check("--baseline", "known.json")


def test_a_baseline_that_was_never_written_says_how(folder):
    with pytest.raises(RbpsymError, match="no baseline yet") as told:
        check("--baseline", "known.json")
    assert "--write-baseline" in told.value.instead


@pytest.mark.parametrize("option", [("--baseline", "--write-baseline"), ("--json",)])
def test_two_runs_are_compared(folder, capsys, option):
    def run(name):
        capsys.readouterr()
        check(*((option[0], name, option[1]) if len(option) == 2 else option))
        if len(option) == 1:
            (folder / name).write_text(capsys.readouterr().out)
        capsys.readouterr()

    run("old.json")
    path = folder / "book" / "part" / "b.tex"
    path.write_text(PART.replace(WRONG, RIGHT))
    run("better.json")
    path.write_text(PART.replace(WRONG, RIGHT.replace("^2", "^5")))
    run("worse.json")
    tell = lambda *names: (  # noqa: E731
        main.main(["check", "--compare", *names], standalone_mode=False), capsys.readouterr().out)
    code, told = tell("old.json", "better.json")
    assert code == 0 and "REFUTED -> -" in told and "- -> REFUTED" not in told
    assert tell("old.json", "worse.json")[0] == 1
    assert tell("worse.json", "worse.json")[1].startswith("0 changed")


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"findings": [1]}', '{"results": [{"file": 1}]}'])
def test_what_can_not_be_compared_is_told(folder, text):
    (folder / "old.json").write_text(text)
    with pytest.raises(RbpsymError, match="no findings"):
        main.main(["check", "--compare", "old.json", "old.json"], standalone_mode=False)


def test_the_page_shows_the_texts_with_what_was_read(folder):
    check("--html", "a.html")
    page = (folder / "a.html").read_text()
    shown = r'class="unexpected" title="V² = ℓ²[^"]*?REFUTED[^"]*">V\^2 = \\ell\^2\\omega\^3</a> \\\]'
    assert re.search(shown, page)
    assert "book/part/b.tex: 1 unexpected, 1 proved" in page


ROOT = Path(__file__).parents[2]


def test_the_action_and_the_hook_call_what_there_is():
    """They install this very tree, so that they work before a release; what they call has only options that there are."""
    action, hook = (ROOT / "action.yml").read_text(), (ROOT / ".pre-commit-hooks.yaml").read_text()
    assert "using: composite" in action and 'pip install "$GITHUB_ACTION_PATH"' in action
    [call] = re.findall(r"^\s+(rbpsym check .*)$", action, re.M)
    [entry] = re.findall(r"^\s+entry: (rbpsym check.*)$", hook, re.M)
    known = {name for option in command.params for name in option.opts}
    assert set(re.findall(r"--[\w-]+", f"{call} {entry}")) <= known
    named = set(re.findall(r"\$\{\{ inputs\.([\w-]+) \}\}", action))
    assert named == set(re.findall(r"^  ([\w-]+):$", action.partition("inputs:")[2].partition("runs:")[0], re.M))

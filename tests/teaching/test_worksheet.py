"""Worksheets: the same bytes again from the same secret, papers in all formats, errors with their places."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.errors import RbpsymError
from rbpsym.statement.library import library_folder, worksheet_files
from rbpsym.teaching import codes
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.formats import Options, exporter
from rbpsym.teaching.grading.desk import Desk, grade_worksheet
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.papers.html_fields import spellings
from rbpsym.teaching.papers.latex_paper import write_paper as latex_paper
from rbpsym.teaching.papers.layout import file_stem, key_document, own, paper_document, safe, solution_document
from rbpsym.teaching.papers.typst_paper import write_paper as typst_paper
from rbpsym.teaching.plan import WorksheetPlan, plan_of
from rbpsym.teaching.sheet import sheet_of_text
from rbpsym.teaching.spreadsheets import roster_of
from rbpsym.typeset.machine import to_machine

ANA = Student("ana", "Ana López")
ROOT = Path(__file__).resolve().parents[2]


@cache
def plan(name: str = "sliding-ladder") -> WorksheetPlan:
    return plan_of(name)


@cache
def ladder() -> Worksheet:
    return plan().worksheet(ANA, "secret")


# --- the same again


def test_draws_are_fixed_for_ever() -> None:
    """On every machine and in every version: a form code that was printed must rebuild its paper."""
    draws = Draws(b"seed", "label")
    assert [draws.below(1000) for _ in range(6)] == [839, 537, 52, 646, 671, 481]


def test_draws_are_even_and_stay_inside() -> None:
    draws = Draws(b"even")
    counts = [0] * 6
    for _ in range(6000):
        counts[draws.below(6)] += 1
    assert max(counts) - min(counts) < 200
    assert sorted(draws.shuffled(range(20))) == list(range(20))
    with pytest.raises(ValueError, match="nothing"):
        draws.below(0)


def test_a_student_gets_the_same_again_and_others_something_else() -> None:
    again = plan_of("sliding-ladder").worksheet(ANA, "secret")
    assert typst(again) == typst(ladder())
    others = {plan().worksheet(Student(f"s{k}"), "secret").parts[0].given["M"].value for k in range(12)}
    assert len(others) > 4
    assert plan().worksheet(ANA, "another").code != ladder().code


def typst(sheet: Worksheet) -> str:
    return typst_paper(paper_document(sheet), sheet) + typst_paper(key_document(sheet), sheet, is_key=True)


def test_the_seed_is_sha256_of_secret_worksheet_and_student() -> None:
    parts = [b"secret", b"sliding-ladder", b"ana"]
    joined = b"".join(len(part).to_bytes(8, "big") + part for part in parts)
    wanted = int.from_bytes(hashlib.sha256(joined).digest()[:8], "big") >> 4
    assert codes.seed_of("secret", "sliding-ladder", "ana") == wanted
    assert codes.read(ladder().code, "secret", plan().fingerprint).seed == wanted


def test_the_code_rebuilds_paper_and_key() -> None:
    again = plan().from_code(ladder().code.lower(), "secret", ANA)
    assert typst(again) == typst(ladder())


@pytest.mark.parametrize("spoil", [lambda c: c[:-1] + ("0" if c[-1] != "0" else "1"), lambda c: c[:-3], lambda c: "x",
                                   lambda c: c.replace("-", "?", 1)])  # fmt: skip
def test_a_mistyped_code_is_told(spoil) -> None:
    with pytest.raises(RbpsymError) as error:
        plan().from_code(spoil(ladder().code), "secret")
    assert error.value.instead


def test_a_code_needs_its_secret_and_its_text() -> None:
    for secret, text in (("wrong", plan().fingerprint), ("secret", "another text")):
        with pytest.raises(RbpsymError, match="does not fit"):
            codes.read(ladder().code, secret, text)
    assert str(codes.seed_of("secret", "sliding-ladder", "ana")) not in ladder().code


def test_letters_that_look_alike_are_read_as_meant() -> None:
    code = codes.FormCode("a.b", "en", 123456789)
    text = codes.written(code, "s", "t")
    head, tail = text.rsplit(".", 1)
    confused = tail.replace("1", "l").replace("0", "O")
    assert codes.read(f"{head}.{confused}", "s", "t") == code


# --- papers


@cache
def papers(name: str) -> dict[str, bytes | str]:
    sheet = plan(name).worksheet(ANA, "secret")
    options = Options(key=True, solution=True, derivations=plan(name).derivations)
    return {
        path: content
        for fmt in ("pdf", "tex", "html")
        for path, content in exporter(fmt)((sheet,), options).files.items()
    }


@pytest.mark.parametrize("name", [*worksheet_files()])
def test_each_worksheet_that_ships_is_printed_whole(name: str) -> None:
    made = papers(name)
    stem = f"{name}-ana"
    for path in (f"{stem}.pdf", f"keys/{stem}-key.pdf", f"keys/{stem}-solution.pdf"):
        assert made[path].startswith(b"%PDF-")
    assert {f"{stem}.tex", f"keys/{stem}-key.tex", f"keys/{stem}-solution.tex", f"{stem}.html"} <= set(made)
    text = pdf_text(made[f"{stem}.pdf"])
    code = plan(name).worksheet(ANA, "secret").code
    assert code in text.replace("\n", "")
    assert "Ana" in text


def pdf_text(content: bytes) -> str:
    if shutil.which("pdftotext") is None:
        pytest.skip("poppler is not installed")
    done = subprocess.run(["pdftotext", "-layout", "-", "-"], input=content, capture_output=True, check=True)
    return done.stdout.decode()


def test_the_paper_holds_no_answer() -> None:
    sheet = ladder()
    key = typst_paper(key_document(sheet), sheet, is_key=True)
    paper = typst_paper(paper_document(sheet), sheet)
    numbers = [item.key.measure for item in sheet.items if item.kind == "number"]
    from rbpsym.teaching.ranges import measure_text

    for measure in numbers:
        assert measure_text(measure) in key and measure_text(measure) not in paper


def test_latex_compiles_in_the_exam_class(tmp_path: Path) -> None:
    if shutil.which("pdflatex") is None:
        pytest.skip("no TeX here")
    for path, content in papers("works-that-cancel").items():
        if path.endswith(".tex"):
            assert r"{exam}" in content
            file = tmp_path / Path(path).name
            file.write_text(content, encoding="utf-8")
            command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", file.name]
            done = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False, timeout=100)
            assert done.returncode == 0, done.stdout.decode("utf-8", "replace")[-600:]


def test_names_that_are_code_stay_text() -> None:
    evil = Student("=cmd|x", '\\input{/etc/passwd} #eval("1") <script>alert(1)</script>')
    sheet = plan().worksheet(evil, "s")
    assert "\\input{" not in latex_paper(paper_document(sheet), sheet)
    assert "#eval" not in typst_paper(paper_document(sheet), sheet).replace("\\#eval", "")
    [page] = exporter("html")((sheet,), Options()).files.values()
    assert "<script>alert" not in page
    assert safe("../../etc/passwd") == "etc-passwd" and "/" not in file_stem(sheet)


def test_the_solution_shows_the_students_numbers() -> None:
    sheet = ladder()
    source = typst_paper(solution_document(sheet, plan().derivations), sheet, is_key=True)
    mass = sheet.parts[0].given["ell"]
    from rbpsym.teaching.ranges import measure_text

    assert measure_text(mass).split("\u00a0")[0] in source
    assert "9.81" in source


# --- the page that checks itself


def node(script: str) -> object:
    runtime = shutil.which("node")
    if runtime is None:
        pytest.skip("no Node here")
    whole = f"const W = require({json.dumps(str(ROOT / 'templates' / 'worksheet.js'))});\n{script}"
    done = subprocess.run([runtime, "-e", whole], capture_output=True, check=True, timeout=60)
    return json.loads(done.stdout)


def page_keys(sheet: Worksheet) -> dict:
    [page] = (text for name, text in exporter("html")((sheet,), Options(key=True)).files.items() if "key" in name)
    found = re.search(r'<script type="application/json" id="keys">(.*?)</script>', page, re.S)
    return json.loads(found[1])["keys"]


def test_the_page_checks_typed_formulas_numbers_and_orders() -> None:
    sheet, keys = ladder(), page_keys(ladder())
    from rbpsym.typeset.text import to_text

    cases = []
    for item in sheet.items:
        key = keys.get(f"{item.id}.0")
        if item.kind == "formula":
            right = to_text(item.key.value, sheet.notation)
            cases += [
                (key, right, "right"),
                (key, f"2 {right}", "wrong"),
                (key, "(M g", "invalid"),
                (key, "alert(1)", "invalid"),
            ]
            wrong = to_text(item.key.anticipated[0].formula, sheet.notation)
            cases.append((key, wrong, "wrong"))
        if item.kind == "number":
            value = float(item.key.measure.value)
            unit = item.key.measure.unit
            cases += [(key, f"{value:g} {unit}", "right"), (key, f"{value:g}", "unit"), (key, f"{value * 1.1:g} {unit}", "wrong"),
                      (key, f"{str(value).replace('.', ',')} {unit}", "right"), (key, "much", "invalid"),
                      (key, f"{value:.7f} {unit}", "many")]  # fmt: skip
        if item.kind == "order":
            letters = "abcdefgh"
            cases.append((key, " ".join(letters[k] for k in item.key.sample), "right"))
            cases.append((key, " ".join(letters[k] for k in reversed(item.key.sample)), "wrong"))
            cases.append((key, "a b", "invalid"))
    assert len(cases) >= 12
    script = (
        f"const cases = {json.dumps(cases)};\n"
        "console.log(JSON.stringify(cases.map(([key, text]) => W.CHECKS[key.check](key, [text]).verdict)));"
    )
    assert node(script) == [verdict for _, _, verdict in cases]


def test_the_page_checks_signs_and_groups() -> None:
    sheet, keys = ladder(), page_keys(ladder())
    item = next(item for item in sheet.items if item.kind == "signs")
    letters = {"": "", "N_w": "p", "N_f": "q"}
    right = [cell for row in item.key.rows for cell in (row.translational, row.rotational, letters[row.cancels])]
    alike = ["p" if cell == "q" else cell for cell in right]
    turned = ["+" if cell == "-" else cell for cell in right]
    script = (
        f"const key = {json.dumps(keys[f'{item.id}.0'])};\n"
        f"const all = {json.dumps([right, alike, turned, [''] * len(right)])};\n"
        "console.log(JSON.stringify(all.map(a => W.CHECKS.signs(key, a).verdict)));"
    )
    assert node(script) == ["right", "wrong", "wrong", "invalid"]


def test_the_page_names_the_slip() -> None:
    sheet, keys = ladder(), page_keys(ladder())
    item = next(item for item in sheet.items if item.kind == "number")
    slip = item.key.anticipated[0]
    text = f"{float(slip.number.value):g} {slip.number.unit}"
    script = f"console.log(JSON.stringify(W.checkNumber({json.dumps(keys[f'{item.id}.0'])}, {json.dumps(text)})));"
    found = node(script)
    assert found["verdict"] == "wrong" and len(found["comment"]) > 20


def test_hostile_input_in_the_page_ends_at_once() -> None:
    key = next(k for k in page_keys(ladder()).values() if k["check"] == "formula")
    texts = ["(" * 5000, "constructor", "__proto__", "g^g^g^g^g^g", "9" * 500, "a" * 10000, "M" * 550, "\u202eM", ""]
    script = (
        f"const key = {json.dumps(key)}, texts = {json.dumps(texts)}, begun = Date.now();\n"
        "const found = texts.map(t => W.checkFormula(key, t).verdict);\n"
        "console.log(JSON.stringify([found, Date.now() - begun]));"
    )
    found, took = node(script)
    assert "right" not in found and took < 1000


def test_spellings_are_not_ambiguous() -> None:
    names = ("M", "ell", "theta_0", "theta_dot")
    found = spellings(names, ladder().notation)
    assert found["omega"] == found["ω"] == "theta_dot"
    assert found["l"] == found["ℓ"] == "ell" and found["θ₀"] == found["theta0"] == "theta_0"


# --- worksheet files


GOOD = """
title = "Mine"
[[problem]]
name = "sliding-ladder"
[problem.numbers]
M = { from = "5 kg", to = "6 kg", step = "0.5 kg" }
theta_0 = "60 deg"
theta = "45 deg"
[[problem.task]]
kind = "number"
about = "speed.theta"
points = 2.5
"""


def test_wishes_are_kept() -> None:
    whole = plan_of(sheet_of_text(GOOD))
    for k in range(6):
        sheet = whole.worksheet(Student(str(k)))
        given = sheet.parts[0].given
        assert given["theta_0"].value == 60 and given["M"].value * 2 in (10, 11, 12)
        [item] = sheet.items
        assert item.key.given["theta"].value == 45 and float(item.points) == 2.5


BAD = [
    (GOOD.replace("title", "titel"), "unknown key “titel”", 2),
    (GOOD.replace('"sliding-ladder"', '"sliding-lader"'), "no problem", 4),
    (GOOD.replace('kind = "number"', 'kind = "numbr"'), "no kind of task “numbr”", 10),
    (GOOD.replace('"speed.theta"', '"speed.phi"'), "no quantity", 10),
    (GOOD.replace("points = 2.5", "points = -1"), "points", 12),
    (GOOD.replace("points = 2.5", "level = 7"), "level", 12),
    (GOOD.replace("points = 2.5", 'answers = "words"'), "answers", 12),
    (GOOD.replace('kind = "number"', 'kind = "find-the-slip"\nmisconceptions = ["spin"]'), "no misconception", 11),
    (GOOD.replace("points = 2.5", "number = 4"), "only 1", 10),
    (GOOD.replace('"5 kg"', '"5 m"'), "no unit", 6),
    (GOOD.replace('"5 kg"', '"five kg"'), "no number", 6),
    (GOOD.replace('"6 kg"', '"4 kg"'), "ends before", 6),
    (GOOD.replace('step = "0.5 kg"', 'step = "0 kg"'), "step", 6),
    (GOOD.replace("theta_0 =", "theta_9 ="), "unknown key “theta_9”", 7),
    (
        GOOD.replace('kind = "number"\nabout = "speed.theta"', 'kind = "choose"\nabout = "moment.ladder"'),
        "only 2 wrong answers",
        10,
    ),
    (GOOD + "language = 3", "", 0),
    ('title = "x"', "no “problem”", 1),
]


@pytest.mark.parametrize(("text", "what", "line"), BAD, ids=range(len(BAD)))
def test_bad_files_are_told_with_their_place(text: str, what: str, line: int) -> None:
    with pytest.raises(RbpsymError) as error:
        plan_of(sheet_of_text(text, "mine.toml"))
    assert what in error.value.what
    assert error.value.place is not None
    if line:
        assert error.value.place.line == line and "^" in str(error.value)
        assert error.value.instead


def test_numbers_that_can_not_be_are_told() -> None:
    text = GOOD.replace('theta = "45 deg"', 'theta = "30 deg"')  # it leaves the wall at 35.3 deg
    with pytest.raises(RbpsymError, match="would not be reached"):
        plan_of(sheet_of_text(text)).worksheet()


def test_rosters() -> None:
    assert roster_of("id,name\na1,Ana\nb2,Ben\n") == (Student("a1", "Ana"), Student("b2", "Ben"))
    assert roster_of("Nombre;Correo\nAna;a@x.mx\n") == (Student("a@x.mx", "Ana"),)
    assert roster_of("id\na1\nb2\n")[1] == Student("b2", "b2")
    for text, what in (
        ("", "empty"),
        ("a1\nb2\n", "names no column"),  # a paper for the student “a1”, where “foo” was meant to be a heading
        ("foo,bar\n1,2\n", "names no column"),
        ("id,name\n", "no student"),
        ("id\na\na\n", "twice"),
        ("id,name\n,Ana\n", "without a key"),
        ("id\n" + "x" * 300, "printed"),
    ):
        with pytest.raises(RbpsymError, match=what):
            roster_of(text)


# --- the command


def run(*arguments: str):
    return CliRunner().invoke(main, ["worksheet", *arguments])


def test_the_command_writes_papers_for_a_class(tmp_path: Path) -> None:
    roster = tmp_path / "class.csv"
    roster.write_text("id,name\na1,Ana\nb2,Ben\n", encoding="utf-8")
    out = tmp_path / "papers"
    done = run(
        "works-that-cancel", "--students", str(roster), "--seed", "s", "--key", "--format", "tex,html", "-o", str(out)
    )
    assert done.exit_code == 0, done.output
    assert {p.relative_to(out).as_posix() for p in out.rglob("*.*")} == {
        f"{folder}works-that-cancel-{student}{end}"
        for student in ("a1", "b2")
        for folder, end in (("", ".tex"), ("", ".html"), ("keys/", "-key.tex"), ("keys/", "-key.html"))
    } | {"works-that-cancel.papers.json"}
    code = re.search(r"Form ([\w.-]+)", (out / "works-that-cancel-a1.tex").read_text())[1]
    again = run("--from-code", code, "--seed", "s", "--format", "tex", "--key", "-o", str(tmp_path / "again"))
    assert again.exit_code == 0, again.output
    key = (tmp_path / "again" / "keys" / "works-that-cancel-key.tex").read_text()
    assert key.replace("", "") and code in key
    wrong = run("--from-code", code, "--seed", "other", "-o", str(tmp_path / "none"))
    assert wrong.exit_code == 2 and not (tmp_path / "none").exists()


@pytest.mark.parametrize(
    "arguments",
    [("nothing-like-this",), (), ("sliding-ladder", "--lang", "xx"), ("sliding-ladder", "--format", "docx"),
     ("sliding-ladder", "--variants", "0"), ("sliding-ladder", "--students", "nowhere.csv"),
     ("sliding-ladder", "--variants", "2", "--from-code", "x")],
)  # fmt: skip
def test_bad_commands_get_a_sentence(arguments: tuple[str, ...], tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = run(*arguments, *(["-o", str(out)] if arguments else []))
    assert done.exit_code == 2 and "Traceback" not in done.output
    assert not out.exists()


def test_the_folder_of_worksheets_holds_no_problem() -> None:
    assert (library_folder() / "worksheets").is_dir()
    assert {"spin-part", "works-that-cancel", "spring-whose-works-do-not-cancel"} <= set(worksheet_files())


def test_the_documentation_names_everything() -> None:
    from rbpsym.teaching.formats import EXPORTERS
    from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS, SOURCES
    from rbpsym.teaching.ranges import RANGE_KEYS
    from rbpsym.teaching.sheet import PROBLEM_KEYS, SHEET_KEYS, TASK_KEYS
    from rbpsym.teaching.tasks.registry import TASKS

    text = (ROOT / "docs" / "worksheets.md").read_text(encoding="utf-8")
    names = {*TASKS, *MISCONCEPTIONS, *EXPORTERS, *SHEET_KEYS, *TASK_KEYS, *RANGE_KEYS, *PROBLEM_KEYS}
    assert not [name for name in names if f"`{name}`" not in text and f"[[problem.{name}]]" not in text
                and f"[[{name}]]" not in text]  # fmt: skip
    assert all(source in text for source in SOURCES.values())
    sheet = sheet_of_text(text.split("```toml\n")[1].split("```")[0])
    assert len(plan_of(sheet).worksheet().items) == 3


def test_every_student_has_a_file_of_their_own() -> None:
    ids = ["王", "李", "Иван", "Ольга", "a_b", "a-b", "Ana", "ana", "José", "jose", "x" * 60, "x" * 61]
    assert len({own(id).casefold() for id in ids}) == len(ids)


PHASES = {"question.1": "This is asked", "acceleration.y": "In the phase before “bounced”",
          "phase2.start.y_dot": "When “bounced” begins",
          "phase2.speed.y": "In the phase “bounced”", "phase2.start.blow": "", "phase3.speed.y": ""}  # fmt: skip


@pytest.mark.parametrize(("about", "told"), PHASES.items())
def test_a_task_says_in_which_phase_it_asks_and_is_marked_there(about: str, told: str) -> None:
    text = f'title = "Bounce"\n[[problem]]\nname = "superball"\n[[problem.task]]\nkind = "formula"\nabout = "{about}"\n'
    if not told:  # the ball loses no energy, and has no third phase
        with pytest.raises(RbpsymError, match="no quantity"):
            plan_of(sheet_of_text(text))
        return
    sheet = plan_of(sheet_of_text(text)).worksheet()
    [item] = sheet.items
    assert "".join(getattr(inline, "text", "") for inline in item.prompt[0].inlines).startswith(told)
    assert item.asked.problem == ("superball.phase2" if about.startswith("phase") else "superball")
    [found] = grade_worksheet(sheet, {item.id: to_machine(item.key.value)}, Desk())
    assert found.points == item.points

"""Exports are read, and run, by programs that we did not write; what a format can't carry is told."""

from __future__ import annotations

import ast
import html.parser
import io
import json
import re
import zipfile
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree as Tree

import pytest

from rbpsym.document.model import Paragraph, words
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import value
from rbpsym.teaching.exports.bench import free_pairs, nearest_pairs, orders
from rbpsym.teaching.exports.page import zipped
from rbpsym.teaching.formats import Exported, Options, exporter
from rbpsym.teaching.grading.ground import bare_ground
from rbpsym.teaching.grading.verdicts import are_equal
from rbpsym.teaching.model import FormulaKey, LinePiece, OrderKey
from tests.teaching.readers import by_gift_pegjs, by_maxima, by_python
from tests.teaching.sample_worksheet import NAMES, POWERED, SPINLESS, worksheet

FORMATS = ("moodle", "qti", "canvas", "prairielearn", "gift")
SHEETS = (worksheet(), worksheet("bob", 2), worksheet("eva", 3, "es"))
MATHML = "{http://www.w3.org/1998/Math/MathML}"


@pytest.fixture(scope="module")
def exported() -> dict[str, Exported]:
    return {name: exporter(name)(SHEETS, Options()) for name in FORMATS}


@pytest.mark.parametrize("name", FORMATS)
def test_the_same_bytes_each_time(name: str, exported: dict[str, Exported]) -> None:
    again = exporter(name)((worksheet(), worksheet("bob", 2), worksheet("eva", 3, "es")), Options())
    assert again == exported[name]


@pytest.mark.parametrize("name", FORMATS)
def test_what_is_left_out_is_told(name: str, exported: dict[str, Exported]) -> None:
    told = exported[name].left_out
    assert len(set(told)) == len(told) >= 4
    assert all(re.fullmatch(r".+ \(item [\d, ]+\)\.", sentence) for sentence in told)
    assert any("carried forward" in sentence and "item 3" in sentence for sentence in told)


@pytest.mark.parametrize("name", FORMATS)
def test_nothing_is_asked_without_a_field(name: str, exported: dict[str, Exported]) -> None:
    files = (file if isinstance(file, str) else file.decode("utf-8", "ignore") for file in exported[name].files.values())
    assert not any("letter to each force" in file for file in files)


# --- Moodle


def quiz(exported: dict[str, Exported]) -> Tree.Element:
    return Tree.fromstring(exported["moodle"].files["moodle.xml"])


def of_type(root: Tree.Element, kind: str) -> list[Tree.Element]:
    return [question for question in root.iter("question") if question.get("type") == kind]


def test_moodle_has_every_item_of_every_student(exported: dict[str, Exported]) -> None:
    root = quiz(exported)
    kinds = [question.get("type") for question in root.iter("question")]
    assert kinds.count("category") == len(SHEETS[0].items)
    assert len(kinds) == len(SHEETS[0].items) * (len(SHEETS) + 1)
    assert set(kinds) == {"category", "stack", "numerical", "multichoice", "cloze", "essay"}
    names = [question.findtext("name/text") for question in root.iter("question") if question.get("type") != "category"]
    assert len(set(names)) == len(names)


def test_moodle_pictures_are_there(exported: dict[str, Exported]) -> None:
    for question in quiz(exported).iter("question"):
        text = question.find("questiontext")
        if text is not None:
            used = set(re.findall(r"@@PLUGINFILE@@/([\w.-]+)", text.findtext("text")))
            assert used == {file.get("name") for file in text.iter("file")} != set()


def test_moodle_choices_have_one_right_answer(exported: dict[str, Exported]) -> None:
    for question in of_type(quiz(exported), "multichoice"):
        fractions = sorted(answer.get("fraction") for answer in question.iter("answer"))
        assert fractions.count("100") == 1 and set(fractions) == {"0", "100"}


def test_moodle_is_read_by_moodle_xml_parser(exported: dict[str, Exported], tmp_path: Path) -> None:
    file = tmp_path / "moodle.xml"
    file.write_bytes(exported["moodle"].files["moodle.xml"])
    found = by_python("moodle_xml_parser", file)
    assert found["multichoice"] and found["cloze"]
    assert all(sorted(set(fractions)) == [0, 100] and fractions.count(100) == 1 for fractions in found["multichoice"])
    for fields in found["cloze"]:
        assert len(fields) >= 2
        assert all(len(options) == 3 and sum(score == 100 for _, score in options) == 1 for options in fields)


def test_moodle_numbers(exported: dict[str, Exported]) -> None:
    first = of_type(quiz(exported), "numerical")[0]
    right, wrong = first.findall("answer")
    assert (right.findtext("text"), right.get("fraction")) == ("-5.12", "100")
    assert float(right.findtext("tolerance")) == pytest.approx(0.0512)
    assert wrong.get("fraction") == "0" and "Sample slip" in wrong.findtext("feedback/text")
    assert abs(float(wrong.findtext("text")) + 5.12) > float(wrong.findtext("tolerance"))
    assert {unit.findtext("unit_name") for unit in first.iter("unit")} >= {"rad/s²", "rad/s^2"}


CLOZE = re.compile(r"\{1:MULTICHOICE:((?:\\.|[^}\\])*)\}")


def test_moodle_cloze_fields(exported: dict[str, Exported]) -> None:
    for question in of_type(quiz(exported), "cloze"):
        fields = CLOZE.findall(question.findtext("questiontext/text"))
        assert len(fields) >= 2
        for field in fields:
            options = re.split(r"(?<!\\)~", field)
            assert len(options) == 3 and sum(option.startswith("=") for option in options) == 1


def test_an_author_makes_no_moodle_fields(exported: dict[str, Exported]) -> None:
    sheet = SHEETS[0]
    written = Paragraph(words("{1:SHORTANSWER:=x} and {=y}"))
    parts = tuple(replace(part, statement=(written, *part.statement)) for part in sheet.parts)
    hostile = exporter("moodle")((replace(sheet, parts=parts),), Options())
    plain = exporter("moodle")((sheet,), Options())
    fields = re.compile(r"\{(?:\d*:)?[A-Z_]+:")
    for one, other in zip(*(of_type(quiz({"moodle": each}), "cloze") for each in (hostile, plain)), strict=True):
        text = one.findtext("questiontext/text")
        assert "&#123;1:SHORTANSWER:=x}" in text
        assert len(fields.findall(text)) == len(fields.findall(other.findtext("questiontext/text")))


def test_stack_trees_follow_their_own_tests(exported: dict[str, Exported]) -> None:
    """Maxima compares as AlgEquiv does; each question test must end at the note that it names."""
    for question in of_type(quiz(exported), "stack")[:4]:
        variables = question.findtext("questionvariables/text").replace("\n", " ")
        lines = [part.strip() for part in variables.split(";") if part.strip()]
        checks, expected = [], []
        for test in question.iter("qtest"):
            inputs = {entry.findtext("name"): entry.findtext("value") for entry in test.iter("testinput")}
            for wanted in test.iter("expected"):
                tree = next(prt for prt in question.iter("prt") if prt.findtext("name") == wanted.findtext("name"))
                for node in tree.iter("node"):
                    given = inputs[node.findtext("sans")]
                    checks.append(f"is(ratsimp(({given}) - ({node.findtext('tans')})) = 0)")
                    passed = node.findtext("trueanswernote") == wanted.findtext("expectedanswernote")
                    expected.append("true" if passed else "false")
                    if passed:
                        break
        found = by_maxima([*lines, *checks])
        assert found[len(lines) :] == expected


def test_stack_names_are_readable(exported: dict[str, Exported]) -> None:
    text = of_type(quiz(exported), "stack")[0].findtext("questiontext/text")
    assert "<code>omega</code>" in text and "[[input:ans1]]" in text and "[[validation:ans1]]" in text


# --- QTI 2.1


def unpacked(data: bytes, folder: Path) -> Path:
    with zipfile.ZipFile(io.BytesIO(data)) as package:
        assert package.testzip() is None
        package.extractall(folder)
    return folder


def qti(exported: dict[str, Exported], folder: Path, place: int = 0) -> Path:
    return unpacked(list(exported["qti"].files.values())[place], folder)


RESPONSES = [
    ("q-item-2.xml", {"RESPONSE": -5.12}, 5, "right"),
    ("q-item-2.xml", {"RESPONSE": -5.26}, 0, "slip1"),
    ("q-item-2.xml", {"RESPONSE": 5.12}, 0, "wrong"),
    ("q-item-4.xml", {"RESPONSE": "option2"}, 2, "right"),
    ("q-item-4.xml", {"RESPONSE": "option1"}, 0, "slip1"),
    ("q-item-5.xml", {"RESPONSE": ["step2", "step3", "step1"]}, 2, "right"),
    ("q-item-5.xml", {"RESPONSE": ["step3", "step2", "step1"]}, 2, "right"),
    ("q-item-5.xml", {"RESPONSE": ["step1", "step2", "step3"]}, 0, "wrong"),
    ("q-item-6.xml", {"RESPONSE": "option2"}, 2, "right"),
    ("q-item-7.xml", {"T1": "plus", "R1": "minus", "T2": "minus", "R2": "zero", "T3": "plus", "R3": "zero"}, 3, None),
    ("q-item-7.xml", {"T1": "plus", "R1": "minus", "T2": "minus", "R2": "zero", "T3": "minus", "R3": "zero"}, 2.5, None),
    ("q-item-9.xml", {"RESPONSE": "option1"}, 2, "right"),
]  # fmt: skip


def test_qti_items_are_read_and_scored_by_pyslet(exported: dict[str, Exported], tmp_path: Path) -> None:
    folder = qti(exported, tmp_path)
    asked = [[file, responses] for file, responses, _, _ in RESPONSES]
    found = by_python("pyslet", folder, json.dumps(asked))
    assert found["read"] == {
        "test.xml": "AssessmentTest",
        **{f"q-item-{n}.xml": "AssessmentItem" for n in range(1, 11)},
    }
    for (file, given, score, feedback), (points, shown) in zip(RESPONSES, found["scores"], strict=True):
        assert (points, shown) == (pytest.approx(score), feedback), (file, given)


def test_qti_is_read_by_citolab(exported: dict[str, Exported], tmp_path: Path) -> None:
    """A second reader makes QTI 3.0 of it: every interaction, the right responses, pictures with their descriptions."""
    file = tmp_path / "quiz.zip"
    file.write_bytes(next(iter(exported["qti"].files.values())))
    found = by_python("qti_convert", file)
    assert set(found) == {f"q-item-{n}.xml" for n in range(1, 11)}
    assert all(len(item["interactions"]) == 1 for item in found.values())
    assert found["q-item-2.xml"]["right"] == ["-5.12"] and found["q-item-4.xml"]["right"] == ["option2"]
    assert set(found["q-item-5.xml"]["right"]) == {"step1", "step2", "step3"}
    assert all(alt and len(alt) > 20 for item in found.values() for alt in item["alt"])
    assert any(item["alt"] for item in found.values())


def test_qti_manifest_names_every_file(exported: dict[str, Exported], tmp_path: Path) -> None:
    folder = qti(exported, tmp_path)
    root = Tree.parse(folder / "imsmanifest.xml").getroot()
    hrefs = {part.get("href") for part in root.iter() if part.tag.endswith("}file")}
    assert hrefs == {path.name for path in folder.iterdir()} - {"imsmanifest.xml"}
    identifiers = {part.get("identifier") for part in root.iter() if part.tag.endswith("}resource")}
    assert {part.get("identifierref") for part in root.iter() if part.tag.endswith("}dependency")} < identifiers


def test_qti_formulas_are_mathml(exported: dict[str, Exported], tmp_path: Path) -> None:
    root = Tree.parse(qti(exported, tmp_path) / "q-item-4.xml").getroot()
    assert sum(1 for _ in root.iter(f"{MATHML}math")) >= 3
    assert not any("\\" in (part.text or "") for part in root.iter())


# --- Canvas


def test_canvas_is_read_by_qti2latex(exported: dict[str, Exported], tmp_path: Path) -> None:
    file = tmp_path / "quiz.zip"
    file.write_bytes(next(iter(exported["canvas"].files.values())))
    found = by_python("qti2latex", file)
    assert [kind for kind, *_ in found] == [
        "essay_question", "numerical_question", "numerical_question", "multiple_choice_question", "multiple_dropdowns_question",
        "multiple_choice_question", "multiple_dropdowns_question", "essay_question", "multiple_choice_question", "essay_question",
    ]  # fmt: skip
    assert [float(points) for _, points, *_ in found] == [float(item.points) for item in SHEETS[0].items]
    assert found[1][3] == ["-5.12"] and "4002" in found[3][3] and found[3][2] == 3


def test_canvas_package(exported: dict[str, Exported], tmp_path: Path) -> None:
    folder = unpacked(next(iter(exported["canvas"].files.values())), tmp_path)
    root = Tree.parse(folder / "imsmanifest.xml").getroot()
    hrefs = {part.get("href") for part in root.iter() if part.tag.endswith("}file")}
    assert hrefs == {str(path.relative_to(folder)) for path in folder.rglob("*.*") if path.name != "imsmanifest.xml"}
    text = next(path for path in folder.glob("q-*/q-*.xml")).read_text(encoding="utf-8")
    for name in set(re.findall(r"%24IMS-CC-FILEBASE%24/(images/[\w.-]+)", text)):
        assert (folder / name).is_file()


# --- GIFT


def test_gift_is_read_by_gift_pegjs(exported: dict[str, Exported], tmp_path: Path) -> None:
    file = tmp_path / "questions.gift"
    file.write_text(exported["gift"].files["questions.gift"], encoding="utf-8")
    found = by_gift_pegjs(file)
    assert [q["type"] for q in found if q["type"] != "Category"][:: len(SHEETS)] == [
        "Essay", "Numerical", "Numerical", "MC", "Essay", "MC", "Matching", "Essay", "MC", "Essay",
    ]  # fmt: skip
    choice = next(q for q in found if q["type"] == "MC")
    assert [option["isCorrect"] for option in choice["choices"]] == [False, True, False]
    assert r"\frac{" in choice["choices"][1]["text"]["text"]
    number = next(q for q in found if q["type"] == "Numerical")
    assert number["choices"][0]["text"]["number"] == pytest.approx(-5.118, abs=1e-3)
    assert number["choices"][1]["weight"] == 0


@pytest.mark.parametrize("factor", [1e-6, 1e-9, 1e8])
def test_gift_has_no_powers_of_ten(factor: float, tmp_path: Path) -> None:
    """Small and large numbers are written out: GIFT does not know 7e-05."""
    (part,) = SHEETS[0].parts
    item = next(item for item in part.items if item.id == "2")
    (slip,) = item.key.anticipated
    tiny = replace(slip, number=replace(slip.number, value=slip.number.value * Fraction(factor)))
    changed = replace(item, key=replace(item.key, exact=item.key.exact * factor, anticipated=(tiny,)))
    sheet = replace(SHEETS[0], parts=(replace(part, items=(changed,)),))
    file = tmp_path / "questions.gift"
    file.write_text(exporter("gift")((sheet,), Options()).files["questions.gift"], encoding="utf-8")
    (number,) = (q for q in by_gift_pegjs(file) if q["type"] == "Numerical")
    assert number["choices"][0]["text"]["number"] == pytest.approx(-5.118 * factor, rel=1e-3)


# --- PrairieLearn


class Fields(html.parser.HTMLParser):
    """Elements of a page, open ones closed."""

    def __init__(self) -> None:
        super().__init__()
        self.seen: list[tuple[str, dict]] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list) -> None:
        self.seen.append((tag, dict(attrs)))
        self.open += [] if tag in ("img", "br") else [tag]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


ELEMENTS = {
    "pl-question-panel", "pl-answer-panel", "pl-figure", "pl-symbolic-input", "pl-number-input", "pl-units-input",
    "pl-multiple-choice", "pl-answer", "pl-order-blocks", "pl-dropdown", "pl-rich-text-editor",
}  # fmt: skip


def test_prairielearn_folders(exported: dict[str, Exported]) -> None:
    files = exported["prairielearn"].files
    folders = {path.rsplit("/", 1)[0] for path in files if path.endswith("info.json")}
    assert len(folders) == len(SHEETS) * len(SHEETS[0].items)
    uuids = set()
    for folder in folders:
        info = json.loads(files[f"{folder}/info.json"])
        assert info["type"] == "v3" and info["title"] and info["topic"]
        uuids.add(info["uuid"])
        page = Fields()
        page.feed(files[f"{folder}/question.html"])
        assert not page.open and "{{" not in files[f"{folder}/question.html"]
        assert {tag for tag, _ in page.seen if tag.startswith("pl-")} <= ELEMENTS
        pictures = {attrs["file-name"] for tag, attrs in page.seen if tag == "pl-figure"}
        assert all(f"{folder}/clientFilesQuestion/{name}" in files for name in pictures)
    assert len(uuids) == len(folders)


def answers_of(text: str) -> dict[str, object]:
    """The right answers of a server.py, which may hold nothing but assignments of literals."""
    (function,) = ast.parse(text).body
    found = {}
    for line in function.body:
        if isinstance(line, ast.Assign):
            (target,) = line.targets
            found[target.slice.value] = ast.literal_eval(line.value)
        else:
            assert isinstance(line, ast.Pass)
    return found


def test_prairielearn_servers_hold_data_only(exported: dict[str, Exported]) -> None:
    files = exported["prairielearn"].files
    for path, text in files.items():
        if path.endswith("server.py"):
            page = Fields()
            page.feed(files[path.replace("server.py", "question.html")])
            asked = {
                a["answers-name"]
                for tag, a in page.seen
                if tag in ("pl-symbolic-input", "pl-number-input", "pl-units-input")
            }
            assert set(answers_of(text)) == asked


def test_prairielearn_formulas_mean_the_key(exported: dict[str, Exported]) -> None:
    """sympy, with which PrairieLearn reads them, finds the value that the key has."""
    import sympy

    files, place = exported["prairielearn"].files, 0
    text = answers_of(files[next(path for path in files if path.endswith("/1/server.py"))])["formula"]
    at = {name: sympy.Rational(place + k, 7) for k, name in enumerate(("m", "M", "ell", "R", "g", "theta"), start=2)}
    theirs = sympy.sympify(text, locals={name: sympy.Symbol(name) for name in at}).subs(at)
    m, M, ell, R, g, theta = (float(at[name]) for name in ("m", "M", "ell", "R", "g", "theta"))
    import math

    ours = -(m / 2 + M) * g * ell * math.sin(theta) / (m * ell**2 / 3 + M * ell**2 + M * R**2 / 2)
    assert float(theirs) == pytest.approx(ours)


# --- pieces


def test_orders_of_a_graph() -> None:
    pieces = tuple(LinePiece(str(k), t.Num(k)) for k in range(4))
    key = OrderKey(pieces, frozenset({(0, 1), (1, 2), (0, 2)}), (0, 1, 2, 3))
    assert nearest_pairs(key) == [(0, 1), (1, 2)]
    assert free_pairs(key) == [(0, 3), (1, 3)]
    found = orders(key)
    assert len(found) == 4 and all(key.accepts(order) for order in found)
    assert orders(OrderKey(tuple(LinePiece(str(k), t.Num(k)) for k in range(6)), frozenset(), tuple(range(6)))) is None


@pytest.mark.parametrize("path", ["../x", "/etc/passwd", "a/../../b", "a\\b"])
def test_no_package_leads_out_of_its_folder(path: str) -> None:
    with pytest.raises(ValueError, match="leads out"):
        zipped({path: b""})


def test_hostile_titles_stay_text() -> None:
    """Names of students and titles can't break out of any format."""
    from dataclasses import replace

    from rbpsym.document.model import words

    nasty = "]]><script>{{7*7}}</script>&a;\x00\u202e $CATEGORY: x {=a ~b} [[input:ans9]] \"'"
    sheet = replace(SHEETS[0], title=words(nasty))
    files = {name: exporter(name)((sheet,), Options()).files for name in FORMATS}
    Tree.fromstring(files["moodle"]["moodle.xml"])
    for name in ("qti", "canvas"):
        (data,) = files[name].values()
        with zipfile.ZipFile(io.BytesIO(data)) as package:
            for path in package.namelist():
                if path.endswith(".xml"):
                    Tree.fromstring(package.read(path))
    assert "{{7*7}}" not in "".join(v for k, v in files["prairielearn"].items() if k.endswith(".html"))


def test_the_key_and_the_sample_agree() -> None:
    """The sample worksheet is what it says: the key, and a slip that differs from it."""
    ground = bare_ground(dict.fromkeys(NAMES, "positive"))
    assert isinstance(SHEETS[0].item("1").key, FormulaKey)
    assert value(read_infix(POWERED, NAMES)) == value(SHEETS[0].item("1").key.value)
    assert are_equal(read_infix(POWERED, NAMES), read_infix(SPINLESS, NAMES), ground).is_refuted


def test_references_are_resolved_or_told() -> None:
    """A figure of the question has its number; what is not in the question is called so."""
    from dataclasses import replace

    from rbpsym.document.model import Paragraph, Ref, Text
    from rbpsym.teaching.exports.bench import ExportDesk

    figure = replace(SHEETS[0].parts[0].statement[1], label="fig")
    text = ExportDesk(SHEETS[0]).html(
        (Paragraph((Text("See Figure "), Ref("fig"), Text(" and "), Ref("step.7"))), figure)
    )
    assert "See Figure 1 and a step of the derivation" in text and "Figure 1. " in text


# --- points


POINTS = re.compile(r'<item [^>]*ident="item([^"]+)".*?points_possible</fieldlabel>\s*<fieldentry>([^<]+)', re.S)


def test_canvas_gives_the_points_of_each_item_and_of_the_whole(exported: dict[str, Exported]) -> None:
    assert len(exported["canvas"].files) == len(SHEETS)
    for sheet, (_, content) in zip(SHEETS, exported["canvas"].files.items(), strict=True):
        package = zipfile.ZipFile(io.BytesIO(content))
        texts = {name: package.read(name).decode() for name in package.namelist() if name.endswith(".xml")}
        told = {id: float(points) for text in texts.values() for id, points in POINTS.findall(text)}
        assert told == {item.id: pytest.approx(float(item.points)) for item in sheet.items}
        [total] = [re.search(r"<points_possible>([^<]+)", text)[1] for name, text in texts.items() if "meta" in name]
        assert float(total) == pytest.approx(float(sheet.points))

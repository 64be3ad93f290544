"""Course files: what they may say, the author's words in the document, and the sentence for each mistake."""

import re
from pathlib import Path

import pytest

from rbpsym.commands.new import course_text
from rbpsym.courses import derive_course, sources
from rbpsym.document.model import Paragraph
from rbpsym.document.notes import course_notes, plain
from rbpsym.errors import RbpsymError
from rbpsym.statement.course import load_course
from rbpsym.statement.library import find_problem

PAGE = (Path(__file__).parents[2] / "docs/courses.md").read_text(encoding="utf-8")
EXAMPLE = re.findall(r"```toml\n(.*?)```", PAGE, re.S)[0]


@pytest.fixture
def written(tmp_path):
    def write(text):
        file = tmp_path / "week.toml"
        file.write_text(text, encoding="utf-8")
        return file

    return write


def document(file, language="en"):
    return course_notes(derive_course(load_course(file), simulation=False), language)


def headings(found):
    return [plain(part.title) for part in found.sections if part.level == 1]


@pytest.mark.parametrize("text", [EXAMPLE, course_text("week-5")], ids=["the page", "the starter"])
def test_what_is_told_to_write_is_derived(written, text):
    derived = derive_course(load_course(written(text)), simulation=False)
    steps = [s for lesson in (*derived.lessons.values(), *derived.derivations.values()) for s in lesson.steps]
    assert len(steps) > 100
    assert all(step.certificate.verdict.is_proved for step in steps)


@pytest.mark.parametrize(
    ("language", "heading", "words"),
    [("en", "Introduction", "Where does it leave the wall?"), ("es", "Introducción", "¿Dónde se separa de la pared?")],
)
def test_the_authors_words_stand_where_they_belong(written, language, heading, words):
    found = document(written(EXAMPLE), language)
    assert headings(found)[0] == heading
    assert headings(found)[2] == "A ladder that slides"
    first = next(part for part in found.sections if part.label == "p1.part")
    assert [type(block) for block in first.blocks] == [Paragraph, Paragraph]
    ladder = next(part for part in found.sections if part.label == "p3.part")
    assert [plain(block.inlines) for block in ladder.blocks] == [words]


def test_a_remark_without_a_title_goes_on_with_the_part_before(written):
    text = 'title = "x"\n[[part]]\nproblem = "rod-pendulum"\n[[part]]\ntext = "So much for it."\n'
    found = document(written(text))
    before = next(part for part in found.sections if part.label == "p1.section.checks")
    assert plain(before.blocks[-1].inlines) == "So much for it."


def test_the_detail_of_a_part_is_its_own(written):
    text = 'title = "x"\n[[part]]\nproblem = "rod-pendulum"\n'
    counts = [
        sum(len(part.blocks) for part in document(written(text + more)).sections)
        for more in ('detail = "brief"\n', "", 'detail = "full"\n')
    ]
    assert counts[0] < counts[1] < counts[2]


def test_a_problem_beside_the_course_is_found_with_and_without_its_ending(written, tmp_path):
    (tmp_path / "mine.toml").write_text(find_problem("rod-pendulum").read_text(encoding="utf-8"), encoding="utf-8")
    for name in ("mine", "mine.toml"):
        course = load_course(written(f'title = "x"\n[[part]]\nproblem = "{name}"\n'))
        assert sources(course)[1] == tmp_path / "mine.toml"


PAIR = 'title = "x"\n[[part]]\ncomparison = ["disk-on-incline", "ring-on-incline"]\n'
WRONG = {
    'title = "x"\n': "1:1: the course has no parts",
    'title = "x"\n[[part]]\nproblm = "rod-pendulum"\n': "a part of a course is a theory, a problem, a comparison or a text",
    'title = "x"\n[[part]]\nproblem = "rod-pendulum"\ndetial = "brief"\n': "4:1: unknown key “detial” in a problem",
    'title = "x"\n[[part]]\nproblem = "rod-pendulum"\ndetail = "short"\n': "4:10: “short” is not a value of “detail”",
    'title = "x"\n[[part]]\nproblem = "rod-pendulm"\n': "3:11: there is no problem “rod-pendulm”",
    'title = "x"\n[[part]]\ntheory = "plane"\n': "3:10: unknown theory “plane”",
    'title = "x"\n[[part]]\ntheory = "plane-motion"\nproblem = "yo-yo"\n': "4:1: a part is a theory or a problem, not both",
    'title = "x"\n[[part]]\ncomparison = ["yo-yo"]\n': "3:14: a comparison takes two problems",
    PAIR + 'of = "weight"\n': "4:6: “weight” is not a value of “of”",
    PAIR + 'of = "oscillation"\n': "4:6: “disk-on-incline” and",
    PAIR + 'limit = "Q"\n': "4:9: no parameter is called “Q”",
    'title = "x"\n[[part]]\ntext = "Say $E = m c^2$."\n': "3:8: “Say $E = m c^2$.” is bound to no claim, but holds a formula",
    'title = 3\n[[part]]\ntext = "x"\n': "1:9: “title” must be a text in quotes",
    'title = "x"\n[notation]\nvectors = "wavy"\n[[part]]\ntext = "x"\n': "vectors cannot be “wavy”",
    'title = "x"\npart = "yo-yo"\n': "2:8: part must be a list of tables",
}


@pytest.mark.parametrize(("text", "said"), WRONG.items(), ids=range(len(WRONG)))
def test_a_mistake_gets_its_sentence_and_its_place(written, text, said):
    with pytest.raises(RbpsymError) as caught:
        derive_course(load_course(written(text)), simulation=False)
    assert said in str(caught.value)
    assert caught.value.instead
    assert caught.value.exit_code == 2


def compared(written, of, first="disk-on-incline", second="ring-on-incline", more=""):
    text = f'title = "x"\n[[part]]\ncomparison = ["{first}", "{second}"]\nof = "{of}"\n{more}'
    [lesson] = derive_course(load_course(written(text)), simulation=False).lessons.values()
    assert all(step.certificate.verdict.is_proved for step in lesson.steps)
    return {step.id: step for step in lesson.steps}


def test_accelerations_are_compared_for_all_values(written):
    steps = compared(written, "acceleration")
    assert steps["order"].statement.ops == (">",)
    assert {"frequency.1", "frequency.2", "ratio"} <= set(steps)


def test_what_depends_on_the_start_has_no_order(written):
    steps = compared(written, "speed")
    assert "order" not in steps
    assert "ratio" in steps


def test_moments_of_inertia_that_differ_are_told(written, tmp_path):
    text = find_problem("disk-on-incline").read_text(encoding="utf-8")
    (tmp_path / "hollow.toml").write_text(text.replace('"cylinder"', '"ring"'), encoding="utf-8")
    steps = compared(written, "acceleration", second="hollow")
    assert "moments.drum" in steps

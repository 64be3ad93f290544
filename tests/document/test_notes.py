"""Notes of all shipped problems, of unseen ones and of the course: complete, clean, and only what was proved."""

import re
from functools import cache

import pytest

from rbpsym.courses import derive_course
from rbpsym.derive import derive
from rbpsym.document.chapters import repeated
from rbpsym.document.model import Display, FigureBlock, Math, Paragraph, Ref, Text, numbered, parts
from rbpsym.document.notes import DETAILS, course_notes, notes, shown_steps
from rbpsym.document.notes_question import in_known_forms
from rbpsym.document.telling import known_key
from rbpsym.document.words import Words
from rbpsym.document.writers import files, writer
from rbpsym.expr import tree as t
from rbpsym.languages import languages
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files, problem_files
from rbpsym.statement.loader import load_text
from tests.document.unseen import UNSEEN
from tests.library.derived import answers_to, unsimulated

pytestmark = pytest.mark.heavy(of=20)

NAMES = (*sorted(problem_files()), *UNSEEN)


@cache
def derived(name):
    return derive(load_text(UNSEEN[name]), simulation=False) if name in UNSEEN else unsimulated(name)


@cache
def document(name, detail="standard"):
    return notes(derived(name), "en", detail)


@cache
def course():
    return derive_course(load_course(course_files()["paper"]), derived=lambda path: derived(path.stem))


by_problem = pytest.mark.parametrize("name", NAMES)
by_detail = pytest.mark.parametrize("detail", DETAILS)


def rows(node):
    """The single relations of a formula."""
    return node.rows if isinstance(node, t.Relations) else (node,)


def formulas(found):
    """All relations and expressions that stand in a document."""
    return {row for part in parts(found) if isinstance(part, (Display, Math)) for row in rows(part.node)}


def ends(node):
    """What a chain comes to: its first and its last item."""
    return t.Chain((node.items[0], node.items[-1]), node.ops[-1:]) if isinstance(node, t.Chain) else node


@by_problem
@by_detail
def test_every_shown_step_is_in_the_document(name, detail):
    derivation, shown = derived(name), formulas(document(name, detail))
    for step in derivation.steps:
        if step.id in shown_steps(derivation, detail) and step.chapter not in ("forces", "work"):
            assert {ends(row) for row in rows(step.statement)} <= {ends(node) for node in shown}, step.id


@by_problem
def test_every_force_and_work_has_its_row(name):
    shown = formulas(document(name, "full"))
    for step in derived(name).steps:
        if step.id in shown_steps(derived(name), "full") and step.chapter in ("forces", "work"):
            ends = {row.items[-1] for row in rows(step.statement)}
            pieces = shown | {row.items[-1] for row in shown if isinstance(row, t.Chain)}
            assert ends <= pieces, step.id


@by_problem
@by_detail
def test_no_formula_comes_by_another_road(name, detail):
    """Law 2: a displayed formula is what a step states, all of it or its two ends."""
    answers = in_known_forms(answers_to(derived(name).study), derived(name).all_steps)
    asked = [step for found in answers for step in found.steps]
    stated = {row for step in (*derived(name).all_steps, *asked) for row in rows(step.statement)}
    stated |= {t.equation(row.items[0], row.items[-1]) for row in stated if row.ops[0] == "="}
    for block in parts(document(name, detail)):
        if isinstance(block, Display):
            assert set(rows(block.node)) <= stated, block.label


@by_problem
@by_detail
def test_every_phrase_of_a_step_is_known(name, detail):
    derivation = derived(name)
    said = Words("en", derivation.study.problem)
    silent = {"torque.none", "work.none", "work.integrals", "work.done"}
    for step in derivation.all_steps:
        if step.chapter != "forces" and step.phrase not in silent:
            assert known_key(step.phrase, said), f"{step.id}: {step.phrase}"


@by_problem
@by_detail
def test_references_lead_to_what_was_shown_before(name, detail):
    """A reference to a formula or section stands after it, never before."""
    seen, ahead = set(), []
    sections = numbered(document(name, detail)).sections
    for part in parts(sections[1:]):  # the first one says under which numbers the answers stand
        if isinstance(part, Display):
            seen |= {part.label, *part.also}
        if isinstance(part, Ref) and part.mark.startswith("(") and part.label not in seen:
            ahead.append(part.label)
    assert not ahead


@by_problem
def test_prose_is_clean(name):
    """No empty paragraph, no name of the file's grammar, no doubled space or word, the right article."""
    for part in parts(document(name)):
        if isinstance(part, Paragraph):
            text = "".join(i.text if isinstance(i, Text) else "x" for i in part.inlines)
            assert text.strip(), part
            assert not re.search(r"  |\{|\}|_|\b(\w\w+) \1\b| [,.;:]", text), text
            assert not re.search(r"\b(a (?!uni)[aeiou]|an [^aeiou])", text), text


@by_problem
@pytest.mark.parametrize("ending", ["tex", "html", "typ", "md"])
def test_every_format_is_written(name, ending):
    text = writer(ending)(document(name))
    assert len(text) > 2000
    if ending == "html":
        body = re.sub(r"<style.*?</style>|data:[^\"')]*", "", text, flags=re.S)
        assert "{" not in body
        assert "\\" not in body


@pytest.mark.parametrize("name", list(UNSEEN))
def test_an_unseen_problem_has_a_pdf_with_both_figures(name):
    alone = len(derived(name).study.system.bodies) == 1  # then the free body stands beside the system
    for detail, count in (("standard", 1 if alone else 2), ("full", 2)):
        figures = [part for part in parts(document(name, detail)) if isinstance(part, FigureBlock)]
        assert len(figures) == count and sum(len(figure.scenes) for figure in figures) >= 2
    assert writer("pdf")(document(name)).startswith(b"%PDF")


def test_what_stands_already_on_the_page_is_only_referred_to():
    derivation = derived("sliding-ladder")
    said = Words("en", derivation.study.problem)
    again = ("motion.from_newton.theta", "motion.from_work", "motion.from_energy")
    assert repeated(derivation, shown_steps(derivation, "full"), said) == dict.fromkeys(again, "motion.theta")


@by_detail
def test_the_course_is_one_document_with_all_parts(detail):
    found = course_notes(course(), "en", detail)
    assert len([s for s in found.sections if s.level == 1]) == len(course().course.parts) + 1
    assert len({s.label for s in found.sections}) == len(found.sections)
    assert all(len(writer(ending)(found)) > 20_000 for ending in ("tex", "html"))


MOST_PAGES = 30


@pytest.mark.parametrize("language", languages())
def test_the_course_is_short_enough_to_be_read(language):
    pdf = files(course_notes(course(), language, plots=True), "pdf", "course")["course.pdf"]
    assert len(re.findall(rb"/Type */Page\b", pdf)) <= MOST_PAGES


def test_more_detail_shows_more():
    counts = [len(formulas(document("rod-and-disk-free", detail))) for detail in DETAILS]
    assert counts == sorted(counts)
    assert len(set(counts)) == 3


def test_a_motion_that_a_blow_ends_at_its_start_has_no_speed_along_it():
    """The square of the speed in a phase of no duration is below zero; full notes tell that of the phase after the blow."""
    derivation = derived("center-of-percussion")
    shown = shown_steps(derivation, "full")
    left_out = {step.rule for step in derivation.steps if step.id not in shown}
    assert {"first_integral", "substitution"} <= left_out
    squares = [step for step in derivation.steps if step.rule == "first_integral"]
    printed = [part.node for part in parts(document("center-of-percussion", "full").sections) if isinstance(part, Display)]
    assert squares and all(step.statement not in printed for step in squares)
    assert any(isinstance(node, t.Chain) and node.items[0] == squares[0].statement.items[0] for node in printed)


def test_the_friction_of_a_contact_is_a_vector_in_the_statement_as_everywhere():
    statement = next(s for s in document("disk-on-incline").sections if s.label == "section.statement")
    told = [part.node for part in parts(statement) if isinstance(part, Math)]
    assert t.Vec("f") in told and t.Sym("f") not in told


def test_a_force_on_the_other_body_acts_at_the_point_of_contact():
    assert "cube (point of contact), by the ball" in _said("ball-on-rod-against-cube")
    assert "rod (point of contact), by the bead" in _said("bead-on-rotating-rod")


def test_a_contact_that_may_end_is_told_however_long_its_force_is():
    assert "The contact lasts only while" in _said("loaded-wheel")


def test_no_coefficient_is_enough_where_the_normal_force_comes_to_nothing():
    assert "slipping sets in before" in _said("rod-falling-on-rough-floor")
    assert "no coefficient is large enough" not in _said("loaded-wheel")


def _said(name):
    return writer("md")(document(name))

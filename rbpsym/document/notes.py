"""Lecture notes: a derivation, or a whole course, as a document."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from importlib.util import find_spec

from rbpsym.ask.asking import own_answers
from rbpsym.document.chapters import chapter_sections, in_page_order, repeated
from rbpsym.document.model import Block, Document, Inlines, Live, Paragraph, Ref, Section, Text, words
from rbpsym.document.needless import is_still, needless, owed_by
from rbpsym.document.notes_checks import Told, checks_section, course_checks_section, results_section, with_remarks
from rbpsym.document.notes_figures import free_bodies_figure, free_bodies_label, has_single_body
from rbpsym.document.notes_lessons import compared_figure, lesson_sections
from rbpsym.document.notes_phases import CHAPTERS, new_steps, phase_results, phase_sections
from rbpsym.document.notes_question import answer_section, asked, boxes_of_answers, in_known_forms
from rbpsym.document.notes_statement import statement_section
from rbpsym.document.own_texts import own_blocks
from rbpsym.document.phrases import common_notation, problem_notation
from rbpsym.document.places import locator
from rbpsym.document.used import reaches_beyond, retold, used
from rbpsym.document.words import Words
from rbpsym.expr.glyphs import Notation
from rbpsym.proof.step import Derivation, DerivedCourse, Lesson
from rbpsym.statement.course import CoursePart
from rbpsym.statement.model import Problem
from rbpsym.statement.own_text import OwnParagraph

# --- notes as short as in a book: few headings, what leads to the results, and no step between


# what the next step starts from, or a student must see; results are shown besides
RULES: Mapping[str, frozenset[str]] = {
    "kinematics": frozenset({"constraint", "no_slip", "taut"}),
    "inertia": frozenset({"mass_integral", "parallel_axis", "statement"}),
    "instant": frozenset({"held", "start_rate", "start_law"}),
    "motion": frozenset({"torque", "balance", "combination", "solution"}),
    "reactions": frozenset({"balance"}),
    "work": frozenset({"work", "workless", "power"}),
    "energy": frozenset({"kinetic_energy", "potential", "conservation", "first_integral"}),
    "contact": frozenset({"substitution"}),
    "oscillations": frozenset({"linearization"}),
}
STANDARD = 2


def brief_steps(derivation: Derivation) -> frozenset[str]:
    """Ids of the steps that a book would print, and of the angular momenta that they start from."""
    kept = [s for s in derivation.steps if s.is_result or (s.level <= STANDARD and s.rule in RULES.get(s.chapter, ()))]
    cited = {id for step in kept if step.chapter == "motion" for id in step.reasons}
    momenta = {step.id for step in derivation.chapter("momentum") if step.id in cited}
    return frozenset(step.id for step in kept) | momenta


def _forces(derivation: Derivation, said: Words) -> Iterator[Block]:
    """The free-body diagrams with the sentence that leads to them, where they do not stand beside the system."""
    if derivation.chapter("forces") and not has_single_body(derivation):
        count = len(derivation.study.system.bodies)
        yield Paragraph(said.say("forces.brief", figure=Ref(free_bodies_label(said)), count=count))
        yield free_bodies_figure(derivation, said)


# ---


DETAILS: Mapping[str, int] = {"brief": 1, "standard": 2, "full": 3}


def notes(derivation: Derivation, language: str = "en", detail: str = "standard", *, plots: bool = False) -> Document:
    """The notes of one problem, with its formulas as curves if `plots` are wanted."""
    problem = derivation.study.problem
    said = Words(language, problem)
    return Document(
        words(said.title(problem.title)),
        tuple(problem_sections(derivation, language, detail, "", 1, plots=plots)),
        source=words(problem.source),
        language=language,
        notation=notation_of(derivation, language),
        live=live(problem, ""),
    )


def live(problem: Problem, prefix: str) -> tuple[Live, ...]:
    """The problem for formats that run, if its source is known."""
    return (Live(problem.name, problem.text, prefix),) if problem.text else ()


def notation_of(derivation: Derivation, language: str = "en") -> Notation:
    """How the names of a derived problem are printed."""
    return problem_notation(derivation.study.problem, language)


def words_of(derivation: Derivation, shown: frozenset[str], language: str = "en", prefix: str = "") -> Words:
    """How notes that show these steps speak: what stands already on the page is only referred to."""
    where, owed = locator(derivation.study), owed_by(in_page_order(derivation.steps), shown, derivation.study.assumptions)
    said = Words(language, derivation.study.problem, prefix, shown, locate=where, owed=owed)
    same = repeated(derivation, shown, said)
    return replace(said, shown=shown - set(same), same=same)


def problem_sections(
    derivation: Derivation,
    language: str,
    detail: str,
    prefix: str,
    level: int,
    checks: str = "",
    *,
    plots: bool = False,
) -> list[Section]:
    """All sections of a problem; `prefix` keeps its labels apart from those of other problems.

    `checks` is the label of a table of checks for the whole document, "" for one of its own.
    """
    is_brief = detail == "brief"
    said = words_of(derivation, shown_steps(derivation, detail), language, prefix)
    said = replace(said, is_brief=is_brief, is_posed=True, level=DETAILS[detail])
    answers = tuple(in_known_forms(own_answers(derivation.study), derivation.all_steps))
    speaker = phase_words(derivation, detail, language)
    later = list(phase_results(derivation, said, speaker))
    drawn = _curves(derivation, said, level, [(said, derivation.steps), *later]) if plots and not is_still(derivation) else None
    answered, stated = answer_section(answers, ((said, derivation.steps), *later), said, level)
    derived = (
        *chapter_sections(derivation, said, level, _forces(derivation, said) if is_brief else ()),
        *phase_sections(derivation, said, level, speaker),
    )
    remarked = with_remarks(derived, derivation, (said, *(own for own, _ in later[1::2])), detail)
    laws = (said.step(step.id)[0] for step in derivation.chapter("motion") if step.rule == "solution")
    boxed = [mark for mark in (stated.values() if answers else laws) if isinstance(mark, Ref)]
    return [
        statement_section(derivation, said, level, asked(answers, stated, said)),
        *(derived if said.is_full else boxes_of_answers(remarked, boxed)),
        *([answered] if answered else []),
        # why there are no curves is no news, unless something is not installed
        *([drawn] if drawn and (said.is_full or drawn.blocks[1:] or not find_spec("numpy")) else []),
        *(results_section(derivation, said, level, later, detail) if said.is_full else ()),
        checks_section(derivation, said, level, checks or ("" if said.is_full else None)),
    ]


def _curves(derivation: Derivation, said: Words, level: int, told: Iterable[Told]) -> Section:
    """The formulas as curves; a sentence where numpy, which draws them, is not there (in a browser)."""
    if find_spec("numpy") is None:
        why = Paragraph(said.say("plots.none.numpy"))
        return Section(said.say("plots.title"), (why,), said.prefix + "section.plots", level)
    from rbpsym.document.notes_plots import plots_section

    return plots_section(derivation, said, level, () if said.is_full else told)


def phase_words(
    derivation: Derivation, detail: str, language: str
) -> Callable[[Derivation, str], Words]:
    """How notes speak of the later phases of a derivation: of what is new in each."""
    chapters = CHAPTERS if detail == "full" or reaches_beyond(derivation) else ("inertia",)
    told = shown_steps(derivation, detail)

    def speaker(phase: Derivation, prefix: str) -> Words:
        new = new_steps(phase, shown_steps(phase, detail, derivation), told, chapters)
        return replace(words_of(phase, new, language, prefix), is_later=True, is_brief=detail == "brief", level=DETAILS[detail])

    return speaker


def shown_steps(derivation: Derivation, detail: str, whole: Derivation | None = None) -> frozenset[str]:
    """Ids of the steps that are shown at a level of detail, of a later phase as part of the `whole` motion."""
    level = DETAILS[detail]
    kept = frozenset(step.id for step in derivation.steps if step.level <= level or step.is_result)
    if detail == "full":
        return kept - needless(derivation)
    kept = brief_steps(derivation) if detail == "brief" else kept
    return used(derivation, whole or derivation) & kept - needless(derivation) - retold(derivation)


CHECKS = "table.checks"


def course_notes(
    derived: DerivedCourse, language: str = "en", detail: str = "standard", *, plots: bool = False
) -> Document:
    """The notes of a course: theory, problems and comparisons in its order, with curves if `plots` are wanted."""
    course, sections, problems = derived.course, list[Section](), list[Live]()
    said = Words(language)
    for place, part in enumerate(course.parts, 1):
        prefix = f"p{place}."
        if part.kind == "remark" and not part.title and sections:
            sections[-1] = replace(sections[-1], blocks=(*sections[-1].blocks, *_own(part.text, derived, said)))
            continue
        sections += _part_sections(part, derived, said, prefix, detail, plots=plots)
        if part.discussion:
            blocks = _own(part.discussion, derived, said)
            sections.append(Section(said.say("section.discussion"), blocks, prefix + "section.discussion", 2))
        if part.kind == "problem":
            problems += live(derived.derivations[part.name].study.problem, prefix)
    sections.append(course_checks_section(derived, said, CHECKS, detail))
    notation = _common_notation(derived, language)
    return Document(
        words(said.title(course.title)),
        tuple(sections),
        words(said.title(course.subtitle) if course.subtitle else ""),
        words(course.source),
        language,
        notation,
        tuple(problems),
    )


def _part_sections(
    part: CoursePart, derived: DerivedCourse, said: Words, prefix: str, detail: str, *, plots: bool
) -> list[Section]:
    """One part: its heading, the author's words, then what is derived."""
    own = _own(part.text, derived, said)
    plots = plots and part.plots
    if part.kind == "problem":
        derivation = derived.derivations[part.name]
        title = words(said.title(part.title or derivation.study.problem.title))
        level = part.detail or detail if detail == "standard" else detail
        found = problem_sections(derivation, said.language, level, prefix, 2, CHECKS, plots=plots)
        return [Section(title, own, prefix + "part", 1), *found]
    if part.kind == "remark":
        title = words(said.title(part.title)) if part.title else said.say("section.introduction")
        return [Section(title, own, prefix + "part", 1)]
    lesson = derived.lessons[part]
    first, *rest = lesson_sections(lesson, _about(derived, lesson), said.language, prefix)
    title = words(said.title(part.title)) if part.title else first.title
    drawn: Iterable[Block] = ()
    if part.kind == "comparison" and plots:
        one, other = (derived.derivations[name] for name in (part.first, part.second))
        about = _about(derived, lesson)
        speech = Words(said.language, about.study.problem if about else None, prefix)
        drawn = compared_figure(one, other, part.coordinate, speech)
    return [replace(first, title=title, blocks=(*own, *first.blocks, *drawn)), *rest]


def _own(text: Mapping[str, tuple[OwnParagraph, ...]], derived: DerivedCourse, said: Words) -> tuple[Block, ...]:
    """The author's words."""
    return tuple(own_blocks(said.told(text), derived.formulas))


def _about(derived: DerivedCourse, lesson: Lesson) -> Derivation | None:
    """A problem whose bodies a lesson speaks of."""
    return next((d for name, d in derived.derivations.items() if name in lesson.name), None)


def _common_notation(derived: DerivedCourse, language: str) -> Notation:
    """The notations of all problems together (they should agree on names that they share)."""
    problems = [derivation.study.problem for derivation in derived.derivations.values()]
    return common_notation(problems, language, derived.course.notation)


def plain(inlines: Inlines) -> str:
    """The words of inlines that hold nothing else."""
    return "".join(inline.text for inline in inlines if isinstance(inline, Text))

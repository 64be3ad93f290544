"""How values show themselves in a notebook: each as a few blocks, printed as HTML, LaTeX and text."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from rbpsym.decide.verdict import Verdict
from rbpsym.document.model import Block, Callout, Display, Document, Inlines, Paragraph, Section, Strong, Text, numbered, words
from rbpsym.document.notes import notation_of, shown_steps, words_of
from rbpsym.document.notes_checks import checks_section, results_section
from rbpsym.document.notes_statement import statement_section
from rbpsym.document.phrases import has_phrase, phrase, usual_notation
from rbpsym.document.words import Words, capital
from rbpsym.document.writers import html, latex
from rbpsym.document.writers.page import body, page_for
from rbpsym.expr.glyphs import DEFAULT, Notation, notation_for
from rbpsym.expr.tree import Node
from rbpsym.languages import phrases
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import UNCHECKED, Certificate, Derivation, DerivedCourse, Excerpt, Lesson, Step
from rbpsym.statement.model import Problem
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text

# --- the language in which values show themselves in a notebook: English, until `speak` names another


_CHOSEN = {"language": "en"}  # what a notebook chose: values know nothing of the language of their reader


def speak(language: str) -> None:
    """Let values show themselves in a language from now on. Raises RbpsymError if there are no phrases in it.

    >>> speak("en")
    """
    phrases(language)
    _CHOSEN["language"] = language


def spoken() -> str:
    """The language that was chosen."""
    return _CHOSEN["language"]


# ---


Bundle = dict[str, str]


def looks(value: object) -> Bundle:
    """The value by media type; the class decides, or the nearest class above it that has a look."""
    show = next(LOOKS[kind] for kind in type(value).__mro__ if kind in LOOKS)
    return show(value)


def formula(node: Node) -> Bundle:
    """A formula, which the notebook's own MathJax draws."""
    notation = usual_notation(spoken())
    return {"text/latex": rf"$\displaystyle {to_latex(node, notation)}$", "text/plain": to_text(node, notation)}


def of_document(document: Document) -> Bundle:
    """A document without the shell of a page."""
    from rbpsym.document.writers.terminal import plain_lines

    done = numbered(document)
    page = page_for(done, latex.LATEX, latex.COLUMN)
    return {
        "text/html": html_part(done),
        "text/latex": "\n\n".join(filter(None, [page.inlines(done.title), body(done, page)])),
        "text/plain": "\n".join(plain_lines(document)),
    }


def html_part(document: Document) -> str:
    """The document as one element; its style sheet touches nothing outside of it."""
    page = page_for(document, html.HTML, html.COLUMN)
    title = f"<h1>{page.inlines(document.title)}</h1>" if document.title else ""
    inner = title + body(document, page)
    return f'<div class="rbpsym" lang="{document.language}"><style>{scoped_style()}</style>{inner}</div>'


def scoped_style() -> str:
    """The style sheet of the notes inside `.rbpsym`, whose variables and page settings move there.

    The class is named three times, so that the notebook's own rules for tables give way.
    """
    sheet = re.sub(r"(?<![\w.#-])(?::root|html|body)\{", "&{", html.style())
    return f".rbpsym.rbpsym.rbpsym{{{sheet}&{{max-width:none;padding:0 .5rem;margin:0;font-size:1rem}}}}"


def fragment(blocks: Iterable[Block], notation: Notation = DEFAULT, title: Inlines = ()) -> Bundle:
    """Blocks as a document without headings."""
    return of_document(Document(title, (Section((), tuple(blocks), level=4),), language=spoken(), notation=notation))


def verdict_words(verdict: Verdict) -> Inlines:
    """ "proved" in bold, and why."""
    told = str(verdict).partition(": ")[2]
    word = phrase(f"verdict.{verdict.kind}", spoken())
    return (Strong(word), *words(f": {told}" if told else ""))


def step_blocks(step: Step) -> tuple[Block, ...]:
    """The formula of a step, and what became of its check."""
    shown = Display(step.statement, "", False, step.is_result)
    return (shown,) if step.certificate is UNCHECKED else (shown, Paragraph(checked(step.certificate)))


def checked(certificate: Certificate) -> Inlines:
    """The verdict on a step and the ways in which it was checked."""
    language = spoken()
    names = [name for name in certificate.checks if has_phrase(f"checked.{name}", language)]
    told = [part for name in names for part in (Text(" "), *phrase(f"checked.{name}", language))]
    verdict = certificate.verdict
    if not verdict.is_proved or not told:
        return verdict_words(verdict)
    return (Strong(capital(phrase(f"verdict.{verdict.kind}", language))), Text("."), *told)


def of_problem(problem: Problem) -> Bundle:
    """The statement in words, with drawing and symbols."""
    derivation = Derivation(Study(problem), ())
    said = Words(spoken(), problem)
    blocks = statement_section(derivation, said, 1).blocks
    return fragment(blocks, said.notation, words(said.title(problem.title)))


def of_derivation(derivation: Derivation) -> Bundle:
    """The results, and what was proved by which roads."""
    said = words_of(derivation, shown_steps(derivation, "standard"), spoken())
    shown = (block for section in results_section(derivation, said, 1) for block in section.blocks)
    results = [_without_reasons(block) for block in shown if isinstance(block, Callout)]
    checks = checks_section(derivation, said, 1, None).blocks
    problem = derivation.study.problem
    return fragment((*results, *checks), said.notation, words(said.title(problem.title)))


def _without_reasons(block: Callout) -> Callout:
    """A callout of results whose numbers stand on no page here."""
    plain = (replace(one, reason=None, repeats=None) if isinstance(one, Display) else one for one in block.blocks)
    return replace(block, blocks=tuple(plain))


def of_excerpt(excerpt: Excerpt) -> Bundle:
    """Some steps of a derivation in its notation."""
    blocks = (block for id in excerpt.ids for block in step_blocks(excerpt.derivation.step(id)))
    return fragment(blocks, notation_of(excerpt.derivation, spoken()))


def of_lesson(lesson: Lesson) -> Bundle:
    """The steps of a lesson."""
    notation = notation_for((), lesson.notation, usual_notation(spoken()))
    return fragment((block for step in lesson.steps for block in step_blocks(step)), notation)


def of_course(course: DerivedCourse) -> Bundle:
    """The problems of a course, each with how many of its steps are proved."""
    said = Words(spoken())
    lines = []
    for derivation in course.derivations.values():
        counts = derivation.summary()
        name = said.title(derivation.study.problem.title)
        told = said.say("notebook.proved", proved=counts["proved"], steps=counts["steps"])
        lines.append(Paragraph((Strong(words(name)), Text(": "), *told)))
    return fragment(lines, title=words(said.title(course.course.title)))


LOOKS: Mapping[type, Callable[..., Bundle]] = {
    Node: formula,
    Verdict: lambda verdict: fragment([Paragraph(verdict_words(verdict))]),
    Problem: of_problem,
    Step: lambda step: fragment(step_blocks(step)),
    Excerpt: of_excerpt,
    Derivation: of_derivation,
    Lesson: of_lesson,
    DerivedCourse: of_course,
    Document: of_document,
}

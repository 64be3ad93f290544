"""A worksheet as a document: the paper of a student, the key, the solution. No format is chosen here."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cache
from hashlib import sha256
from typing import Any

from rbpsym.document import model as d
from rbpsym.document.phrases import usual_notation
from rbpsym.document.twin import code
from rbpsym.document.writers.page import Page
from rbpsym.document.writers.page import plain_text as bare
from rbpsym.expr import tree as t
from rbpsym.proof.step import Derivation
from rbpsym.teaching import model as m
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.papers.blocks import LETTERS, AnswerOptions, EmptySpace, Form, Lead, Marked, WritingRules
from rbpsym.teaching.ranges import measure_text, number_text
from rbpsym.teaching.wording import plain_text, say, say_slip

SIGN_WORDS = {"+": "positive", "-": "negative", "0": "zero"}


Escape = Callable[[str], str]


def points_text(points: Fraction, language: str) -> str:
    """ "3 points"."""
    count = 1 if points == 1 else 2
    shown = number_text(points, usual_notation(language).decimal)
    return plain_text("paper.points", language, count=count, points=shown)


def head(
    worksheet: m.Worksheet, document: d.Document, page: Page, escape: Escape, as_text: Escape | None = None, *, is_key: bool
) -> dict[str, Any]:
    """What stands at the top and the foot of a paper or a key, written for a format by `escape` (`as_text` where no markup
    may stand)."""

    def said(key: str, **slots: str) -> str:
        return escape(plain_text(f"paper.{key}", worksheet.language, **slots))

    student = worksheet.student
    shown = "" if student is None else (student.name or student.id) if is_key else student.name
    return {
        "title": page.inlines(document.title),
        "plain_title": (as_text or escape)(bare(document.title, document.notation)),
        "language": worksheet.language,
        "is_key": is_key,
        "code": said("form", code=worksheet.code),
        "student": escape(shown),
        "words": {key: said(key) for key in ("name", "date", "total")},
        "points": escape(number_text(worksheet.points, worksheet.notation.decimal)),
    }


# --- the paper


def paper_document(worksheet: m.Worksheet, studio: str = "") -> d.Document:
    """The paper: statements, numbers, tasks with room for answers; codes that lead to the tutor of a studio, if one is named."""
    sections: list[d.Section] = []
    if worksheet.introduction:
        sections.append(d.Section((), worksheet.introduction, level=3))
    for part in worksheet.parts:
        heading = part.title if len(worksheet.parts) > 1 else ()
        live = d.Live(part.problem, worksheet.problems[part.problem].text)
        codes = (code(live, studio, worksheet.language, "tutor"),) if studio else ()
        sections.append(d.Section(heading, (*part.statement, *codes), level=1 if heading else 3))
        sections += [d.Section((), tuple(task_blocks(item, worksheet)), level=3) for item in part.items]
    return d.Document(worksheet.title, tuple(sections), language=worksheet.language, notation=worksheet.notation)


def task_blocks(item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    """A task with its answer area."""
    first, *rest = item.prompt
    inlines = first.inlines if isinstance(first, d.Paragraph) else ()
    yield Lead(item.id, inlines, points_text(item.points, worksheet.language))
    yield from rest if isinstance(first, d.Paragraph) else item.prompt
    yield from AREAS[type(item.key)](item.key, item, worksheet)


def _choices(key: m.ChoiceKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    yield AnswerOptions(tuple(option.content for option in key.options))
    if item.kind == "compare":
        yield EmptySpace(float(item.space))


def _number_line(key: m.NumberKey | m.FormulaKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    yield EmptySpace(float(item.space))
    yield WritingRules(((d.Math(t.relation(key.left, "=", t.Word(""))),),))


def _pieces(key: m.OrderKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    yield Marked(tuple(zip(LETTERS, (piece.statement for piece in key.pieces), strict=False)))
    yield WritingRules((d.words(plain_text("paper.order", worksheet.language) + ": "),), 8.0)


def _lines(key: m.SlipKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    yield Marked(tuple((str(k), piece.statement) for k, piece in enumerate(key.lines, 1)))
    language = worksheet.language
    words = (d.words(plain_text(f"paper.{key}", language) + ": ") for key in ("line", "corrected", "reason"))
    yield WritingRules(tuple(words), 8.0)


def _sign_table(key: m.SignsKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    rows = tuple((row.label, (), (), ()) for row in key.rows)
    yield Form(_sign_header(worksheet.language), rows)


def _sign_header(language: str) -> tuple[d.Inlines, ...]:
    return tuple(say(f"signs.{key}", language) for key in ("force", "translational", "rotational", "cancels"))


Area = Callable[[Any, m.Item, m.Worksheet], Iterator[d.Block]]

AREAS: Mapping[type, Area] = {
    m.ChoiceKey: _choices,
    m.ComparisonKey: _choices,
    m.NumberKey: _number_line,
    m.FormulaKey: _number_line,
    m.OrderKey: _pieces,
    m.SlipKey: _lines,
    m.SignsKey: _sign_table,
    m.BlanksKey: lambda key, item, worksheet: iter(
        [WritingRules(tuple((d.Math(t.relation(m.blank(b.number), "=", t.Word(""))),) for b in key.blanks))]
    ),
    m.ExplanationKey: lambda key, item, worksheet: iter([EmptySpace(float(item.space))]),
}


# --- the key


def key_document(worksheet: m.Worksheet) -> d.Document:
    """The key: every answer, the rubric, and the slips that wrong answers show."""
    sections = [d.Section((), tuple(_key_head(worksheet)), level=3)]
    for part in worksheet.parts:
        if len(worksheet.parts) > 1:
            sections.append(d.Section(part.title, (), level=1))
        sections += [d.Section((), tuple(key_blocks(item, worksheet)), level=3) for item in part.items]
    title = say("paper.key_of", worksheet.language, title=worksheet.title)
    return d.Document(title, tuple(sections), language=worksheet.language, notation=worksheet.notation)


def _key_head(worksheet: m.Worksheet) -> Iterator[d.Block]:
    given = [numbers(part, worksheet) for part in worksheet.parts if part.given]
    for listed in given:
        yield d.Paragraph(say("solution.numbers", worksheet.language, given=listed))


def numbers(part: m.Part, worksheet: m.Worksheet) -> list[t.Node]:
    """name = number for all that is given."""
    mark = worksheet.notation.decimal
    return [t.equation(t.Sym(n), t.Word(measure_text(x, mark))) for n, x in part.given.items()]


def key_blocks(item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    """The answer to a task, its rubric and the known slips."""
    yield Lead(item.id, tuple(_answer(item, worksheet)), points_text(item.points, worksheet.language))
    if type(item.key) in KEYS:
        yield from KEYS[type(item.key)](item.key, item, worksheet)
    if item.rubric:
        yield d.ItemList(tuple(_criterion(c, worksheet) for c in item.rubric))
    slips = tuple(_slips(item, worksheet))
    if slips:
        yield d.ItemList(slips)


def solution_blocks(item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    """The answer to a task, and how it is found."""
    yield Lead(item.id, tuple(_answer(item, worksheet)), points_text(item.points, worksheet.language))
    if isinstance(item.key, (m.SignsKey, m.BlanksKey)):
        yield from KEYS[type(item.key)](item.key, item, worksheet)
    if not isinstance(item.key, m.BlanksKey):
        yield from item.solution


def _answer(item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Inline]:
    """The answer in a line, where it fits one."""
    key, mark = item.key, worksheet.notation.decimal
    if isinstance(key, m.ChoiceKey):
        yield d.Strong(d.words(f"{LETTERS[key.right]})"))
        yield d.Text(" ")
        yield from key.options[key.right].content
    elif isinstance(key, m.NumberKey):
        yield d.Math(t.equation(key.left, key.formula, t.Word(measure_text(key.measure, mark))))
    elif isinstance(key, m.FormulaKey):
        yield d.Math(t.equation(key.left, key.value))
    elif isinstance(key, m.OrderKey):
        order = " ".join(LETTERS[k] for k in key.sample)
        yield from say("paper.accepted_order", worksheet.language, order=order)
    elif isinstance(key, m.SlipKey):
        yield d.Text(f"{plain_text('paper.line', worksheet.language)}: {key.wrong + 1}. ")
        yield d.Text(f"{plain_text('paper.corrected', worksheet.language)}: ")


def _slip_key(key: m.SlipKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    yield d.Display(key.corrected, numbered=False)
    yield d.Paragraph(feedback(key.slip, item, worksheet))


def _signs_key(key: m.SignsKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    language = worksheet.language
    groups = list(dict.fromkeys(row.cancels for row in key.rows if row.cancels))
    rows = []
    for row in key.rows:
        signs = (say(f"signs.{SIGN_WORDS[s]}", language) for s in (row.translational, row.rotational))
        group = d.words(LETTERS[groups.index(row.cancels)]) if row.cancels else say("signs.nothing", language)
        rows.append((row.label, *signs, group))
    yield Form(_sign_header(language), tuple(rows))


def _blanks_key(key: m.BlanksKey, item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Block]:
    for answer in key.blanks:
        yield d.Display(t.equation(m.blank(answer.number), answer.value), numbered=False)


# what a key shows below the answer; of other kinds the answer is all
KEYS: Mapping[type, Area] = {
    m.SlipKey: _slip_key,
    m.SignsKey: _signs_key,
    m.BlanksKey: _blanks_key,
    m.ExplanationKey: lambda key, item, worksheet: iter(key.sample),
}


def _criterion(criterion: m.Criterion, worksheet: m.Worksheet) -> d.Inlines:
    points = say("paper.points_each", worksheet.language, points=number_text(criterion.points, worksheet.notation.decimal))
    return (d.Strong(points), d.Text(" "), *criterion.text)


def _slips(item: m.Item, worksheet: m.Worksheet) -> Iterator[d.Inlines]:
    """What each known wrong answer says about its maker."""
    key, mark = item.key, worksheet.notation.decimal
    if isinstance(key, m.ChoiceKey):
        found = [(d.words(f"{LETTERS[k]})"), o.slip) for k, o in enumerate(key.options) if o.slip]
    elif isinstance(key, m.NumberKey):
        found = [(d.words(measure_text(a.number, mark)), a.slip) for a in key.anticipated if a.number]
    elif isinstance(key, m.FormulaKey):
        found = [((d.Math(formula),), slip) for formula, slip in m.wrong_formulas(key.anticipated)]
    elif isinstance(key, m.BlanksKey):
        found = [((d.Math(formula),), slip) for b in key.blanks for formula, slip in m.wrong_formulas(b.anticipated)]
    else:
        found = []
    for answer, slip in found:
        comment = feedback(slip, item, worksheet)
        yield say("paper.slip", worksheet.language, answer=answer, comment=comment)


def feedback(slip: m.Slip, item: m.Item, worksheet: m.Worksheet) -> d.Inlines:
    """What is said of a slip, the bodies called as in the problem of the item."""
    return say_slip(slip, worksheet.language, (worksheet.problems[item.asked.problem],))


# --- the solution


def solution_document(worksheet: m.Worksheet, derivations: Mapping[str, Derivation]) -> d.Document:
    """The full derivation of each problem, then every answer worked out at the student's numbers."""
    from rbpsym.teaching.papers.solution import part_sections

    sections: list[d.Section] = []
    for part in worksheet.parts:
        sections += part_sections(part, worksheet, derivations[part.problem])
    title = say("paper.solution_of", worksheet.language, title=worksheet.title)
    return d.Document(title, tuple(sections), language=worksheet.language, notation=worksheet.notation)


# --- names of students: of the files of their papers, and on the papers themselves


LONGEST = 60


def file_stem(worksheet: Worksheet) -> str:
    """`name` or `name-student`, without anything that a file system or a shell takes amiss; what is called as its problem is
    `name-worksheet`: the notes of that are `name` in the same folder."""
    name, student = worksheet.name, worksheet.student
    if student is not None:
        return f"{safe(name)}-{own(student.id)}"
    return f"{name}-worksheet" if name in worksheet.problems else name


def own(id: str) -> str:
    """A name that no other id has, not even where capitals do not count: a changed one ends with a digest."""
    plain = safe(id)
    if plain == id == id.lower():
        return plain
    return f"{plain}-{sha256(id.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}"


def safe(text: str) -> str:
    """Letters, digits, dots and dashes of a text; "student" if nothing is left."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9.]+", "-", plain).strip("-.")[:LONGEST] or "student"


# --- names of students that the fonts of a paper have no letters for: the key of the student stands there instead


FONT = "New Computer Modern"  # of templates/worksheet.typ
ENCODINGS = ("latin-1", "iso8859-2", "iso8859-9", "iso8859-15")  # what pdflatex sets without further packages


def printable(worksheet: Worksheet, engine: str) -> Worksheet:
    """The worksheet with a name that can be set."""
    student = worksheet.student
    if student is None or has_letters(student.name, engine):
        return worksheet
    shown = student.id if has_letters(student.id, engine) else ""
    return replace(worksheet, student=replace(student, name=shown))


def without_letters(students: Iterable[Student], engine: str) -> tuple[Student, ...]:
    """The students whose names can't be set."""
    return tuple(student for student in students if not has_letters(student.name, engine))


def has_letters(text: str, engine: str) -> bool:
    """Whether an engine (“typst” or “pdflatex”) can set a text."""
    if all(_is_latin(char) for char in text):
        return True
    return engine == "typst" and _typst_sets(text)


def _is_latin(char: str) -> bool:
    for encoding in ENCODINGS:
        with suppress(UnicodeEncodeError):
            char.encode(encoding)
            return True
    return False


@cache
def _typst_sets(text: str) -> bool:
    """Tried on a page that holds nothing else."""
    import typst

    from rbpsym.typeset.escaping import typst_string

    source = f'#set document(title: "x")\n#set text(font: "{FONT}", lang: "en")\n#{typst_string(text)}'
    try:
        typst.compile(source.encode(), pdf_standards=["ua-1"], font_paths=typst.Fonts(include_system_fonts=False))
    except typst.TypstError:
        return False
    return True

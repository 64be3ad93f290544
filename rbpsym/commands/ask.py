"""`rbpsym ask`: questions about a problem, and their answers with their road and with numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import click

from rbpsym.commands.arguments import found, name_argument, stated
from rbpsym.commands.certify import lines as certificate
from rbpsym.commands.certify import report_on_answer
from rbpsym.errors import RbpsymError, ReadError

if TYPE_CHECKING:
    from rbpsym.ask.asked import Asked
    from rbpsym.ask.found import Answer
    from rbpsym.ask.numbers import GivenNumbers
    from rbpsym.expr.glyphs import Notation
    from rbpsym.kernel.coqc import Report
    from rbpsym.statement.model import Problem

FINE, DOUBTFUL, UNANSWERED, BROKEN = 0, 1, 2, 70
INSIDE = "an error inside rbpsym, not in this question"
OURS = (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError)  # what a fault of ours raises


@click.command("ask")
@name_argument
@click.argument("questions", nargs=-1, metavar='"QUESTION"...')
@click.option("--json", "as_json", is_flag=True, help="Print the answers as JSON, for programs.")
@click.option("--with", "given", metavar='"M = 10 kg, ..."', help="Numbers with units (“example”: the file's): the value too.")
@click.option("--certified", is_flag=True, help="Mark with ✓ only what Rocq certifies too (takes a while).")
def command(name: str, questions: tuple[str, ...], as_json: bool, given: str | None, certified: bool) -> int:
    """Answer questions about a problem: any quantity, at any moment or along the motion, with its proof.

    \b
    Examples:
      rbpsym ask sliding-ladder "N_w where theta = pi/6"
      rbpsym ask rod-pendulum "velocity of rod.end as a function of theta" --json
      rbpsym ask rod-pendulum "period of theta" --with "ell = 1 m, g = 9.81 m/s^2"
      rbpsym ask my-problem.toml            # the questions of the file itself: [[ask]]

    A question is a quantity, and when, where or as a function of what it is asked for: docs/ask.md has the
    whole grammar. In JSON, `answer` is text for sympy.sympify with the names that `symbols` tells. With --certified
    ○ stands before what is proved, and not certified by Rocq.
    """
    from rbpsym.ask.asked import Asked
    from rbpsym.ask.numbers import read_numbers
    from rbpsym.ask.words.reader import spread

    problem = stated(found(name, ("problem",))[1], questions)
    questions = tuple(one for text in questions or problem.questions for one in spread(problem, text))
    if not questions:
        raise ReadError(f"nothing is asked about {name}", instead='add a question: rbpsym ask NAME "N at the start".')
    numbers = read_numbers(given, problem) if given else None
    asked = Asked(numbers.in_case(problem) if numbers else problem)
    tell = _told if len(questions) == 1 else _told_or_refused
    told = [tell(asked, text, numbers) for text in questions]
    reports = [report_on_answer(answer) if certified and answer else None for answer, _ in told]
    records = [record | ({} if report is None else {"certified": report.record()})
               for (_, record), report in zip(told, reports, strict=True)]  # fmt: skip
    if as_json:
        import json

        click.echo(json.dumps(records[0] if len(records) == 1 else records, indent=2, ensure_ascii=False))
    else:
        rows = zip(told, reports, strict=True)
        click.echo("\n\n".join("\n".join(lines(*each, numbers, problem, report)) for each, report in rows))
    errors = [record["error"] for record in records if "error" in record]
    if errors:
        return BROKEN if any(error.startswith(INSIDE) for error in errors) else UNANSWERED
    return FINE if all(record["verdict"] == "PROVED" for record in records) else DOUBTFUL


def _told(asked: Asked, text: str, numbers: GivenNumbers | None) -> tuple[Answer | None, dict[str, Any]]:
    """The answer with its record; no answer where there is no closed form and numbers give the value."""
    from rbpsym.ask.asked import NoClosedForm
    from rbpsym.ask.asking import answered
    from rbpsym.ask.question import read_question
    from rbpsym.ask.telling import record, record_integrated
    from rbpsym.ask.units import in_letters

    try:
        answer = answered(asked, text)
    except NoClosedForm:
        if numbers is None:
            raise
        asked, plain, given = in_letters(asked, text)
        told = record_integrated(asked, read_question(plain), numbers.beside(asked.problem, given))
        return None, {**told, "question": text}
    return answer, record(answer, numbers)


def _told_or_refused(asked: Asked, text: str, numbers: GivenNumbers | None) -> tuple[Answer | None, dict[str, Any]]:
    """The same; for a question without an answer the sentence that says why, as the reason and as the "error": what fails in one
    question, by a fault of ours too, leaves the others theirs."""
    from rbpsym.ask.telling import unanswered

    try:
        return _told(asked, text, numbers)
    except (RbpsymError, *OURS) as error:
        told = str(error) if isinstance(error, RbpsymError) else f"{INSIDE}: {type(error).__name__}: {error}"
        return None, {**unanswered(text, told), "error": told}


def lines(
    found: Answer | None, record: Mapping[str, Any], numbers: GivenNumbers | None, problem: Problem, report: Report | None = None
) -> Iterator[str]:
    """An answer with its short road, as a textbook prints it, its numbers, and what Rocq says, if it was asked."""
    from rbpsym.ask.telling import numbered
    from rbpsym.decide.verdict import PROVED, Kind
    from rbpsym.document.writers.terminal import MARKS, UNCERTIFIED
    from rbpsym.expr.glyphs import Notation

    notation = Notation(problem.notation)
    yield click.style(record["question"], bold=True)
    yield from [click.style(f"    (read as “{record['read_as']}”)", dim=True)] if "read_as" in record else ()
    is_doubtful = report is not None and record["verdict"] == PROVED and not report.is_whole
    sign, colour = UNCERTIFIED if is_doubtful else MARKS[Kind(record["verdict"])]
    mark = click.style(sign, fg=colour)
    yield from _road(found, mark, notation) if found else [f"  {mark} {record['reason']}"]
    yield from (f"    {line}" for line in numbered(record, numbers)) if numbers and {"value", "table"} & record.keys() else ()
    yield from (f"    {line}" for line in certificate(report)) if report else ()


def _road(found: Answer, mark: str, notation: Notation) -> Iterator[str]:
    """The steps, the values, what is said beside them, the conditions."""
    from rbpsym.expr import tree as t
    from rbpsym.typeset.text import to_text

    for step in (step for step in found.steps if step.id != "answer"):
        rows = (row.strip() for row in to_text(step.statement, notation).splitlines())
        yield click.style(f"    {'; '.join(rows)}", dim=True)
    told = list(_values(found, notation))
    whole = told[0] if len(told) == 1 else f"({', '.join(told)})" if told else ""
    yield f"  {mark} {whole}".rstrip()
    yield from (f"    {line}" for line in _beside(found, notation))
    if found.valid:
        yield f"    where {', '.join(to_text(t.upright(node), notation) for node in found.valid)}"
    if not found.verdict.is_proved:
        yield f"    {found.verdict.kind}: {found.verdict.reason}"


def _values(found: Answer, notation: Notation) -> Iterator[str]:
    """The values, those of a parameter with its name, each with its own conditions."""
    from rbpsym.expr import tree as t
    from rbpsym.typeset.text import to_text

    if found.holds_so is not None:
        yield "yes" if found.holds_so else "no"
    ops = {"between": (">", "<")}.get(found.relation, (found.relation,) * len(found.nodes))
    for number, (node, op) in enumerate(zip(found.nodes, ops, strict=False)):
        shown = t.relation(t.Sym(found.symbol), op, node) if found.symbol and op in ("=", "<", ">", "<=", ">=") else node
        own = found.each[number] if found.each else ()
        yield to_text(shown, notation) + (f" if {', '.join(to_text(t.upright(part), notation) for part in own)}" if own else "")


def _beside(found: Answer, notation: Notation) -> Iterator[str]:
    """What else is said: a sentence, the equation that is solved, the place of an extremum."""
    from rbpsym.ask.telling import valid_for
    from rbpsym.expr import tree as t
    from rbpsym.typeset.text import to_text

    if found.given:
        yield ", ".join(f"{name} = {value}" for name, value in found.given.items())
    if found.equation is not None:
        yield f"{found.symbol} solves {to_text(t.equation(found.equation, t.ZERO), notation)}"
    if found.at is not None and found.at[0] != found.symbol:
        yield f"at {to_text(t.equation(t.Sym(found.at[0]), found.at[1]), notation)}"
    if found.says and (found.holds_so is None or found.says not in ("yes", "no")):
        yield found.says
    if nearly := valid_for(found):
        yield f"for {nearly}"

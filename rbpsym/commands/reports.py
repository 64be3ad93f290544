"""What a check found: a table for people, JSON, JUnit, annotations for GitHub, a page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any

from rbpsym.claims.model import CERTIFIED, Outcome, Result

if TYPE_CHECKING:
    from rich.text import Text

    from rbpsym.commands.check import CheckRun

STYLES = {
    Outcome.PROVED: "green",
    Outcome.DEFINITION: "green",
    Outcome.REFUTED: "red",
    Outcome.UNDECIDED: "yellow",
    Outcome.NOT_COMPUTED: "dim",
    Outcome.UNREAD: "bold red",
}
LINE = 120  # characters, where no terminal says how wide it is
SHORT = {Outcome.NOT_COMPUTED: "not computed", Outcome.UNREAD: "NOT READ"}


def word(result: Result) -> str:
    """The verdict in a word or two; an erratum that stays refuted says so."""
    told = SHORT.get(result.outcome, str(result.outcome))
    if result.known:
        return f"{told} (known)"
    return f"{told} ({result.erratum or 'expected'})" if result.outcome is Outcome.REFUTED and result.expected else told


def lines(result: Result) -> Iterator[str]:
    """How it was proved, or the witness and what seems to be meant."""
    if result.outcome in (Outcome.PROVED, Outcome.DEFINITION):
        yield result.how or result.detail
    if result.rocq:
        yield result.rocq if result.rocq == CERTIFIED else f"not certified: {result.rocq}"
    for link in result.links:
        if link.outcome not in (Outcome.PROVED, Outcome.DEFINITION):
            many = f"{link.relation}: " if len(result.links) > 1 else ""
            yield f"{many}{link.detail or link.outcome}"
    if not result.links and result.outcome not in (Outcome.PROVED, Outcome.DEFINITION):
        yield result.detail
    if result.diagnosis:
        yield result.diagnosis if result.diagnosis.startswith("in fact") else f"near miss: {result.diagnosis}"
    if result.fix:
        yield f"write: {' '.join(result.fix.split())}"
    if result.right:
        yield f"right form {result.right}: {result.right_latex.strip()}"


def name_of(result: Result) -> str:
    """Number, or the id of what has none."""
    return f"({result.number})" if result.number else result.id


def totals(found: CheckRun) -> dict[str, int]:
    """How many results of each kind, and how many are not as expected."""
    counted = Counter(str(result.outcome) for result in found.results)
    unexpected = sum(not result.expected for result in found.results)
    return {**{str(outcome): counted[str(outcome)] for outcome in Outcome}, "unexpected": unexpected}


def summary(found: CheckRun) -> str:
    """The last line: counts, and whether all is as expected."""
    counts = totals(found)
    told = [
        f"{count} {SHORT.get(Outcome(kind), kind)}" for kind, count in counts.items() if count and kind != "unexpected"
    ]
    whole = "all as expected" if found.is_decided else "NOT AS EXPECTED: nothing was decided"
    whole = f"{counts['unexpected']} NOT AS EXPECTED" if counts["unexpected"] else whole
    asked = [result.rocq == CERTIFIED for result in found.results if result.rocq]
    told += [f"{sum(asked)} of {len(asked)} certified by Rocq"] if asked else []
    return f"{len(found.results)} checked: {', '.join(told) or 'nothing'}; {whole}."


def source(result: Result) -> str:
    """The text or claims file of a result, as one names it."""
    return result.file or PurePath(result.declared[0]).stem


def cells(result: Result) -> tuple[str | Text, ...]:
    """Its row in the table."""
    from rich.text import Text

    style = STYLES[result.outcome] if result.outcome is not Outcome.REFUTED or not result.expected else "cyan"
    verdict = Text(("" if result.expected else "✗ ") + word(result), style=style)
    return name_of(result), result.label, str(result.line or ""), verdict, Text("\n".join(lines(result)))


def as_table(found: CheckRun, failures: bool = False) -> str:
    """A table for a terminal."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, header_style="bold")
    for column in ("No.", "Label", "Line", "Verdict", "How, witness, diagnosis"):
        table.add_column(
            column, overflow="fold", no_wrap=column == "Line", justify="right" if column == "Line" else "left"
        )
    shown, last = [result for result in found.results if not (failures and result.expected)], ""
    several = len({source(result) for result in found.results if result.kind == "claim"}) > 1
    for result in shown:
        if several and result.kind == "claim" and source(result) != last:
            last = source(result)
            table.add_row(Text(last, style="bold"))
        table.add_row(*cells(result))
    console = Console(highlight=False)
    if not console.is_terminal:
        console = Console(highlight=False, width=max(console.width, LINE))
    with console.capture() as capture:
        if table.row_count:
            console.print(table)
        for file, line, remark in found.remarks:
            console.print(Text(f"{file}:{line}: {remark}", style="yellow"))
        console.print(Text(summary(found), style="bold"))
    return capture.get()


# what JSON tells of a result, and of each link of its chain
RESULT = (
    "id kind number label file claims line latex says outcome expected how detail diagnosis fix erratum right right_latex note"
)
LINK = "relation outcome how detail diagnosis fix"


def record(result: Result) -> dict[str, Any]:
    """One result as JSON has it."""
    own: dict[str, Any] = {"claims": result.declared[0], "latex": result.latex.strip(), "outcome": str(result.outcome)}
    links = [{name: str(getattr(link, name)) for name in LINK.split()} for link in result.links]
    if result.rocq:
        is_certified = result.rocq == CERTIFIED
        own |= {"certified": is_certified, "not_certified": "" if is_certified else result.rocq}
    asked = [name for name in ("certified", "not_certified") if name in own]
    return {name: own.get(name, getattr(result, name, None)) for name in (*RESULT.split(), *asked)} | {"links": links}


def as_json(found: CheckRun, failures: bool = False) -> str:
    """All results for programs."""
    import json

    kept = [result for result in found.results if not (failures and result.expected)]
    remarks = [{"file": file, "line": line, "remark": remark} for file, line, remark in found.remarks]
    whole = {"version": 1, "summary": totals(found), "results": [record(result) for result in kept], "remarks": remarks}
    return json.dumps(whole, indent=2, ensure_ascii=False) + "\n"


def as_junit(found: CheckRun) -> str:
    """A JUnit report: a test case a formula."""
    from xml.etree import ElementTree as xml

    failed = sum(not result.expected for result in found.results)
    skipped = sum(result.outcome is Outcome.NOT_COMPUTED and result.expected for result in found.results)
    suite = xml.Element(
        "testsuite", name="rbpsym check", tests=str(len(found.results)), failures=str(failed), skipped=str(skipped)
    )
    for result in found.results:
        where = shown(result.file) if result.file else source(result)
        case = xml.SubElement(
            suite, "testcase", classname=where or "claims", name=result.id, time=f"{result.seconds:.4f}"
        )
        told = printable("\n".join(lines(result)))
        if not result.expected:
            xml.SubElement(case, "failure", message=f"{word(result)}: {told.partition(chr(10))[0]}").text = printable(
                f"{result.latex}\n{told}"
            )
        elif result.outcome is Outcome.NOT_COMPUTED:
            xml.SubElement(case, "skipped", message=told or "not a formula we compute")
    xml.indent(suite)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + xml.tostring(suite, encoding="unicode") + "\n"


def printable(text: str) -> str:
    """The text without characters that XML can't hold."""
    return "".join(char if char in "\n\t" or char.isprintable() else " " for char in text)


def as_annotations(found: CheckRun) -> str:
    """Workflow commands that put a note on the line of each formula that is not as expected."""
    told = [
        annotation("error", *place(result), f"{name_of(result)} {word(result)}", "\n".join(lines(result)))
        for result in found.results
        if not result.expected
    ]
    told += [annotation("warning", file, line, "label", remark) for file, line, remark in found.remarks]
    return "".join(f"{one}\n" for one in told)


def place(result: Result) -> tuple[str, int]:
    """The line in the text, or that of the claim."""
    return (result.file, result.line) if result.file and result.line else result.declared


def shown(file: str) -> str:
    """A file as a program that runs in this folder finds it: with / and from here, if it lies here."""
    path = Path(file)
    here = path.resolve().is_relative_to(Path.cwd())
    return (path.resolve().relative_to(Path.cwd()) if here and file else path).as_posix()


def annotation(level: str, file: str, line: int, title: str, message: str) -> str:
    """One workflow command, what is special in it escaped."""
    return f"::{level} file={escaped(shown(file))},line={max(line, 1)},title={escaped(title)}::{escaped(message, whole=True)}"


def escaped(text: str, whole: bool = False) -> str:
    """Percent signs and line ends, and in a property also : and ,."""
    marks = {"%": "%25", "\r": "%0D", "\n": "%0A", **({} if whole else {":": "%3A", ",": "%2C"})}
    return "".join(marks.get(char, char) for char in text)


def as_html(found: CheckRun) -> str:
    """A page: one row a formula, its LaTeX beside what was found; below, the texts with their formulas coloured."""
    from markupsafe import Markup

    from rbpsym.commands.patches import marked
    from rbpsym.document.writers.page import shell

    rows = [
        {
            **record(result),
            "name": name_of(result),
            "word": word(result),
            "lines": list(lines(result)),
            "drawn": [Markup(link.mathml) if link.mathml else str(link.relation) for link in result.links],
            "kind": kind_of(result),
        }
        for result in found.results
    ]
    texts = dict.fromkeys(result.file for result in found.results if result.file and result.line)
    sources = [_source_of(file, marked(file, found.results)) for file in texts]
    return shell("check.html", autoescape=True, rows=rows, sources=sources, summary=summary(found), remarks=found.remarks)


def kind_of(result: Result) -> str:
    """Its colour on a page."""
    return "unexpected" if not result.expected else result.outcome.name.lower()


def _source_of(file: str, pieces: Iterator[tuple[str, Result | None]]) -> dict[str, Any]:
    """A text as the page shows it: how many formulas of each verdict it has, and its pieces with what was read of them."""
    parts = [(text, result and (result.id, kind_of(result), _read_as(result))) for text, result in pieces]
    counted = Counter(told[1] for _, told in parts if told)
    return {"name": shown(file), "counts": counted, "parts": parts}


def _read_as(result: Result) -> str:
    """What was read, and what was found out of it."""
    return "\n".join((*(str(link.relation) for link in result.links), word(result), *lines(result)))

"""Changes of a text as unified diffs: a first draft of its comments, and repaired formulas."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from difflib import unified_diff
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING

from rbpsym.claims.papers.macros import changed

if TYPE_CHECKING:
    from rbpsym.claims.model import Result

_MARKED_UP = (".md", ".markdown", ".myst", ".html", ".htm", ".ipynb")
COMMENTS = {".rst": (".. rbpsym{}", ""), ".typ": ("// rbpsym{}", ""), **dict.fromkeys(_MARKED_UP, ("<!-- rbpsym{}", " -->"))}


def draft_of(path: Path) -> str:
    """The text with a first draft of comments that name a problem, symbols and claims, as a diff. Raises ReadError."""
    from rbpsym.claims.papers.draft import draft
    from rbpsym.claims.papers.walk import read_paper

    begin, end = COMMENTS.get(path.suffix.lower(), ("% rbpsym{}", ""))
    comments: dict[tuple[str, int], list[str]] = {}
    for formula, said in draft(read_paper(path), path.parent):
        gap = "\n" if path.suffix.lower() == ".rst" else ""
        comments.setdefault((formula.file, formula.line), []).extend(begin.format(one) + end + "\n" + gap for one in said)
    cells = path.suffix.lower() == ".ipynb"

    def before(file: str, number: int, line: str) -> list[str]:
        """The comments before a line; in a notebook as strings of its list."""
        told = comments.get((file, number), [])
        indent = line[: len(line) - len(line.lstrip())]
        return [f"{indent}{json.dumps(one, ensure_ascii=False)},\n" for one in told] if cells else told

    return "".join(
        diff(file, text, [part for number, line in enumerate(text, 1) for part in (*before(file, number, line), line)])
        for file in dict.fromkeys(file for file, _ in comments)
        for text in [lines_in(file)]
    )


def repairs(results: Iterable[Result]) -> str:
    """The diff that repairs each formula whose one wrong place is known, where it stands in its file as it was read."""
    wrong: dict[str, list[Result]] = {}
    for result in results:
        if result.fix and result.is_finding and result.file:
            wrong.setdefault(result.file, []).append(result)
    return "".join(_repaired(file, own) for file, own in wrong.items())


def _repaired(file: str, wrong: list[Result]) -> str:
    old = lines_in(file)
    text = "".join(old)
    for result in wrong:
        start = len("".join(old[: max(result.line - 1, 0)]))
        for pattern, fix in _spellings(result.latex, result.fix):
            if found := pattern.search(text, max(start - 200, 0)):
                text = f"{text[: found.start(1)]}{fix}{text[found.end(1) :]}"
                break
    return diff(file, old, _lines(text))


_BETWEEN = r"(?:\s|(?<!\\)%[^\n]*+\n|\\label\s*+\{[^{}]*+\}|\\tag\*?\{[^{}]*+\})*+"  # of a formula, and not of what it says
_TOKEN = re.compile(r"\\[A-Za-z]+|\S")


def _spellings(latex: str, fix: str) -> Iterator[tuple[re.Pattern[str], str]]:
    """The formula with what is to be replaced as a group, and what replaces it: as LaTeX, and as a notebook holds it."""
    latex = latex.strip()
    begin, old, new = changed(latex, fix.strip())
    parts = latex[:begin], old, latex[begin + len(old) :]
    for own, between in ((str, _BETWEEN), (lambda part: json.dumps(part)[1:-1], rf'(?:{_BETWEEN}|\\n(?:",\s*+")?)*+')):
        before, inside, behind = (between.join(re.escape(own(token)) for token in _TOKEN.findall(part)) for part in parts)
        glue = between if (before or not inside) and (inside or behind) else ""  # what is put in stands in front of a part
        yield re.compile(f"{before}{glue}({inside}){between if inside and behind else ''}{behind}"), own(new)


def marked(file: str, results: Iterable[Result]) -> Iterator[tuple[str, Result | None]]:
    """The text of a file in pieces, those that are formulas with what was found out of them."""
    own = sorted((result for result in results if result.file == file and result.latex.strip()), key=lambda one: one.line)
    rows = lines_in(file)
    text, starts = "".join(rows), [0, *accumulate(len(row) for row in rows)]
    place = 0
    for result in own:
        start = max(starts[min(max(result.line - 1, 0), len(rows))], place)
        spots = (pattern.search(text, start) for pattern, _ in _spellings(f"{result.latex.strip()}", ""))
        if found := next(filter(None, spots), None):
            yield text[place : found.start()], None
            yield found[0], result
            place = found.end()
    yield text[place:], None


def lines_in(file: str) -> list[str]:
    """The lines of a text with their ends. Raises ReadError."""
    from rbpsym.claims.papers.source import MAX_BYTES
    from rbpsym.statement.library import latin_or_utf8_in

    return _lines(latin_or_utf8_in(Path(file), MAX_BYTES, "the text")[0])


def _lines(text: str) -> list[str]:
    """As git counts them: a form feed ends none."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)


def diff(file: str, old: list[str], new: list[str]) -> str:
    """What patch and git apply take, who want to be told of a last line without an end."""
    told = unified_diff(old, new, f"a/{file}", f"b/{file}")
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in told)

r"""Markdown (MyST too), reStructuredText, HTML and notebooks as LaTeX with the same lines.

Formulas become \( \), $$ $$ or environments, other text loses what TeX would act on. What a comment says to
us stands between `NOTE` and `NOTE_END` (in LaTeX it is a comment, `% rbpsym: ...`).
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Callable, Mapping
from typing import Any

from rbpsym.claims.papers.marks import NOTE, NOTE_END, SPAN, Rewriting, blank, comment, display, displays, noted
from rbpsym.claims.papers.typst import of_typst
from rbpsym.errors import Place, ReadError

_DATA = re.compile(r"data:[\w/+.-]{1,99};base64,[\w+/=]*+")  # a picture within the text
Lines = list[tuple[int, str]]  # the number of each line in its file, and the line

SINGLE = ("equation", "multline", "displaymath", "math", "dmath", "empheq")
ROWED = ("align", "eqnarray", "gather", "alignat", "flalign", "IEEEeqnarray", "dgroup")
_MATH = (
    rf"\\begin\{{(?P<name>(?:{'|'.join((*SINGLE, *ROWED))})\*?)\}}|(?<!\\)(?P<bracket>\\[\[(])|(?P<display>\$\$)"
    r"|(?P<inline>(?<!\\)\$`?)(?=\S)|(?P<sign>(?<!\\)[$%])"
)
_MARKDOWN = re.compile(
    r"(?P<comment><!--)|^[ \t]*+%[ \t]*+rbpsym:(?P<line>[^\n]*+)$"
    r"|^(?P<in>[ \t>]*+)(?P<mark>(?P<tick>[`~:])(?P=tick){2,19}+)[ \t]*+(?P<kind>\{?[\w:.+#-]*+\}?+)(?P<rest>[^\n]*+)\n"
    rf"|(?P<role>\{{math\}})?(?<!`)(?P<span>`++)|\\\\(?P<escaped>[\[\]()])|{_MATH}",
    re.M,
)
_HTML = re.compile(r"(?P<comment><!--)|<(?P<tag>/?[A-Za-z!][^<>]*+)>")
_SHOWN = re.compile(_MATH)
_RST = re.compile(
    r"^(?P<in>[ \t]*+)\.\.[ \t]++(?P<kind>math::|rbpsym:|include::|toctree::|[\w-]{0,20}code[\w-]{0,20}::)(?P<rest>[^\n]*+)"
    r"(?P<body>(?:\n[ \t]*+(?=\n|\Z)|\n(?P=in)[ \t]+[^\n]*+)*+)"
    r"|:math:`(?P<inline>[^`]+)`|(?P<sign>(?<!\\)[$%])",
    re.M,
)
_LABEL = re.compile(r"[ \t]*+\(([\w:.-]{1,200})\)")
_STRING = re.compile(r'"(?:[^"\\]|\\.)*+"')


def _math(text: Rewriting, found: re.Match[str]) -> tuple[str, int]:
    """A formula between its marks, or a dollar or percent sign of the text."""
    told, start = found.groupdict(), found.end()
    if told["name"] or told["bracket"]:
        mark = rf"\\end\{{{re.escape(told['name'])}\}}" if told["name"] else rf"\\{_CLOSED[told['bracket'][1]]}"
        closed = text.closing(mark, start)
        return text.text[found.start() : closed[1] if closed else start], closed[1] if closed else start
    closed = text.closing(r"\$\$", start) if told["display"] else None
    if closed and closed[0] > start and not _BROKEN.search(text.text, start, closed[0]):
        label = _LABEL.match(text.text, closed[1])
        body, begun = text.text[start : closed[0]], text.text[: found.start()].rpartition("\n")[2]
        body = re.sub(r"^[ \t]*>", " ", body, flags=re.M) if begun.lstrip()[:1] == ">" else body  # in a quotation
        return display(body, label[1] if label else ""), label.end() if label else closed[1]
    if told["inline"] and (closed := text.closing(r"\$", start, SPAN)) and text.paragraph(start, closed[0]):
        tick, (end, behind) = told["inline"][1:], closed
        body = text.text[start : end - len(tick)]
        marked = text.text[start:end].endswith(tick) and not text.text[behind : behind + 1].isdigit()
        if marked and body and not body[-1].isspace():
            return rf"\({body}\)", behind
    return "\\" + found[0][:1] + ("\\$" if told["display"] else found[0][1:]), start


_BROKEN = re.compile(r"\n[ \t]*\n[^$]*\$[^$]")  # a paragraph with formulas: the display before it was never closed
_CLOSED = {"[": r"\]", "(": r"\)"}


def _of_markdown(text: str) -> str:
    shown = re.sub(r"(?<!\\)\\([_*])", r" \1", _DATA.sub("", text))  # x\_p, written so for Markdown
    return re.sub(r"(?<!\\)%", r"\\%", Rewriting(shown).rewritten(_MARKDOWN, _markdown_piece))


def _markdown_piece(text: Rewriting, found: re.Match[str]) -> tuple[str, int]:
    told, start = found.groupdict(), found.end()
    if told["comment"]:
        return _commented(text, start)
    if told["line"] is not None:
        return noted(told["line"]), start
    if told["mark"]:
        closed = text.closing(rf"^[ \t>]*+{re.escape(told['mark'])}[ \t]*+$", start, len(text.text))
        kind = told["kind"]
        body = text.text[start : closed[0]] if closed else ""
        made = _fenced(kind.strip("{}"), kind.startswith("{"), told["rest"], body) if closed else blank(found[0])
        return made, closed[1] if closed else start
    if told["span"]:
        end = text.span(start, len(told["span"]))
        code = text.text[start : max(end, start)]
        return rf"\({code}\)" if told["role"] and code else blank(code), max(end, start) + len(told["span"]) * (end > 0)
    return ("\\" + told["escaped"], start) if told["escaped"] else _math(text, found)


def _commented(text: Rewriting, start: int) -> tuple[str, int]:
    """A comment: what it says to us, and its lines."""
    closed = text.closing("-->", start)
    return (comment(text.text[start : closed[0]]), closed[1]) if closed else ("", start)


def _fenced(kind: str, directive: bool, rest: str, body: str) -> str:
    """A block between fences: a formula, the text of a directive, or code."""
    if kind == "math":
        return (displays if directive else display)(f"{rest}\n{body}")
    if directive and kind in INCLUDING:
        return _included(kind, rest, body)
    if directive and "code" not in kind:
        return f"\n{_of_markdown(body)}"
    return blank(body) + "\n"


INCLUDING = ("include", "toctree")
_NO_FILE = re.compile(r"[*{}]|://|^:|^---|^\w+:\s")


def _included(kind: str, rest: str, body: str) -> str:
    r"""The files that a directive puts in, as \input, with as many lines."""
    named = (line.strip() for line in (rest, *body.split("\n")[: None if kind == "toctree" else 0]))
    names = (re.sub(r".*<([^<>]+)>$", r"\1", name) for name in named)
    inputs = (rf"\input{{{name}}}" if name and not _NO_FILE.search(name) else "" for name in names)
    return "\n".join(inputs) + ("" if kind == "toctree" else blank(body) + "\n")


def _of_html(text: str) -> str:
    return Rewriting(html.unescape(Rewriting(text).rewritten(_HTML, _html_piece))).rewritten(_SHOWN, _math)


def _html_piece(text: Rewriting, found: re.Match[str]) -> tuple[str, int]:
    if found["comment"]:
        return _commented(text, found.end())
    name = re.split(r"\W", found["tag"], maxsplit=1)[0].lower()
    if name not in ("script", "style", "pre", "code"):
        return blank(found[0]), found.end()
    closed = text.closing(rf"</{name}\s*+>", found.end(), len(text.text)) or (found.end(), found.end())
    body = text.text[found.end() : closed[0]]
    if name == "script" and "math/tex" in found["tag"] and body:
        made = rf"\[{body}\]" if "display" in found["tag"] else rf"\({body}\)"
        return blank(found[0]) + made, closed[1]
    return blank(found[0] + body), closed[1]


def _rst_piece(found: re.Match[str]) -> str:
    told = found.groupdict()
    if told["kind"] == "math::":
        return displays(told["rest"] + told["body"])
    if told["kind"] == "rbpsym:":
        return noted(told["rest"] + told["body"])
    if told["inline"]:
        return rf"\({told['inline']}\)"
    if (told["kind"] or "").removesuffix("::") in INCLUDING:
        return _included(told["kind"][:-2], told["rest"], told["body"].removeprefix("\n"))
    return "\\" + told["sign"] if told["sign"] else blank(found[0])


def _of_notebook(text: str, file: str) -> Lines:
    """The Markdown cells of a notebook and what its metadata say; a line has the number that it has in the file."""
    try:
        whole = json.loads(text)
        cells = [cell for cell in whole["cells"] if cell["cell_type"] == "markdown"]
        sources = [(_told(cell), cell["source"]) for cell in cells]
        said = _told(whole)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise ReadError("this is no notebook", instead="save it as .ipynb of version 4.", place=Place(file)) from None
    found: Lines = [(1, note) for note in (*said, "")]
    strings, place, number = _STRING.finditer(text), 0, 1
    for notes, source in sources:
        parts = source if isinstance(source, list) else [source]
        for part in filter(lambda part: isinstance(part, str), parts):
            before = place
            place = next((one.start() for one in strings if json.loads(one[0], strict=False) == part), place)
            number += text.count("\n", before, place)
            found += [(number, line) for line in (*notes, *part.removesuffix("\n").split("\n"))]
            notes = []
        found.append((number, ""))
    plain = _of_markdown("\n".join(line for _, line in found)).split("\n")
    return [(number, line) for (number, _), line in zip(found, plain, strict=True)]


def _told(part: Mapping[str, Any]) -> list[str]:
    """What the metadata of a notebook or of a cell say to us, `"rbpsym": "claim"` or a list, as comments."""
    said = part.get("metadata", {}).get("rbpsym", [])
    lines = [said] if isinstance(said, str) else said
    return [f"<!-- rbpsym: {line} -->" for line in lines if isinstance(line, str) and "\n" not in line]


FORMATS: Mapping[str, Callable[[str], str]] = {
    **dict.fromkeys((".md", ".markdown", ".myst"), _of_markdown), **dict.fromkeys((".html", ".htm"), _of_html),
    ".rst": lambda text: _RST.sub(_rst_piece, text), ".typ": of_typst,
}  # fmt: skip
NOTEBOOK = ".ipynb"
LATEX = (".tex", ".ltx", ".txt", ".latex")
TEXTS = (*LATEX, *FORMATS, NOTEBOOK)  # the endings of the names of papers


def lines_of(text: str, file: str, ending: str) -> Lines:
    """The lines of a text as LaTeX. Raises ReadError for a notebook that is none."""
    if ending == NOTEBOOK:
        return _of_notebook(text, file)
    plain = text.replace(NOTE, "").replace(NOTE_END, "")
    return list(enumerate(FORMATS.get(ending, str)(plain).split("\n"), 1))

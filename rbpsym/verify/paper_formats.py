r"""Markdown (MyST too), reStructuredText, HTML and notebooks as LaTeX with the same lines.

Formulas become \( \), $$ $$ or environments, other text loses what TeX would act on. What a comment says to
us stands between `NOTE` and `NOTE_END` (in LaTeX it is a comment, `% rbpsym: ...`).
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Callable, Mapping

from rbpsym.errors import Place, ReadError

NOTE, NOTE_END = "\ue000", "\ue001"
Lines = list[tuple[int, str]]  # the number of each line in its file, and the line

_PARAGRAPH = r"(?:(?!\n[ \t]*\n)[^$])"
_MATH = (
    r"(?P<kept>\\begin\{(?P<name>\w+\*?)\}.{0,20000}?\\end\{(?P=name)\}|(?<!\\)\\\[.*?\\\]|(?<!\\)\\\(.*?\\\))"
    r"|\$\$(?P<display>.{1,20000}?)\$\$(?:[ \t]*\((?P<label>[\w:.-]+)\))?"
    rf"|(?<!\\)\$(?P<tick>`?)(?=\S)(?P<inline>{_PARAGRAPH}{{1,2000}}?)(?<=\S)(?P=tick)\$(?!\d)"
    r"|(?P<sign>(?<!\\)[$%])"
)
_COMMENT = r"<!--(?P<comment>.{0,20000}?)-->"
_MARKDOWN = re.compile(
    rf"{_COMMENT}"
    r"|^[ \t]*%[ \t]*rbpsym:(?P<line>[^\n]*)$"
    r"|^(?P<in>[ \t>]*)(?P<mark>`{3,}|~{3,}|:{3,})[ \t]*(?P<kind>\{?[\w:.+#-]*\}?)"
    r"(?P<rest>[^\n]*)\n(?P<body>.*?)^[ \t>]*(?P=mark)[ \t]*$"
    r"|(?P<role>\{math\})?(?P<span>(?<!`)`+)(?!`)(?P<code>(?:(?!\n[ \t]*\n).){1,2000}?)(?<!`)(?P=span)(?!`)"
    rf"|\\\\(?P<bracket>[\[\]()])|{_MATH}",
    re.S | re.M,
)
_HTML = re.compile(
    rf"{_COMMENT}|<script[^>]*math/tex(?P<mode>[^>]*)>(?P<tex>.*?)</script\s*>"
    r"|<(?P<tag>script|style|pre|code)\b.*?</(?P=tag)\s*>|</?[A-Za-z!][^<>]*>",
    re.S | re.I,
)
_SHOWN = re.compile(_MATH, re.S)
_RST = re.compile(
    r"^(?P<in>[ \t]*)\.\.[ \t]+(?P<kind>math::|rbpsym:|[\w-]*code[\w-]*::)(?P<rest>[^\n]*)"
    r"(?P<body>(?:\n[ \t]*(?=\n|\Z)|\n(?P=in)[ \t]+[^\n]*)*)"
    r"|:math:`(?P<inline>[^`]+)`|(?P<sign>(?<!\\)[$%])",
    re.M,
)
_OPTION = re.compile(r"^[ \t]*:(\w+):[ \t]*(.*)$", re.M)
_SAYS = re.compile(r"\s*rbpsym:(.*)", re.S)


def _blank(text: str) -> str:
    """The ends of its lines alone."""
    return "\n" * text.count("\n")


def _noted(said: str) -> str:
    """What is said to us, a note for each line."""
    return "\n".join(f"{NOTE}{line}{NOTE_END}" if line.strip() else "" for line in said.split("\n"))


def _comment(text: str) -> str:
    found = _SAYS.match(text)
    return _blank(text[: found.start(1)]) + _noted(found[1]) if found else _blank(text)


def _display(body: str, label: str = "") -> str:
    """A displayed formula; the options of a directive in front of it name it."""
    options = dict(_OPTION.findall(body))
    label = label or options.get("label", "")
    body = _OPTION.sub("", body).rstrip(" \t")
    if "nowrap" in options:
        return body
    end = body.rstrip()
    name = "equation" if label else "equation*"
    named = rf"\label{{{label.strip()}}}" if label else ""
    return rf"\begin{{{name}}}{end}{named}\end{{{name}}}{body[len(end) :]}"


def _math(found: re.Match[str]) -> str:
    """A formula between dollars, or a dollar or percent sign of the text."""
    told = found.groupdict()
    if told["display"]:
        return _display(told["display"], told["label"] or "")
    if told["inline"]:
        return rf"\({told['inline']}\)"
    return "\\" + told["sign"] if told["sign"] else found[0]


def _of_markdown(text: str) -> str:
    return re.sub(r"(?<!\\)%", r"\\%", _MARKDOWN.sub(_markdown_piece, text))


def _markdown_piece(found: re.Match[str]) -> str:
    told = found.groupdict()
    if told["comment"] is not None:
        return _comment(told["comment"])
    if told["line"] is not None:
        return _noted(told["line"])
    if told["mark"]:
        return _fenced(told["kind"].strip("{}"), told["kind"].startswith("{"), told["rest"], told["body"])
    if told["span"]:
        return rf"\({told['code']}\)" if told["role"] else _blank(told["code"])
    return "\\" + told["bracket"] if told["bracket"] else _math(found)


def _fenced(kind: str, directive: bool, rest: str, body: str) -> str:
    """A block between fences: a formula, the text of a directive, or code."""
    if kind == "math":
        return _display(f"{rest}\n{body}")
    if directive and "code" not in kind:
        return f"\n{_of_markdown(body)}"
    return _blank(body) + "\n"


def _of_html(text: str) -> str:
    plain = html.unescape(_HTML.sub(_html_piece, text))
    return _SHOWN.sub(_math, plain)


def _html_piece(found: re.Match[str]) -> str:
    told = found.groupdict()
    if told["comment"] is not None:
        return _comment(told["comment"])
    if told["tex"]:
        return rf"\[{told['tex']}\]" if "display" in told["mode"] else rf"\({told['tex']}\)"
    return _blank(found[0])


def _of_rst(text: str) -> str:
    return _RST.sub(_rst_piece, text)


def _rst_piece(found: re.Match[str]) -> str:
    told = found.groupdict()
    if told["kind"] == "math::":
        return _display(told["rest"] + told["body"])
    if told["kind"] == "rbpsym:":
        return _noted(told["rest"] + told["body"])
    if told["inline"]:
        return rf"\({told['inline']}\)"
    return "\\" + told["sign"] if told["sign"] else _blank(found[0])


def _of_notebook(text: str, file: str) -> Lines:
    """The Markdown cells of a notebook; a line has the number that it has in the file."""
    try:
        cells = json.loads(text)["cells"]
        sources = [cell["source"] for cell in cells if cell["cell_type"] == "markdown"]
    except (ValueError, KeyError, TypeError, RecursionError):
        raise ReadError("this is no notebook", instead="save it as .ipynb of version 4.", place=Place(file)) from None
    found: Lines = []
    place = 0
    for source in sources:
        parts = source if isinstance(source, list) else [source]
        for part in filter(lambda part: isinstance(part, str), parts):
            place = max(text.find(json.dumps(part, ensure_ascii=False), place), place)
            number = text.count("\n", 0, place) + 1
            found += [(number, line) for line in part.removesuffix("\n").split("\n")]
        found.append((text.count("\n", 0, place) + 1, ""))
    whole = _of_markdown("\n".join(line for _, line in found)).split("\n")
    return [(number, line) for (number, _), line in zip(found, whole, strict=True)]


FORMATS: Mapping[str, Callable[[str], str]] = {
    **dict.fromkeys((".md", ".markdown", ".myst"), _of_markdown),
    **dict.fromkeys((".html", ".htm"), _of_html),
    ".rst": _of_rst,
}
NOTEBOOK = ".ipynb"
LATEX = (".tex", ".ltx", ".txt", ".latex")
TEXTS = (*LATEX, *FORMATS, NOTEBOOK)  # the endings of the names of papers


def lines_of(text: str, file: str, ending: str) -> Lines:
    """The lines of a text as LaTeX. Raises ReadError for a notebook that is none."""
    if ending == NOTEBOOK:
        return _of_notebook(text, file)
    plain = text.replace(NOTE, "").replace(NOTE_END, "")
    return list(enumerate(FORMATS.get(ending, str)(plain).split("\n"), 1))

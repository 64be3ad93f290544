"""The macros of a paper: found where they are defined, and put in where they are used."""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping
from contextlib import suppress
from itertools import takewhile

from rbpsym.errors import LimitError, RbpsymError, ReadError
from rbpsym.expr.letters import LETTERS
from rbpsym.expr.source import behind_brace
from rbpsym.frozen import Frozen

MOST_EXPANSIONS, LONGEST, DEEPEST = 2000, 20_000, 40
MOST_FAULTS = 20  # definitions that are never closed
LET, NAMES = 7, (1, 2, 5, 7, 10, 12)  # the group of _HEAD that holds what is let be another, and those that hold a name
COUNTERS = (r"\theequation",)  # left where they stand: numbers of equations depend on the place
_HEAD = re.compile(
    r"\\(?:(?:re)?new|provide)command\*?\s*+(?:\{\s*+(\\[A-Za-z]++)\s*+\}|(\\[A-Za-z]++))\s*+(?:\[(\d)\])?\s*+(?:\[([^\[\]]{0,999}+)\])?\s*+(?=\{)"
    r"|\\(?:New|Renew|Provide|Declare)(?:Expandable)?DocumentCommand\s*+\{?\s*+(\\[A-Za-z]++)\s*+\}?\s*+\{([\smoO{}]{0,99})\}\s*+(?=\{)"
    r"|\\let\s*+(\\[A-Za-z]++)\s*+=?\s*+(\\[A-Za-z]++)()"
    r"|\\(?:long\s*+\\)?def\s*+(\\[A-Za-z]++)(\((?:#\d,?)++\)|(?:#\d)*+)\s*+(?=\{)"
    r"|\\DeclareMathOperator\*?\s*+\{\s*+(\\[A-Za-z]++)\s*+\}\s*+(?=\{)"
)
_NAMED = re.compile(r"\\?[a-z]+\s*:(?!=)")  # fill: red, which only says how it looks
_COMMAND = re.compile(r"\\[A-Za-z]+")
_UPRIGHT = re.compile(r"\\(?:text|math)(?:rm)?\s*\{([^{}]*)\}")
_DROPPED = re.compile(r"\\(?:ensuremath|xspace|protect|mathstrut|relax)(?![A-Za-z])")


class Macro(Frozen):
    """The body of a macro with #1 ... #count, the first of which may have a default; `called`: they stand in parentheses."""

    body: str
    count: int = 0
    default: str | None = None
    called: bool = False


def definitions(text: str) -> tuple[dict[str, Macro], str, list[tuple[int, str]]]:
    """(macros by command, the text with the definitions blanked out, where a definition is never closed: it is left out)."""
    found: dict[str, Macro] = {}
    faults: list[tuple[int, str]] = []
    position, pieces = 0, list[str]()
    while (head := _HEAD.search(text, position)) is not None:
        name = next(filter(None, (head[place] for place in NAMES)))
        try:
            end = head.end() if head[LET] else closing(text, head.end(), LONGEST)
        except ReadError as error:
            faults.append((head.start(), f"the definition of {name} is left out: {error.what}"))
            pieces, position = [*pieces, text[position : head.end()]], head.end()
            if len(faults) >= MOST_FAULTS:
                break
            continue
        if name in COUNTERS:
            pieces, position = [*pieces, text[position:end]], end
            continue
        macro = _macro(head, text[head.end() + 1 : end - 1])
        if not any(found[own].body == name for own in _COMMAND.findall(macro.body) if own in found):  # by \\let
            found[name] = macro
        pieces += [text[position : head.start()], re.sub(r"[^\n]", " ", text[head.start() : end])]
        position = end
    return found, "".join([*pieces, text[position:]]), faults


def _macro(head: re.Match[str], body: str) -> Macro:
    _, _, count, default, document, arguments, let, same, _, by_def, parameters, operator = head.groups()
    if let:
        return Macro(same)
    if document:
        first = re.match(r"\s*+[oO]\s*+(?:\{([^{}]*)\})?", arguments)
        return Macro(body, len(re.findall(r"[moO]", re.sub(r"\{[^{}]*\}", "", arguments))), first and (first[1] or ""))
    if operator:
        return Macro(r"\operatorname{" + _UPRIGHT.sub(r"\1", body) + "}")
    if by_def:
        return Macro(body, parameters.count("#"), called=parameters.startswith("("))
    return Macro(body, int(count or 0), default)


_SITE = re.compile(r"""(?:^|[{,\s])r?(["']?)(\\{0,2}[A-Za-z]+)\1\s*+:\s*+(?:\[\s*+)?(r?)(["'])((?:(?!\4)[^\\\n]|\\.)*+)\4""")


def site_macros(text: str) -> str:
    r"""The macros that the settings of a site give to MathJax or KaTeX, `"name": ["body", 1]`, as \newcommand."""
    block = re.search(r"macros[\"']?\s*[:=]|^[ \t]*+math:", text, re.M)
    found = _SITE.findall(text, block.end() if block else len(text))
    bodies = ((name.strip("\\"), body if raw else body.replace("\\\\", "\\")) for _, name, raw, _, body in found)
    counted = ((name, max(re.findall(r"#(\d)", body), default="0"), body) for name, body in bodies)
    return "\n".join(rf"\newcommand{{\{name}}}[{count}]{{{body}}}" for name, count, body in counted)


def closing(text: str, start: int, most: int = sys.maxsize) -> int:
    """The offset behind the brace that closes the one at `start`. Raises ReadError if none does (so soon)."""
    if end := behind_brace(text, start, most):
        return end
    raise ReadError("a brace is never closed")


_OWN = {  # in displays, the first; and brackets that grow
    r"\mathchoice": Macro("#1", 4), r"\del": Macro(r"\left(#1\right)", 1), r"\sbr": Macro(r"\left[#1\right]", 1),
}  # fmt: skip
_LOOKS = (r"\vec", r"\hat", r"\bar", r"\tilde", r"\dot", r"\ddot")  # defined anew, they look otherwise and mean the same


def _only_looks(name: str, macro: Macro) -> bool:
    r"""Does it but change how a mark, or a letter, is drawn: \\let\\epsilon\\varepsilon?"""
    letter = name.removeprefix("\\").removeprefix("var") in LETTERS
    return name in _LOOKS or (letter and bool(_COMMAND.fullmatch(macro.body.strip())))


def expanded(latex: str, macros: Mapping[str, Macro]) -> str:
    """The formula with all macros put in. Raises LimitError for what does not end."""
    macros = {**_OWN, **{name: macro for name, macro in macros.items() if not _only_looks(name, macro)}}
    for _ in range(DEEPEST):
        latex, count = _once(_DROPPED.sub(" ", latex), macros)
        if not count:
            return latex
        if len(latex) > LONGEST:
            break
    raise LimitError("the macros of this formula do not come to an end", instead="a macro must not hold itself.")


def _alike(one: str, other: str) -> int:
    """How many characters two texts begin with alike."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(one, other, strict=False)))


def changed(old: str, new: str) -> tuple[int, str, str]:
    """Where two texts differ: from where on, and what stands there in each."""
    begin = _alike(old, new)
    end = _alike(old[begin:][::-1], new[begin:][::-1])
    return begin, old[begin : len(old) - end], new[begin : len(new) - end]


def unexpanded(latex: str, fix: str, macros: Mapping[str, Macro]) -> str:
    """The formula as the author wrote it with the one change that leads to `fix` when its macros are put in; else `fix`."""
    _, old, new = changed(expanded(latex, macros).strip(), fix.strip())
    wanted = "".join(fix.split())
    begin = len(latex) - len(latex.lstrip())
    spots = ((place, old, new) for place in range(begin, len(latex) + 1) if latex.startswith(old, place))
    bodies = ((one.start(), one[0], _filled(macros[one[0]], [])) for one in _COMMAND.finditer(latex) if one[0] in macros)
    inside = ((place, name, body.lstrip().replace(old, new, 1)) for place, name, body in bodies if old in body)
    for place, part, other in (*spots, *inside):
        behind, inner = latex[place + len(part) :], part[:1] == "\\" and other[:1].isalpha()
        gap = " " * (inner and bool(re.search(r"\\[A-Za-z]+$", latex[:place])))  # \alpha\half is no \alpham
        found = f"{latex[:place]}{gap}{other if behind[:1].isalpha() else other.rstrip() or other}{behind}"
        with suppress(RbpsymError):
            if "".join(expanded(found, macros).split()) == wanted:
                return found
    return fix


def _once(latex: str, macros: Mapping[str, Macro]) -> tuple[str, int]:
    """One pass over the formula: every macro replaced by its body."""
    pieces, position, count = [], 0, 0
    for found in _COMMAND.finditer(latex):
        macro = macros.get(found[0])
        if macro is None or found.start() < position:
            continue
        arguments, end = _arguments(latex, found.end(), macro)
        pieces += [latex[position : found.start()], _filled(macro, arguments)]
        position, count = end, count + 1
        if count > MOST_EXPANSIONS:
            raise LimitError(f"more than {MOST_EXPANSIONS} macros in one formula")
    return "".join([*pieces, latex[position:]]), count


def _filled(macro: Macro, arguments: list[str]) -> str:
    """The body with its arguments; a blank keeps a command and a letter apart."""
    body = re.sub(r"(\\[A-Za-z]+)(#\d)(?!\d)", lambda f: f"{f[1]} {f[2]}", macro.body)
    body = re.sub(r"#(\d)", lambda f: arguments[int(f[1]) - 1] if int(f[1]) <= len(arguments) else f[0], body)
    return f"{body} " if body[-1:].isalpha() else body


def _arguments(latex: str, position: int, macro: Macro) -> tuple[list[str], int]:
    found: list[str] = []
    if macro.called:
        return _in_parentheses(latex, _behind_blanks(latex, position), macro.count)
    for place in range(macro.count):
        blank = _behind_blanks(latex, position)
        if place == 0 and macro.default is not None:
            value, position = _optional(latex, blank, macro.default)
        else:
            value, position = _required(latex, blank)
        found.append(value)
    return found, position


def _behind_blanks(latex: str, position: int) -> int:
    return position + len(latex[position:]) - len(latex[position:].lstrip())


def _in_parentheses(latex: str, start: int, count: int) -> tuple[list[str], int]:
    """The arguments of a call, f(x, y), and where it ends."""
    depth, begin, found = 0, start + 1, []
    for one in re.compile(r"\\.|[(){}\[\],]").finditer(latex, start):
        depth += (one[0] in "({[") - (one[0] in ")}]")
        if depth == 0 or (depth == 1 and one[0] == ","):
            found.append(latex[begin : one.start()].strip())
            begin = one.end()
        if depth == 0:
            break
    found = [one for one in found if not _NAMED.match(one)]
    if latex[start : start + 1] != "(" or depth or len(found) != count:
        raise ReadError(f"a macro is called with {count} argument{'s' * (count != 1)} in parentheses")
    return found, begin


def _optional(latex: str, position: int, default: str) -> tuple[str, int]:
    end = latex.find("]", position) if latex[position : position + 1] == "[" else -1
    return (latex[position + 1 : end], end + 1) if end > 0 else (default, position)


def _required(latex: str, position: int) -> tuple[str, int]:
    if position >= len(latex):
        raise ReadError("a macro has too few arguments here")
    if latex[position] == "{":
        end = closing(latex, position)
        return latex[position + 1 : end - 1], end
    command = _COMMAND.match(latex, position)
    end = command.end() if command else position + 1
    return latex[position:end], end

"""A paper as text: what its files hold, in their order, and its macros written out."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError
from rbpsym.statement.files import text_in

MAX_BYTES = 4 * 1024 * 1024
MAX_LINE = 200_000
MAX_FILES = 100
_INPUT = re.compile(r"\\(?:input|include)(?![A-Za-z])\s*(?:\{([^{}\n]*)\}|([\w./-]+))")
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%.*")
_VERBATIM = re.compile(r"\\begin\{(verbatim\*?|comment|lstlisting)\}.*?\\end\{\1\}|\\verb\*?([^A-Za-z\s*]).*?\2", re.S)


@dataclass(frozen=True, slots=True)
class Text:
    """A text; `starts` and `origins` tell from which offset on it is which line of which file."""

    text: str
    starts: tuple[int, ...]
    origins: tuple[tuple[str, int], ...]

    def origin(self, offset: int) -> tuple[str, int]:
        """(file, line) of a character."""
        place = bisect_right(self.starts, offset) - 1
        return self.origins[max(place, 0)] if self.origins else ("", 1)

    def place(self, offset: int) -> Place:
        """The place of a character, for an error."""
        file, line = self.origin(offset)
        start = self.text.rfind("\n", 0, offset) + 1
        shown = self.text[start:].split("\n", 1)[0][:200]
        column = offset - start + 1
        return Place(file, line, column, shown if column <= 200 else "")


def read_source(path: Path) -> Text:
    """The text of a file. Raises ReadError or LimitError with the place of what can't be read."""
    lines = list(_lines(path, path.resolve().parent, (), [0]))
    starts, offset = [], 0
    for text, _, _ in lines:
        starts.append(offset)
        offset += len(text) + 1
    whole = "\n".join(text for text, _, _ in lines)
    whole = _VERBATIM.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), whole)
    return Text(whole, tuple(starts), tuple((file, number) for _, file, number in lines))


def _lines(path: Path, folder: Path, around: tuple[Path, ...], size: list[int]):
    """(text, file, number) of each line, inputs put in; `size` counts the bytes of all files."""
    for number, raw in enumerate(_content(path, size).split("\n"), 1):
        if len(raw) > MAX_LINE:
            raise LimitError(f"a line of more than {MAX_LINE} characters", place=Place(str(path), number))
        line = _COMMENT.sub(r"\1", raw)
        begin = 0
        for found in _INPUT.finditer(line):
            yield line[begin : found.start()], str(path), number
            inner = _beside(found, path, folder, number, around)
            yield from _lines(inner, folder, (*around, path.resolve()), size)
            begin = found.end()
        yield line[begin:], str(path), number


def _content(path: Path, size: list[int]) -> str:
    text = text_in(path, MAX_BYTES - size[0], "the text")
    size[0] += len(text)
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _beside(found: re.Match[str], path: Path, folder: Path, line: int, around: tuple[Path, ...]) -> Path:
    r"""The file of an \input, which must be in the folder of the text or below it."""
    name = (found[1] if found[1] is not None else found[2]).strip()
    place = Place(str(path), line, found.start() + 1)
    try:
        target = _existing(folder, name)
    except (OSError, ValueError):
        raise ReadError(f"“{name[:60]}” is no name of a file", place=place) from None
    _check_inside(target, folder, name, place)
    if target in around or target == path.resolve():
        raise ReadError(f"“{name}” inputs itself", place=place)
    if len(around) >= MAX_FILES:
        raise LimitError(f"more than {MAX_FILES} files are nested", place=place)
    if not target.is_file():
        raise ReadError(f"there is no file “{name}” beside the text", place=place)
    return target


def _existing(folder: Path, name: str) -> Path:
    plain, tex = folder / name, folder / f"{name}.tex"
    return (plain if plain.is_file() else tex).resolve()


def _check_inside(target: Path, folder: Path, name: str, place: Place) -> None:
    if not target.is_relative_to(folder):
        raise ReadError(
            f"“{name[:60]}” is outside the folder of the text", instead="only files beside it are read.", place=place
        )


def told_at(error: RbpsymError, text: Text, offset: int) -> RbpsymError:
    """The error of a reader of a formula, told in the file's line."""
    file, line = text.origin(offset)
    inner = error.place or Place(column=1)
    below = max(inner.line, 1) - 1
    return type(error)(
        error.what, instead=error.instead, place=Place(file, line + below, inner.column, inner.text, inner.width)
    )


MOST_EXPANSIONS, LONGEST, DEEPEST = 2000, 20_000, 40
COUNTERS = (r"\theequation",)  # left where they stand: numbers of equations depend on the place
_HEAD = re.compile(
    r"\\(?:re|provide)?newcommand\*?\s*(?:\{\s*(\\[A-Za-z]+)\s*\}|(\\[A-Za-z]+))\s*(?:\[(\d)\])?\s*(?:\[([^\[\]]*)\])?\s*(?=\{)"
    r"|\\providecommand\*?\s*\{?\s*(\\[A-Za-z]+)\s*\}?\s*(?:\[(\d)\])?\s*(?=\{)"
    r"|\\(?:long\s*\\)?def\s*(\\[A-Za-z]+)((?:#\d)*)\s*(?=\{)"
    r"|\\DeclareMathOperator\*?\s*\{\s*(\\[A-Za-z]+)\s*\}\s*(?=\{)"
)
_COMMAND = re.compile(r"\\[A-Za-z]+")
_DROPPED = re.compile(r"\\(?:ensuremath|xspace|protect|mathstrut|relax|boxed)(?![A-Za-z])")


@dataclass(frozen=True, slots=True)
class Macro:
    """The body of a macro with #1 ... #count, the first of which may have a default."""

    body: str
    count: int = 0
    default: str | None = None


def definitions(text: str) -> tuple[dict[str, Macro], str]:
    """(macros by command, the text with the definitions blanked out)."""
    found: dict[str, Macro] = {}
    position, pieces = 0, []
    while (head := _HEAD.search(text, position)) is not None:
        end = closing(text, head.end())
        name, macro = _macro(head, text[head.end() + 1 : end - 1])
        if name in COUNTERS:
            pieces, position = [*pieces, text[position:end]], end
            continue
        found[name] = macro
        pieces += [text[position : head.start()], re.sub(r"[^\n]", " ", text[head.start() : end])]
        position = end
    return found, "".join([*pieces, text[position:]])


def _macro(head: re.Match[str], body: str) -> tuple[str, Macro]:
    braced, plain, count, default, provided, provided_count, by_def, parameters, operator = head.groups()
    if operator:
        return operator, Macro(rf"\operatorname{{{body}}}")
    if by_def:
        return by_def, Macro(body, parameters.count("#"))
    return braced or plain or provided, Macro(body, int(count or provided_count or 0), default)


def closing(text: str, start: int) -> int:
    """The offset behind the brace that closes the one at `start`. Raises ReadError if none does."""
    depth, position = 0, start
    while position < len(text):
        char = text[position]
        if char == "\\":
            position += 2
            continue
        depth += (char == "{") - (char == "}")
        position += 1
        if depth == 0:
            return position
    raise ReadError("a brace is never closed")


def expanded(latex: str, macros: Mapping[str, Macro]) -> str:
    """The formula with all macros put in. Raises LimitError for what does not end."""
    latex = _DROPPED.sub(" ", latex)
    for _ in range(DEEPEST):
        latex, count = _once(latex, macros)
        if not count:
            return latex
        if len(latex) > LONGEST:
            break
    raise LimitError("the macros of this formula do not come to an end", instead="a macro must not hold itself.")


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
    body = re.sub(r"#(\d)", lambda f: arguments[int(f[1]) - 1] if int(f[1]) <= len(arguments) else f[0], macro.body)
    return f"{body} " if body[-1:].isalpha() else body


def _arguments(latex: str, position: int, macro: Macro) -> tuple[list[str], int]:
    found: list[str] = []
    for place in range(macro.count):
        blank = re.compile(r"\s*").match(latex, position).end()
        if place == 0 and macro.default is not None:
            value, position = _optional(latex, blank, macro.default)
        else:
            value, position = _required(latex, blank)
        found.append(value)
    return found, position


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

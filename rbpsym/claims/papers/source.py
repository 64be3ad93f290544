"""A paper as text: what its files hold, in their order, and what their comments say to us."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from rbpsym.claims.papers.formats import LATEX, lines_of
from rbpsym.claims.papers.macros import site_macros
from rbpsym.claims.papers.marks import NOTE, NOTE_END
from rbpsym.errors import LimitError, Place, RbpsymError
from rbpsym.frozen import Frozen
from rbpsym.statement.library import latin_or_utf8_in

SITES = ("conf.py", "_config.yml", "myst.yml", "_quarto.yml", "mathjax-config.js")  # where the macros of a site may be said
_TEX = re.compile(r"""["']([\w./-]{1,200}\.tex)["']""")
_SCRIPT = re.compile(r"""<script[^>]{0,200}?\ssrc=["']([\w./-]{1,200}\.js)["']""")
MAX_BYTES = 4 * 1024 * 1024
MAX_LINE = 200_000
MAX_FILES = 100
MAX_HEAD = 200_000  # bytes in which a document says what its chapters are
_CLASS, _BEGIN = r"\documentclass", r"\begin{document}"
_INPUT = re.compile(
    r"\\(?:(?:sub)?(?:import|includefrom|inputfrom)\*?\s*+\{(?P<folder>[^{}\n]*+)\}\s*+\{(?P<part>[^{}\n]*+)\}"
    r"|(?:input|include|subfile|subfileinclude)(?![A-Za-z])\s*+(?:\{(?P<name>[^{}\n]*+)\}|(?P<word>[\w./-]++)))"
)
_HEAD_INPUT = re.compile(r"\\input(?![A-Za-z])\s*+(?:\{([\w./-]++)\}|([\w./-]++))")
_PACKAGE = re.compile(r"\\(?:usepackage|RequirePackage|documentclass|LoadClass)\s*+(?:\[[^\]]{0,999}+\]\s*+)?\{([^{}\n]*+)\}")
_IMPORT = re.compile(r"\\usepackage\{([^{}\n]+\.typ)\}")
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*+)%(?:[ \t]*rbpsym:(.*)|.*)")
_NOTE = re.compile(f"{NOTE}(.*?){NOTE_END}")
_VERBATIM = re.compile(
    r"\\begin\{(verbatim\*?|comment|lstlisting)\}(?:[^\\]++|\\(?!begin\{\1\}|end\{\1\}))*+\\end\{\1\}|\\verb\*?([^A-Za-z\s*])[^\n]{0,500}?\2"
)
COMMENTED = "\f"  # a line that is a comment is white, and ends no paragraph
Remark = tuple[str, int, str]  # file, line, what is to be said


class Note(Frozen):
    """What a comment of a text says to us, and from where on it is said."""

    said: str
    offset: int
    place: Place


class PaperText(Frozen):
    """A text; `starts` and `origins` tell from which offset on it is which line of which file.

    packages: what its own packages hold, which lie beside it: their macros are those of the text.
    """

    text: str
    starts: tuple[int, ...]
    origins: tuple[tuple[str, int], ...]
    notes: tuple[Note, ...] = ()
    remarks: tuple[Remark, ...] = ()
    packages: str = ""

    def origin(self, offset: int) -> tuple[str, int]:
        """(file, line) of a character."""
        place = bisect_right(self.starts, offset) - 1
        return self.origins[max(place, 0)] if self.origins else ("", 1)

    def offset(self, line: int) -> int:
        """Where a line of the first file begins."""
        first = self.origins[0][0] if self.origins else ""
        lines = zip(self.starts, self.origins, strict=True)
        return next((start for start, origin in lines if origin[0] == first and origin[1] >= line), len(self.text))

    def place(self, offset: int) -> Place:
        """The place of a character, for an error."""
        file, line = self.origin(offset)
        start = self.text.rfind("\n", 0, offset) + 1
        shown = self.text[start:].split("\n", 1)[0][:200]
        column = offset - start + 1
        return Place(file, line, column, shown if column <= 200 else "")


def read_source(path: Path) -> PaperText:
    """The text of a file. Raises ReadError or LimitError with the place of what can't be read."""
    files = _Files(path.resolve().parent, path.parent)
    lines = list(files.lines(path, ()))
    starts, offset, notes = [], 0, []
    for line in lines:
        starts.append(offset)
        notes += [Note(said.strip(), offset, Place(line.file, line.number)) for said in line.notes]
        offset += len(line.text) + 1
    whole = "\n".join(line.text for line in lines)
    hidden = [found.span() for found in _VERBATIM.finditer(whole)]
    notes = [note for note in notes if not any(begin <= note.offset < end for begin, end in hidden)]
    whole = _VERBATIM.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), whole)
    origins = tuple((line.file, line.number) for line in lines)
    return PaperText(whole, tuple(starts), origins, tuple(notes), tuple(files.remarks), files.packages(path, whole))


class _Line(Frozen):
    """A line of a file as LaTeX, and what it says to us."""

    text: str
    file: str
    number: int
    notes: tuple[str, ...] = ()


def files_above(folder: Path, names: Iterable[str]) -> list[Path]:
    """The files of these names (or patterns) beside a text, and above it up to the folder of the run: the nearest last."""
    folder = folder.resolve()
    above = [one for one in folder.parents if one.is_relative_to(run_of(folder))]
    found = (one for place in (*reversed(above), folder) for name in names for one in sorted(place.glob(name)))
    return [one for one in found if is_inside(one, one.parent)]


def run_of(folder: Path) -> Path:
    """The folder of the run, if the folder is below it; else the folder itself."""
    return Path.cwd() if folder.is_relative_to(Path.cwd()) else folder


def is_inside(path: Path, folder: Path) -> bool:
    """Is it a file in the folder or below it?"""
    return path.is_file() and path.resolve().is_relative_to(folder.resolve())


class _Files:
    """The files of a text, read one within the other: all in one folder, and of bounded size together."""

    def __init__(self, folder: Path, given: Path) -> None:
        self.folder, self.given, self.size = folder, given, 0
        self.remarks: list[Remark] = []
        self.read: dict[Path, str] = {}
        self.imported: list[Path] = []  # by Typst: what they define is meant

    def lines(self, path: Path, around: tuple[Path, ...]) -> Iterator[_Line]:
        """The lines of a file, inputs put in."""
        ending, file = path.suffix.lower(), str(path)
        for number, raw in lines_of(self._content(path), file, ending):
            if len(raw) > MAX_LINE:
                raise LimitError(f"a line of more than {MAX_LINE} characters", place=Place(str(path), number))
            said, line, begin = tuple[str, ...](), raw, 0
            if NOTE in raw:
                said, line = tuple(note[1] for note in _NOTE.finditer(raw)), _NOTE.sub("", raw)
            if "%" in line:
                comment = _COMMENT.search(line)
                said += (comment[2],) if comment and comment[2] else ()
                line = _COMMENT.sub(r"\1", line)
            line = line if line.strip() or not raw.strip() else COMMENTED
            if ending == ".typ":
                root = run_of(self.folder)
                self.imported += [(root if name[0] == "/" else path.parent) / name.lstrip("/") for name in _IMPORT.findall(line)]
            for found in _INPUT.finditer(line) if "\\" in line else ():
                yield _Line(line[begin : found.start()], file, number, said)
                said = ()
                if (target := self._followed(found, path, number, around)) is not None:
                    yield from self.lines(target, (*around, path.resolve()))
                begin = found.end()
            yield _Line(line[begin:], file, number, said)

    def packages(self, path: Path, text: str) -> str:
        """What the packages and classes hold that lie in the folder of the text, and those that they ask for.

        So do the settings of a site, what Typst imports, and the head of the document that a chapter belongs to.
        """
        found: dict[Path, str] = {}
        waiting = [(path.parent, text)]
        for one in (*files_above(path.parent, SITES), *self._scripts(path)):
            said = self._content(one)
            found[one] = site_macros(said) + (said.replace("\\\\", "\\") if one.suffix == ".js" else "")
            named = (one.parent / name for name in _TEX.findall(said))
            found |= {other: self._definitions(other) for other in named if is_inside(other, one.parent)}
        for whole in self._wholes(path, text):
            found[whole] = self._definitions(whole).partition(_BEGIN)[0]
            put_in = (whole.parent / f"{name[1] or name[2]}.tex" for name in _HEAD_INPUT.finditer(found[whole]))
            found |= {one: self._definitions(one) for one in put_in if is_inside(one, whole.parent)}
            waiting.append((whole.parent, found[whole]))
        while self.imported and len(found) < MAX_FILES:
            one = self.imported.pop()
            if one not in found and is_inside(one, run_of(self.folder)):
                found[one] = ""
                found[one] = "\n".join(line.text for line in self.lines(one, ()))
        while waiting and len(found) < MAX_FILES:
            beside, told = waiting.pop()
            names = [name.strip() for group in _PACKAGE.findall(told) for name in group.split(",")]
            for one in (beside / f"{name}{end}" for name in names for end in (".sty", ".cls", "")):
                if one not in found and is_inside(one, run_of(beside.resolve())):
                    found[one] = self._definitions(one)
                    waiting.append((beside, found[one]))
        return "\n".join(found.values())

    def _scripts(self, path: Path) -> list[Path]:
        """A page and the scripts beside it that it loads, in which macros may be said."""
        named = _SCRIPT.findall(self._content(path)) if path.suffix.lower() in (".html", ".htm") else None
        return [] if named is None else [path, *(one for name in named if is_inside(one := path.parent / name, self.folder))]

    def _wholes(self, path: Path, text: str, below: tuple[Path, ...] = ()) -> list[Path]:
        """The document beside a chapter or above it that puts the chapter in, or a chapter that does."""
        if path.suffix.lower() not in LATEX or _CLASS in text:
            return []
        named = re.compile(rf"\\(?:input|include|subfile|import)[^\n]*?(?<![\w-]){re.escape(path.stem)}(?:\.tex)?\s*\}}")
        near = [one for one in files_above(path.parent, ("*.tex",)) if one.resolve() != path.resolve()][-MAX_FILES:]
        heads = ((one, one.read_bytes()[:MAX_HEAD].decode("utf-8", "replace")) for one in near)
        naming = [(one, said) for one, said in heads if named.search(said) and one not in below]
        wholes = [one for one, said in naming if _CLASS in said] or [
            found for one, said in naming for found in self._wholes(one, said, (*below, path))
        ]  # fmt: skip
        return wholes[-1:]

    def _definitions(self, path: Path) -> str:
        return "\n".join(_COMMENT.sub(r"\1", line) for line in self._content(path).split("\n"))

    def _content(self, path: Path) -> str:
        if path in self.read:
            return self.read[path]
        text, is_utf8 = latin_or_utf8_in(path, MAX_BYTES - self.size, "the text")
        if not is_utf8:
            self.remarks.append((str(path), 1, "this file is not UTF-8; it was read as Latin-1"))
        self.size += len(text)
        self.read[path] = text.replace("\r\n", "\n").replace("\r", "\n")
        return self.read[path]

    def _followed(self, found: re.Match[str], path: Path, line: int, around: tuple[Path, ...]) -> Path | None:
        r"""The file of an \\input, which must be in the folder of the text or below it. One that can't be read is told."""
        name, place = (found["part"] or found["name"] or found["word"] or "").strip(), Place(str(path), line, found.start() + 1)
        if len(around) >= MAX_FILES:
            raise LimitError(f"more than {MAX_FILES} files are nested", place=place)
        what = f"“{name[:60]}” is no name of a file"
        with suppress(OSError, ValueError):
            target = self._existing(path.parent, (found["folder"] or "").strip(), name, place)
            if not target.is_relative_to(self.folder):
                what = f"“{name[:60]}” is outside the folder of the text"
            elif target in around or target == path.resolve():
                what = f"“{name}” inputs itself"
            elif target.is_file():
                return self.given / target.relative_to(self.folder)
            else:
                what = f"there is no file “{name}” beside the text"
        self.remarks.append((str(path), line, f"not read: {what}"))
        return None

    def _existing(self, beside: Path, below: str, name: str, place: Place) -> Path:
        """The file of this name, beside the text or the file that names it; small letters may stand for large ones."""
        endings = [path.suffix for path in [Path(place.file)] if path.suffix not in ("", ".tex")]
        above = [one for one in self.folder.parents if one.is_relative_to(run_of(self.folder))]  # a chapter of a document there
        tried = [(one / below / f"{name}{end}") for one in (self.folder, beside, *above) for end in ("", ".tex", *endings)]
        found = next((one.resolve() for one in tried if one.is_file()), None)
        for one in tried if found is None else ():
            inside = one.parent.resolve().is_relative_to(self.folder) and one.parent.is_dir()
            alike = [other for other in one.parent.iterdir() if other.name.lower() == one.name.lower()] if inside else []
            if alike:
                self.remarks.append((place.file, place.line, f"“{name}” is the file {alike[0].name}, in other letters"))
                return alike[0].resolve()
        return found or tried[1].resolve()


def told_at(error: RbpsymError, text: PaperText, offset: int) -> RbpsymError:
    """The error of a reader of a formula, told in the file's line."""
    file, line = text.origin(offset)
    inner = error.place or Place(column=1)
    below = max(inner.line, 1) - 1
    return type(error)(error.what, instead=error.instead, place=Place(file, line + below, inner.column, inner.text, inner.width))

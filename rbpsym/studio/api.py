"""What the page of the studio asks the engine: one JSON text in, one JSON text out (`call`), by the table `OPERATIONS`.

A request is {"do": NAME, ...}; the keys of each operation and of its answer are told by `schema`. An answer is {"ok": …}, or
{"error": {what, instead, line, column, width, text, told}}, `told` as the command line prints it.
"""

from __future__ import annotations

import inspect
import json
import tomllib
from base64 import b64encode
from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile

from rbpsym.errors import RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import Scalar
from rbpsym.languages import title_in
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.step import Derivation
from rbpsym.statement.library import library_folder, problem_files
from rbpsym.studio.kept import FILE, derived, problem_of, study
from rbpsym.typeset.mathml import to_mathml

FORMATS = ("html", "tex", "md", "ipynb", "typ")  # of notes; PDF where Typst is installed
SHEETS = ("html", "tex", "typ", "moodle", "qti", "canvas", "prairielearn", "gift")
DETAILS = ("brief", "standard", "full")
Answer = Mapping[str, Any]
GLANCE = 90  # nodes of a formula
NONE: list[str] = []


@lru_cache(maxsize=16)
def call(request: str) -> str:
    """The answer to one request, both JSON. No input of a user raises an error."""
    try:
        told = _read(request)
        return json.dumps({"ok": OPERATIONS[told.pop("do")](**told)}, ensure_ascii=False)
    except RbpsymError as error:
        return json.dumps({"error": told_error(error)}, ensure_ascii=False)


def _read(request: str) -> dict[str, Any]:
    """The request, its operation and keys known. Raises ReadError."""
    try:
        told = json.loads(request)
    except ValueError:
        told = None
    if not isinstance(told, dict) or told.get("do") not in OPERATIONS:
        raise ReadError("this is no request", instead=f'send {{"do": NAME, …}}; names: {", ".join(OPERATIONS)}.')
    keys = inspect.signature(OPERATIONS[told["do"]]).parameters
    needed = [key for key, one in keys.items() if one.default is one.empty]
    wrong = [key for key in (*needed, *told) if key not in told or key not in (*keys, "do")]
    wrong += [key for key, one in keys.items() if key in told and not _is(told[key], one.annotation)]
    if wrong:
        what = f"“{wrong[0]}” is missing, unknown or of another kind in “{told['do']}”"
        raise ReadError(what, instead=f"it takes {inspect.signature(OPERATIONS[told['do']])}.")
    return told


def _is(value: object, kind: str) -> bool:
    """Whether a value of JSON is of a kind: “str”, “int”, or “list[str]”, a list of nothing else."""
    whole, _, of = kind.removesuffix("]").partition("[")
    return type(value).__name__ == whole and (not isinstance(value, list) or all(_is(one, of) for one in value))


def told_error(error: RbpsymError) -> Answer:
    """An error as keys: what is wrong, what to write instead, where (from 1; 0 unknown), all of it as in the terminal."""
    place = error.place
    where = {key: getattr(place, key) if place else 0 for key in ("line", "column", "width")}
    return {"what": error.what, "instead": error.instead, **where, "text": place.text if place else "", "told": str(error)}


def schema() -> Answer:
    """The operations: their keys with kinds and defaults, and what they answer."""
    return {
        name: {
            "takes": {key: {"kind": one.annotation, **({} if one.default is one.empty else {"default": one.default})}
                      for key, one in inspect.signature(function).parameters.items()},
            "answers": inspect.getdoc(function) or "",
        }
        for name, function in OPERATIONS.items()
    }  # fmt: skip


# --- operations


def gallery(language: str = "en") -> list[Answer]:
    """[{name, title, topic, level}] of the problems that ship, by topic."""
    found = [_card(name, path, language) for name, path in problem_files().items()]
    return sorted(found, key=lambda card: (card["topic"], card["title"]))


def _card(name: str, path: Path, language: str) -> Answer:
    head = tomllib.loads(path.read_text(encoding="utf-8"))
    words = {key: head.get(key, "") for key in ("title", "topic", "level")}
    told = {key: title_in(text if isinstance(text, dict) else {"en": text}, language) for key, text in words.items()}
    return {"name": name, **told, "topic": told["topic"] or path.parent.relative_to(library_folder()).name}


def statement(name: str) -> Answer:
    """{text}: the file of a problem that ships."""
    if name not in problem_files():
        raise ReadError(f"there is no problem “{name}”", instead="“gallery” names those that ship.")
    return {"text": problem_files()[name].read_text(encoding="utf-8")}


def notes(text: str, language: str = "en", detail: str = "standard") -> Answer:
    """{title, html, summary}: the notes as a page, how many steps are proved, and by what roads."""
    from rbpsym.document.notes import notes as written
    from rbpsym.document.writers.html import write_html

    _one_of(detail, DETAILS, "level of detail")
    derivation = derived(text)
    document = written(derivation, language, detail)
    return {
        "title": derivation.study.problem.title.get(language) or derivation.study.problem.name,
        "html": write_html(document),
        "summary": derivation.summary(),
    }


def glance(text: str, language: str = "en") -> Answer:
    """{title, figure, alt, motion, forces}: what is known at once: the drawing (SVG); accelerations and forces as MathML."""
    known = study(text)
    motion, forces = _solved(known, Notation(known.problem.notation))
    title = known.problem.title.get(language) or known.problem.name
    return {"title": title, **_drawn(known, language), "motion": motion, "forces": forces}


def picture(name: str, language: str = "en") -> Answer:
    """{figure, alt}: the drawing (SVG) of a problem that ships."""
    return _drawn(study_of(problem_of(statement(name)["text"])), language)


def _drawn(known: Study, language: str) -> Answer:
    from rbpsym.document.notes_figures import system_figure
    from rbpsym.document.words import Words
    from rbpsym.pictures.figures.svg import to_svg

    said = Words(language, known.problem)
    drawn = None if known.problem.is_at_rest else system_figure(Derivation(known, ()), said)
    scenes = "".join(to_svg(scene, said.notation) for scene in drawn.scenes) if drawn else ""
    return {"figure": scenes, "alt": drawn.alt if drawn else ""}


def _solved(known: Study, notation: Notation) -> tuple[list[str], list[str]]:
    """Accelerations and unknown forces as the free bodies give them; the equations of motion where these stay coupled."""
    found = known.solved
    coupled = known.motion_rows if found.accelerations is None else ()
    motion: list[t.Node] = [t.equation(present(row, known.style), t.ZERO) for row in coupled]
    motion += _values(found.accelerations or {}, known)
    shown = [[to_mathml(node, notation) for node in nodes] for nodes in (motion, _values(found.reactions, known))]
    return shown[0], shown[1]


def _values(found: Mapping[str, Scalar], known: Study) -> list[t.Node]:
    """Each value by its name; what would be longer than a glance is left to the notes."""
    nodes = [t.equation(t.Sym(name), present(value, known.style, factor=True)) for name, value in found.items()]
    return [node for node in nodes if sum(1 for _ in t.walk(node)) <= GLANCE]


def answers(text: str, questions: list[str] = NONE) -> list[Answer]:
    """[{question, shown, verdict, says, where}]: its own questions, or these, with answers; `shown` and `where` as MathML."""
    from rbpsym.ask.asking import answered_all, own_answers
    from rbpsym.ask.certified import LETTER

    known = study(text)
    return list(map(_told, answered_all(known, dict.fromkeys(questions, LETTER)) if questions else own_answers(known)))


def _told(found: Any) -> Answer:
    """A question with its answer, or with the reason why there is none."""
    from rbpsym.ask.asking import Refused
    from rbpsym.ask.telling import valid_for

    if isinstance(found, Refused):
        return {"question": found.text, "shown": [], "verdict": "", "says": found.reason, "where": []}
    notation = Notation(found.study.problem.notation)
    named = [t.equation(t.Sym(found.symbol), node) if found.symbol else node for node in found.nodes]
    plain = "" if found.holds_so is None else ("yes" if found.holds_so else "no")
    reason, nearly = "" if found.verdict.is_proved else found.verdict.reason, valid_for(found)
    taken = f"read as “{found.read_as}”" if found.read_as else ""
    return {
        "question": found.question.text,
        "shown": [to_mathml(node, notation) for node in named],
        "verdict": str(found.verdict.kind),
        "says": "; ".join(filter(None, (plain, found.says, nearly and f"for {nearly}", reason, taken))),
        "where": [to_mathml(node, notation) for node in found.valid],
    }


def explorer(text: str, language: str = "en", beside: str = "") -> Answer:
    """{html}: the page in which the system moves, beside that of a problem that ships."""
    from rbpsym.explorer.page import explorer as page

    others = (problem_of(statement(beside)["text"]),) if beside else ()
    return {"html": page((problem_of(text), *others), language)}


def export(text: str, format: str, language: str = "en", detail: str = "standard", packed: bool = False) -> Answer:
    """{files: [{name, content, base64}], left_out}: the notes in a format; `base64` says how the content is written.

    Where they are `packed`, several files are one archive.
    """
    from rbpsym.document.notes import notes as written
    from rbpsym.document.writers import files

    _one_of(format, (*FORMATS, *(("pdf",) if find_spec("typst") else ())), "format")
    _one_of(detail, DETAILS, "level of detail")
    derivation = derived(text)
    document = written(derivation, language, detail, plots=True)
    return {"files": _files(files(document, format, derivation.study.problem.name), packed), "left_out": []}


def worksheet(text: str, format: str, seed: str = "", language: str = "en", packed: bool = False) -> Answer:
    """{files, left_out}: a worksheet of the problem with its key; `left_out` says what the format can't carry."""
    from rbpsym.teaching.formats import Options, exporter
    from rbpsym.teaching.plan import plan_of

    _one_of(format, SHEETS, "format")
    made = exporter(format)((plan_of(problem_of(text)).worksheet(None, seed, language),), Options(key=True))
    return {"files": _files(made.files, packed), "left_out": list(made.left_out)}


def _files(contents: Mapping[str, str | bytes], packed: bool) -> list[Answer]:
    """Files as JSON can hold them; where they are packed, more than two as one archive."""
    if packed and len(contents) > 2:
        archive = BytesIO()
        with ZipFile(archive, "w", ZIP_DEFLATED) as found:
            for name, made in contents.items():
                found.writestr(name, made)
        contents = {"problem.zip": archive.getvalue()}
    coded = {name: b64encode(made).decode() for name, made in contents.items() if isinstance(made, bytes)}
    return [{"name": name, "content": coded.get(name, made), "base64": name in coded} for name, made in contents.items()]


def check(text: str, paper: str, suffix: str = ".tex") -> list[Answer]:
    """[{line, latex, outcome, detail, fix}]: each formula of a pasted text decided with the names of the problem."""
    from rbpsym.claims.papers.formats import TEXTS
    from rbpsym.claims.run import Certificates, check_paper, names_of_problem

    _one_of(suffix, tuple(TEXTS), "kind of text")
    problem_of(text)
    with TemporaryDirectory(prefix="rbpsym-") as name:
        problem, page = Path(name, FILE), Path(name, f"text{suffix}")
        problem.write_text(text, encoding="utf-8")
        page.write_text(paper, encoding="utf-8")
        found, _ = check_paper(page, [names_of_problem(problem)], Certificates(None), everything=True)
    return [_decided(result) for result in found]


def _decided(result: Any) -> Answer:
    """What was found out about one formula."""
    doubtful = [link.detail for link in result.links if link.detail and not link.diagnosis]
    told = [*doubtful, result.detail if not doubtful else "", result.diagnosis]
    return {
        "line": result.line,
        "latex": result.latex.strip(),
        "outcome": str(result.outcome),
        "detail": "; ".join(dict.fromkeys(filter(None, told))) or result.how,
        "fix": result.fix.strip(),
    }


def completions() -> Answer:
    """{sections, keys, kinds, values}: what can be written where, each with its meaning, from the registries."""
    from rbpsym.studio.completing import tables

    return tables()


@lru_cache(maxsize=4)
def _tutor(text: str, language: str) -> Any:
    from rbpsym.studio.tutor import Tutor

    return Tutor(derived(text), language)


def letters(text: str, language: str = "en") -> Answer:
    """{letters, shown}: the names that a student will type, and how they are printed (MathML)."""
    tutor = _tutor(text, language)
    return {"letters": tutor.letters, "shown": list(map(tutor.shown, tutor.letters))}


def typed(text: str, line: str, language: str = "en") -> Answer:
    """{math}: a line as it is printed (MathML); "" as long as it can't be read."""
    return {"math": _tutor(text, language).shown(line)}


def judge(text: str, line: str, lines: list[str] = NONE, language: str = "en") -> Answer:
    """{verdict, says, math, step, principle, choices} of a student's line, typed plainly or LaTeX; `lines` are those above it.

    Where the line is one of the principles `choices` [{key, words}], the student may be asked which (`principle` is its key).
    """
    tutor = _tutor(text, language)
    found = tutor.judge(line, lines)
    asked = tutor.principles() if found.principle else []
    told = {"verdict": found.verdict, "says": found.says, "math": tutor.shown(line), "step": found.step}
    return {**told, "principle": found.principle, "choices": asked}


def hint(text: str, lines: list[str] = NONE, depth: int = 1, language: str = "en") -> Answer:
    """{says, line}: the next step that can be made, the more of it the greater the depth (1 to 3: then `line` is all of it)."""
    return dict(zip(("says", "line"), _tutor(text, language).hint(lines, depth), strict=True))


def record(text: str, lines: list[str], language: str = "en") -> Answer:
    """{problem, title, lines: [{line, verdict, says}], steps, all}: what a student hands in."""
    return dict(_tutor(text, language).record(lines))


def _one_of(value: str, known: tuple[str, ...], what: str) -> None:
    if value not in known:
        raise ReadError(f"unknown {what} “{value}”", instead=f"known: {', '.join(known)}.")


OPERATIONS: Mapping[str, Callable[..., Any]] = {
    one.__name__: one
    for one in (
        schema, gallery, statement, picture, glance, notes, answers, explorer, export, worksheet, check, completions, letters,
        typed, judge, hint, record,
    )
}  # fmt: skip

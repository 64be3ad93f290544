"""Runs inside Pyodide while the site is built: compiles the modules that the page can need, and its standard library."""

import json
import marshal
import sys
import zipfile
from importlib.util import MAGIC_NUMBER
from pathlib import Path

SRC = Path("/src")
OWN_LEFT_OUT = ("commands", "cli.py", "kernel/Prelude.v")
TOUCHED = ("sliding-ladder", "rod-and-disk-free", "atwood-with-massive-pulley")  # to see which modules are loaded
DATA = ("templates", "derivations")


def call(**told):
    """An answer of the engine; an error is told."""
    from rbpsym.studio.api import call as asked

    found = json.loads(asked(json.dumps(told)))
    if "error" in found:
        raise SystemExit(found["error"]["told"])
    return found["ok"]


def touch() -> None:
    """Everything that the page asks for, once."""
    for name in TOUCHED:
        text = call(do="statement", name=name)["text"]
        for do in ("glance", "notes", "answers", "explorer", "letters"):
            call(do=do, text=text)
    call(do="check", text=text, paper=r"\[ \ddot x = g \]")
    for kind in ("html", "tex", "md", "ipynb", "typ"):
        call(do="export", text=text, format=kind)
    call(do="worksheet", text=text, format="moodle")
    call(do="completions")
    import sympy.polys.groebnertools  # noqa: F401


def compiled(source: bytes, name: str) -> bytes:
    """A .pyc that is never compared with its source, without docstrings."""
    code = compile(source, name, "exec", dont_inherit=True, optimize=2)
    return MAGIC_NUMBER + (1).to_bytes(4, "little") + bytes(8) + marshal.dumps(code)


def modules():
    """(file, name in the archive) of the program, and of what of the packages was loaded."""
    for path in sorted((SRC / "rbpsym").rglob("*.py")):
        inner = str(path.relative_to(SRC / "rbpsym"))
        if not inner.startswith(OWN_LEFT_OUT):
            yield path, f"rbpsym/{inner}"
    for name, module in sorted(sys.modules.items()):
        file = getattr(module, "__file__", None)
        if file and file.startswith("/src/") and not name.startswith(("rbpsym", "pack_engine")):
            yield Path(file), str(Path(file).relative_to(SRC))


def data():
    """(file, name in the archive) of what is read and not run."""
    for path in sorted((SRC / "rbpsym").rglob("*")):
        if path.suffix in (".toml", ".js"):
            yield path, f"rbpsym/{path.relative_to(SRC / 'rbpsym')}"
    for folder in DATA:
        for path in sorted((SRC / folder).rglob("*")):
            if path.is_file() and "claims" not in path.parts:
                yield path, f"rbpsym/_data/{path.relative_to(SRC)}"
    yield SRC / "sympy/__init__.py", "sympy/__init__.py"  # its list of names is read (`sympy_bridge`)


def words() -> str:
    """What the page itself says, by language."""
    from rbpsym.languages import languages, phrases

    return json.dumps({language: phrases(language, "studio") for language in languages()}, ensure_ascii=False)


def stock() -> str:
    """What the page knows without asking: what can be written where, and the problems that ship, by language."""
    from rbpsym.languages import languages

    told = {language: call(do="gallery", language=language) for language in languages()}
    return json.dumps({"completions": call(do="completions"), "gallery": told}, ensure_ascii=False)


def packed(files) -> bytes:
    """Files one after the other, behind a list of [name, length] and its own length."""
    files = list(files)
    index = json.dumps([(name, len(content)) for name, content in files]).encode()
    return b"".join([len(index).to_bytes(4, "little"), index, *(content for _, content in files)])


def library(source: str, target: str) -> None:
    """Python's standard library with those modules compiled that were loaded; as it comes, the page would compile each."""
    loaded = {str(getattr(module, "__file__", "")).partition(".zip/")[2] for module in sys.modules.values()}
    with zipfile.ZipFile(source) as given, zipfile.ZipFile(target, "w") as made:
        for info in given.infolist():
            name, content = info.filename, given.read(info)
            if name in loaded:
                name, content = f"{name}c", compiled(content, name)
            made.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, 9)


def pack(code: str, rest: str, looks: str) -> None:
    """Writes the archives of the modules and of the data, and how figures look."""
    touch()
    from rbpsym.pictures.figures.svg import color_rules

    sheet = (SRC / "templates/notes.css").read_text(encoding="utf-8").splitlines()
    rules = [line for line in sheet if line.startswith((".scene", ".fill-none", ".dot-accent"))]
    Path(looks).write_text("\n".join([color_rules(), *rules, ""]), encoding="utf-8")
    Path(code).write_bytes(packed((f"{name}c", compiled(path.read_bytes(), name)) for path, name in modules()))
    Path(rest).write_bytes(packed((name, path.read_bytes()) for path, name in data()))

"""`rbpsym lsp`: what editors ask over stdio (LSP 3.17): findings, what stands under the cursor, what can be written."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import IO, Any
from urllib.parse import unquote, urlparse

import click

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field

Message = dict[str, Any]
ERROR, WARNING = 1, 2
ABILITIES = {
    "textDocumentSync": {"openClose": True, "change": 1, "save": True},
    "hoverProvider": True,
    "completionProvider": {"triggerCharacters": ['"', "[", ":", " "]},
}
MOST_BYTES = 8 * 1024 * 1024


class Server(Frozen):
    """One editor: its open texts, and what was found in them last."""

    out: IO[bytes]
    texts: dict[str, str] = field(default_factory=dict)
    found: dict[str, list[Any]] = field(default_factory=dict)

    def obey(self, message: Message) -> None:
        """One message; a question without a method of ours is answered so."""
        name, asked = message.get("method", ""), "id" in message
        told: dict[str, Callable[[Message], object]] = {
            "initialize": lambda _: {"capabilities": ABILITIES}, "shutdown": lambda _: None,
            "textDocument/hover": self.hover, "textDocument/completion": self.completion,
        }  # fmt: skip
        if asked and name:
            known = name in told
            answer = {"result": told[name](message.get("params", {}))} if known else {"error": {"code": -32601, "message": name}}
            self.send({"id": message["id"], **answer})
        elif name in ("textDocument/didOpen", "textDocument/didChange", "textDocument/didSave"):
            self.read(message["params"], saved=name != "textDocument/didChange")

    def send(self, message: Message) -> None:
        """Write a message."""
        body = json.dumps({"jsonrpc": "2.0", **message}, ensure_ascii=False).encode()
        self.out.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.out.flush()

    def read(self, params: Message, *, saved: bool) -> None:
        """A text that was opened, changed or saved: its findings are told. Papers are read as they are saved."""
        uri, changes = params["textDocument"]["uri"], params.get("contentChanges", [{}])
        text = params["textDocument"].get("text", changes[-1].get("text"))
        self.texts[uri] = self.texts.get(uri, "") if text is None else text
        path = Path(unquote(urlparse(uri).path))
        if path.suffix == ".toml":
            found = _of_statement(self.texts[uri], path)
        elif saved:
            found = self._of_paper(path, uri)
        else:
            return
        self.send({"method": "textDocument/publishDiagnostics", "params": {"uri": uri, "diagnostics": list(found)}})

    def _of_paper(self, path: Path, uri: str) -> Iterable[Message]:
        from rbpsym.claims.run import Certificates, check_paper, default_folder

        certificates = Certificates.opened(default_folder())
        try:
            results, remarks = check_paper(path, (), certificates)
        except RbpsymError as error:
            return [_told_of(error)]
        certificates.store()
        self.found[uri] = results = [result for result in results if Path(result.file) == path]
        wrong = (result for result in results if not result.expected)
        said = ((r.line, ERROR if str(r.outcome) == "REFUTED" else WARNING, _words(r)) for r in wrong)
        noted = ((line, WARNING, what) for file, line, what in remarks if Path(file) == path)
        return [_diagnostic(*one) for one in (*said, *noted)]

    def hover(self, params: Message) -> Message | None:
        """What was read and found of a formula, or what a word of a statement means."""
        uri, place = params["textDocument"]["uri"], params["position"]
        shown = next((r for r in self.found.get(uri, ()) if 0 <= place["line"] + 1 - r.line <= r.latex.strip().count("\n")), None)
        if shown is not None:
            return {"contents": "\n\n".join((*(str(link.relation) for link in shown.links), _words(shown)))}
        line = (self.texts.get(uri, "").split("\n") + [""] * (place["line"] + 1))[place["line"]]
        word = next((w[0] for w in re.finditer(r"[\w-]+", line) if w.start() <= place["character"] <= w.end()), "")
        meaning = _meanings().get(word)
        return {"contents": f"{word}: {meaning}"} if uri.endswith(".toml") and meaning else None

    def completion(self, params: Message) -> list[Message]:
        """What can be written here."""
        uri, place = params["textDocument"]["uri"], params["position"]
        lines = self.texts.get(uri, "").split("\n")[: place["line"] + 1]
        line = lines[-1][: place["character"]] if len(lines) > place["line"] else ""
        words = _of_toml(line, lines) if uri.endswith(".toml") else _of_comment(line, Path(unquote(urlparse(uri).path)).parent)
        return [{"label": word, "detail": meaning} for word, meaning in words.items()]


def _words(result: Any) -> str:
    detail = next((link.detail for link in result.links if link.detail), result.detail)
    return ". ".join(filter(None, (str(result.outcome), detail, result.diagnosis, result.fix)))


def _diagnostic(line: int, severity: int, message: str, column: int = 0, width: int = 1000) -> Message:
    ends = {"start": column, "end": column + width}
    spot = {end: {"line": max(line - 1, 0), "character": character} for end, character in ends.items()}
    return {"range": spot, "severity": severity, "source": "rbpsym", "message": message}


def _told_of(error: RbpsymError) -> Message:
    place = error.place
    at = (place.line, ERROR, max(place.column - 1, 0), max(place.width, 1)) if place else (1, ERROR, 0, 1)
    return _diagnostic(*at[:2], f"{error.what}. {error.instead}", *at[2:])


def _of_statement(text: str, path: Path) -> Iterable[Message]:
    from rbpsym.claims.loader import is_claims
    from rbpsym.statement.loader import load_text

    try:
        if not (path.is_file() and is_claims(path)):
            load_text(text, path.stem)
    except RbpsymError as error:
        yield _told_of(error)


def _of_toml(line: str, lines: list[str]) -> Mapping[str, str]:
    """Sections behind [, kinds behind shape = or type =, else the keys of the section."""
    from rbpsym.studio.completing import tables

    known: Any = tables()
    headers = (re.match(r"\s*\[+\s*(?:phases\.)?(\w+)", one) for one in reversed(lines))
    section = header[1] if (header := next(filter(None, headers), None)) else ""
    kinds = known["kinds"].get(section, {"names": {}})
    if line.lstrip().startswith("["):
        return dict(known["sections"])
    if re.search(r"\b(?:shape|type)\s*=", line):
        return {name: kind["meaning"] for name, kind in kinds["names"].items()}
    keys = (keys for kind in kinds["names"].values() for keys in kind["keys"].items())
    return {**dict(keys), **known["keys"].get(section, {})}


def _of_comment(line: str, folder: Path) -> Mapping[str, str]:
    """The words of comments behind `rbpsym:`, problems behind `problem =`, or what a symbol may mean behind “is”."""
    from rbpsym.claims.papers.claims import OF_CLAIM, OF_SETTING
    from rbpsym.studio.completing import tables

    if "rbpsym:" not in line:
        return {}
    if re.search(r"rbpsym:\s*problem\s*=", line):
        return _problems(folder)
    if re.search(r"\bis\b", line):
        known: Any = tables()
        return dict.fromkeys(known["quantities"], "what a symbol may mean")
    return {"claim": "the next display is claimed", **{f"{key} =": "of this text" for key in (*OF_SETTING, *OF_CLAIM)}}


def _problems(folder: Path) -> Mapping[str, str]:
    """The files beside the text, and the problems that ship, with their titles."""
    from rbpsym.commands.arguments import shelf

    beside = {path.name: "beside the text" for path in sorted(folder.glob("*.toml"))}
    return {**beside, **{entry.name: entry.title() for entry in shelf() if entry.kind == "problem"}}


def _meanings() -> Mapping[str, str]:
    from rbpsym.studio.completing import tables

    known: Any = tables()
    kinds = {name: kind for part in known["kinds"].values() for name, kind in part["names"].items()}
    keys = {key: told for kind in kinds.values() for key, told in kind["keys"].items()}
    return {**keys, **known["sections"], **{name: kind["meaning"] for name, kind in kinds.items()}}


@click.command("lsp")
def command() -> None:
    """Serve editors over stdio: findings, hover and completion, for problems and for papers with comments.

    \b
    Examples:
      rbpsym lsp      the command of the server, in the settings of an editor
    """
    source, server = sys.stdin.buffer, Server(sys.stdout.buffer)
    while header := source.readline():
        size = re.match(rb"Content-Length:\s*(\d+)", header, re.I)
        if size is None:
            continue
        while source.readline().strip():
            pass
        message = json.loads(source.read(min(int(size[1]), MOST_BYTES)))
        if message.get("method") == "exit":
            return
        server.obey(message)

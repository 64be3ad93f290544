"""The built page of the studio served on this machine: its own files and nothing else, to this machine alone."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from rbpsym.errors import RbpsymError

HOST = "127.0.0.1"
BUILT = Path(__file__).resolve().parents[2] / "build" / "studio"  # of a checkout
KINDS: Mapping[str, str] = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".mjs": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".wasm": "application/wasm",
    ".zip": "application/zip",
    ".pack": "application/octet-stream",
    ".woff2": "font/woff2",
    ".otf": "font/otf",
}
ASKED_AGAIN = ("index.html", "sw.js", "frame.html")  # the names of the others change with their content


def built() -> Path:
    """Where the page is: built in this checkout, else in the wheel `rbpsym-studio`."""
    wheel = find_spec("rbpsym_studio")
    own = Path(wheel.origin).with_name("site") if wheel and wheel.origin else BUILT
    return BUILT if (BUILT / "index.html").is_file() else own


def site(folder: Path) -> dict[str, Path]:
    """The files of the page by their addresses. Raises RbpsymError where it is missing."""
    if not (folder / "index.html").is_file():
        what = f"the page of the studio is missing: there is no {folder / 'index.html'}"
        raise RbpsymError(what, instead="“pip install rbpsym-studio” gets it; in a checkout “make studio” builds it.")
    files = (path for path in folder.rglob("*") if path.suffix in KINDS and path.is_file())
    return {**{f"/{path.relative_to(folder).as_posix()}": path for path in files}, "/": folder / "index.html"}


class Handler(BaseHTTPRequestHandler):
    """Answers with a file of the table, or with 404; a request that names another host is refused (DNS rebinding)."""

    protocol_version = "HTTP/1.1"

    def __init__(self, files: Mapping[str, Path], *args: Any) -> None:
        self.files = files
        super().__init__(*args)

    def do_GET(self) -> None:
        """The file."""
        path = self._head()
        if path is not None:
            self.wfile.write(path.read_bytes())

    def do_HEAD(self) -> None:
        """What would be sent."""
        self._head()

    def _head(self) -> Path | None:
        path = self.files.get(unquote(urlsplit(self.path).path))
        if self.headers.get("Host", "").partition(":")[0] not in (HOST, "localhost") or path is None:
            self.send_error(HTTPStatus.NOT_FOUND)
            return None
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", KINDS[path.suffix])
        self.send_header("Content-Length", str(path.stat().st_size))
        self.send_header("Cache-Control", "no-cache" if path.name in ASKED_AGAIN else "max-age=31536000, immutable")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        return path

    def log_message(self, *told: Any) -> None:
        """Nothing is written down."""


def server(port: int = 0, folder: Path | None = None) -> ThreadingHTTPServer:
    """A server of the page on this machine; port 0 takes one that is free. Raises RbpsymError."""
    files = site(folder or built())
    try:
        return ThreadingHTTPServer((HOST, port), partial(Handler, files))
    except (OSError, OverflowError) as error:
        raise RbpsymError(f"port {port} can't be had: {error}", instead="choose another one, or leave --port out.") from None

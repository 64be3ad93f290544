"""The static twin of a page in which things move: a figure with the QR code of the problem's address in the studio."""

from __future__ import annotations

import zlib
from base64 import urlsafe_b64encode
from collections.abc import Iterator
from dataclasses import replace

from rbpsym.document.model import Document, FigureBlock, Live, Section, words
from rbpsym.document.phrases import plain
from rbpsym.errors import RbpsymError
from rbpsym.pictures.figures.scene import Polyline, Scene
from rbpsym.statement.library import problem_files

MODULE, QUIET = 0.05, 4  # cm; empty modules around it
LONGEST = 2900  # bytes of the largest code


def address(site: str, live: Live) -> str:
    """Where a problem is opened: by its name if it ships so, else it travels deflated behind the “#”, which no server sees."""
    own = problem_files().get(live.name)
    if own is not None and own.read_text(encoding="utf-8") == live.text:
        return f"{site}#n={live.name}"
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    packed = packer.compress(live.text.encode()) + packer.flush()
    return f"{site}#p={urlsafe_b64encode(packed).decode().rstrip('=')}"


def with_twins(document: Document, site: str) -> Document:
    """The document with the codes of its problems at its end. Raises RbpsymError."""
    codes = tuple(code(live, site, document.language) for live in document.live)
    title = words(plain("twin.title", document.language))
    return replace(document, sections=(*document.sections, Section(title, codes))) if codes else document


def code(live: Live, site: str, language: str, panel: str = "") -> FigureBlock:
    """The code of a problem, or of one panel of the studio alone. Raises RbpsymError."""
    if not site.startswith(("http://", "https://")):
        raise RbpsymError(f"“{site}” is no address of a studio", instead="write where it is served: https://…/index.html")
    goal = address(site, live) + (f"&only={panel}" if panel else "")
    try:
        from segno import make_qr
    except ImportError:
        raise RbpsymError("QR codes need segno", instead="pip install 'rbpsym[qr]'") from None
    if len(goal) > LONGEST:
        raise RbpsymError(f"the statement of “{live.name}” is too long for a QR code", instead="leave --studio out.")
    shown = goal if "#n=" in goal else ""
    caption = plain("twin.caption", language, name=live.name, address=shown, variant=panel or "whole")
    scene = Scene(tuple(_bars([list(map(bool, row)) for row in make_qr(goal, error="l").matrix_iter(border=QUIET)])))
    return FigureBlock((scene,), words(caption.strip()), plain("twin.alt", language, address=goal))


def _bars(rows: list[list[bool]]) -> Iterator[Polyline]:
    """The dark runs of the rows, and the quiet zone around."""
    yield _box(0, len(rows), 0, len(rows), "quiet")
    for down, row in enumerate(rows, 1):
        turns = [k for k in range(1, len(row)) if row[k] != row[k - 1]]  # the ends of a row are empty
        height = len(rows) - down
        yield from (_box(left, right, height, height + 1, "code") for left, right in zip(turns[::2], turns[1::2], strict=True))


def _box(left: int, right: int, low: int, high: int, style: str) -> Polyline:
    corners = ((left, low), (right, low), (right, high), (left, high))
    return Polyline(tuple((x * MODULE, y * MODULE) for x, y in corners), style, closed=True)

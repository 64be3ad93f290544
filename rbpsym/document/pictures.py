"""Figures as files for formats that can't draw: each one a PNG or SVG, set by Typst like those of the PDF."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from typing import Any

from rbpsym.document.model import Document, FigureBlock, parts
from rbpsym.document.writers.page import shell
from rbpsym.errors import RbpsymError
from rbpsym.expr.glyphs import Notation
from rbpsym.frozen import Frozen
from rbpsym.pictures.figures.scene import Scene, placed
from rbpsym.pictures.figures.svg import color_rules, number, to_svg
from rbpsym.pictures.figures.typst import to_typst_drawing

ROW, GAP = 16.0, 0.5  # cm
RESOLUTION = 200.0  # dots an inch of a PNG


class Picture(Frozen):
    """A figure as a file; `number` is that of its caption, the size in cm is known of a PNG."""

    number: str
    content: bytes
    width: float = 0.0
    height: float = 0.0


def figures_of(document: Document) -> list[tuple[FigureBlock, Notation]]:
    """The figures of a numbered document that show something, with the notation of their section."""
    return [
        (part, section.notation or document.notation)
        for section in document.sections
        for part in parts(section.blocks)
        if isinstance(part, FigureBlock) and part.scenes
    ]


def pictures(document: Document, kind: str = "png", resolution: float = RESOLUTION) -> dict[str, Picture]:
    """The figures of a numbered document by number; `kind` is "png" or "svg"."""
    figures = figures_of(document)
    drawn = drawings([(figure.scenes, notation) for figure, notation in figures], kind, resolution)
    numbers = (figure.number for figure, _ in figures)
    return {n: picture(n, content, kind, resolution) for n, content in zip(numbers, drawn, strict=True)}


def drawings(scenes: Sequence[tuple[tuple[Scene, ...], Notation]], kind: Any, resolution: float) -> list[bytes]:
    """Each group of scenes side by side, all of them drawn in one run."""
    if not scenes:
        return []
    if find_spec("typst") is None:
        return [without_typst(*group) for group in scenes] if kind == "svg" else missing(kind)
    import typst

    groups = [drawn(*group) for group in scenes]
    if kind == "pdf":  # one file a picture
        return [typst.compile(source_of([group])) for group in groups]
    found = typst.compile(source_of(groups), format=kind, ppi=resolution)
    return found if isinstance(found, list) else [found]


def easiest() -> str:
    """The kind of pictures that can be made here: "png", or "svg" where Typst is not installed (in a browser)."""
    return "svg" if find_spec("typst") is None else "png"


def missing(kind: str) -> list[bytes]:
    """Raises RbpsymError: only Typst draws this kind."""
    raise RbpsymError(f"{kind} pictures are drawn by Typst, which is not installed here", instead="pip install typst brings it.")


def without_typst(scenes: Sequence[Scene], notation: Notation) -> bytes:
    """Scenes side by side as an SVG whose labels are MathML, which browsers show."""
    at, high, inner = 0.0, 0.0, []
    for scene in scenes:
        left, bottom, right, top = placed(scene, notation).bounds
        inner.append(to_svg(scene, notation).replace("<svg ", f'<svg x="{number(at)}" ', 1))
        at, high = at + right - left + GAP, max(high, top - bottom)
    size = f'width="{number(at - GAP)}" height="{number(high)}"'
    body = "".join(inner)
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}><style>{color_rules()}</style>{body}</svg>'.encode()


def source_of(groups: Sequence[str]) -> bytes:
    """The Typst source that has a page for each group of drawings."""
    return shell("pictures.typ", pictures="\n".join(groups)).encode()


def drawn(scenes: Sequence[Scene], notation: Notation) -> str:
    """The Typst of scenes side by side."""
    bounds = [placed(scene, notation).bounds for scene in scenes]
    wide = sum(right - left for left, _, right, _ in bounds) + GAP * (len(bounds) - 1)
    inner = ",\n".join(to_typst_drawing(scene, notation) for scene in scenes)
    return f"#picture({'auto' if wide <= ROW else f'{ROW}cm'},\n{inner},\n)"


def picture(number: str, content: bytes, kind: str, resolution: float) -> Picture:
    """The picture with its size."""
    if kind != "png":
        return Picture(number, content)
    wide, high = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))  # the head of a PNG
    return Picture(number, content, wide / resolution * 2.54, high / resolution * 2.54)

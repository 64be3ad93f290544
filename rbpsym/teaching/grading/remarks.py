"""The sentences of marks, [remark] of the phrases. {name} is a place; a tree in a place is printed as a formula."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.document.phrases import phrase_of
from rbpsym.errors import RbpsymError
from rbpsym.notation.glyphs import renamed
from rbpsym.notation.tree import Node
from rbpsym.teaching.grading.judgement import Judgement, Remark
from rbpsym.teaching.grading.translated import reason, translated
from rbpsym.teaching.model import Slip
from rbpsym.teaching.wording import FOLDER

_NAME = re.compile(r"[A-Za-z]\w*_\w+")
_NOTHING: Mapping[str, str] = MappingProxyType({})
SaySlip = Callable[[Slip, str], Inlines]


def said(remark: Remark, language: str, say_slip: SaySlip, called: Mapping[str, str] = _NOTHING) -> Inlines:
    """A remark as a sentence; `called` is what bodies are called in the language."""
    slots = _in_language(remark.slots, language, called)
    told = {name: tuple(_inlines(value, language, say_slip)) for name, value in slots.items()}
    return phrase_of(FOLDER, f"remark.{remark.key}", language, told)


def _in_language(slots: Mapping[str, Any], language: str, called: Mapping[str, str]) -> dict[str, Any]:
    """The slots with what the readers say of the answer in the language."""
    error = slots.get("error")
    spoken = {name: translated(value, language) if isinstance(value, str) else value for name, value in slots.items()}
    why = reason(error, language) if isinstance(error, RbpsymError) else ""
    return spoken | ({"why": _NAME.sub(lambda name: renamed(name[0], called), why)} if why else {})


def _inlines(value: Any, language: str, say_slip: SaySlip) -> Iterator[Any]:
    if isinstance(value, Node):
        yield Math(value)
    elif isinstance(value, Slip):
        yield from say_slip(value, language)
    elif isinstance(value, tuple):
        for place, item in enumerate(value):
            yield from ((Text(", "),) if place else ())
            yield from _inlines(item, language, say_slip)
    else:
        yield Text(str(value))


def comment(judgement: Judgement, language: str, say_slip: SaySlip, called: Mapping[str, str] = _NOTHING) -> Inlines:
    """All remarks of a judgement, one after the other."""
    found: list[Any] = []
    for remark in judgement.remarks:
        found += [Text(" ")] if found else []
        found += said(remark, language, say_slip, called)
    return tuple(found)

"""The registry of printers: name -> where its function `to_X(node, notation)` lives.

Laws and documentation run over this table, so a new printer is tested by being entered here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module

_PLACES = {
    "latex": "rbpsym.typeset.latex:to_latex",
    "typst": "rbpsym.typeset.typst:to_typst",
    "mathml": "rbpsym.typeset.mathml:to_mathml",
    "omml": "rbpsym.typeset.omml:to_omml",
    "text": "rbpsym.typeset.text:to_text",
    "machine": "rbpsym.typeset.machine:to_machine",
    "speech": "rbpsym.typeset.speech:to_speech",
}

Printer = Callable[..., str]


class _Printers(Mapping[str, Printer]):
    """A mapping that imports a printer when it is first asked for."""

    def __getitem__(self, name: str) -> Printer:
        module, function = _PLACES[name].split(":")
        return getattr(import_module(module), function)

    def __iter__(self) -> Iterator[str]:
        return iter(_PLACES)

    def __len__(self) -> int:
        return len(_PLACES)


PRINTERS: Mapping[str, Printer] = _Printers()

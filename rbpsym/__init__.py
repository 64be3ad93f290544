"""rbpsym: symbolic derivations for the plane motion of rigid bodies.

A problem is data; the engine derives its equations step by step, proves every step and writes
lecture notes. The public names are loaded when they are first used; besides those of `_PUBLIC`
there is a function for each kind of shape, interaction and constraint (`rod`, `gravity`,
`contact`, ...), see `rbpsym.statement.build`.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import FunctionType, ModuleType

__version__ = "0.1.0"

_PUBLIC = {
    "load_problem": "rbpsym.statement.loader",
    "load_text": "rbpsym.statement.loader",
    "load_course": "rbpsym.statement.course",
    "find_problem": "rbpsym.statement.library",
    "problem_files": "rbpsym.statement.library",
    "Problem": "rbpsym.statement.model",
    "derive": "rbpsym.derive",
    "derive_course": "rbpsym.courses",
    "solve": "rbpsym.solve",
    "ask": "rbpsym.ask.asking",
    "problem": "rbpsym.face.stating",
    "quantity": "rbpsym.face.stating",
    "model": "rbpsym.face.model",
    "Study": "rbpsym.mechanics.study",
    "compiled_accelerations": "rbpsym.mechanics.compiled",
    "Derivation": "rbpsym.proof.step",
    "notes": "rbpsym.document.notes",
    "course_notes": "rbpsym.document.notes",
    "writer": "rbpsym.document.writers",
    "speak": "rbpsym.document.looks",
    "grade": "rbpsym.teaching.grading.marking",
    "grade_answer": "rbpsym.teaching.grading.answer",
    "grade_number": "rbpsym.teaching.grading.answer",
    "equal": "rbpsym.decide.equal",
    "Assumptions": "rbpsym.decide.signs",
    "Verdict": "rbpsym.decide.verdict",
    "RbpsymError": "rbpsym.errors",
}
_MAKERS = "rbpsym.statement.build"

__all__ = ["__version__", *_PUBLIC]


def __getattr__(name: str) -> object:
    """A public name, imported on first use."""
    home = _PUBLIC.get(name, _MAKERS)
    if name.startswith("_") or (home == _MAKERS and name not in import_module(_MAKERS).__all__):
        raise AttributeError(f"module “rbpsym” has no attribute “{name}”")
    value = getattr(import_module(home), name)
    if home != _MAKERS and isinstance(value, FunctionType):
        value = import_module("rbpsym.facade").opened(value)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """The public names, those that make parts of problems among them."""
    return sorted({*__all__, *import_module(_MAKERS).__all__})


class _Package(ModuleType):
    """The package, in which a function hides the submodule of the same name (`solve`, `derive`)."""

    def __setattr__(self, name: str, value: object) -> None:
        if name not in _PUBLIC or not isinstance(value, ModuleType):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package

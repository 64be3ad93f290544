"""What is true of a system: its bodies, interactions and constraints, read and checked."""

from __future__ import annotations

from importlib import import_module

_HOMES = {
    "load_problem": "loader",
    "load_text": "loader",
    "Problem": "model",
    "unknowns_of": "checks",
    "problem_files": "library",
    "find_problem": "library",
    "starter_text": "starter",
}

_KINDS = ("SHAPES", "INTERACTIONS", "CONSTRAINTS")


def __getattr__(name: str) -> object:
    """What the package offers, imported when it is asked for."""
    if name in _KINDS:
        return getattr(import_module(f"rbpsym.elements.{name.lower()}"), name)
    if name in _HOMES:
        return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    build = import_module(f"{__name__}.build")
    if name in build.__all__:
        return getattr(build, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*_HOMES, *_KINDS, *import_module(f"{__name__}.build").__all__])

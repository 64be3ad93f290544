"""The public functions as a user calls them: a name of what ships, a file or a text where its value is meant.

What fits no argument is told in a sentence. Within the package the functions are called as they are.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from functools import wraps
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rbpsym.errors import StatementError

if TYPE_CHECKING:
    from rbpsym.mechanics.study import Study
    from rbpsym.statement.course import Course
    from rbpsym.statement.model import Problem

WORD = re.compile(r"[A-Za-z]\w*")


def opened(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function with its arguments read by `READERS`, told by their annotations."""
    shape = signature(function)
    readers = {name: READERS[p.annotation] for name, p in shape.parameters.items() if p.annotation in READERS}

    @wraps(function)
    def called(*args: object, **keys: object) -> object:
        bound = shape.bind(*args, **keys)
        for name, read in readers.items():
            if name in bound.arguments:
                bound.arguments[name] = read(bound.arguments[name], f"“{name}” of {function.__name__}()")
        return function(*bound.args, **bound.kwargs)

    called.__module__, called.__qualname__ = "rbpsym", function.__name__  # by which it is pickled
    return called if readers else function


def _wrong(value: object, what: str, wanted: str) -> StatementError:
    from rbpsym.statement.source import kind_of

    return StatementError(f"{what} is {kind_of(value)}", instead=f"give {wanted}.")


def _problem_or_study(value: object, what: str) -> Problem | Study:
    from rbpsym.mechanics.study import Study

    return value if isinstance(value, Study) else _problem(value, what)


def _problem(value: object, what: str) -> Problem:
    from rbpsym.mechanics.study import Study
    from rbpsym.proof.step import Derivation
    from rbpsym.statement.loader import load_problem
    from rbpsym.statement.model import Problem

    if isinstance(value, Derivation):
        return value.study.problem
    if isinstance(value, Study):
        return value.problem
    if isinstance(value, Problem):
        return value
    if isinstance(value, (str, os.PathLike)):
        return load_problem(value if isinstance(value, str) else Path(value))
    raise _wrong(value, what, "a problem, the name of one that ships, a file or a text")


def _derivation(value: object, what: str) -> object:
    from rbpsym.derive import derive
    from rbpsym.proof.step import Derivation

    return value if isinstance(value, Derivation) else derive(_problem(value, what))


def _course(value: object, what: str) -> Course:
    from rbpsym.statement.course import Course, load_course

    if isinstance(value, (str, os.PathLike)):
        return load_course(Path(value))
    if isinstance(value, Course):
        return value
    raise _wrong(value, what, "a course, the name of one that ships, or its file")


def _derived_course(value: object, what: str) -> object:
    from rbpsym.courses import derive_course
    from rbpsym.proof.step import DerivedCourse

    return value if isinstance(value, DerivedCourse) else derive_course(_course(value, what))


def _formula(value: object, what: str) -> object:
    from rbpsym.expr.infix import read_infix
    from rbpsym.expr.infix_names import FUNCTIONS
    from rbpsym.expr.tree import Node
    from rbpsym.face.reading import is_sympy, tree_of
    from rbpsym.statement.source import written

    if is_sympy(value):
        return tree_of(value)
    if isinstance(value, Node):
        return value
    text = value if isinstance(value, str) else written(value)
    if text is None:
        raise _wrong(value, what, 'a formula as text, "2*a"')
    return read_infix(text, set(WORD.findall(text)) - set(FUNCTIONS))


def _assumptions(value: object, what: str) -> object:
    from rbpsym.decide.assumptions import SIGNS, Assumptions

    if isinstance(value, Mapping) and all(sign in SIGNS for sign in value.values()):
        return Assumptions(dict(value))
    if isinstance(value, Assumptions):
        return value
    raise _wrong(value, what, f'Assumptions, or signs by name, {{"a": "positive"}}: {", ".join(SIGNS)}')


READERS: Mapping[str, Callable[[object, str], object]] = {
    "Problem": _problem,
    "Problem | Study": _problem_or_study,
    "Derivation": _derivation,
    "Course": _course,
    "DerivedCourse": _derived_course,
    "Node": _formula,
    "Assumptions": _assumptions,
}

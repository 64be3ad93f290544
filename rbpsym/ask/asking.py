"""Questions of all kinds and their answers; what is no plain quantity is a row of KINDS before the last."""

from __future__ import annotations

import re
from collections.abc import Callable

from rbpsym.ask.answer import Answer, answer
from rbpsym.ask.moments import Asked
from rbpsym.ask.question import read_question
from rbpsym.statement.model import Problem

# how a question of the kind is written, and what answers it from its words
KINDS: tuple[tuple[str, Callable[..., Answer]], ...] = ((r"(.*)", lambda asked, text: answer(asked, read_question(text))),)


def ask(problem: Problem, *questions: str) -> list[Answer]:
    """The answers to questions about a problem. Raises StatementError or ReadError for one that has none.

    >>> from rbpsym.statement.loader import load_problem
    >>> [found] = ask(load_problem("rod-pendulum"), "F_y at the start")
    """
    asked = Asked(problem)
    return [answered(asked, text) for text in questions]


def answered(asked: Asked, text: str) -> Answer:
    """The answer to one question."""
    plain = " ".join(text.split())
    return next(find(asked, *found.groups()) for pattern, find in KINDS if (found := re.fullmatch(pattern, plain)))

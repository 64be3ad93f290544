"""Seeded mutants of the library's problem files: words, values, lines and whole tables lost, exchanged or added.

Most of them are still TOML, and many still a problem; what they state is strange. Whatever it is, it is derived,
or refused with a sentence.
"""

from __future__ import annotations

import json
import random
import re
import signal
import traceback
from collections.abc import Callable
from contextlib import contextmanager, redirect_stderr
from functools import cache
from io import StringIO

from rbpsym.cli import exit_code
from rbpsym.document.notes import notes
from rbpsym.document.writers import writer
from rbpsym.errors import RbpsymError
from rbpsym.statement.library import problem_files

SECONDS = 60
ENDINGS = (0, 1, 2)
WORD = re.compile(r"[A-Za-z]\w*")
ODD_NAMES = ("r", "C", "s", "rho", "phi", "K", "U", "E", "T", "I", "x_cm", "bar", "hat", "dot", "N", "S", "tau", "L")
ODD_VALUES = ("0", "-1", "1", "pi", "2*pi", "1e-300", "1e30", "asin(2)", "sqrt(-1)", "1/0", "t", "x", "y", "", "theta",
              "0/1", "2**50", "-pi/2", "tan(pi/2)", "(", "1,5", "99999999999999999999")  # fmt: skip
SIGNS = ("+", "-", "*", "/", "**")


@cache
def library() -> tuple[str, ...]:
    """The texts of the library."""
    return tuple(path.read_text() for path in problem_files().values())


@cache
def blocks() -> tuple[str, ...]:
    """All tables of the library: [bodies.rod] and what stands below it."""
    return tuple(block for text in library() for block in re.split(r"\n(?=\[)", text)[1:])


@cache
def values(key: str) -> tuple[str, ...]:
    """All values that a key has in the library."""
    found = (re.findall(rf"^{re.escape(key)}\s*=\s*(.+)$", text, re.M) for text in library())
    return tuple(sorted({value for values in found for value in values}))


def mutant(seed: int) -> str:
    """The mutant of a seed."""
    chance = random.Random(seed)
    text = chance.choice(library())
    for _ in range(chance.choice((1, 1, 1, 2, 2, 3))):
        text = chance.choice(CHANGES)(text, chance)
    return text


def _line(text: str, chance: random.Random) -> tuple[list[str], int]:
    lines = text.split("\n")
    filled = [k for k, line in enumerate(lines) if "=" in line] or [0]
    return lines, chance.choice(filled)


def _lose_a_line(text: str, chance: random.Random) -> str:
    lines, k = _line(text, chance)
    return "\n".join(lines[:k] + lines[k + 1 :])


def _lose_a_table(text: str, chance: random.Random) -> str:
    parts = re.split(r"\n(?=\[)", text)
    del parts[chance.randrange(len(parts))]
    return "\n".join(parts)


def _add_a_table(text: str, chance: random.Random) -> str:
    return f"{text}\n{chance.choice(blocks())}\n"


def _other_value(text: str, chance: random.Random) -> str:
    """A value that the same key has in another problem."""
    lines, k = _line(text, chance)
    key = lines[k].partition("=")[0].strip()
    if found := values(key):
        lines[k] = f"{key} = {chance.choice(found)}"
    return "\n".join(lines)


def _in_a_text(change: Callable[[str, random.Random], str]) -> Callable[[str, random.Random], str]:
    """A change inside of one text in quotes."""

    def changed(text: str, chance: random.Random) -> str:
        spans = [found.span(1) for found in re.finditer(r'"([^"\n]*)"', text)]
        if not spans:
            return text
        start, end = chance.choice(spans)
        return text[:start] + change(text[start:end], chance) + text[end:]

    return changed


@_in_a_text
def _odd_value(text: str, chance: random.Random) -> str:
    return chance.choice(ODD_VALUES)


@_in_a_text
def _other_sign(text: str, chance: random.Random) -> str:
    places = [found.span() for found in re.finditer(r"\*\*|[-+*/]", text)]
    if not places:
        return f"-({text})"
    start, end = chance.choice(places)
    return text[:start] + chance.choice(SIGNS) + text[end:]


@_in_a_text
def _odd_factor(text: str, chance: random.Random) -> str:
    return f"{chance.choice(('0', '-1', '2', 'pi', '1/3', '-2'))}*({text})"


def _other_word(text: str, chance: random.Random) -> str:
    """One name of an expression for another name of the file."""
    found = list(WORD.finditer(text))
    one, other = chance.choice(found), chance.choice(found)
    return text[: one.start()] + other.group() + text[one.end() :]


def _renamed(text: str, chance: random.Random) -> str:
    """A name for a letter that the program writes itself, wherever it stands."""
    name = chance.choice(re.findall(r"^(\w+)\s*=", text, re.M) + re.findall(r"^\[\w+\.(\w+)\]", text, re.M) or ["x"])
    return re.sub(rf"\b{name}(?=\b|_dot\b)", chance.choice(ODD_NAMES), text)


def _characters(text: str, chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    end = min(len(text), at + chance.choice((0, 1, 1, 3)))
    return text[:at] + chance.choice(('"', "'", "[", "]", "{", "}", "=", ",", "\n", "é", "\\", "x", "")) + text[end:]


CHANGES = (
    _lose_a_line, _lose_a_table, _add_a_table, _other_value, _other_value, _odd_value, _odd_value, _other_sign,
    _odd_factor, _other_word, _renamed, _characters,
)  # fmt: skip


class TooLong(Exception):
    """A mutant that is not done within the time."""


@contextmanager
def within(seconds: int):
    """Raises TooLong after so many seconds of the processor (in the main thread of Unix)."""

    def stop(*_: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def fault(text: str, *, simulation: bool = False) -> str:
    """What is wrong with how a text is met: "" if it is derived, or refused with a sentence."""
    told: list[str] = []

    def run() -> int:
        try:
            return _derived(text, simulation)
        except RbpsymError as error:
            told.append(str(error))
            raise
        except TooLong:
            raise
        except Exception:
            told.append(traceback.format_exc())
            raise

    try:
        with within(SECONDS), redirect_stderr(StringIO()):
            code = exit_code(run)
    except TooLong:
        return f"not done within {SECONDS} s"
    if code not in ENDINGS:
        return told[-1] if told else f"exit code {code}"
    if told and not told[-1].strip():
        return "refused without a word"
    return ""


def _derived(text: str, simulation: bool) -> int:
    """The exit code of a derivation, its results as JSON and as text, and its notes."""
    from rbpsym.commands.solve import lines
    from rbpsym.derive import derive
    from rbpsym.solve import answer_of
    from rbpsym.statement import load_text

    problem = load_text(text, file="mutant.toml")
    derivation = derive(problem, simulation=simulation)
    answer = answer_of(derivation)
    json.dumps(answer)
    assert all(isinstance(line, str) for line in lines(answer, problem))
    assert writer("tex")(notes(derivation))
    return 0 if answer["verdicts"]["proved"] == answer["verdicts"]["steps"] else 1

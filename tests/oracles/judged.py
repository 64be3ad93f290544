"""A random system derived and put to every oracle; what is refused gets a sentence, and nothing that is told is false."""

from __future__ import annotations

from dataclasses import dataclass, field
from zlib import crc32

from rbpsym.derive import derive
from rbpsym.document.notes import notes
from rbpsym.document.writers.terminal import plain_lines
from rbpsym.errors import LimitError, RbpsymError
from rbpsym.statement.loader import load_text
from tests.oracles.compare import each, findings
from tests.oracles.work import TooHeavy, at_most

OUTCOMES = ("proved", "undecided", "refused", "too heavy", "false")
SETS, LONGEST = 2, 6.0
CLOSE = 1e-6


@dataclass
class Judged:
    """`wrong`: false verdicts and crashes; `refused`: the sentence of a refusal; `open_`: what was not decided.

    What is too heavy was not ended.
    """

    text: str
    wrong: list[str] = field(default_factory=list)
    refused: str = ""
    is_too_heavy: bool = False
    open_: list[str] = field(default_factory=list)
    sets: int = 0
    compared: int = 0

    @property
    def outcome(self) -> str:
        """One of OUTCOMES."""
        if self.wrong or self.is_too_heavy:
            return "false" if self.wrong else "too heavy"
        return "refused" if self.refused else "undecided" if self.open_ else "proved"


MOST = 600_000  # of work (see tests.oracles.work): some seconds


def judged(text: str, most: int = MOST) -> Judged:
    """What is wrong with the derivation of a statement."""
    try:
        with at_most(most):
            return _judged(text)
    except TooHeavy:
        return Judged(text, is_too_heavy=True)


def _judged(text: str) -> Judged:
    found = Judged(text)
    try:
        derivation = derive(load_text(text))
    except LimitError as error:
        found.refused = f"limit: {error.what}"
        return found
    except RbpsymError as error:
        found.refused = error.what
        return found
    except Exception as error:  # whatever it is: a refusal has a sentence
        found.wrong.append(f"crash: {type(error).__name__}: {error}")
        return found
    for step in derivation.all_steps:
        verdict = step.certificate.verdict
        if verdict.is_refuted:
            found.wrong.append(f"step {step.id} is refuted")
        elif not verdict.is_proved:
            found.open_.append(step.id)
    for name, verdict in derivation.agreement.items():
        found.wrong += [f"the method {name} differs"] if verdict.is_refuted else []
    if derivation.lagrange is not None and derivation.lagrange.is_refuted:
        found.wrong.append("Lagrange's equations differ")
    try:
        list(plain_lines(notes(derivation, detail="full")))
    except Exception as error:
        found.wrong.append(f"crash of the notes: {type(error).__name__}: {error}")
    report = derivation.simulation
    if report is not None and not report.max_relative_error <= CLOSE:
        worst = max(report.errors, key=lambda key: report.errors[key], default="drift")
        found.wrong.append(f"the simulation differs by {report.max_relative_error:.1e}: {worst}")
    try:
        seen = findings(derivation.study, SETS, LONGEST, seed=crc32(text.encode()))
    except RbpsymError as error:
        found.open_.append(error.what)
        return found
    except Exception as error:
        found.wrong.append(f"crash of the comparison: {type(error).__name__}: {error}")
        return found
    found.sets, found.compared = seen.sets, len(seen.compared)
    found.wrong += list(each(seen))
    return found

"""The reading of a question: the texts in the engine's language that it may mean, of those that leave the least unread."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache, partial

from rbpsym.ask.question import LONGEST
from rbpsym.ask.words.chart import Chart, Heard, Meaning, Node, Parsed, compiled, tokens
from rbpsym.ask.words.clauses import CLAUSES
from rbpsym.ask.words.lexicon import GROUND, ROLES, Lexicon, Phrases
from rbpsym.ask.words.means import MEANINGS
from rbpsym.ask.words.nouns import NOUNS
from rbpsym.ask.words.questions import QUESTIONS
from rbpsym.ask.words.verbs import patterns
from rbpsym.decide.dimensions import dimension_of
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.quantities import LENGTH, NUMBER, TIME
from rbpsym.statement.model import Problem

UNREAD, MOST_UNREAD = 4, 16  # what a word costs that is taken as it is written, and what a reading may cost
NAMED = ("Body", "Coord", "Par", "Point", "Force", "Element", "Contact", "Blow", "Begin", "Begun", "Phase", "Struck", "Each", "Several", "Pair")
GROUNDS = (
    f"{GROUND}|wall|incline|slope|ramp|hill|dome|bowl|loop|circle|sphere|wedge|edge|corner|step|peg|hoop|guide|wire|cylinder|drum|"
    "curve|tube|bar|rod"
)
A_NOUN = "distance|height|time|speed|angle|function|full|complete|length|force|turn|revolution|depth|way"
VALUES = {"Length": LENGTH, "Angle": NUMBER, "Time": TIME, "SpeedValue": LENGTH / TIME, "TurnValue": NUMBER / TIME}


@cache
def grammar() -> dict[str, list[tuple[Node, str, int]]]:
    """The rows of the grammar by name, with what each costs."""
    rows: dict[str, list[tuple[Node, str, int]]] = {}
    for line in re.sub(r"\n {4,}", " ", QUESTIONS + CLAUSES + NOUNS).splitlines():
        if line and not line[0].isspace():
            name = line
        elif line:
            rows.setdefault(name, []).append(_row(line))
    for name, row in patterns().items():
        rows[name] = [_row(row)]
    rows["RoleNoun"] = [_row(f"({'|'.join(words for words, _ in ROLES.values())}):x -> {{x}}")]
    rows["Ground"] = [_row(f"({GROUNDS}):x -> {{x}}")]
    rows["Floor"] = [_row(f"({GROUND}):x -> {{x}}")]
    rows["It"] = [_row("(it|he|she) -> @it")]
    return rows


def _row(line: str) -> tuple[Node, str, int]:
    pattern, _, meaning = line.strip().partition(" ->")
    meaning, _, cost = meaning.partition(" !")
    return compiled(re.sub(r"(?<=[\s\[(|])an? ", "", pattern)), meaning.strip(), int(cost or 0)


def read(problem: Problem, text: str) -> list[str]:
    """What a question may mean, in the engine's language: all readings that leave the least unread; none where too much is."""
    if len(text) > LONGEST:
        return []
    plain, lexicon = _plain(problem, text), Lexicon(problem)
    words = tokens(plain)
    lexicon.it = _it(lexicon, words)
    finders: dict[str, Callable[[list[Heard], int], Iterator[Parsed]]] = {
        **{kind: partial(_phrase, found) for kind, found in lexicon.finders(NAMED).items()},
        **{kind: partial(_value, problem, plain, dimension, False) for kind, dimension in VALUES.items()},
        "Value": partial(_value, problem, plain, None, False),
        "Formula": partial(_value, problem, plain, None, True),
        "Raw": partial(_raw, plain),
    }
    functions: dict[str, Meaning] = {name: partial(find, lexicon) for name, find in MEANINGS.items()}
    functions["it"] = lambda caps: lexicon.it or "it"
    rules = {name: [(node, functions.get(meaning[1:], meaning), cost) for node, meaning, cost in rows]
             for name, rows in grammar().items()}  # fmt: skip
    found = {spoken: cost for one, cost in Chart(plain, rules, finders).read("Question").items() if (spoken := _ordered(one))}
    least = min(found.values(), default=MOST_UNREAD)
    return [one for one, cost in found.items() if cost == least < MOST_UNREAD]


PLURAL = re.compile(r"(?:\w+ )?(?:tensions|forces|reactions|speeds|velocities|accelerations)\b")


def spread(problem: Problem, text: str) -> list[str]:
    """The questions that one in the plural asks: “tensions” is the tension of each string."""
    return (read(problem, text) if PLURAL.match(text) else []) or [text]


def _plain(problem: Problem, text: str) -> str:
    plain = " ".join(text.split()).rstrip(" ?.").replace("°", " deg")
    first, *_ = plain.split(" ", 1) or [""]
    if first not in problem.dimensions and first.lower() != first and first.isalpha() and len(first) > 1:
        plain = plain[0].lower() + plain[1:]
    plain = re.sub(r"\b(?:the|an) (?=\S)", "", plain)
    if "a" in problem.dimensions:
        return re.sub(rf"\ba (?=(?:{A_NOUN})\b)", "", plain)
    return re.sub(r"\ba (?=[A-Za-z])", "", plain)


def _it(lexicon: Lexicon, words: list[Heard]) -> str:
    """Whom “it” may mean: the only body, or else coordinate, that is named, or the only one there is."""
    for kind in ("Body", "Coord"):
        named = {one.text for at in range(len(words)) for one in _phrase(lexicon.finders([kind])[kind], words, at)}
        if len(named) == 1:
            return named.pop()
        if named:
            return ""
    names = lexicon.problem.body_names
    return names[0] if len(names) == 1 else ""


def _phrase(known: Phrases, words: list[Heard], at: int) -> Iterator[Parsed]:
    for phrase, names in known.items():
        if at < len(words) and phrase[0] == words[at].word and phrase == tuple(one.word for one in words[at : at + len(phrase)]):
            yield from (Parsed(at + len(phrase), name, 0) for name in names)


def _value(problem: Problem, plain: str, dimension: object, is_formula: bool, words: list[Heard], at: int) -> Iterator[Parsed]:
    """A formula in the parameters (a formula in all names: in more than one of them)."""
    for to in range(at + 1, min(at + 16, len(words)) + 1):
        said, known = plain[words[at].begin : words[to - 1].end], problem.dimensions
        if words[to - 1].word in ("=", "<", ">", ",", ">=", "<=") or (words[to - 1].word.isalpha() and len(words[to - 1].word) > 4
                                                                      and words[to - 1].word not in known):  # fmt: skip
            return
        with suppress(RbpsymError):
            node = read_infix(said, [*known])
            used = t.names(node)
            if is_formula and (not used or to == at + 1):
                continue
            if used <= {*known, "pi"} and (dimension is None or dimension_of(node, known) == dimension):
                yield Parsed(to, said, 0)


def _raw(plain: str, words: list[Heard], at: int) -> Iterator[Parsed]:
    ends = range(at + 1, len(words) + 1)
    yield from (Parsed(to, plain[words[at].begin : words[to - 1].end], UNREAD * (to - at)) for to in ends)


def _ordered(text: str) -> str | None:
    """The clauses of a question in the order of the engine's language: phase, moment, function, manner, values; None where one
    stands twice."""
    head, *clauses = re.split(r"\s*<(?=\d>)", text)
    if len({one[0] for one in clauses}) < len(clauses):
        return None
    return " ".join((head, *(one[2:].strip() for one in sorted(clauses)))).strip()

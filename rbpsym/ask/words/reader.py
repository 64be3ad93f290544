"""The reading of a question: the texts in the engine's language that it may mean, of those that leave the least unread."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache, partial

from rbpsym.ask.question import LONGEST
from rbpsym.ask.words.chart import UNREAD, Chart, Heard, Meaning, Node, Parsed, compiled, tokens
from rbpsym.ask.words.clauses import CLAUSES
from rbpsym.ask.words.lexicon import GROUND, ROLES, Lexicon, Phrases
from rbpsym.ask.words.means import MEANINGS
from rbpsym.ask.words.motions import MOTIONS
from rbpsym.ask.words.nouns import NOUNS
from rbpsym.ask.words.questions import QUESTIONS
from rbpsym.ask.words.verbs import patterns
from rbpsym.decide.dimensions import dimension_of
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.quantities import LENGTH, NUMBER, TIME
from rbpsym.statement.model import Problem

MOST_UNREAD = 16  # what a reading may cost
NAMED = (
    "Body",
    "Coord",
    "Par",
    "Point",
    "Force",
    "Element",
    "Contact",
    "Blow",
    "Begin",
    "Begun",
    "Phase",
    "Struck",
    "Each",
    "Several",
    "Pair",
    "Chosen",
)
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
    rows["It"] = [_row("(it|he|she|him|her) -> @it")]
    return rows


def _row(line: str) -> tuple[Node, str, int]:
    pattern, _, meaning = line.strip().partition(" ->")
    meaning, _, cost = meaning.partition(" !")
    return compiled(re.sub(r"(?<=[\s\[(|])an? ", "", pattern)), meaning.strip(), int(cost or 0)


def read(problem: Problem, text: str) -> list[str]:
    """What a question may mean, in the engine's language: all readings that leave the least unread; none where too much is."""
    chart = _chart(problem, text) if len(text) <= LONGEST else None
    readings = chart.read("Question") if chart else {}
    found = {spoken: cost for one, cost in readings.items() if (spoken := _ordered(one))}
    least = min(found.values(), default=MOST_UNREAD)
    return [one for one, cost in found.items() if cost == least < MOST_UNREAD]


def unread(problem: Problem, text: str) -> tuple[str, str] | None:
    """What is understood of the beginning of a question, and the rest that is not; None where no quantity stands there."""
    chart = _chart(problem, text) if len(text) <= LONGEST else None
    begun = [*chart.begun("Ask", 0), 0] if chart else []
    ends = max((to for at in begun for name in ("State", "Gone") for to in chart.begun(name, at)), default=0) if chart else 0
    if chart is None or not ends or ends == len(chart.words):
        return None
    cut = chart.words[ends].begin
    return chart.text[:cut].rstrip(" ,"), chart.text[cut:]


def _chart(problem: Problem, text: str) -> Chart:
    plain, lexicon = _plain(problem, text), Lexicon(problem)
    words = tokens(plain)
    lexicon.it = _it(lexicon, words)
    finders: dict[str, Callable[[list[Heard], int], Iterator[Parsed]]] = {
        **{kind: partial(_phrase, found) for kind, found in lexicon.finders(NAMED).items()},
        **{kind: partial(_value, problem, plain, dimension, False) for kind, dimension in VALUES.items()},
        "Value": partial(_value, problem, plain, None, False),
        "Formula": partial(_value, problem, plain, None, True),
        "Raw": partial(_raw, plain),
        "Stranger": partial(_stranger, lexicon),
    }
    functions: dict[str, Meaning] = {name: partial(find, lexicon) for name, find in {**MEANINGS, **MOTIONS}.items()}
    functions["it"] = lambda caps: lexicon.it or "it"
    rules = {name: [(node, functions.get(meaning[1:], meaning), cost) for node, meaning, cost in rows]
             for name, rows in grammar().items()}  # fmt: skip
    return Chart(plain, rules, finders)


PLURAL = re.compile(
    r"(?:\w+ )?(?:tensions|components|horizontal and vertical components|forces|reactions|speeds|velocities|accelerations)\b"
    r"|.*\bof each\b|.*\bneither\b.* nor |.*\b(?:slipping|sliding) (?:or|and) "
)


def spread(problem: Problem, text: str) -> list[str]:
    """The questions that one in the plural asks: “tensions” is the tension of each string."""
    return (read(problem, text) if PLURAL.match(text) else []) or [text]


def _plain(problem: Problem, text: str) -> str:
    plain = " ".join(text.split()).rstrip(" ?.").replace("°", " deg")
    first, *_ = plain.split(" ", 1) or [""]
    if first not in problem.dimensions and first.lower() != first and first.isalpha() and len(first) > 1:
        plain = plain[0].lower() + plain[1:]
    plain = re.sub(r"\b(?:the|an) (?=\S)", "", plain)
    plain = re.sub(r"\b([\w.-]+)['’]s ((?:own |angular |upper |lower )?\w+)", r"\2 of \1", plain)
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


def _stranger(lexicon: Lexicon, words: list[Heard], at: int) -> Iterator[Parsed]:
    """A noun that names nothing of the problem: “ledge”."""
    if (
        at < len(words)
        and (word := words[at].word).isalpha()
        and len(word) > 2
        and word not in NO_NOUNS
        and not lexicon.knows(word)
    ):
        yield Parsed(at + 1, word, 0)


NO_NOUN = """and the for with when where after before until which that just its than relative not never only almost again first
second third last initial final total net average mean maximum minimum twice half double normal tangential horizontal vertical
angular upper lower left right other kinetic static"""
NO_NOUNS = {
    *GROUND.split("|"),
    *NO_NOUN.split(),
}


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

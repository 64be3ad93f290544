"""Sentences with places for formulas, in the reader's language.

`phrase("rule.integrate", "en", variable=node)` looks up a template such as
"We integrate over {variable}." and fills its places. A phrase with variants is a table in the
TOML file (`one = ...`, `many = ...`); `count=` chooses by the language's plural rule, `variant=`
by name, and `masculine` and `feminine` go by the noun in the first place (`document.grammar`).
`*words*` in a template are emphasised. Nothing is ever glued together in code.

What may fill a place: a Node (a formula), a str or int, an inline (Ref, Emph, ...), a tuple of
inlines (a phrase, put in as it is), a list of any of these (joined: "a, b and c").
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from difflib import get_close_matches
from functools import cache
from string import Formatter
from types import MappingProxyType
from typing import Any

from rbpsym.document import model as d
from rbpsym.expr.glyphs import MARKS, Notation, notation_for
from rbpsym.expr.tree import Node, Word, walk
from rbpsym.frozen import Frozen, field
from rbpsym.languages import part_of, phrases
from rbpsym.statement.model import Problem
from rbpsym.statement.own_text import letters_of


@cache
def usual_notation(language: str) -> Notation:
    """The notation of a language, as its phrases tell it under [notation], [functions] and [spoken]."""
    table = phrases(language)
    marks = {key: table[f"notation.{key}"] for key in MARKS if f"notation.{key}" in table}
    parts = {part: MappingProxyType(part_of(part, language)) for part in ("functions", "spoken")}
    return replace(notation_for((), marks), functions=parts["functions"], words=parts["spoken"])


def common_notation(
    problems: Iterable[Problem], language: str, said: Mapping[str, str] = MappingProxyType({})
) -> Notation:
    """The notation of several problems together, which should agree on names that they share; `said` overrides it."""
    problems = tuple(problems)
    own = {name for p in problems for name in letters_of(p).names}
    aliases = {name: drawn for p in problems for name, drawn in p.notation.items()}
    names = {name: word for p in problems for name, word in p.names_in(language).items()}
    found = notation_for(own, {**aliases, **said}, usual_notation(language))
    return replace(found, names=MappingProxyType(names))


def problem_notation(problem: Problem, language: str = "en") -> Notation:
    """How the names of a problem are printed in a language."""
    return common_notation((problem,), language)


# --- Sentences with places for formulas, in the reader's language


# --- the grammar of a language, as its phrases file tells it under [grammar]: number, gender, contractions


class Grammar(Frozen):
    """How words change beside others.

    `singular` are the numbers that take the form `one`; the gender of a phrase is that of the first word like `noun`: as
    `genders` tell of it, else of how it ends (the longest first), else masculine; `cases`: by name, what becomes what, in
    order; `contractions` are what words that meet become (“de el”: “del”); the last “and” of a list is `other_last`
    before the `sound` (a regular expression), else `last`.
    """

    last: str = ", "
    other_last: str = ""
    sound: str = ""
    noun: str = r"\w+"
    singular: frozenset[int] = frozenset({1})
    genders: Mapping[str, str] = field(default_factory=dict)
    endings: tuple[tuple[str, str], ...] = ()
    cases: Mapping[str, tuple[tuple[str, str], ...]] = field(default_factory=dict)
    contractions: Mapping[str, str] = field(default_factory=dict)

    def number(self, count: int) -> str:
        """ "one" or "many"."""
        return "one" if count in self.singular else "many"

    def gender(self, phrase: str) -> str:
        """The gender of a noun phrase.

        >>> Grammar(endings=(("a", "feminine"),), genders={"mapa": "masculine"}).gender("la cuña")
        'feminine'
        """
        found = re.search(self.noun, phrase)
        word = found[0].lower() if found else ""
        return self.genders.get(word) or next((name for end, name in self.endings if word.endswith(end)), "masculine")

    def declined(self, phrase: str, case: str) -> str:
        """Noun phrases in another case than that of a subject.

        >>> Grammar(cases={"acc": (("^der ", "den "),)}).declined("der Stab", "acc")
        'den Stab'
        """
        parts = re.split(f"({re.escape(self.last)}|, )", phrase)
        for pattern, told in self.cases.get(case, ()):
            parts[::2] = [re.sub(pattern, told, part) for part in parts[::2]]
        return "".join(parts)

    def contracted(self, text: str) -> str:
        """The text with its contractions.

        >>> Grammar(contractions={"de el": "del"}).contracted("De el centro de el disco")
        'Del centro del disco'
        """
        for meeting, short in self.contractions.items():
            first, rest = re.escape(meeting[1:]), short[1:]
            text = re.sub(rf"\b({meeting[0]}|{meeting[0].upper()}){first}\b", rf"\g<1>{rest}", text)
        return text

    def last_and(self, word: str) -> str:
        """What stands before the last item of a list."""
        return self.other_last if self.sound and re.match(self.sound, word, re.IGNORECASE) else self.last


GENDERS = ("masculine", "feminine", "neuter")


def grammar_of(table: Mapping[str, str]) -> Grammar:
    """The grammar in the phrases of a language (dotted keys)."""

    def several(key: str) -> tuple[str, ...]:
        return tuple(table.get(f"grammar.{key}", "").split())

    def entries(part: str) -> Iterator[tuple[str, str]]:
        prefix = f"grammar.{part}."
        return ((key.removeprefix(prefix), text) for key, text in table.items() if key.startswith(prefix))

    cases: dict[str, tuple[tuple[str, str], ...]] = {}
    for key, told in entries("cases"):
        case, _, pattern = key.partition(".")
        cases[case] = (*cases.get(case, ()), (pattern, told))
    endings = [(end, gender) for gender in GENDERS for end in several(f"{gender}_endings")]
    return Grammar(
        last=table["list.last"],
        other_last=table.get("grammar.other_last", ""),
        sound=table.get("grammar.sound", ""),
        noun=table.get("grammar.noun", r"\w+"),
        singular=frozenset(map(int, several("singular"))) or frozenset({1}),
        genders={word: gender for gender in GENDERS for word in several(f"{gender}_words")},
        endings=tuple(sorted(endings, key=lambda pair: -len(pair[0]))),
        cases=cases,
        contractions=dict(entries("contractions")),
    )


# ---


DECIMAL_COMMA = re.compile(r"\d,\d")
INLINES = (d.Text, d.Math, d.Ref, d.Emph, d.Strong)


@cache
def grammar(language: str) -> Grammar:
    """The grammar that the file of a language tells."""
    return grammar_of(phrases(language))


def phrase(key: str, language: str = "en", **slots: object) -> d.Inlines:
    """The phrase `key` with its places filled. Raises DocumentError for a missing key or slot."""
    return phrase_of("notes", key, language, slots)


OPTIONAL = re.compile(r"\[([^][]*)\]")  # a part in square brackets is said where all its places are filled


def places(text: str) -> set[str]:
    """The names of the places in a template."""
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def phrase_of(part: str, key: str, language: str, slots: Mapping[str, object]) -> d.Inlines:
    """The same of the phrases in one part of a language (those of documents stand in “notes”)."""
    text = OPTIONAL.sub(lambda told: told[1] if places(told[1]) <= slots.keys() else "", template(key, language, slots, part))
    return contracted(merged(filled(text, key, language, slots)), language)


def plain(key: str, language: str = "en", **slots: object) -> str:
    """A phrase that holds nothing but text, as a string (captions of tables, verdict words)."""
    return text_of(phrase(key, language, **slots), key)


def text_of(inlines: d.Inlines, key: str) -> str:
    """Inlines that are nothing but text, as a string."""
    texts = [inline.text for inline in inlines if isinstance(inline, d.Text)]
    if len(texts) < len(inlines):
        raise d.DocumentError(f"phrase “{key}” is more than text")
    return "".join(texts)


def has_phrase(key: str, language: str = "en") -> bool:
    """Is there a phrase (or one with variants) under this key?"""
    table = phrases(language)
    return key in table or any(name.startswith(f"{key}.") for name in table)


def template(key: str, language: str, slots: Mapping[str, object], part: str = "notes") -> str:
    """The template of `key`, in the variant that the slots ask for."""
    table = phrases(language, part)
    wanted = f"{key}.{variant(language, slots)}"
    if wanted in table:
        return table[wanted]
    if key in table:
        return table[key]
    if "variant" not in slots and f"{key}.masculine" in table:
        return table[f"{key}.{grammar(language).gender(first_noun(table[f'{key}.masculine'], slots))}"]
    near = get_close_matches(wanted.rstrip("."), table, n=1)
    what = f"no phrase “{wanted.rstrip('.')}” in “{language}”"
    raise d.DocumentError(what, instead=f"did you mean “{near[0]}”?" if near else f"add it to languages/{language}/{part}.toml.")


def variant(language: str, slots: Mapping[str, Any]) -> str:
    """The name of the variant: given, or chosen by the count; "" if neither is there."""
    if "variant" in slots:
        return str(slots["variant"])
    return grammar(language).number(slots["count"]) if "count" in slots else ""


def first_noun(text: str, slots: Mapping[str, object]) -> str:
    """The words in the first place of a template."""
    name = next((name for _, name, _, _ in Formatter().parse(text) if name), "")
    value = slots.get(name, "")
    found = value if isinstance(value, tuple) else (value,)
    return "".join(item.text if isinstance(item, d.Text) else str(item) for item in found)


def contracted(inlines: d.Inlines, language: str) -> d.Inlines:
    """The inlines with the contractions of the language made inside each text."""
    contract = grammar(language).contracted
    return tuple(d.Text(contract(inline.text)) if isinstance(inline, d.Text) else inline for inline in inlines)


def last_and(item: d.Inlines, language: str) -> str:
    """The word before the last item of a list, as its first sound asks."""
    return grammar(language).last_and(item[0].text if isinstance(item[0], d.Text) else "")


def filled(text: str, key: str, language: str, slots: Mapping[str, object]) -> Iterator[d.Inline]:
    """The inlines of a template: words, emphasised words and filled places."""
    for position, part in enumerate(text.split("*")):
        inner = pieces(part, key, language, slots)
        if position % 2:
            yield d.Emph(merged(inner))
        else:
            yield from inner


def pieces(text: str, key: str, language: str, slots: Mapping[str, object]) -> Iterator[d.Inline]:
    """The inlines of a template without emphasis."""
    for literal, name, case, _ in Formatter().parse(text):
        yield d.Text(literal)
        if name is None:
            continue
        if name not in slots:
            raise d.DocumentError(f"phrase “{key}” needs a value for “{name}”")
        yield from inlines_of(slots[name], language, case or "")


def inlines_of(value: object, language: str, case: str = "") -> d.Inlines:
    """What stands in a place for a value, in the case that the place asks for ({body:gen})."""
    if isinstance(value, tuple) and value and all(isinstance(item, INLINES) for item in value):
        return declined(value, language, case)
    if isinstance(value, (list, tuple)):
        return joined([inlines_of(item, language, case) for item in value], language)
    node = d.Math(value) if isinstance(value, Node) else value
    return declined((node if isinstance(node, INLINES) else d.Text(str(node)),), language, case)


def declined(inlines: d.Inlines, language: str, case: str) -> d.Inlines:
    """A noun phrase in a case; it begins with a formula where it begins with no text."""
    is_text = isinstance(inlines[0], d.Text)
    head = inlines[0].text if isinstance(inlines[0], d.Text) else ""
    return (d.Text(grammar(language).declined(head, case)), *inlines[is_text:]) if case else inlines


def joined(items: list[d.Inlines], language: str) -> d.Inlines:
    """ "a, b and c" by the language's rule (`list.separator`, `list.numbers` and `list.last` of its phrases)."""
    found: list[d.Inline] = []
    comma = phrases(language)["list.numbers" if any(map(has_decimal_comma, items)) else "list.separator"]
    for position, item in enumerate(items):
        is_last = position == len(items) - 1
        link = last_and(item, language) if is_last else comma
        found += [d.Text(link)] if position else []
        found += item
    return tuple(found)


def has_decimal_comma(item: d.Inlines) -> bool:
    """Is there a number in it with a decimal comma, which a comma behind would be taken for?"""
    texts = (
        part.text
        for inline in item
        if isinstance(inline, d.Math)
        for part in walk(inline.node)
        if isinstance(part, Word)
    )
    return any(DECIMAL_COMMA.search(text) for text in texts)


def merged(inlines: Iterator[d.Inline]) -> d.Inlines:
    """The inlines with neighbouring texts joined and empty ones dropped."""
    found: list[d.Inline] = []
    for inline in inlines:
        if isinstance(inline, d.Text) and found and isinstance(found[-1], d.Text):
            found[-1] = d.Text(found[-1].text + inline.text)
        elif inline != d.Text(""):
            found.append(inline)
    return tuple(found)

"""Texts of a file: one for all languages, or one a language; [names.es]: what bodies, points and phases are called there."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.statement.model import Problem
from rbpsym.statement.source import SourceTable, did_you_mean


def worded(table: SourceTable, key: str, default: str = "") -> Mapping[str, str]:
    """A text by language; one that is not told apart is taken for English."""
    if not isinstance(table.data.get(key), Mapping):
        return {"en": table.string(key, default)}
    texts = strings(table, key)
    check_languages(table.table(key, key), f'write {key} = {{ en = "...", es = "..." }}')
    return texts


def check_languages(section: SourceTable, cure: str) -> None:
    """The keys of a table by language are codes of languages."""
    for language in section.names():
        if not re.fullmatch(r"[a-z]{2,3}", language):
            raise section.error(f"“{language}” is no language", cure, language)


def strings(table: SourceTable, key: str) -> dict[str, str]:
    """A table of texts."""
    section = table.table(key, f"“{key}”")
    return {name: section.string(name) for name in section.names()}


_WORD = re.compile(r"[^\W\d_]\w*")


def check_translated_names(problem: Problem, table: SourceTable) -> None:
    """[names] speaks of what exists; in a language no two bodies or forces are called alike."""
    section = table.table("names", "names")
    in_formulas = (*problem.body_names, *(e.name for e in problem.elements))
    elsewhere = (
        *problem.points,
        *(p for body in problem.bodies for p in body.points),
        *(p.name for p in problem.phases),
    )
    for language in section.names():
        own = section.table(language, f"names.{language}")
        for name in own.names():
            _check_known(name, (*in_formulas, *elsewhere), own)
            if name in in_formulas:
                _check_word(name, own)
    for language in {*problem.meanings, *problem.names}:
        _check_distinct(problem.names_in(language), in_formulas, language, table)


def _check_known(name: str, known: tuple[str, ...], own: SourceTable) -> None:
    if name not in known:
        what = f"[{'.'.join(map(str, own.path))}] speaks of “{name}”, which is no body, force, point or phase"
        raise own.error(what, did_you_mean(name, known, "names"), name)


def _check_word(name: str, own: SourceTable) -> None:
    word = own.string(name)
    if not _WORD.fullmatch(word):
        raise own.error(
            f"“{word}” can't stand in a formula as the name of “{name}”",
            "give one word; the words of sentences stand in [meanings].",
            name,
        )


def _check_distinct(names: Mapping[str, str], in_formulas: tuple[str, ...], language: str, table: SourceTable) -> None:
    """Two things that are called alike could not be told apart in a formula."""
    called = {name: names.get(name, name) for name in in_formulas}
    for name, word in called.items():
        others = [other for other, said in called.items() if said == word and other != name]
        if others:
            raise table.error(
                f"in “{language}” both “{name}” and “{others[0]}” are called “{word}”",
                f'give each a name of its own: [names.{language}] and, below it, {name} = "..."',
                "names" if "names" in table else "meanings",
            )

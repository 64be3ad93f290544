"""The index of positions agrees with tomllib on every key, value and character."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator

import pytest

from rbpsym.statement.positions import Path, index_positions

TEXTS = {
    "dotted": 'a.b.c = "x"\na . "d e" = \'y\'',
    "tables": '[a]\nb = "x"\n[a.c]\nd = "y"\n["q.r".s]\nt = 1',
    "lists of tables": '[[a]]\nb = "x"\n[[a]]\nb = "y"\n[a.c]\nd = "z"\n[[a.e]]\nf = "u"\n[[a.e]]\nf = "v"',
    "inline": 'a = { b = "x", c = { d = "y" }, "e f" = [1, "z"] }',
    "list": 'a = [ # [ ]\n "x", # "no"\n\n ["y", \'z\'],\n]\nb = "u"',
    "escapes": 'a = "q\\"q\\\\ \\u00e9 \\U0001F600 é"\nb = \'\\n\'',
    "long": 'a = """\nx\n  "y" \\\n   z"""\nb = \'\'\'u\nv\'\'\'\nc = """q"""""',
    "others": "a = 1_000 # c\nb = 1979-05-27T07:32:00Z\nc = [true, 1e5]\nd = -inf",
    "empty": "",
    "comments": '# a = "x"\n\t a\t=\t"y" # b = "z"\n',
    "empty things": "a = []\nb = {}\nc = ''\n[d]\n[[e]]",
}


def leaves(data: object, path: Path = ()) -> Iterator[tuple[Path, object]]:
    pairs = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else None
    if pairs is None:
        yield path, data
    for key, part in pairs or ():
        yield from leaves(part, (*path, key))


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_agrees_with_tomllib(text: str) -> None:
    index = index_positions(text)
    found = dict(leaves(tomllib.loads(text)))
    assert set(found) <= set(index.values)
    for path, value in found.items():
        start, width = index.value(path)
        source = text[start : start + width]
        assert tomllib.loads(f"it = {source}")["it"] == value


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_every_character_of_a_string(text: str) -> None:
    index = index_positions(text)
    for path, value in leaves(tomllib.loads(text)):
        if isinstance(value, str):
            offsets = index.strings[path]
            assert len(offsets) == len(value) + 1
            assert all(text[at] == char or text[at] == "\\" for at, char in zip(offsets, value, strict=False))


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_every_key(text: str) -> None:
    index = index_positions(text)
    for path, _ in leaves(tomllib.loads(text)):
        for length in range(1, len(path) + 1):
            if isinstance(path[length - 1], str):
                start, width = index.key(path[:length])
                assert text[start : start + width].strip("'\"") == path[length - 1]

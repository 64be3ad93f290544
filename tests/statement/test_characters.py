"""Characters that are not seen, or turn the writing round, stand in no text and no name."""

from __future__ import annotations

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.statement import build, load_text
from rbpsym.statement.course import load_course
from tests.statement.sound import SOUND

HIDDEN = [
    "\\u0000",
    "\\u0007",
    "\\u001b",
    "\\u007f",
    "\\u0085",
    "\\u202e",
    "\\u2066",
    "\\u200b",
    "\\u2028",
    "\\ufeff",
    "\\ue000",
]


@pytest.mark.parametrize("char", HIDDEN)
@pytest.mark.parametrize("old", ["mass of the rod", 'en = "All things', '"theta - pi/2"', "[names.es]\n"])
def test_hidden(char: str, old: str) -> None:
    text = SOUND if old in SOUND else SOUND + "\n[names.es]\n"
    new = {"[names.es]\n": f'[names.es]\n"r{char}od" = "x"\n', '"theta - pi/2"': f'"theta{char} - pi/2"'}
    with pytest.raises(RbpsymError, match=f"U\\+{char[2:].upper()}") as found:
        load_text(text.replace(old, new.get(old, f"{old} {char}"), 1), file="file.toml")
    assert found.value.place.column > 1 and found.value.place.line
    assert found.value.instead


def test_from_python() -> None:
    with pytest.raises(RbpsymError, match="not seen"):
        build.problem("p", title="a\u202eb")


def test_in_a_course(tmp_path) -> None:
    path = tmp_path / "course.toml"
    path.write_text('title = "a\\u202eb"\n[[part]]\ntheory = "general"\n')
    with pytest.raises(RbpsymError, match="not seen"):
        load_course(path)


def test_line_breaks_and_letters_of_all_languages_may_stand() -> None:
    load_text(SOUND.replace("mass of the rod", "masa ñ — 質量 ладонь 😀").replace("title =", "# \ntitle ="))
    load_text(SOUND.replace("mass: mass of the rod", "mass: mass\\nof the rod"))

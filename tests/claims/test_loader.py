"""A wrong claims file gets a sentence with its place."""

from pathlib import Path

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome
from rbpsym.claims.run import Worlds
from rbpsym.errors import RbpsymError
from tests.claims.broken import CHECKING, CLAIM, HEAD, LOADING


@pytest.fixture
def read_claims(tmp_path, monkeypatch):
    """The claims in a text, as the file my.toml."""
    monkeypatch.chdir(tmp_path)

    def read(text):
        Path("my.toml").write_text(text)
        return load_claims(Path("my.toml"))

    return read


@pytest.mark.parametrize("name", LOADING)
def test_what_is_wrong_is_said_with_its_line(name, read_claims):
    text, words = LOADING[name]
    with pytest.raises(RbpsymError) as caught:
        read_claims(text)
    told = str(caught.value)
    assert words in told and told.startswith("my.toml") and caught.value.exit_code == 2


@pytest.mark.parametrize("name", CHECKING)
def test_a_claim_that_cannot_be_read_says_why(name, read_claims):
    old, new, words = CHECKING[name]
    text = (HEAD + CLAIM).replace(old, new)
    [claim] = read_claims(text).claims
    result = Checker(Worlds()).check_safely(claim)
    assert result.outcome in (Outcome.UNREAD, Outcome.NOT_COMPUTED) and not result.expected
    assert words in result.detail


def test_a_sound_file_is_read_with_its_places(read_claims):
    [claim] = read_claims(HEAD + CLAIM).claims
    assert claim.place.line == 11 and claim.printed.place.line == 13
    assert Checker(Worlds()).check(claim).outcome is Outcome.PROVED

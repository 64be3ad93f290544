"""A wrong claims file gets a sentence with its place."""

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.loader import read_claims
from rbpsym.claims.model import Outcome
from rbpsym.claims.run import Worlds
from rbpsym.errors import RbpsymError
from tests.claims.broken import CHECKING, CLAIM, HEAD, LOADING


@pytest.mark.parametrize("name", LOADING)
def test_what_is_wrong_is_said_with_its_line(name):
    text, words = LOADING[name]
    with pytest.raises(RbpsymError) as caught:
        read_claims(text, "my.toml")
    told = str(caught.value)
    assert words in told and told.startswith("my.toml") and caught.value.exit_code == 2


@pytest.mark.parametrize("name", CHECKING)
def test_a_claim_that_cannot_be_read_says_why(name):
    old, new, words = CHECKING[name]
    text = (HEAD + CLAIM).replace(old, new)
    [claim] = read_claims(text, "my.toml").claims
    result = Checker(Worlds()).check_safely(claim)
    assert result.outcome in (Outcome.UNREAD, Outcome.NOT_COMPUTED) and not result.expected
    assert words in result.detail


def test_a_sound_file_is_read_with_its_places():
    [claim] = read_claims(HEAD + CLAIM, "my.toml").claims
    assert claim.place.line == 11 and claim.printed.place.line == 13
    assert Checker(Worlds()).check(claim).outcome is Outcome.PROVED

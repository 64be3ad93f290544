"""The claims that ship: every displayed equation and inline relation decided, every known slip found."""

import pytest

from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome
from rbpsym.statement.library import library_folder
from tests.expr.paper import equations
from tests.library.derived import checked_claims

FILES = sorted((library_folder() / "claims").glob("*.toml"))
PAPER = library_folder() / "claims" / "paper.toml"


@pytest.fixture(scope="module")
def results():
    return {result.id: result for result in checked_claims(PAPER)}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_all_claims_are_as_expected(path):
    found = checked_claims(path)
    wrong = [(result.id, str(result.outcome), result.detail) for result in found if not result.expected]
    assert found and not wrong


def test_the_displayed_equations_are_those_of_the_source(results):
    printed = {claim.number: claim.printed.latex for claim in load_claims(PAPER).claims if claim.number}
    assert {int(number) for number in printed} == set(equations())
    for number, latex in equations().items():
        assert "".join(printed[str(number)].split()) == "".join(latex.split())


def test_all_41_displayed_equations_are_proved(results):
    found = [result for result in results.values() if result.number]
    assert len(found) == 41
    assert all(result.outcome is Outcome.PROVED for result in found)
    assert sum(len(result.links) for result in found) == 61


@pytest.mark.parametrize("erratum", ["E1", "E2", "E3", "E4", "E5", "E6", "E7", "E8", "M1", "M2", "M5", "M9"])
def test_each_slip_is_refuted_with_a_witness_and_its_right_form_proved(results, erratum):
    found = [result for result in results.values() if result.erratum == erratum]
    assert found
    for result in found:
        assert result.outcome is Outcome.REFUTED and result.right == "PROVED"
        assert all("left = " in link.detail for link in result.links)


def test_what_is_no_formula_is_said_and_not_passed(results):
    assert results["axis-to-cm"].outcome is Outcome.NOT_COMPUTED

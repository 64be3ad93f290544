"""The oracles of the library at twenty sets a problem, each motion followed to its end."""

import pytest

from tests.library.derived import FOLLOWED
from tests.oracles.motion import LONGEST
from tests.oracles.test_library import new_gaps, put_to_the_test, wrong

pytestmark = pytest.mark.thorough
MANY = 20


@pytest.mark.parametrize("name", FOLLOWED)
def test_the_motion_is_that_of_the_simulation_at_many_sets(name, record_property):
    found = put_to_the_test(name, MANY, LONGEST, record_property)
    assert not wrong(name, found)
    assert not new_gaps(name, found)

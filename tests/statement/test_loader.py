"""What a file says is what the problem holds."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.expr.tree import ZERO, Num, Sym, names
from rbpsym.quantities import LENGTH, NUMBER, TIME
from rbpsym.statement import find_problem, load_problem, load_text, problem_files
from rbpsym.statement.model import Element, Problem
from tests.statement.numeric import value
from tests.statement.sound import SOUND

ALL = load_text(SOUND, name="all")


def constraint(problem: Problem, name: str) -> Element:
    return next(element for element in problem.constraints if element.name == name)


def load(change: Callable[[str], str]) -> Problem:
    return load_text(change(SOUND))


@pytest.mark.parametrize("path", problem_files().values(), ids=lambda path: path.stem)
def test_library(path) -> None:
    problem = load_problem(path)
    assert problem.name == path.stem
    assert set(problem.title) >= {"en", "es"}
    assert problem.source and problem.level and problem.topic
    assert {*problem.example} == {quantity.name for quantity in problem.parameters}
    assert all(quantity.meaning for quantity in problem.parameters)
    assert not problem.claims


def test_paper_cases_are_there() -> None:
    assert {"rod-and-disk-fixed", "rod-and-disk-free", "sliding-ladder", "sliding-ladder-with-spring"} <= {
        *problem_files()
    }


def test_implicit_constants() -> None:
    found = {quantity.name: quantity for quantity in ALL.parameters if quantity.name in ALL.implicit}
    assert set(found) == {"omega_0", "phi_0"}
    assert found["omega_0"].dimension == NUMBER / TIME
    assert {quantity.sign for quantity in found.values()} == {"real"}


def test_speed_is_zero_unless_said() -> None:
    theta, phi = ALL.coordinates
    assert (theta.speed, phi.speed) == (Sym("omega_0"), ZERO)


def test_signs_and_tables_of_parameters() -> None:
    signs = {quantity.name: quantity.sign for quantity in ALL.parameters}
    assert (signs["m"], signs["M"], signs["F"]) == ("positive", "nonnegative", "real")


@pytest.mark.parametrize("said", ["length < ell, real", "length, real < ell", "length <= ell, real", "length, real ≤ ell"])
def test_sign_and_bound_stand_in_either_order(said: str) -> None:
    text = 'title = "t"\n[parameters]\nell = "length: a"\nd = "' + said + ': b"\nm = "mass: c"\n'
    text += '[coordinates.x]\nmeaning = "p"\ndimension = "length"\n'
    text += '[bodies.bob]\nshape = "particle"\nmass = "m"\ncenter = ["x", "0"]\n'
    d = next(quantity for quantity in load_text(text).parameters if quantity.name == "d")
    assert (d.sign, d.upper, d.lower) == ("real", Sym("ell"), None)


def test_gravity_acts_on_all() -> None:
    assert ALL.interactions[0]["bodies"] == ("rod", "disk", "bob")


def test_keys_in_other_words() -> None:
    """Where the kind has no key of that name: the bodies on which gravity acts, the coefficient of friction."""
    told = load(lambda text: text.replace('[interactions.W]\n', '[interactions.W]\non = "disk"\n'))
    assert next(e for e in told.interactions if e.name == "W")["bodies"] == ("disk",)


def test_pivot_takes_its_place_from_the_pose() -> None:
    assert constraint(ALL, "A")["at"] == (Num(0), Num(0))


def test_pivot_elsewhere_is_left_to_the_mechanics() -> None:
    problem = load(lambda text: text.replace('point = "rod.start"', 'point = "rod.end"'))
    assert constraint(problem, "A")["at"] is None


def test_origins_and_points() -> None:
    assert list(ALL.origins) == ["O", "disk.cm"]
    assert (ALL.origins["disk.cm"].body, ALL.origins["disk.cm"].point) == ("disk", "cm")
    assert list(ALL.points) == ["O", "Q"]


def weld(keys: str, angle: str = 'angle  = "phi"') -> Element:
    joined = f'type   = "weld"\n{keys}\npoints = ["rod.end", "disk.center"]'
    changed = SOUND.replace('type   = "pin"\npoints = ["rod.end", "disk.center"]', joined)
    if not angle:
        changed = changed.replace('angle  = "phi"\n', "").replace('angle  = "theta - pi/2"', 'angle = "theta + phi"')
    return constraint(load_text(changed), "N")


def test_weld() -> None:
    assert (weld("")["couple"], weld("")["angle"]) == ("tau_N", None)
    assert weld("", angle="")["angle"] == ZERO
    assert weld('couple = "tau"\nangle = "beta"')["couple"] == "tau"


@pytest.mark.parametrize(
    ("text", "a", "b", "c"),
    [
        ("x = 0", 1, 0, 0),
        ("y = 0", 0, 1, 0),
        ("0 = x", -1, 0, 0),
        ("y = 3 + 2", 0, 1, 5),
        ("2*x + 3*y = 4", 2, 3, 4),
        ("(x - y)/2 = x - 1", -0.5, -0.5, -1),
        ("y = x*tan(beta)", -0.5, 1, 0),
        ("-(x - 2*y) = ell", -1, 2, 3),
        ("x + y - x = 0", 0, 1, 0),
    ],
)
def test_lines(text: str, a: float, b: float, c: float) -> None:
    from math import atan

    import rbpsym.statement.references as lines
    from rbpsym.expr.infix import read_infix

    known = {"x": 0, "y": 0, "beta": 0, "ell": 0}
    left, right = (read_infix(side.strip(), known) for side in text.split("="))
    line = lines._line(text, left, right)
    values = {"beta": atan(0.5), "ell": 3.0}
    found = tuple(value(part, values) for part in (line.a, line.b, line.c))
    assert found == pytest.approx((a, b, c))


def test_x_and_y_may_be_coordinates() -> None:
    text = """
    [parameters]
    m = "mass"
    [coordinates]
    x = { dimension = "length" }
    y = { dimension = "length" }
    [bodies]
    bob = { shape = "particle", mass = "m", center = ["x", "y"] }
    [constraints]
    N = { type = "contact", point = "bob.center", line = "x + y = 0" }
    """
    problem = load_text(text)
    assert [coordinate.quantity.dimension for coordinate in problem.coordinates] == [LENGTH, LENGTH]
    assert constraint(problem, "N")["line"].a == Num(1)


def test_windows_line_ends_and_byte_order_mark() -> None:
    assert load_text("\ufeff" + SOUND.replace("\n", "\r\n"), name="all") == ALL


def test_places_of_elements() -> None:
    place = constraint(ALL, "L").place
    assert SOUND.split("\n")[place.line - 1] == "[constraints.L]"


def test_text_or_path() -> None:
    assert load_problem(SOUND).bodies == ALL.bodies


def test_unknown_problem() -> None:
    with pytest.raises(RbpsymError, match="did you mean “sliding-ladder”"):
        find_problem("slidingladder")


def test_names_in_expressions_are_the_authors() -> None:
    assert names(ALL.body("rod").angle) == {"theta", "pi"}

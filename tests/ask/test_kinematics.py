"""Motions that are given need no masses: what is asked of them is told, and what hangs on a mass is refused."""

from pathlib import Path

import pytest

from rbpsym import ask, derive, load_text
from rbpsym.ask.telling import valid_for
from rbpsym.errors import StatementError

GIVEN = Path(__file__).with_name("given")
WHEEL, COLLAR, FOUR_BAR, ROD, LADDER, PLANET, SPOOL, LINKS, ROD_ON_WHEEL = (
    (GIVEN / f"{name}.toml").read_text()
    for name in ("wheel", "collar", "four-bar", "rod", "ladder", "planet", "spool", "links", "rod-on-wheel")
)
STEADY = WHEEL.replace('\nacceleration = "a"', "")


@pytest.mark.parametrize(
    ("text", "question", "wanted"),
    [
        (STEADY, "velocity of wheel.P where phi = pi/2", "(v, -v)"),
        (STEADY, "acceleration of wheel.P at the start", "(0, -v**2/R)"),
        (STEADY, "angular velocity of wheel", "-v/R"),
        (WHEEL, "acceleration of wheel.P at the start", "(2*a, -v**2/R)"),
        (WHEEL, "speed of wheel.P where x = R*pi", "0"),
        (ROD_ON_WHEEL, "velocity of slider at the start", "(2*v, 0)"),
        (ROD_ON_WHEEL, "angular velocity of rod where phi = pi/2", "v/l"),
        (COLLAR, "acceleration of collar at the start", "(a - b*omega**2, b*alpha + 2*u*omega)"),
        (FOUR_BAR, "angular velocity of coupler at the start", "-a*Omega/d"),
        (FOUR_BAR, "angular acceleration of rocker at the start", "Omega**2*(1 + a/d)"),
        (LADDER, "velocity of ladder.end where theta = pi/6", "(0, -v*sqrt(3))"),
        (PLANET, "angular velocity of spider", "a*omega/(2*(a + b))"),
        (PLANET, "velocity of planet.P at the start", "(0, 0)"),
        (SPOOL, "velocity of spool.top at the start", "(2*R*v/(R - r), 0)"),
        (SPOOL, "time until phi = 2*pi", "2*pi*(R - r)/v"),
        (WHEEL, "time until angular velocity of wheel = -2*v/R", "v/a"),
        (FOUR_BAR.replace("constraints.E", "constraints.C"), "speed of rocker.end at the start", "a*Omega*sqrt(2)"),
        (FOUR_BAR, "instantaneous centre of coupler at the start", "(0, a + d)"),
        (LINKS, "acceleration of forearm.end at the start", "(-(a*omega**2 + b*(omega + nu)**2), kappa*(a + b))"),
    ],
)
def test_a_given_motion_needs_no_masses(text: str, question: str, wanted: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved
    assert found.text.replace(" ", "") == wanted.replace(" ", "")


@pytest.mark.parametrize(
    ("text", "question", "said"),
    [
        (STEADY, "N", "it hangs on masses"),
        (STEADY, "kinetic energy", "hangs on masses, which are not stated"),
        (ROD, "acceleration of rod.end at the start", "the acceleration of theta is not stated"),
    ],
)
def test_what_hangs_on_a_mass_is_refused(text: str, question: str, said: str) -> None:
    with pytest.raises(StatementError) as refused:
        ask(load_text(text), question)
    assert said in refused.value.what


def test_a_speed_that_hangs_on_the_place_is_that_of_the_start_alone() -> None:
    [found] = ask(load_text(ROD), "velocity of rod.end at the start")
    assert found.verdict.is_proved


@pytest.mark.parametrize(
    ("text", "question", "speeds"),
    [
        (STEADY, "angular velocity of wheel", "kept speeds: x_dot = v"),
        (STEADY, "velocity of wheel.P at the start", ""),
        (STEADY, "acceleration of wheel.P at the start", "kept speeds: x_dot = v"),
        (WHEEL, "acceleration of wheel.P at the start", ""),
        (FOUR_BAR, "angular velocity of coupler at the start", ""),
        (LINKS, "angular acceleration of forearm", "kept speeds: phi_dot = nu"),
        (LINKS, "angular acceleration of upper", ""),
    ],
)
def test_a_speed_that_is_taken_to_be_kept_is_told_where_the_answer_hangs_on_it(text: str, question: str, speeds: str) -> None:
    [found] = ask(load_text(text), question)
    assert valid_for(found) == speeds
    assert found.verdict.is_proved


def test_a_relative_angle_may_be_led_where_masses_are_stated() -> None:
    """By the couple between the links, and not by a point that begins in a singular position."""
    heavy = LINKS.replace('shape = "rod"', 'shape = "rod"\nmass = "M"').replace("[parameters]", '[parameters]\nM = "mass"')
    heavy = heavy.replace('speed = "nu"', 'speed = "nu"\nacceleration = "0*kappa"')
    heavy += '[constraints.P]\ntype = "pivot"\npoint = "upper.start"\n'
    heavy += '[constraints.Q]\ntype = "pin"\npoints = ["upper.end", "forearm.start"]\n'
    [found] = ask(load_text(heavy), "angular acceleration of forearm")
    assert found.verdict.is_proved and found.text == "kappa"


def test_what_leads_a_point_pushes_along_its_way() -> None:
    """Along an incline, and so without a part across it; what turns as it goes has no such force."""
    block = """
        [parameters]
        M = "mass"
        a = "acceleration"
        g = "acceleration"
        beta = "acute"
        [coordinates.s]
        start = "0"
        acceleration = "a"
        [bodies.block]
        shape = "particle"
        mass = "M"
        center = ["s*cos(beta)", "s*sin(beta)"]
        [interactions.W]
        type = "gravity"
        [constraints.N]
        type = "guide"
        point = "block.center"
        line = "y = x*tan(beta)"
    """
    across, along = ask(load_text(block), "N", "D_s")
    assert (across.text, along.text) == ("M*g*cos(beta)", "M*(a + g*sin(beta))")
    with pytest.raises(StatementError, match="no point a straight way"):
        load_text(block.replace("s*sin(beta)", "s*sin(beta)*exp(s/b)").replace("[coordinates", "b = 'length'\n[coordinates"))


def test_nothing_is_said_of_forces() -> None:
    found = derive(load_text(WHEEL))
    assert found.steps and all(step.certificate.verdict.is_proved for step in found.steps)
    assert found.lagrange is None


def test_letters_that_stand_for_what_is_not_stated_meet_none_of_the_authors():
    """The author's m_wheel is a length, and a constraint is called D_x."""
    text = WHEEL.replace("[coordinates.x]", 'm_wheel = "length: tread"\n[coordinates.x]', 1)
    other = {'radius = "R"': 'radius = "R + m_wheel"', '["x", "R"]': '["x", "R + m_wheel"]', "constraints.N": "constraints.D_x"}
    for old, new in other.items():
        text = text.replace(old, new)
    [found] = ask(load_text(text), "angular acceleration of wheel")
    assert found.verdict.is_proved and found.text == "-a/(R + m_wheel)"

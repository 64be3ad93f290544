"""What a textbook calls things: each question means what the one in the names of the problem does."""

from __future__ import annotations

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.named import in_names
from rbpsym.errors import RbpsymError
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem

SAME = (
    ("rod-pendulum", "magnitude of the force at the pivot when the rod is vertical", "F where theta = 0"),
    ("rod-pendulum", "reaction at the hinge at the start", "F at the start"),
    (
        "rod-pendulum",
        "angular velocity of the rod when it passes through its lowest point",
        "angular velocity of rod where theta = 0",
    ),
    ("rod-pendulum", "natural frequency", "frequency of theta"),
    ("rod-pendulum", "length of the equivalent simple pendulum", "equivalent length of theta"),
    ("double-atwood", "acceleration of m_1", "acceleration of first"),
    ("disk-on-incline", "speed of the drum after it has rolled a distance 3*R", "speed of drum where s = 3*R"),
    ("disk-on-incline", "speed of drum after falling a height R*sin(beta)", "speed of drum where s = R"),
    ("disk-on-incline", "time until the drum has turned through 2*pi", "time until s = 2*pi*R"),
    ("disk-on-incline", "smallest mu for rolling without slipping", "smallest mu for which it does not slip"),
    ("rod-with-damper", "damping ratio", "damping ratio of theta"),
    ("rod-with-damper", "c for critical damping", "c for which theta is critically damped"),
    ("rod-pendulum", "initial angular acceleration of the rod", "angular acceleration of rod at the start"),
    ("rod-pendulum", "moment of inertia about the pivot", "moment of inertia of rod about O"),
    ("rod-pendulum", "speed of the tip when the rod is vertical", "speed of rod.end where theta = 0"),
    ("spring-coupled-pendulums", "longest period", "longest period of theta_1"),
    ("block-up-and-down-incline", "deceleration of the block", "minus acceleration of s"),
    ("braking-wheel", "time it takes to stop", "time until it comes to rest"),
    ("ball-in-a-loop", "theta where the ball leaves the track", "theta where N vanishes"),
    ("ladder-with-friction", "friction at the floor", "f"),
    ("block-up-and-down-incline", "friction at N", "friction f"),
    ("rod-pendulum", "angular velocity of the bar in the vertical position", "angular velocity of rod where theta = 0"),
    ("rod-pendulum", "velocity of the midpoint of the rod at the start", "velocity of rod.cm at the start"),
    ("disk-on-incline", "speed of the wheel after 2 turns of the drum", "speed of drum where number of turns of drum = 2"),
    ("rod-hits-ball-at-bottom", "speed of the ball right after the rod hits it", "speed of ball right after impact"),
    ("motor-with-load", "time until its angular speed is 1/9*omega_m", "time until speed of phi = 1/9*omega_m"),
    ("disk-on-incline", "least coefficient of friction for which it does not slip", "least mu for which it does not slip"),
    ("block-up-and-down-incline", "how far up the incline does the block slide", "displacement of s until it stops"),
)
REFUSED = (
    ("block-up-and-down-incline", "normal force f", "is no normal force"),
    ("block-up-and-down-incline", "tension N", "is no tension"),
    ("sliding-ladder", "friction at N_w", "has no friction"),
    ("disk-with-spring", "speed of disk when the disk leaves the spring", "is not understood"),
    ("rod-pendulum", "M", "is a parameter"),
    ("rod-pendulum", "speed of rod.end when the rod is horizontal", "at 2 places"),
    ("block-up-and-down-incline", "magnitude of displacement of block until s = 0", "phase by phase"),
    ("bead-on-rotating-rod", "tension in the cord", "no tension"),
    ("ball-and-hinged-rod", "angular velocity of the rod when the ball hits it", "before the blow or after it"),
    ("ball-and-hinged-rod", "angular velocity of the rod when it is hit by the ball", "“right after bounced”"),
    ("ball-and-hinged-rod", "velocity of the rod at impact", "is not understood"),
    ("braking-car", "angular velocity of the wheel", "there is no body"),
    ("rod-hits-ball-at-bottom", "speed of the ball when it reaches the top", "is not understood"),
    ("rod-dropped-on-rough-floor", "speed with which the rod strikes the wall", "means nothing"),
    ("brake-drum", "speed of the drum", "may mean its turning"),
    ("disk-with-spring", "speed of the disk in equilibrium", "nothing moves"),
    ("ball-on-incline", "smallest mu for which it does not slip", "no parameter"),
)


@pytest.mark.parametrize(("name", "textbook", "plain"), SAME)
def test_it_means_what_the_plain_words_do(name: str, textbook: str, plain: str) -> None:
    asked = Asked(load_problem(find_problem(name)))
    found, meant = answered(asked, textbook), answered(asked, plain)
    assert found.verdict.is_proved
    assert (found.values, found.holds_so) == (meant.values, meant.holds_so)


@pytest.mark.parametrize(("name", "question", "told"), REFUSED)
def test_what_could_mean_two_things_is_refused(name: str, question: str, told: str) -> None:
    with pytest.raises(RbpsymError) as refused:
        answered(Asked(load_problem(find_problem(name))), question)
    assert told in f"{refused.value.what} {refused.value.instead}"


def test_a_word_for_a_parameter_means_one_of_its_kind() -> None:
    """The coefficient of a damper is none of friction, nor is that of sliding the one of rest."""
    damped, sliding = (load_problem(find_problem(name)) for name in ("rod-with-damper", "block-sliding-or-tipping"))
    assert in_names(damped, "coefficient of friction for which") == "coefficient of friction for which"
    assert in_names(sliding, "coefficient of kinetic friction for which") == "mu for which"
    assert in_names(sliding, "coefficient of static friction for which") == "coefficient of static friction for which"

"""With a clock, coordinates and time are tied along the motion: a pair of them taken at will is no witness."""

from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome
from rbpsym.claims.run import Certificates, check_claims

TRUE_ON_THE_MOTION = r"""
title = "Works in a truck"
source = "ours"
problem = "cylinder-in-truck"

[[claim]]
id = "mixed"
latex = '''W + W_\theta = m v^2'''
[claim.symbols]
'W' = "work of f on pipe, translational"
'W_\theta' = "work of f on pipe, rotational"
'v' = "speed of s"
"""


def test_a_true_claim_is_not_refuted_by_a_state_that_is_never_reached(tmp_path):
    path = tmp_path / "clock.toml"
    path.write_text(TRUE_ON_THE_MOTION, encoding="utf-8")
    [found] = check_claims(load_claims(path), Certificates(None))
    assert found.outcome in (Outcome.PROVED, Outcome.UNDECIDED), found


TIMED = {  # of a ladder that is released at rest, which has no clock of its own
    r"\omega \approx -\frac{3g}{4\ell} t\cos\theta_0 \quad\text{for small } t": "PROVED",
    r"\omega \approx -\frac{3g}{2\ell} t\cos\theta_0 \quad\text{for small } t": "REFUTED",
    r"\theta \approx \theta_0 - \frac{3g}{8\ell} t^2\cos\theta_0 \quad\text{for small } t": "PROVED",
    r"\theta \approx \theta_0 - \frac{3g}{7\ell} t^2\cos\theta_0 \quad\text{for small } t": "REFUTED",
    r"\theta \approx \theta_0 \quad\text{for small } t": "PROVED",
    r"\theta \approx \theta_0\cos(\sqrt{g/\ell}\,t)": "UNDECIDED",
    r"\theta \ge \theta_0 - \frac{3g}{4\ell} t^2": "PROVED",
    r"\theta < \theta_0": "REFUTED",
    r"\theta < \theta_0 \quad\text{for } t > 0": "PROVED",
    r"\theta < \theta_0 \quad\text{for } t \ge 0": "REFUTED",
    r"\theta > \theta_0 \quad\text{for } t > 0": "UNDECIDED",
    r"\omega \ge -\frac{3g}{4\ell} t": "PROVED",
    r"\omega > -\frac{3g}{4\ell} t": "REFUTED",
    r"\omega \le -\frac{g}{4\ell} t \quad\text{for } \theta < \frac{\pi}{4}": "UNDECIDED",
    r"\omega = -\frac{3g}{4\ell} t\cos\theta_0": "REFUTED",
    r"\frac{d\theta}{dt} = \omega": "PROVED",
    r"t \ge 0": "PROVED",
}


def test_the_time_has_a_meaning_without_a_clock(tmp_path):
    rows = [f"[[claim]]\nid = '{k}'\nlatex = '{latex}'\n" for k, latex in enumerate(TIMED)]
    path = tmp_path / "timed.toml"
    path.write_text("title = 'Times'\nproblem = 'sliding-ladder'\n" + "".join(rows), encoding="utf-8")
    found = check_claims(load_claims(path), Certificates(None))
    assert {one.latex: str(one.outcome) for one in found} == TIMED


def test_a_start_of_another_motion_is_no_witness(tmp_path):
    """r = 2 of a motion from r_0 = 1 was said to refute this; a state that the start leaves open refutes as before."""
    rows = "[[claim]]\nid = '1'\nlatex = 'r^2 \\le r_0^2'\n[[claim]]\nid = '2'\nlatex = 'r = r_0'\n"
    path = tmp_path / "other.toml"
    path.write_text("title = 'Other starts'\nproblem = 'elastic-pendulum'\n" + rows, encoding="utf-8")
    found = check_claims(load_claims(path), Certificates(None))
    assert [one.outcome for one in found] == [Outcome.UNDECIDED, Outcome.REFUTED]


ON_ITS_WAY = {  # of a block that friction stops: what its speed and the square of it say
    r"s \ge 0": "PROVED",
    r"s \le \frac{v_0^2}{2g(\sin\beta + \mu\cos\beta)}": "PROVED",
    r"s < \frac{v_0^2}{2g(\sin\beta + \mu\cos\beta)}": "UNDECIDED",
    r"s \le \frac{v_0^2}{3g(\sin\beta + \mu\cos\beta)}": "REFUTED",
}


def test_where_a_motion_goes_follows_from_its_speed(tmp_path):
    rows = [f"[[claim]]\nid = '{k}'\nlatex = '{latex}'\n" for k, latex in enumerate(ON_ITS_WAY)]
    path = tmp_path / "way.toml"
    path.write_text("title = 'Ways'\nproblem = 'block-up-and-down-incline'\n" + "".join(rows), encoding="utf-8")
    found = check_claims(load_claims(path), Certificates(None))
    assert {one.latex: str(one.outcome) for one in found} == ON_ITS_WAY

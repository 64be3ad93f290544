"""Questions that assert something of a system are asked where it is proved; each phrase asserts, or does not."""

from __future__ import annotations

from contextlib import suppress
from importlib import import_module
from inspect import getsource

import pytest

from rbpsym.expr import tree as t
from rbpsym.languages import phrases
from rbpsym.proof.step import QuestionRef
from rbpsym.quantities import NUMBER
from rbpsym.teaching.distractors import pool
from rbpsym.teaching.misconceptions.model import Site
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.misconceptions.told import ASKED_OF, TRUE_OF, is_asked_of
from rbpsym.teaching.target import Target
from rbpsym.teaching.targets import targets
from tests.library.derived import unsimulated

# What asserts something of a system or of an answer, and who decides that it is so; all other phrases ask, name or narrate.
MARKED = {  # remarks on an answer, by the module that makes them when it has decided so
    "answer": ("equation wanted", "other equation"),
    "choices": (
        "several options", "wrong option", "wrong order", "not an order", "rows", "cancelling", "not signs", "not an option",
    ),
    "desk": ("numbers put in", "wrong line", "right line", "wrong correction"),
    "formula": (
        "zero division", "circular", "chain", "number beside", "identity", "unsolved", "unfinished", "sign", "factor",
        "dimension", "dimensions", "carried",
    ),
    "judgement": ("invalid", "undecided", "wrong", "slip", "first wrong", "empty"),
    "number": (
        "zero", "wrong value", "power of ten", "degrees", "unit missing", "unit wrong", "unit cycles", "too few figures",
        "too many figures", "one figure fewer",
    ),
    "quantity": ("rounded",),
}  # fmt: skip
ASSERTIONS = {
    **{f"ask.{task}.frequency": "targets.ASSERTED" for task in ("choose", "number", "formula", "compare")},
    **{f"ask.{task}.loss": "targets.ASSERTED" for task in ("choose", "number", "formula")},
    **{f"remark.{key}": f"grading.{module}" for module, keys in MARKED.items() for key in keys},
    "compare.why": "tasks.compare._answer",
    "misconception": "misconceptions.told.is_true",
    "paper.also": "distractors.Pool",
    "principle": "tasks.derivations",
    "solution.case": "solving._special_case",
    "solution.unit": "solving._check",
}
NARRATION = """lead ask.choose ask.number ask.formula ask.compare ask.place ask.fill-in ask.order ask.find-the-slip ask.signs
ask.explain hint compare.doubled compare.shape compare.welded compare.free compare.first compare.second compare.same
compare.one compare.other shape signs rubric solution.from solution.derivation solution.answers solution.numbers paper
remark.at remark.blank remark.decided remark.open remark.equation remark.read_as remark.other_side feedback exports sentence"""


def _kind(key: str) -> str:
    parts = key.replace("read as", "read_as").replace("other side", "other_side").split(".")
    stems = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((stem for stem in stems if stem in ASSERTIONS or stem in NARRATION.split()), "")


WHAT_WAS_DONE = """
action-along-reaction all-mass-at-centers all-work-is-rotational angular-velocity-kept damping-left-out diameter-for-radius
end-of-rod-taken-for-axis energy-kept f-is-ma-at-contact-point force-acts-at-center force-sign forces-as-at-rest
free-taken-as-welded friction-along-slip friction-is-mu-n friction-wrong-way half-forgotten-in-kinetic-energy
half-forgotten-in-rotational-energy half-forgotten-in-spring-energy half-length-for-length inertia-of-one-body-left-out
kinetic-friction-left-out length-for-elongation mass-dropped moment-about-wrong-point moment-of-another-shape
momentum-is-angular-velocity momentum-kept-at-hinge normal-force-is-weight one-body-not-in-the-sum one-of-two-parts-of-string
orbital-part-dropped parallel-axis-forgotten parallel-axis-twice rim-and-hub-alike rolling-taken-as-sliding
rolls-while-slipping rotational-energies-subtract rotational-energy-left-out same-tension-on-both-sides shift-by-whole-length
sine-for-cosine sine-for-cosine-in-lever-arm sine-for-cosine-in-momentum small-angle-for-large speed-of-end-for-center
spin-dropped spin-of-carrier start-speed-forgotten struck-at-center-of-mass tension-is-weight third-law-forgotten
torque-about-accelerating-contact torque-about-axis-in-work torque-sign translational-energy-left-out
turning-force-moves-nothing weight-at-middle-of-shape weight-left-out weight-sign welded-taken-as-free
whole-length-for-lever-arm whole-weight-along-slope work-at-application-point work-sign wrong-sense-of-rotation
"""  # beside that, it tells what the place itself is chosen for (a weld, a slope, a force off the centre), or a law
SAYS_WHAT_WAS_DONE = frozenset(WHAT_WAS_DONE.split())


def test_what_is_said_of_a_sum_or_a_way_is_not_said_of_one_body_or_the_start() -> None:
    assert set(ASKED_OF) <= set(MISCONCEPTIONS)

    def asked(name: str, id: str, **slots: object) -> bool:
        return is_asked_of(name, Target(id, t.ZERO, lambda study: None, NUMBER, slots=slots))

    told = [asked("one-body-not-in-the-sum", id) for id in ("momentum.total", "momentum.drum")]
    told += [asked("start-speed-forgotten", id) for id in ("speed.phi", "start.phi_dot")]
    assert told == [True, False, True, False] and asked("weight-sign", "start.phi_dot")
    blows = ("speed of theta when embedded begins", "smallest v_0 for which theta reaches pi", "energy lost when embedded begins")
    assert [asked("momentum-kept-at-hinge", "question.1", question=QuestionRef(text)) for text in blows] == [True, False, False]


def test_there_is_no_third_kind() -> None:
    assert not set(ASSERTIONS) & set(NARRATION.split())
    for language in ("en", "es"):
        assert not [key for key in phrases(language, "worksheets") if not _kind(key)]
    for told in (*ASSERTIONS, *NARRATION.split()):
        assert any(f"{key}.".startswith(f"{told.replace('_', ' ')}.") for key in phrases("es", "worksheets")) or any(
            f"{key}.".startswith(f"{told}.") for key in phrases("es", "worksheets")
        ), told


@pytest.mark.parametrize("decider", sorted(set(ASSERTIONS.values())))
def test_who_decides_is_there(decider: str) -> None:
    """A module, or something in one, of the room."""
    parts = decider.split(".")
    for cut in (len(parts), len(parts) - 1):
        with suppress(ModuleNotFoundError):
            found = import_module(".".join(("rbpsym.teaching", *parts[:cut])))
            assert all(hasattr(found, name) for name in parts[cut:])
            return
    raise AssertionError(decider)


@pytest.mark.parametrize(("module", "keys"), MARKED.items())
def test_a_remark_is_made_where_it_is_decided(module: str, keys: tuple[str, ...]) -> None:
    source = getsource(import_module(f"rbpsym.teaching.grading.{module}"))
    assert all(f'"{key}"' in source for key in keys)


# --- feedback: true of the system, or no place for the misconception


def test_each_feedback_is_true_of_its_place_or_says_what_was_done() -> None:
    assert set(TRUE_OF) | SAYS_WHAT_WAS_DONE == set(MISCONCEPTIONS)
    assert not set(TRUE_OF) & SAYS_WHAT_WAS_DONE


@pytest.mark.parametrize(
    ("name", "misconception", "forces"),
    [
        ("sliding-ladder", "contact-forces-do-no-work", {"N_w": "one", "N_f": "one"}),
        ("rod-and-disk-free", "contact-forces-do-no-work", {"F": "one", "N": "several"}),
        ("sliding-ladder", "works-add-up", {"N_w": None, "N_f": None}),
        ("rod-and-disk-free", "works-add-up", {"F": None}),
        ("disk-on-incline", "works-add-up", {"f": None}),
        ("sliding-ladder-with-spring", "works-always-cancel", {"F_s": None}),
    ],
)
def test_cancelling_is_said_of_what_cancels(name: str, misconception: str, forces: dict) -> None:
    """Of the pin between two bodies neither work is the opposite of the other."""
    found = pool(unsimulated(name), [misconception]).wrongs
    assert {wrong.site.slots["force"].name: wrong.site.slots.get("variant") for wrong in found} == forces


def test_a_centripetal_acceleration_is_not_missed_on_a_straight_path() -> None:
    """The forces on a ball in the air depend on its speed, and its path is straight."""
    study = unsimulated("ball-thrown-up-in-air").study
    assert not TRUE_OF["centripetal-forgotten"](study, Site({}, lambda: study))
    assert TRUE_OF["centripetal-forgotten"](unsimulated("sliding-ladder").study, Site({}, lambda: study))


@pytest.mark.parametrize(("name", "asked"), [("rod-pendulum", True), ("rod-with-damper", False)])
def test_a_period_is_asked_for_where_there_is_one(name: str, asked: bool) -> None:
    """With a damper the displacement does not come back: no period, no “it swings about its stable position”."""
    found = unsimulated(name)
    assert any(target.kind == "frequency" for target in targets(found)) is asked


def test_a_place_of_loss_is_asked_for_where_it_comes_first() -> None:
    found = unsimulated("ball-off-sphere")
    lost = [target.step for target in targets(found) if target.kind == "loss"]
    assert all(found.step(step).phrase.startswith("contact.lost") for step in lost)

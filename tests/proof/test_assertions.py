"""Each sentence narrates or asserts; what asserts is said only where its condition is proved."""

from __future__ import annotations

import ast
import re
from dataclasses import replace

import pytest

from rbpsym.decide.verdict import UNDECIDED, Verdict
from rbpsym.derive import derive
from rbpsym.document.model import ItemList, Paragraph
from rbpsym.document.notes import notes
from rbpsym.document.phrases import has_phrase
from rbpsym.document.writers.page import plain_text
from rbpsym.expr import tree as t
from rbpsym.languages import languages, phrases
from rbpsym.pictures.plots.following import leg
from rbpsym.pictures.pose import DrawnPose
from rbpsym.proof import assertions as a
from rbpsym.proof.assertions import ASSERTIONS, NARRATION, PAGES, STEPS, Said, base, entry, on_page, settled
from rbpsym.proof.step import Certificate
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.architecture.source import Module, of_every_module
from tests.ask.test_unseen import HERE
from tests.library.derived import derived


def said_in(derivation, detail: str = "full") -> str:
    """The sentences of the notes, formulas left out."""
    document = notes(derivation, "en", detail)
    found = []
    for section in document.sections:
        for block in section.blocks:
            parts = [block.inlines] if isinstance(block, Paragraph) else block.items if isinstance(block, ItemList) else []
            found += [plain_text(part, document.notation, "en") for part in parts]
    return " ".join(found)


# --- the tables


@pytest.mark.parametrize("language", languages())
def test_there_is_no_third_kind(language: str) -> None:
    """The longest part of a key that is told of is told of once."""
    assert not (set(ASSERTIONS) | set(a.ELSEWHERE)) & NARRATION and not set(ASSERTIONS) & set(a.ELSEWHERE)
    for key in phrases(language):
        parts = base(key).split(".")
        assert any(".".join(parts[:k]) in {*ASSERTIONS, *NARRATION, *a.ELSEWHERE} for k in range(1, len(parts) + 1)), key


def test_nothing_is_told_of_what_is_not_there() -> None:
    keys = {base(key) for language in languages() for key in phrases(language)}
    for told in (*ASSERTIONS, *NARRATION):
        assert any(key == told or key.startswith(f"{told}.") for key in keys), told


@pytest.mark.parametrize("language", languages())
def test_what_is_said_instead_is_there_and_comes_to_an_end(language: str) -> None:
    for key, (_, other) in ASSERTIONS.items():
        seen = {key}
        while other:
            assert has_phrase(other, language), (key, other)
            assert other not in seen, key
            seen.add(other)
            other = found[1] if (found := entry(other)) else ""


@pytest.mark.parametrize("key", PAGES)
def test_what_asserts_is_said_of_something(key: str) -> None:
    with pytest.raises(KeyError, match=re.escape(key)):
        on_page(key, None)


IMPOSSIBLE = {
    "en": r"(has|have) no (closed form|solution)|cannot be solved|without a solution|(?<!found )no formula",
    "es": r"no tienen? (forma cerrada|solución)|no se pueden? (despejar|resolver)|sin solución|ninguna fórmula",
}


@pytest.mark.parametrize("language", IMPOSSIBLE)
def test_that_something_is_impossible_is_said_nowhere(language: str) -> None:
    """That there is no closed form would have to be proved; what is said is that none was found."""
    for key, text in phrases(language).items():
        assert not re.search(IMPOSSIBLE[language], text, re.IGNORECASE), key


@of_every_module
def test_no_reason_says_it_either(module: Module) -> None:
    """Reasons, errors and sentences that stand in the code: what is no docstring."""
    parts = [node for node in ast.walk(module.tree) if not isinstance(node, ast.Expr)]
    for node in (child for part in parts for child in ast.iter_child_nodes(part)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            assert not re.search(r"(has|have) no closed form", node.value), node.lineno


# --- one place where it is decided


def stem(step) -> str:
    """The entry under which the sentence of a step stands."""
    parts = base(f"{step.phrase}.{step.slots.get('variant', '')}").strip(".").split(".")
    stems = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((found for found in stems if found in STEPS or found in NARRATION), "")


def ground(draft, step, told) -> Said:
    before = draft.steps[: [found.id for found in draft.steps].index(step.id)]
    return Said(draft.study, told, before, draft.context)


def test_what_is_asserted_holds(draft) -> None:
    for step in draft.steps:
        assert step.phrase == settled(step.phrase, ground(draft, step, step), step.slots.get("variant", "")), step.id


BY_SYSTEM = {"kinematics.turning.none"}  # decided from the system alone


def test_what_is_not_proved_asserts_nothing(draft) -> None:
    """Each step, its formula and its certificate spoilt: the sentence goes, or another takes its place."""
    for step in draft.steps:
        if stem(step) in STEPS and stem(step) not in BY_SYSTEM:
            wrong = ground(draft, step, spoilt(step))
            assert settled(step.phrase, wrong, step.slots.get("variant", "")) != step.phrase, step.id


def spoilt(step):
    """The step as it would be if nothing were known of it."""
    wrong = t.Relations((t.equation(t.Sym("wrong_dot"), t.Sym("t")),))
    slots = {**step.slots, "coordinates": []}
    return replace(step, statement=wrong, certificate=Certificate((), Verdict(UNDECIDED, reason="spoilt")), slots=slots)


@pytest.mark.parametrize("key", ["energy.conserved", "work.cancels", "kinematics.dependent", "torque.net.contact"])
def test_no_road_goes_round_the_condition(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = load_problem(problem_files()["ball-on-incline"])
    assert [step for step in derive(problem, simulation=False).steps if step.phrase.startswith(key)]
    never = {found: (lambda said: False, "") for found in STEPS if found.startswith(key)}
    monkeypatch.setattr(a, "ASSERTIONS", {**ASSERTIONS, **never})
    assert not [step for step in derive(problem, simulation=False).steps if step.phrase.startswith(key)]


# --- systems of which a sentence is not true


def text_of(name: str, **changes: str) -> str:
    """The notes of a problem that ships, some of its lines changed."""
    found = problem_files().get(name, HERE / f"{name}.toml").read_text(encoding="utf-8")
    for old, new in changes.items():
        assert old in found
        found = found.replace(old, new)
    return said_in(derive(load_problem(found), simulation=False))


AT_THE_BOTTOM = {'"theta_0"': '"0"', 'theta_0 =': '#'}
COUPLE = '[interactions.C]\ntype = "couple"\non = "rod"\ncouple = "M*g*ell*sin(sqrt(g/ell)*t)"\n\n[interactions.W]'
SHAKEN = AT_THE_BOTTOM | {"[interactions.W]": COUPLE}
SAID = [  # a problem, changes of its text, what is not said of it, what is said instead
    ("sliding-ladder-with-spring", {}, "and it is the opposite", "together do the opposite rotational work"),
    ("sliding-ladder", {}, "of the other forces the rotational work", "and it is the opposite"),
    ("slider-crank", {}, "cannot be solved", "We do not solve the conditions"),
    ("three-logs", {}, "in a vertical plane. move", "are at rest in a vertical plane"),
    ("bicycle-wheelie", {}, "to the other coordinates", "This determines"),
    ("block-sliding-or-tipping", {}, "works that cancel drop out", "Everything added changes"),
    ("rod-pendulum", AT_THE_BOTTOM, "The motion begins from rest", "nothing accelerates: left to itself it stays"),
    ("rod-pendulum", AT_THE_BOTTOM, "so the bracket must vanish:", "If a push, however small, sets it going"),
    ("rod-pendulum", SHAKEN, "left to itself", "The motion begins from rest"),
    ("ball-off-sprung-pan", {}, "as long as kd ≥", "as long as kd > 2Mg + 2mg"),
    ("rod-pendulum", {}, "left to itself", "The motion begins from rest"),
    ("cylinder-on-belt", {}, "has taken from the kinetic energy", "with which this motion began, less that at its end"),
    ("ball-against-free-rod", {}, "The kinetic energy that is lost is", "before the impulses, less that after them"),
    ("pendulum-on-oscillating-support", {}, "As functions of position and speed", "Solved for the unknown forces"),
    ("loaded-wheel", {}, "This is what sets", "This changes the energy of the rotation"),
    ("block-sliding-or-tipping", {}, "changes the spin of the block", "The block does not turn, so the torques balance"),
    ("cylinder-in-corner", {}, "have no torque about this point", "Take the cylinder about the fixed point O. The net"),
    ("brake-drum", {}, "The unknown forces D and N have no torque", "Take the drum about the fixed point O. The unknown"),
    ("three-logs", {}, "rolls without slipping", "rests on the floor"),
    ("rod-tipping-over-edge", {}, "it moves along with the rod", "does not slip along what it touches"),
    ("ring-with-bob", {}, "two works, but whatever its value, they are opposite", "cancel in the sum, whatever its value"),
    ("linear-molecule", {}, "sum of the translational and rotational", "The kinetic energy is"),
    ("rod-falling-on-rough-floor", {}, "takes from the motion of the centre", "takes from the rotation it gives to the motion"),
    ("half-disk-rocking", {}, "What it takes from", "so that they are opposite, whatever its value"),
    ("step-ladder-sliding", {}, "what the force takes from one body", "goes away. What is left is"),
    ("bead-on-turning-hoop", {}, "stay at rest", "No body turns"),
    ("four-bar-linkage", {}, "of what was found before", "The rate of"),
]


@pytest.mark.parametrize(("name", "changes", "never", "instead"), SAID)
def test_what_is_false_is_not_said(name: str, changes: dict[str, str], never: str, instead: str) -> None:
    told = text_of(name, **changes)
    assert never not in told
    assert instead in told


def test_a_force_that_pulls_at_several_bodies_is_named_once() -> None:
    """Both pulls of a string have the same sense: neither is the opposite of the other."""
    steps = derived("double-atwood").steps
    assert next(s for s in steps if s.id == "energy").slots["ideal"] == [t.Vec("T_1"), t.Vec("T_2")]
    assert [s.slots["force"] for s in steps if s.rule == "workless"] == [t.Vec("T_1"), t.Vec("T_2")]


SUMMARIES = [
    ("checks.methods", {"torque": "PROVED"}, True, "checks.open"),
    ("checks.methods", {"torque": "PROVED", "energy": "UNDECIDED"}, False, "checks.open"),
    ("checks.methods", {"torque": "PROVED", "energy": "REFUTED"}, False, "checks.differ"),
    ("checks.methods", {"torque": "PROVED", "energy": "PROVED"}, True, "checks.methods"),
]


@pytest.mark.parametrize(("key", "methods", "agree", "said"), SUMMARIES)
def test_methods_agree_where_two_are_proved(key: str, methods: dict[str, str], agree: bool, said: str) -> None:
    assert on_page(key, Said(summary={"methods": methods, "methods_agree": agree})) == said


@pytest.mark.parametrize(("error", "said"), [(1e-9, "checks.simulation"), (0.5, "checks.simulation_differs")])
def test_a_simulation_agrees_or_differs(error: float, said: str) -> None:
    assert on_page("checks.simulation", Said(summary={"simulation": {"max_relative_error": error}})) == said


def test_a_force_beside_which_others_cancel_is_no_absence_of_forces() -> None:
    """Two opposite forces: the momentum does not change, but it is not true that no force acts."""
    pushed = """
parameters = { m = "mass: m", F = "force: F" }
coordinates.x = { start = "0", speed = "v_0", dimension = "length" }
coordinates.y = { start = "0", speed = "0", dimension = "length" }
[bodies.bead]
shape = "particle"
mass = "m"
center = ["x", "y"]
[interactions.A]
type = "force"
on = "bead.center"
force = ["F", "0"]
[interactions.B]
type = "force"
on = "bead.center"
force = ["-F", "0"]
"""
    told = said_in(derive(load_problem(pushed), simulation=False))
    assert "No force acts on the bead horizontally" not in told
    assert "the outer forces on the bead cancel" in told
    assert "No force acts on the bead vertically" in told
    assert "vertical plane" not in told


SAID_OF = {
    "falling-stick": ("If a push, however small", "Multiplied by its speed and integrated"),
    "rod-on-two-strings": ("Some of these integrals", "With the forces known along the motion, these"),
    "bead-on-rotating-rod": ("Jacobi's integral", "grows to the right"),
    "stepped-pulley": ("act along the same line", "act at the same point"),
    "loaded-wheel": ("", "from those of its parts"),
}


@pytest.mark.parametrize("name", problem_files())
def test_friction_gives_to_what_it_is_said_to_give_to(name: str) -> None:
    """The translational work that is told to be taken, or given, has this sign on the motion that is integrated."""
    senses = {"work.cancels.grip": -1, "work.cancels.grip.back": 1}
    found = derived(name)
    told = [s for s in found.steps if s.phrase in senses and s.slots["variant"] == "one"]
    for step in told:
        force = step.id.split(".")[1]
        value = next(w for w in found.study.works if w.force == force).translational.value
        way = leg(found, dict(DrawnPose(found.study).numbers))
        worked = senses[step.phrase] * way.values(value)
        assert min(worked) >= -1e-9 * max(worked), force  # nothing is done where it stays at rest


@pytest.mark.parametrize("name", SAID_OF)
def test_what_is_not_so_is_not_said(name: str) -> None:
    """Nothing is said of a push, a force or a direction that this motion does not have."""
    yes, no = SAID_OF[name]
    said = said_in(derived(name))
    assert yes in said and no not in said
    assert "Since the energy" not in said or not derived(name).study.system.has_clock

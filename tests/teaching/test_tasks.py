"""Tasks are derived from the derivation: each kind has the properties that make its key right."""

from __future__ import annotations

import itertools
import math
from functools import cache

import pytest

from rbpsym.decide.equal import equal, scalars_equal
from rbpsym.document.model import Math
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.field import names_in
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.numbers import angles, floating
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.distractors import apart, without_noise
from rbpsym.teaching.lines import gaps, lines_to
from rbpsym.teaching.model import KINDS, Item, OrderKey, Student, Worksheet, blank, blank_name
from rbpsym.teaching.papers.solution import _start
from rbpsym.teaching.plan import WorksheetPlan, bench_of, plan_of
from rbpsym.teaching.ranges import conditions, default_ranges, middles, si
from rbpsym.teaching.sheet import sheet_of_text
from rbpsym.teaching.tasks.compare import variants
from rbpsym.teaching.tasks.registry import TASKS
from rbpsym.teaching.tasks.slip import SHORT, SPLITS, brief
from tests.library.derived import problem

PROBLEMS = ("rod-and-disk-free", "sliding-ladder-with-spring", "disk-on-incline")
STUDENTS = [Student(f"s{k}") for k in range(8)]


@cache
def plan(name: str) -> WorksheetPlan:
    return plan_of(name)


@cache
def sheets(name: str) -> tuple[Worksheet, ...]:
    return tuple(plan(name).worksheet(student, "secret") for student in STUDENTS)


def items(name: str, kind: str) -> list[tuple[Worksheet, Item]]:
    return [(sheet, item) for sheet in sheets(name) for item in sheet.items if item.kind == kind]


def assumptions(name: str):
    return plan(name).parts[0].bench.study.assumptions


def test_every_kind_is_in_the_table_and_made() -> None:
    assert set(TASKS) == set(KINDS)
    made = {item.kind for name in PROBLEMS for sheet in sheets(name)[:1] for item in sheet.items}
    assert made == set(KINDS)


@pytest.mark.parametrize("name", PROBLEMS)
def test_ids_points_and_prompts(name: str) -> None:
    for sheet in sheets(name):
        assert [item.id for item in sheet.items] == [str(k + 1) for k in range(len(sheet.items))]
        assert sheet.points == sum(item.points for item in sheet.items) > 0
        for item in sheet.items:
            assert item.prompt and item.points > 0 and item.asked.problem == name
            assert not item.rubric or sum(c.points for c in item.rubric) == item.points


@pytest.mark.parametrize("name", PROBLEMS)
def test_choices_have_one_right_answer(name: str) -> None:
    for _, item in items(name, "choose"):
        options = item.key.options
        assert [option.slip is None for option in options].count(True) == 1
        assert options[item.key.right].slip is None
        for a, b in itertools.combinations([option.formula for option in options], 2):
            assert equal(a, b, assumptions(name)).is_refuted


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_place_of_the_right_answer_varies(name: str) -> None:
    places = {item.key.right for _, item in items(name, "choose")}
    assert len(places) > 1


@pytest.mark.parametrize("name", PROBLEMS)
def test_numbers_are_those_of_the_formula(name: str) -> None:
    """The key from the display tree and the printed numbers alone: another way than that which made it."""
    for _, item in items(name, "number"):
        key = item.key
        given = {n: si(measure) for n, measure in key.given.items()}
        assert t.names(key.formula) - {"pi"} <= set(given)
        [value] = compiled([scalar(key.formula)])(given)
        assert math.isclose(value, key.exact, rel_tol=1e-9)
        assert abs(si(key.measure) - value) <= 0.006 * abs(value)
        printed = [key.measure, *(a.number for a in key.anticipated)]
        assert all(apart(a, b) for a, b in itertools.combinations(printed, 2))


def test_error_carried_forward_is_consistent() -> None:
    """The follow-on formula, fed with the right earlier answer, gives the right later one."""
    found = 0
    for sheet, item in items("rod-and-disk-free", "number"):
        for follow in item.key.follows:
            found += 1
            earlier = sheet.item(follow.item).key.exact
            given = {n: si(m) for n, m in item.key.given.items()} | {follow.name: earlier}
            given |= {n: si(m) for n, m in sheet.item(follow.item).key.given.items()}
            [value] = compiled([scalar(follow.formula)])(given)
            assert math.isclose(value, item.key.exact, rel_tol=1e-9)
    assert found


@pytest.mark.parametrize("name", PROBLEMS)
def test_blanks_filled_in_give_the_steps_again(name: str) -> None:
    derivation = plan(name).parts[0].bench.derivation
    for _, item in items(name, "fill-in")[:2]:
        shown = [block.node for block in item.prompt if hasattr(block, "node")]
        for answer in item.key.blanks:
            with_it = [node for node in shown if blank_name(answer.number) in t.names(node)]
            assert len(with_it) == 1
        steps = {block_statement(node, item) for node in shown}
        assert steps <= {step.statement for step in derivation.steps}
        assert sum(answer.points for answer in item.key.blanks) == item.points


def block_statement(node: t.Node, item: Item) -> t.Node:
    """The statement with the answers put into its blanks."""
    from dataclasses import fields, replace

    answers = {blank(answer.number): answer.value for answer in item.key.blanks}

    def filled(part: t.Node) -> t.Node:
        if part in answers:
            return answers[part]
        changes = {}
        for field in fields(part):
            value = getattr(part, field.name)
            if isinstance(value, t.Node):
                changes[field.name] = filled(value)
            elif isinstance(value, tuple) and value and isinstance(value[0], t.Node):
                changes[field.name] = tuple(map(filled, value))
        return replace(part, **changes) if changes else part

    return filled(node)


def test_help_fades() -> None:
    text = "[[problem]]\nname = 'rod-and-disk-free'\n" + "".join(
        f"[[problem.task]]\nkind = 'fill-in'\nabout = 'acceleration.theta'\nlevel = {level}\n" for level in range(4)
    )
    sheet = plan_of(sheet_of_text(text)).worksheet()
    counts = [len(item.key.blanks) for item in sheet.items]  # between the ends terms give way to whole sides
    assert min(counts) == counts[0] < counts[-1] == max(counts)
    told = [sum(not hasattr(block, "node") for block in item.prompt) for item in sheet.items]
    assert told[-1] == 1 < told[0]


def test_a_sign_is_left_out_with_the_blank() -> None:
    value = t.Mul((t.Sym("g"), t.Fn("sin", t.Sym("theta"))))
    for turned, along in ((t.neg(value), None), (t.neg(t.Mul((value, t.Unit("k")))), t.Unit("k"))):
        [gap] = [gap for gap in gaps(t.equation(t.Sym("a"), turned)) if not gap.is_term]
        kept = blank(1) if along is None else t.Mul((blank(1), along))
        assert gap.node == t.neg(value) and gap.left_out(t.equation(t.Sym("a"), turned), 1) == t.equation(t.Sym("a"), kept)


@pytest.mark.parametrize("name", PROBLEMS)
def test_orders_are_decided_by_the_graph(name: str) -> None:
    by_id = {step.id: step for step in plan(name).parts[0].bench.derivation.steps}
    for _, item in items(name, "order"):
        key: OrderKey = item.key
        assert key.accepts(key.sample)
        assert not key.accepts(tuple(range(len(key.pieces))))
        assert not key.accepts(key.sample[:-1]) and not key.accepts((*key.sample[:-1], key.sample[0]))
        for later, piece in enumerate(key.pieces):
            for premise in by_id[piece.id].reasons:
                earlier = next((k for k, other in enumerate(key.pieces) if other.id == premise), None)
                assert earlier is None or (earlier, later) in key.before
        assert not key.accepts(tuple(reversed(key.sample)))


@pytest.mark.parametrize("name", PROBLEMS)
def test_a_slip_is_one_wrong_line_carried_through(name: str) -> None:
    by_id = {step.id: step for step in plan(name).parts[0].bench.derivation.steps}
    for _, item in items(name, "find-the-slip"):
        key = item.key
        shown = [piece.statement for piece in key.lines]
        forms = ([brief(by_id[piece.id], rules).statement for piece in key.lines] for rules in (SHORT, SHORT | SPLITS))
        right = next(
            form for form in forms if shown[: key.wrong] == form[: key.wrong] and form[key.wrong] == key.corrected
        )
        assert shown[key.wrong] != right[key.wrong] and shown[-1] != right[-1]


@pytest.mark.parametrize("name", PROBLEMS)
def test_signs_agree_with_the_works(name: str) -> None:
    study = plan(name).parts[0].bench.study
    for sheet, item in items(name, "signs"):
        number = next(i for i in sheet.items if i.kind == "number")  # of the same situation
        numbers = {n: si(m) for n, m in {**sheet.parts[0].given, **number.key.given}.items()}
        for row, work in zip(item.key.rows, study.works, strict=True):
            for sign, half in ((row.translational, work.translational), (row.rotational, work.rotational)):
                value = compiled([half.value])(numbers)[0]
                assert {"+": value > 0, "-": value < 0, "0": abs(value) < 1e-9}[sign]
        groups = {row.cancels for row in item.key.rows} - {""}
        for group in groups:
            own = [w for w in study.works if w.force == group]
            total = sum(w.translational.value + w.rotational.value for w in own)
            assert scalars_equal(total, total * 0, study.assumptions).is_proved


@pytest.mark.parametrize("name", PROBLEMS)
def test_comparisons_hold_at_numbers(name: str) -> None:
    for sheet, item in items(name, "compare"):
        relations = [criterion.formula for criterion in item.rubric if criterion.formula is not None]
        numbers = {"theta": 0.3, "s": 0.7, "theta_dot": 1.1}
        numbers |= {n: si(m) for n, m in sheet.parts[0].given.items()}
        first, second = (abs(compiled([scalar(r.items[-1])])(numbers)[0]) for r in relations)
        answer = 2 if math.isclose(first, second) else 0 if first > second else 1
        assert item.key.right == answer


def test_explanations_name_what_they_stand_on() -> None:
    for name in PROBLEMS:
        by_id = {step.id: step for step in plan(name).parts[0].bench.derivation.steps}
        for _, item in items(name, "explain")[:1]:
            wanted = {by_id[id].statement for id in by_id[item.asked.step].reasons}
            assert {c.formula for c in item.rubric if c.formula is not None} <= wanted
            assert item.key.sample


def test_angles_stay_in_range_and_friction_suffices() -> None:
    for sheet in sheets("disk-on-incline"):
        given = {n: si(m) for n, m in sheet.parts[0].given.items()}
        assert 0 < given["beta"] < math.pi / 2
        assert math.tan(given["beta"]) / 3 <= given["mu"]
    for sheet in sheets("sliding-ladder-with-spring"):
        [place] = {i.key.given["theta"].value for i in sheet.items if i.kind == "number" and "theta" in i.key.given}
        assert 0 < place < sheet.parts[0].given["theta_0"].value < 90


def test_frequencies_can_be_measured() -> None:
    text = "[[problem]]\nname = 'rod-and-disk-free'\n[[problem.task]]\nkind = 'number'\nabout = 'frequency.*'\n"
    whole = plan_of(sheet_of_text(text))
    for student in STUDENTS:
        [item] = whole.worksheet(student).items
        assert 1 / 3 < item.key.exact < 1 / 0.15


def test_rounding_does_not_make_a_difference() -> None:
    """0 and -3.6e-16 stand for the same number: found over the library, on a drum with two tensions."""
    assert without_noise([0.0, -6.81, -3.64e-16, math.nan])[:3] == [0.0, -6.81, 0.0]
    assert without_noise([3e-14, 2e-15]) == [0.0, 0.0]
    assert without_noise([3e-7, 2e-7]) == [3e-7, 2e-7]


@pytest.mark.parametrize("name", ["disk-on-incline", "rod-and-disk-fixed"])
def test_sentences_speak_of_no_equation_without_a_number(name: str) -> None:
    items = plan(name).worksheet(Student("s1"), "secret").parts[0].items
    assert {"fill-in", "explain"} <= {item.kind for item in items}
    assert "found before" not in repr(items)

def test_a_weld_is_compared_with_a_bearing_only_where_that_leaves_the_spin_alone() -> None:
    """The friction of a plank would turn a free cylinder, and a chimney's upper part would swing: other systems than those."""
    free = {}
    for name in ("plank-on-cylinder", "breaking-chimney", "rod-and-disk-fixed"):
        bench = bench_of(load_problem(find_problem(name)))
        free[name] = [(bench, variant) for variant in variants(bench) if variant.phrase == "compare.free"]
    assert not free["plank-on-cylinder"] and not free["breaking-chimney"]
    [(bench, variant)] = free["rod-and-disk-fixed"]
    told = variant.value(bench, bench.targets["acceleration.theta"])
    other = Study(load_problem(find_problem("rod-and-disk-free")))
    assert scalars_equal(told, other.dynamics.accelerations["theta_ddot"], other.assumptions).is_proved


@pytest.mark.parametrize("name", ["torsion-pendulum", "rod-with-spring"])
def test_a_period_and_its_frequency_are_one_answer(name: str) -> None:
    """Where the problem asks for one, no task wants the other."""
    tasks = [(item.kind, item.asked.quantity) for item in plan_of(name).worksheet().items]
    assert any(quantity.startswith("question.") for _, quantity in tasks)
    assert not [kind for kind, quantity in tasks if quantity.startswith("frequency.") and kind != "compare"]


def test_a_derivation_is_the_lines_of_its_argument_about_what_is_asked() -> None:
    """Of a crate on a truck: forces on the crate, of which the questions are, and no torque about a point of no use."""
    [part] = plan("crate-on-truck").parts
    about = {target.id for wish, _ in part.wishes for id in wish.about if (target := part.bench.targets.get(id))}
    assert about & {"reaction.N_r", "reaction.f"} and not about & {"reaction.B", "reaction.D", "reaction.tau_B"}
    lines = lines_to(part.bench, "reaction.N_r", 6)
    assert lines and all(step.chapter != "forces" for step in lines)


def test_nothing_comes_before_what_does_not_need_it() -> None:
    """N = m g of a wheel that rolls needs neither its energy nor its acceleration."""
    bench = bench_of(load_problem(find_problem("wheel-pulled-by-axle")))
    assert not {"energy", "square.x", "motion.x"} & {step.id for step in lines_to(bench, "along.N", 9)}


def test_a_couple_is_in_newton_metres_and_an_angle_in_degrees() -> None:
    found = default_ranges(study_of(load_text(TURNED, "turned")))
    assert found["C"].unit == "N*m" and found["beta"].unit == "deg" and found["mu"].unit == ""


def test_numbers_let_it_move_as_it_is_told_and_weigh_as_on_earth() -> None:
    """What a spring pushes over a rough floor starts, and gets to where the spring ends."""
    found = middles(default_ranges(study_of(load_text(PUSHED, "pushed"))))
    assert found["k"] * found["d"] > 2 * found["mu"] * found["m"] * found["g"] and found["g"] == pytest.approx(9.8)


def test_a_start_below_is_told_and_an_angle_of_a_place_is_in_degrees() -> None:
    text = PUSHED.replace('"-d"', '"-h"').replace("parameters = {", 'parameters = { beta = "angle",')
    problem = load_text(text + 'points = { Q = ["0", "d*tan(beta)"] }', "below")
    [start] = [part.node for part in _start(problem, "h", Words("en", problem)) if isinstance(part, Math)]
    assert start == t.neg(t.Sym("x")) and "beta" in angles(problem)


PUSHED = """
parameters = { m = "mass", k = "stiffness", d = "length", mu = "number", g = "acceleration" }
coordinates.x = { dimension = "length", start = "-d" }
bodies.block = { shape = "particle", mass = "m", center = ["x", "0"] }
interactions.W = { type = "gravity" }
interactions.F = { type = "force", on = "block.center", force = ["-k*x", "0"] }
constraints.N = { type = "contact", point = "block.center", line = "y = 0", coefficient = "mu", slip = "forward" }
phases = [{ name = "free", event = "reaches", of = "x", at = "0", without = ["F"] }]
"""


TURNED = """
parameters = { m = "mass", C = "torque", beta = "angle, acute", mu = "number", d = "length", g = "acceleration" }
coordinates.s = { dimension = "length", start = "0" }
bodies.block = { shape = "particle", mass = "m", center = ["s*cos(beta)", "s*sin(beta)"] }
interactions.W = { type = "gravity" }
interactions.K = { type = "force", on = "block.center", force = ["2*m*g + C/d", "0"] }
constraints.N = { type = "contact", point = "block.center", line = "y = x*tan(beta)", coefficient = "mu", slip = "forward" }
"""


def test_what_a_question_asks_of_the_numbers_keeps_both_its_sides() -> None:
    """“2θ₀ > π”, under which the rod comes to what is asked, is no condition that 2θ₀ alone is positive."""
    own = replace(problem("rod-pendulum"), questions={"angular velocity of rod where theta = pi/2": {}})
    asked = [demand for demand in conditions(study_of(own)) if names_in(demand.value) == {"theta_0", "pi"}]
    assert asked and all(floating(one.value, {"theta_0": 1.0}) < 0 < floating(one.value, {"theta_0": 2.0}) for one in asked)

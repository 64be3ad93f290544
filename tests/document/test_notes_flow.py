"""What notes leave out and put together, so that a page reads like one of a book."""

from __future__ import annotations

from functools import cache

import pytest

import rbpsym
from rbpsym.document.breaking import table_width
from rbpsym.document.model import (
    Display,
    Document,
    FigureBlock,
    Math,
    Paragraph,
    Ref,
    Section,
    Table,
    Text,
    numbered,
    once_each,
    parts,
)
from rbpsym.document.needless import is_still
from rbpsym.document.notes import plain
from rbpsym.document.notes_sentences import element_sentences
from rbpsym.document.telling import TOO_WIDE
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.mechanics.study import Study
from rbpsym.pictures.pose import DrawnPose
from rbpsym.statement.library import problem_files
from tests.library.derived import stated
from tests.library.derived import unsimulated as derived

NAMES = ("rod-struck-off-center", "ball-slipping-to-rolling", "yo-yo", "spool-pulled-at-angle")


@cache
def page(name: str, detail: str = "standard") -> Document:
    return numbered(rbpsym.notes(derived(name), detail=detail))


def displays(document: Document) -> list[Display]:
    return [part for part in parts(document.sections) if isinstance(part, Display)]


def section(document: Document, chapter: str) -> Section | None:
    return next((found for found in document.sections if found.label == f"section.{chapter}"), None)


def text_of(part: Paragraph) -> str:
    return "".join(inline.text for inline in part.inlines if isinstance(inline, Text))


def text(document: Document) -> str:
    return "\n".join(text_of(part) for part in parts(document.sections) if isinstance(part, Paragraph))


@pytest.mark.parametrize("name", NAMES)
def test_a_speed_that_stays_zero_is_not_a_result(name: str) -> None:
    for shown in displays(page(name)):
        if isinstance(shown.node, t.Chain) and isinstance(shown.node.items[0], t.Pow):
            assert shown.node.items[-1] != t.ZERO


def test_where_no_force_is_unknown_none_is_looked_for() -> None:
    free, rolling = (page(name, "full") for name in ("rod-struck-off-center", "spool-pulled-at-angle"))
    assert section(free, "reactions") is None
    assert section(rolling, "reactions") is not None
    assert "fewest unknown forces" not in text(free)
    assert "fewest unknown forces" in text(rolling)
    assert "No force acts, so nothing changes the energy" in text(free)
    assert "Every force has a potential energy" not in text(free)


def test_a_moment_that_is_given_is_not_called_an_integral() -> None:
    assert "integral over the mass" not in text(page("spool-pulled-at-angle", "full"))
    assert "integral over the mass" in text(page("yo-yo", "full"))


@pytest.mark.parametrize(("name", "count"), [("ball-slipping-to-rolling", 2), ("rod-struck-off-center", 3)])
def test_accelerations_from_the_same_equations_stand_together(name: str, count: int) -> None:
    motion = section(page(name, "full"), "motion")
    boxes = [block for block in motion.blocks if isinstance(block, Display) and block.boxed]
    assert [len(block.node.rows) for block in boxes] == [count]
    lead = motion.blocks[motion.blocks.index(boxes[0]) - 1]
    assert sum(isinstance(inline, Math) for inline in lead.inlines) == count


def test_forces_that_stay_the_same_are_not_called_functions_of_position() -> None:
    for name in ("yo-yo", "ball-slipping-to-rolling"):
        assert "function of position alone" not in text(page(name))
        assert "constant:" in text(page(name))


def test_methods_that_were_left_out_are_told_after_those_that_agree() -> None:
    checks = section(page("ball-slipping-to-rolling", "full"), "checks")
    assert isinstance(checks.blocks[-1], Paragraph)
    items = [inline.text for item in checks.blocks[-2].items for inline in item if isinstance(inline, Text)]
    assert not any("cannot" in item or "does not apply" in item for item in items)


def test_a_phase_refers_to_the_equations_of_motion_that_hold_on() -> None:
    struck = page("rod-struck-off-center", "full")
    assert not any(found.label.startswith("phase2.section.motion") for found in struck.sections)
    sentence = next(p for p in parts(struck.sections) if isinstance(p, Paragraph) and "again" in text_of(p))
    motion = next(block for block in section(struck, "motion").blocks if isinstance(block, Display) and block.boxed)
    assert [inline.mark for inline in sentence.inlines if isinstance(inline, Ref)] == [motion.mark]
    rolling = page("ball-slipping-to-rolling", "full")
    assert any(found.label == "phase2.section.motion" for found in rolling.sections)


def test_the_end_of_a_phase_is_told_with_its_coordinate_and_value() -> None:
    said = text(page("rod-hits-ball-at-bottom"))
    assert "a coordinate" not in said
    ends = [p for p in parts(page("rod-hits-ball-at-bottom").sections) if isinstance(p, Paragraph)]
    end = next(p for p in ends if "The phase before ends when" in text_of(p))
    assert [inline.node for inline in end.inlines if isinstance(inline, Math)] == [t.Sym("theta"), t.ZERO]


def test_a_number_is_cited_once_in_a_list() -> None:
    seven, eight = Ref("a", "(7)"), Ref("b", "(8)")
    assert once_each((seven, Text(", "), seven, Text(" and "), eight)) == (seven, Text(" and "), eight)
    assert once_each((seven, Text(", "), eight, Text(" and "), eight)) == (seven, Text(" and "), eight)
    assert once_each((seven, Text(", "), seven, Text(" and "), seven)) == (seven,)
    apart = (seven, Text(" gives what also "), seven)
    assert once_each(apart) == apart


@pytest.mark.parametrize("name", ["yo-yo", "sliding-ladder", "rod-hits-ball-at-bottom"])
def test_brief_notes_are_short_and_keep_all_results(name: str) -> None:
    brief, standard = page(name, "brief"), page(name)
    counted = [len([shown for shown in displays(one) if shown.numbered]) for one in (brief, standard)]
    assert counted[0] < 0.9 * counted[1]
    assert len(brief.sections) <= len(standard.sections)
    later = enumerate(derived(name).phases, 2)  # beyond the question, which asks how the second phase begins
    beyond = {f"phase{number}.{step.id}" for number, phase in later for step in phase.derivation.steps}
    boxed = [shown for shown in displays(page(name, "full")) if shown.boxed and not shown.label.startswith("ask")]
    results = {row for shown in boxed if shown.label not in beyond for row in t.rows(shown.node)}
    assert results <= {row for found in displays(brief) for row in t.rows(found.node)}
    below = [part for part in parts(brief.sections[1:]) if isinstance(part, Display)]
    road = [found.node for found in below]
    assert len(road) == len(set(road)), "a result is not derived twice on so few pages"


@pytest.mark.parametrize("name", ["yo-yo", "sliding-ladder"])
def test_brief_notes_say_what_every_letter_of_the_statement_means(name: str) -> None:
    problem = derived(name).study.problem
    first = next(found for found in page(name, "brief").sections if found.label == "section.statement")
    paragraphs = [block for block in first.blocks if isinstance(block, Paragraph)]
    told = {n for p in paragraphs for part in p.inlines if isinstance(part, Math) for n in t.names(part.node)}
    assert {q.name for q in problem.parameters} - set(problem.implicit) <= told


def test_brief_notes_keep_what_ties_the_coordinates() -> None:
    assert any("does not stretch" in text_of(p) for p in parts(page("yo-yo", "brief").sections) if type(p) is Paragraph)
    assert {"phi_dot", "y_dot"} <= {name for shown in displays(page("yo-yo", "brief")) for name in t.names(shown.node)}


def test_where_nothing_can_move_nothing_is_said_of_motion() -> None:
    still = page("ladder-with-friction", "full")
    said = text(still)
    for words_ in ("how it moves", "does not turn", "position and speed", "Nothing is free to move", "accelerations"):
        assert words_ not in said
    titles = [plain(found.title) for found in still.sections]
    assert "Static friction" in titles and "The forces along the motion" not in titles
    forces = next(shown for shown in displays(still) if shown.boxed)
    assert {row.items[0].name for row in forces.node.rows} == set(derived("ladder-with-friction").study.system.unknowns)


def test_where_the_motion_is_given_the_forces_are_the_results() -> None:
    driven = derived("slider-crank")
    boxed = [row.items[0] for shown in displays(page("slider-crank", "full")) if shown.boxed for row in t.rows(shown.node)]
    assert {t.Sym(name) for name in driven.study.system.unknowns} <= set(boxed)


def test_a_ledger_is_never_set_in_tiny_letters() -> None:
    for name in ("slider-crank", "ladder-with-friction"):
        document = page(name, "full")
        ledgers = [part for part in parts(document.sections) if isinstance(part, Table) and "forces" in part.label]
        assert all(table_width(ledger, document.notation) <= TOO_WIDE for ledger in ledgers)
        assert ledgers


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_a_line_without_ends_is_taken_for_a_body_that_is_long_enough(name):
    """No condition asks whether what touches a body along a line of it stays between its ends: that is an assumption."""
    problem = stated(problem_files()[name])
    pose, said = DrawnPose(Study(problem)), Words("en", problem)
    told = ["".join(getattr(part, "text", "") for part in found) for found in element_sentences(pose, said)]
    along = {e["of"] for e in problem.constraints if e.values.get("line") is not None and e.values.get("of")}
    assert sum("long enough" in sentence for sentence in told) == len(along)


def test_ends_are_called_as_they_lie_in_the_figure_where_they_may_turn_over():
    swings, slides = (" ".join(captions(page(name))) for name in ("rod-pendulum", "sliding-ladder"))
    assert "as they lie here" in swings and "as they lie here" not in slides


def captions(document: Document) -> list[str]:
    found = [part for part in parts(document.sections) if isinstance(part, FigureBlock)]
    return ["".join(inline.text for inline in block.caption if isinstance(inline, Text)) for block in found]


def test_what_no_question_reaches_is_told_in_full_notes_only() -> None:
    """A rod that is caught: what would happen without the blow does not, nor is it told how it then turns."""
    short, full = ({found.label for found in displays(page("rod-caught-at-end", detail))} for detail in ("standard", "full"))
    assert {"moment.rod", "phase2.moment.rod.P_P", "phase2.after.speeds", "phase2.energy.lost"} <= short
    assert "phase2.motion.theta" in full - short
    assert not {"kinetic", "energy", "position.rod", "phase2.square.theta", "phase2.along.P_x"} & short
    assert {"phase2.square.theta", "phase2.along.P_x"} <= full
    assert "phase2.along.f" in {found.label for found in displays(page("ball-slipping-to-rolling"))}, "it rolls without friction"


def test_where_the_motion_is_given_its_energy_leads_nowhere() -> None:
    labels = {found.label for found in displays(page("crate-on-truck"))}
    assert "free_body.crate" in labels and not {"kinetic", "energy"} & labels


def test_an_integral_is_carried_out_once() -> None:
    first, second = (found.node for found in displays(page("movable-pulley")) if found.label.startswith("moment."))
    assert len(first.items) == 4 and second.items[1:] == first.items[-1:]


@pytest.mark.parametrize(("op", "turned"), [(">", "<"), (">=", "<="), ("!=", "!=")])
def test_a_condition_does_not_begin_with_a_minus(op: str, turned: str) -> None:
    a, b, z = map(t.Sym, "abz")
    assert t.upright(t.relation(t.Neg(z), op, t.ZERO)) == t.relation(z, turned, t.ZERO)
    assert t.upright(t.relation(t.add(t.Neg(a), b, z), op, t.ZERO)) == t.relation(t.add(b, z), op, a)
    assert t.upright(t.relation(t.add(t.ONE, t.Neg(b)), op, t.ZERO)) == t.relation(b, turned, t.ONE)
    assert t.upright(t.relation(t.add(a, t.Neg(b)), op, z)) == t.relation(t.add(a, t.Neg(b)), op, z)


@pytest.mark.parametrize("name", ["falling-rod-hooked", "bullet-in-a-rod"])
def test_what_ties_coordinates_has_plain_angles(name: str) -> None:
    """cos θ and not cos(−θ), sin θ and not cos(θ − π/2)."""
    tied = next(found.node for found in displays(page(name, "full")) if found.label == "phase2.condition.P")
    turned = [node for node in t.walk(tied) if isinstance(node, t.Fn)]
    assert turned and all(node.arg == t.Sym("theta") for node in turned)


@pytest.mark.parametrize("name", ["ladder-with-friction", "three-logs"])
def test_where_nothing_moves_no_speed_is_told(name: str) -> None:
    """A cylinder that rests does not roll with Rω = 0."""
    shown = {part.label.rpartition(".")[0] for part in displays(page(name))}
    assert is_still(derived(name)) and shown.isdisjoint({"no_slip", "taut", "turning", "velocity"})


def test_a_body_is_called_by_the_word_of_its_author() -> None:
    assert "niform cylinder of mass" in text(page("falling-spool"))

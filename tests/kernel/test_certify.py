"""The paper's four problems in the words of Rocq: each step from its listed premises, and what coqc says of them."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from functools import cache

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.commands.certify import lines
from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.field.scalar import symbol
from rbpsym.kernel.certificates import Lemma, formulas, reduced
from rbpsym.kernel.certify import Written, declared, results, text, written
from rbpsym.kernel.claim import AHEAD, Proposition
from rbpsym.kernel.coqc import AXIOMS, Report, compiled, has_coqc, together, with_prelude
from rbpsym.kernel.proofs import Search
from rbpsym.kernel.rocq import REFUSED, identifier
from tests.kernel.spoiling import come_through, draws
from tests.library.derived import unsimulated

pytestmark = pytest.mark.heavy(of=4)

PAPER = ("rod-and-disk-fixed", "rod-and-disk-free", "sliding-ladder", "sliding-ladder-with-spring")
needs_coqc = pytest.mark.skipif(not has_coqc(), reason="coqc is not installed (apt: coq libcoq-coquelicot)")
each_problem = pytest.mark.parametrize("name", PAPER)


@cache
def found(name: str) -> Written:
    return written(unsimulated(name))


@cache
def report(name: str) -> Report:
    return compiled(found(name))


# --- without coqc


@each_problem
def test_every_step_follows_from_its_listed_premises(name: str) -> None:
    assert not found(name).refused


@each_problem
def test_nothing_is_assumed_in_the_text(name: str) -> None:
    body = text(found(name))
    assert not re.search(r"\b(Admitted|Axiom|Parameter|admit|Conjecture)\b", body)
    hypotheses = re.findall(r"^Hypothesis (\S+) ", body, re.MULTILINE)
    assert all(word.startswith(("above'", "rate'", "steady'")) for word in hypotheses), "signs and the motion alone"


@each_problem
def test_a_lemma_names_only_what_its_step_lists(name: str) -> None:
    derivation = found(name).source.derivation
    ranges = declared(found(name).source)
    for id, lemmas in found(name).lemmas.items():
        allowed = {id, *derivation.step(id).premises}
        for lemma in lemmas:
            listed = lemma.premises.keys() - ranges.keys()
            assert {premise.rpartition("'")[0] for premise in listed} <= set(map(identifier, allowed)), lemma.name


@each_problem
def test_nothing_is_divided_by_a_letter_that_a_premise_says_to_vanish(name: str) -> None:
    """A work is no multiple of 1/τ where τ = 0 (the factors of linear algebra were not looked through for negative powers)."""
    for lemma in (lemma for each in found(name).lemmas.values() for lemma in each):
        gone = {item.left.name for item in lemma.premises.values() if item.right == t.ZERO and isinstance(item.left, t.Sym)
                and item.kind == "equal"}  # fmt: skip
        for part in (part for node in formulas(lemma.proof) for part in t.walk(node)):
            is_power = isinstance(part, t.Pow) and isinstance(part.exponent, t.Num) and part.exponent.value < 0
            below = part.den if isinstance(part, t.Div) else part.base if is_power else t.ONE
            assert not gone & t.names(below), (lemma.name, below)


LONG = [pytest.param(name, marks=pytest.mark.thorough) for name in ("half-disk-rocking", "double-compound-pendulum")]


@pytest.mark.parametrize("name", ["marble-in-half-smooth-bowl", *LONG])
def test_what_has_no_words_yet_is_told_by_its_step(name: str) -> None:
    whole = found(name)
    assert whole.refused and all(whole.refused.values())
    assert {*whole.refused, *whole.lemmas} == {step.id for step in whole.source.derivation.steps}


def test_multiples_are_found_with_their_account() -> None:
    a, b, m, s, c = map(symbol, ("a", "b", "m", "sin x", "cos x"))
    known = [m * a * s - b, m * a * c - 1]
    rest, multiples, _ = reduced(m * a - b * s - c, known, lambda index: 0, lambda value: True)
    assert rest and not multiples, "without letters to replace nothing is taken off"
    order = {name: place for place, name in enumerate("ab", 1)}
    rest, multiples, _ = reduced(b - s * m * a, known, lambda i: order.get(symbol_of(i), 0), lambda value: len(value.num) == 1)
    assert not rest and set(multiples) == {0}


def symbol_of(index: int) -> str:
    from rbpsym.field.atoms import symbol_name

    return symbol_name(index) or ""


@pytest.mark.parametrize("names", [("R", "R_", "R__"), ("fun", "fun_"), ("N_w", "N'w"), ("t", "t_")])
def test_different_letters_stay_different(names: tuple[str, ...]) -> None:
    assert len(set(map(identifier, names))) == len(names) and not {"R", "fun", "t"} & set(map(identifier, names))


# --- with coqc


@needs_coqc
@each_problem
def test_coqc_accepts_a_sample(name: str) -> None:
    """Every fourth step of each; all of them in the thorough tier."""
    whole = found(name)
    told = compiled(Written(whole.source, dict(list(whole.lemmas.items())[::4])))
    assert not told.refused and told.steps > 3
    assert set(told.axioms or ()) <= AXIOMS


@pytest.mark.thorough
@needs_coqc
@each_problem
def test_coqc_accepts_all_that_is_written(name: str) -> None:
    told = report(name)
    assert not told.refused
    assert set(told.axioms or ()) <= AXIOMS


def spoilt(lemma: Lemma, place: int, right: t.Node) -> Lemma:
    return replace(lemma, name=f"{lemma.name}'{place}", claim=replace(lemma.claim, right=right))


def spoilings(claim: Proposition) -> list[t.Node]:
    """Right sides that are wrong: one more, twice."""
    more = t.Add((claim.right, t.ONE))
    return [more] if claim.right == t.ZERO else [more, t.Mul((t.TWO, claim.right))]


@needs_coqc
def test_coqc_refuses_what_is_spoilt() -> None:
    """The proofs of a wrong claim: each is refused."""
    whole = found("sliding-ladder")
    each = {
        id: [spoilt(item, place, right) for item in lemmas for place, right in enumerate(spoilings(item.claim), 1)]
        for id, lemmas in list(whole.lemmas.items())[::6]
    }
    names = {item.name for lemmas in each.values() for item in lemmas}
    told = with_prelude([text(Written(whole.source, lemmas=each), trial=True)])[0].stdout
    assert set(re.findall(rf"^{REFUSED}(\S+)", told, re.MULTILINE)) == names and len(names) > 12


@needs_coqc
@pytest.mark.parametrize("name", ["rod-and-disk-free", "rod-and-disk-fixed", "sliding-ladder-with-spring"])
def test_coqc_refuses_what_is_spoilt_at_random(name: str) -> None:
    """Another sign or factor, without a premise or a range: neither the old proof nor one that is sought anew is accepted."""
    steps = draws(found(name), seed=17, count=10)
    assert len(steps) == 10 and not come_through(found(name), steps)


@each_problem
def test_a_result_stands_on_laws_and_definitions_alone(name: str) -> None:
    """As one theorem: its hypotheses are no steps, and what leads to it is given by name."""
    told = [line for line in results(found(name)) if line.startswith("Theorem motion'")]
    assert told
    for theorem in told:
        *grounds, _ = theorem.partition(" : ")[2].partition(".\n")[0].split(" -> ")
        assert all(re.match(r"(law|start|range|shape|def)'|.*'d\d+$", ground) for ground in grounds), grounds
        assert not grounds or any(ground.startswith("law'") for ground in grounds)


@needs_coqc
def test_a_wrong_proof_is_reported_by_its_step() -> None:
    whole = found("sliding-ladder")
    [right] = whole.lemmas["balance.ladder"]
    wrong = spoilt(right, 1, t.ONE)
    told = compiled(Written(whole.source, {"balance.ladder": [wrong], "energy": whole.lemmas["energy"]}, {"rest": "why"}))
    assert set(told.refused) == {"balance.ladder", "rest"} and told.steps == 3


@needs_coqc
def test_coqchk_agrees_with_what_is_compiled() -> None:
    whole = found("sliding-ladder")
    told = compiled(Written(whole.source, {"energy": whole.lemmas["energy"]}), check=True)
    assert told.checked and told.is_sound and told.axioms


def test_a_report_with_which_coqchk_does_not_agree_is_not_sound() -> None:
    told = [together([("", replace(SOME, checked=True)), ("phase2.", replace(SOME, checked=agrees))]) for agrees in (True, False)]
    assert [report.is_sound for report in told] == [True, False]
    assert [[*lines(report)][-1].rpartition("; ")[2] for report in told] == ["coqchk agrees", "coqchk does not agree"]


# --- the command


def test_the_command_writes_both_files(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.kernel.coqc.has_coqc", lambda: False)
    done = CliRunner().invoke(main, ["certify", "sliding-ladder", "-o", str(tmp_path)], standalone_mode=False)
    assert {path.name for path in tmp_path.iterdir()} == {"Prelude.v", "sliding_ladder.v"}
    assert "there is no coqc" in done.output


@pytest.mark.parametrize("name", ["dog-on-flatboat", "cart-pulled-over-pulley", "coupled-cylinders-on-incline"])
def test_integrals_over_the_time_roots_and_several_bodies_are_written(name: str) -> None:
    """An integral over the time runs along it; of these each step has a proof, and the text is closed."""
    whole = found(name)
    assert len(whole.refused) <= 1
    body = text(whole)
    assert not re.search(r"\(RInt \(fun x\d* : R => [^)]*\(\w+ t\)", body), "what moves is not held fixed below an integral"
    assert body.count("'holds : ") == sum(map(len, whole.lemmas.values()))


SOME = Report(49, 90, {"motion.theta": "why"}, tuple(sorted(AXIOMS)), 1.0)


def test_what_is_not_certified_has_another_mark_than_a_check(monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.commands.derive.report_on", lambda path: SOME)
    plain = CliRunner().invoke(main, ["derive", "sliding-ladder"], standalone_mode=False).output
    told = CliRunner().invoke(main, ["derive", "sliding-ladder", "--certified"], standalone_mode=False).output
    assert "○" not in plain and told.count("○") == 1 and plain.count("✓") == told.count("✓") + 1
    assert "motion.theta: why" in told and "48 of 49 steps certified by coqc" in told


def test_without_coqc_nothing_is_marked_as_certified(monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.commands.derive.report_on", lambda path: replace(SOME, axioms=None))
    told = CliRunner().invoke(main, ["derive", "sliding-ladder", "--certified"], standalone_mode=False).output
    assert "✓" not in told and "○" in told


def test_json_says_what_is_certified(monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.commands.solve.report_on", lambda path: SOME)
    command = ["solve", "sliding-ladder", "--json", "--no-simulation"]
    told = json.loads(CliRunner().invoke(main, [*command, "--certified"], standalone_mode=False).output)
    assert told["certified"] == {
        "steps": 49, "certified": 48, "not_certified": {"motion.theta": "why"}, "axioms": sorted(AXIOMS),
    }  # fmt: skip
    assert "certified" not in json.loads(CliRunner().invoke(main, command, standalone_mode=False).output)


def test_a_motion_that_sets_out_from_an_end_of_its_range_is_within_only_later() -> None:
    """Else start and range contradict each other, and everything follows from them."""
    whole = written(unsimulated("cylinder-off-cylinder"), ())
    ranges = [claim for name, claim in declared(whole.source).items() if name.startswith("range'theta'")]
    assert ranges and all(claim.given == (AHEAD,) for claim in ranges)
    assert all(not claim.given for name, claim in declared(written(unsimulated("sliding-ladder"), ()).source).items())


def test_signs_that_take_a_gap_a_least_value_or_pi() -> None:
    """R > a declared; a mass that may be 0; 9π > 16 cos θ."""
    for name, id in (("rod-in-bowl", "motion.theta"), ("double-atwood", "motion.x"), ("half-disk-rocking", "motion.theta")):
        assert id in written(unsimulated(name), [id]).lemmas, name


# Linear systems and their amplitudes, arccosines within a declared bound, cosines of sums beside products, Iω² as one, and
MENDED = {  # what is three integrals deep, divides by what a premise keeps positive, needs the root that is left, nested roots
    "ball-in-a-loop": ("moment.ball", "friction.N", "linear.1"), "cylinder-off-cylinder": ("at_loss.N.f",),
    "half-ring-on-its-end": ("frequency.1",), "elastic-pendulum": ("rest", "linear.1", "characteristic.1"),
    "bead-on-turning-hoop": ("equilibrium.3", "linear.3", "frequency.3"), "rod-on-two-strings": ("linear.1",),
    "brake-drum": ("energy.change",), "bar-in-two-slots": ("linear.1",),
    # a root of a distance within an integral, of a number, what divides a force that does not vanish
    "rod-with-spring": ("work.S.rod", "equilibrium.1"), "double-compound-pendulum": ("modes.1",),
    "rod-falling-on-rough-floor": ("friction.N",),
}  # fmt: skip


def test_a_wrong_polynomial_of_modes_does_not_follow_from_the_linear_equations() -> None:
    whole = written(unsimulated("elastic-pendulum"), ["characteristic.1"])
    for lemma in whole.lemmas["characteristic.1"]:
        wrong = replace(lemma.claim, left=t.Add((lemma.claim.left, t.Sym("m"))))
        with pytest.raises(Undecided):
            Search(whole.source, dict(lemma.premises)).prove(wrong)


@needs_coqc
@pytest.mark.parametrize("name", MENDED)
def test_integrals_factors_and_roots_carry_the_signs_that_they_need(name: str) -> None:
    whole = written(unsimulated(name), MENDED[name])
    told = compiled(Written(whole.source, {id: whole.lemmas[id] for id in MENDED[name]}))
    assert not told.refused and told.steps == len(MENDED[name])

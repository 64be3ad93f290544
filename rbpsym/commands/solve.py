"""`rbpsym solve`: the results of a problem, for machines or in short for people."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import click

from rbpsym.commands.arguments import found, name_argument, stated
from rbpsym.commands.certify import lines as told
from rbpsym.commands.certify import report_on
from rbpsym.frozen import Frozen

if TYPE_CHECKING:
    from rbpsym.statement.model import Problem

FINE, DOUBTFUL = 0, 1
FUNCTIONS = {"sin", "cos", "tan", "sqrt", "asin", "acos", "atan", "exp", "log", "ln", "pi"}
CLOSE = 1e-8  # relative error that a simulation may have


@click.command("solve")
@name_argument
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON, for programs.")
@click.option("--simulation/--no-simulation", default=True, show_default=True, help="Run the numerical oracle too.")
@click.option("--certified", is_flag=True, help="Tell too what Rocq certifies (takes a while).")
def command(name: str, as_json: bool, simulation: bool, certified: bool) -> int:
    """Print the results of a problem: accelerations, forces, energies, works, equilibria.

    \b
    Examples:
      rbpsym solve sliding-ladder
      rbpsym solve sliding-ladder --json | jq -r .accelerations.theta
      rbpsym solve my-problem.toml --json --no-simulation

    In JSON, expressions are text that Python and sympy read: `**`, `sin`, `cos`, `sqrt`; the speed
    of a coordinate theta is `theta_dot`. What has no closed form is null.
    """

    problem, answer = _answer(name, simulation)
    report = report_on(found(name, ("problem",))[1]) if certified else None
    if report is not None:
        answer["certified"] = report.record()
    if as_json:
        import json

        click.echo(json.dumps(answer, indent=2, ensure_ascii=False))
    else:
        click.echo("\n".join([*lines(answer, problem), *([] if report is None else told(report))]))
    is_answered = all(item["verdict"] == "PROVED" for item in answer["questions"])
    return exit_code(answer["verdicts"]) if is_answered else DOUBTFUL


def _answer(name: str, simulation: bool) -> tuple[Problem, dict[str, Any]]:
    from rbpsym.commands.progress import Progress
    from rbpsym.solve import solve

    _, path = found(name, ("problem",))
    problem = stated(path)
    with Progress(f"deriving {name}"):
        return problem, solve(problem, simulation=simulation)


def exit_code(verdicts: Mapping[str, Any]) -> int:
    """0 if all is proved and the roads agree, 1 if not."""
    doubtful = verdicts["refuted"] or verdicts["undecided"] or not verdicts["methods_agree"]
    simulation = verdicts["simulation"] or {"max_relative_error": 0.0}
    apart = not simulation["max_relative_error"] <= CLOSE  # also if it is not a number
    return DOUBTFUL if doubtful or apart or verdicts["lagrange"] not in ("PROVED", None) else FINE


def lines(answer: Mapping[str, Any], problem: Problem) -> Iterator[str]:
    """The results in short, as a textbook prints them."""
    drawn = InLetters(problem)
    yield click.style(drawn.title, bold=True)
    yield from _asked(answer["questions"], drawn)
    speeds = {f"{name}_dot**2": value for name, value in (answer["speed_squared"] or {}).items()}
    accelerations = _dotted(answer["accelerations"], 2)
    energies = {"K": answer["kinetic_energy"]["total"], "U": answer["potential_energy"]}
    there = _there(answer)
    for title, values in (
        ("moments of inertia", {f"I__{name}": value for name, value in answer["moments_of_inertia"].items()}),
        (f"speeds{there}", _dotted((answer["at_start"] or {}).get("speeds"))),
        (f"accelerations{there}", accelerations),
        ("squares of speeds", speeds),
        (f"unknown forces{there}", answer["reactions"]),
        ("unknown forces along the motion", answer["reactions_along_motion"]),
        ("energy", energies),
        *_moves(answer.get("kinematics", {})),
    ):
        yield from table(title, values, drawn)
    yield from _begins(answer, drawn)
    yield from _equilibria(answer, drawn)
    yield from _balance(answer["balance"], drawn)
    yield from _conditions(answer, drawn)
    yield from _friction(answer, drawn)
    for phase in answer["phases"]:
        yield from _phase(phase, drawn)
    yield ""
    yield verdict_line(answer["verdicts"])


MOVES = {"velocity": "velocities", "acceleration": "accelerations of the centres", "angular_velocity": "angular velocities",
         "angular_acceleration": "angular accelerations", "instantaneous_centre": "instantaneous centres"}  # fmt: skip
LETTERS = dict(zip(MOVES, ("V", "A", "omega", "alpha", "C"), strict=True))


def _moves(answer: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, str | None]]]:
    """How the bodies move where nothing is asked of forces, a vector as its components."""
    for key, title in MOVES.items():
        parts = {name: told[key] for name, told in answer.items() if told[key] is not None}
        vectors = {name: zip("xy", told, strict=True) if isinstance(told, list) else [("", told)] for name, told in parts.items()}
        yield title, {f"{LETTERS[key]}__{name}{axis and f'_{axis}'}": v for name, both in vectors.items() for axis, v in both}


def _asked(questions: list[Mapping[str, Any]], drawn: InLetters) -> Iterator[str]:
    """What the problem asks, with the answers: a value, yes or no, a sentence; the verdict where it is not proved."""
    if questions:
        yield click.style("what is asked", dim=True)
    for item in questions:
        said = YES.get(item["answer"]) or item.get("says") or item["reason"]
        value = None if item["answer"] in (None, *YES) else drawn.formula(item["answer"])
        doubt = "" if item["verdict"] == "PROVED" else f" ({item['verdict']})"
        yield f"  {item['question']}: {value or said}{_valid(item, drawn)}{doubt}"


YES = {"True": "yes", "False": "no"}


def _there(told: Mapping[str, Any]) -> str:
    """Where accelerations and forces are told, if not for every position."""
    return " at the start" if told["at_start"] else ""


def _dotted(values: Mapping[str, str] | None, order: int = 1) -> dict[str, str]:
    """Speeds or accelerations by their names."""
    return {f"{name}_{'d' * order}ot": value for name, value in (values or {}).items()}


class InLetters(Frozen):
    """How the infix text of an answer is printed: with the letters of the problem."""

    problem: Problem

    @property
    def title(self) -> str:
        """The problem's title."""
        return self.problem.title.get("en") or self.problem.name

    def name(self, text: str) -> str:
        """The name of a quantity, or the square of one."""
        from rbpsym.expr import tree as t
        from rbpsym.expr.glyphs import Notation
        from rbpsym.typeset.text import to_text

        name, square, _ = text.partition("**2")
        return to_text(t.Pow(t.Sym(name), t.TWO) if square else t.Sym(name), Notation(self.problem.notation))

    def formula(self, text: str) -> str:
        """A formula or relation in Unicode; text that our reader does not know stays as it is, what nobody reads is left out."""
        from rbpsym.errors import RbpsymError
        from rbpsym.expr.glyphs import Notation
        from rbpsym.expr.infix import read_infix, read_relation
        from rbpsym.typeset.text import to_text

        if len(text) > LONGEST:
            return f"a formula of {len(text)} characters: see --json"
        words = set(re.findall(r"[A-Za-z]\w*", text)) - FUNCTIONS
        read = read_relation if re.search("[<>=]", text) else read_infix
        try:
            return to_text(read(text, dict.fromkeys(words)), Notation(self.problem.notation))
        except RbpsymError:
            return text


def table(title: str, values: Mapping[str, str | None] | None, drawn: InLetters) -> Iterator[str]:
    """One group of results."""
    from rbpsym.typeset.escaping import columns, padded

    known = {drawn.name(name): drawn.formula(value) for name, value in (values or {}).items() if value is not None}
    width = max(map(columns, known), default=0)
    if known:
        yield click.style(title, dim=True)
        yield from (f"  {padded(name, width)} = {value}" for name, value in known.items())


def _places(values: Mapping[str, str], drawn: InLetters) -> str:
    return ", ".join(f"{drawn.formula(name)} = {drawn.formula(value)}" for name, value in values.items())


LONGEST = 800
STABLE = {True: "stable", False: "unstable", None: "stability undecided"}


def _begins(answer: Mapping[str, Any], drawn: InLetters) -> Iterator[str]:
    if answer["start_valid_where"]:
        yield f"the motion begins so only{_valid({'valid_where': answer['start_valid_where']}, drawn)}"


def _equilibria(answer: Mapping[str, Any], drawn: InLetters) -> Iterator[str]:
    if answer["equilibria"]:
        yield click.style("equilibria", dim=True)
    for item in answer["equilibria"]:
        squares = ", ".join(drawn.formula(value) for value in item["frequencies_squared"])
        told = f"; squares of frequencies: {squares}" if squares and item["stable"] else ""
        told += "".join(
            f"; one mode dies out at the rate {drawn.formula(mode['decay_rate'])}, and swings where this is positive, "
            f"with the square of the frequency {drawn.formula(mode['frequency_squared'])}"
            for mode in (item["stable"] is not False and item["damping"]) or ()
        )
        yield f"  {_places(item['at'], drawn)}{_valid(item, drawn)}: {_stability(item, drawn)}{told}"
    if not answer["at_start"] and not drawn.problem.unstated:
        yield from _not_all("equilibria", answer["equilibria_complete"])


def _valid(item: Mapping[str, Any], drawn: InLetters) -> str:
    """The conditions under which something is said."""
    told = ", ".join(map(drawn.formula, item["valid_where"]))
    return f" (where {told})" if told else ""


def _not_all(what: str, found: Mapping[str, Any]) -> Iterator[str]:
    if found["complete"] is not True:
        told = "not decided whether these are all" if found["complete"] == "undecided" else "these are not all"
        yield f"  {click.style(f'{told} {what}:', dim=True)} {found['reason']}"


def _balance(item: Mapping[str, Any] | None, drawn: InLetters) -> Iterator[str]:
    if item is None:
        return
    yield click.style("equilibrium (no formula found)", dim=True)
    square = item["frequency_squared"]
    told = f"; square of the frequency there: {drawn.formula(square)}" if square else ""
    yield f"  where {drawn.formula(item['vanishes'])} = 0: {STABLE[item['stable']]}{told}"


def _stability(item: Mapping[str, Any], drawn: InLetters) -> str:
    where = item["stable_where_positive"]
    return (
        ("asymptotically " if item["stability"] == "asymptotic" else "") + STABLE[item["stable"]]
        if where is None
        else f"stable where {drawn.formula(where)} > 0, unstable where it is < 0"
    )


def _conditions(answer: Mapping[str, Any], drawn: InLetters) -> Iterator[str]:
    if answer["conditions"]:
        yield click.style("loss of contact", dim=True)
    for item in answer["conditions"]:
        where = f"at {_places(item['at'], drawn)}" if item["at"] else f"where {drawn.formula(item['vanishes'])} = 0"
        yield f"  {drawn.formula(item['force'])} vanishes {where}{_valid(item, drawn)}"
    for item in answer["one_sided"]:
        if item["state"] in ("asked", "open"):
            yield f"  {drawn.formula(item['force'])} has the sign that it can have only{_valid(item, drawn)}"
    if answer["at_start"]:
        yield click.style(answer["at_start"]["reason"], dim=True)
    else:
        yield from _not_all("losses of contact", answer["conditions_complete"])


def _friction(answer: Mapping[str, Any], drawn: InLetters) -> Iterator[str]:
    needed = [item for item in answer["static_friction"] if item["needed"] is not None]
    if needed:
        yield click.style("static friction that is needed", dim=True)
    for item in needed:
        yield f"  {drawn.formula(item['friction'])}: coefficient of at least {drawn.formula(item['needed'])}"


def _phase(phase: Mapping[str, Any], drawn: InLetters) -> Iterator[str]:
    """A further phase: when and where it begins, how fast things then move, what the blow brought and cost."""
    yield click.style(f"phase “{phase['name']}”", bold=True)
    if "reason" in phase:
        yield f"  {phase['reason']}"
        return
    values = {"t": phase["time"], **(phase["at"] or {})}
    if phase["valid_where"]:
        yield f"  the motion comes there only{_valid(phase, drawn)}"
    yield from (f"  {line}" for line in _begins(phase, drawn))
    yield from table("begins at", values, drawn)
    yield from table("with the speeds", _dotted(phase["speeds"]), drawn)
    yield from table("impulses", {n: v for n, v in (phase["impulses"] or {}).items() if v != "0"}, drawn)
    if phase["energy_taken"] not in (None, "0"):
        yield f"  {click.style('energy taken in the phase before', dim=True)} {drawn.formula(phase['energy_taken'])}"
    if phase["energy_lost"] not in (None, "0"):
        yield f"  {click.style('energy lost', dim=True)} {drawn.formula(phase['energy_lost'])}"
    yield from table(f"accelerations{_there(phase)}", _dotted(phase["accelerations"], 2), drawn)
    yield from table(f"unknown forces{_there(phase)}", phase["reactions"], drawn)
    yield from _friction(phase, drawn)


def verdict_line(verdicts: Mapping[str, Any]) -> str:
    """What was proved, in one line."""
    parts = [f"{verdicts['proved']} of {verdicts['steps']} steps proved"]
    if len(verdicts["methods"]) > 1 or not verdicts["methods_agree"]:
        parts.append("methods agree" if verdicts["methods_agree"] else "METHODS DISAGREE")
    parts.append(f"Lagrange: {str(verdicts['lagrange']).lower()}")
    if verdicts["simulation"]:
        error = verdicts["simulation"]["max_relative_error"]
        parts.append(f"simulation {'agrees to' if error <= CLOSE else 'DIFFERS by'} {error:.0e}")
    parts += [f"{item['what']} {GIVEN_UP[item['why']]}" for item in verdicts["left_out"] if item["why"] in GIVEN_UP]
    return "; ".join(parts)


GIVEN_UP = {"too_long": "left out (too long)", "cut": "left out in part (too long)", "simulation": "gave up"}

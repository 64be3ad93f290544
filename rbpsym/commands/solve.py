"""`rbpsym solve`: the results of a problem, for machines or in short for people."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import click

from rbpsym.commands.arguments import name_argument

DOUBTFUL = 1


@click.command("solve")
@name_argument
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON, for programs.")
@click.option("--simulation/--no-simulation", default=True, show_default=True, help="Run the numerical oracle too.")
def command(name: str, as_json: bool, simulation: bool) -> int:
    """Print the results of a problem: accelerations, forces, energies, works, equilibria.

    \b
    Examples:
      rbpsym solve sliding-ladder
      rbpsym solve sliding-ladder --json | jq -r .accelerations.theta
      rbpsym solve my-problem.toml --json --no-simulation

    In JSON, expressions are text that Python and sympy read: `**`, `sin`, `cos`, `sqrt`; the speed
    of a coordinate theta is `theta_dot`. What has no closed form is null.
    """
    answer = _answer(name, simulation)
    if as_json:
        import json

        click.echo(json.dumps(answer, indent=2, ensure_ascii=False))
    else:
        click.echo("\n".join(lines(answer)))
    return exit_code(answer["verdicts"])


def _answer(name: str, simulation: bool) -> dict[str, Any]:
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.shelf import found
    from rbpsym.solve import solve
    from rbpsym.statement.loader import load_problem

    _, path = found(name, ("problem",))
    with Progress(f"deriving {name}"):
        return solve(load_problem(path), simulation=simulation)


def exit_code(verdicts: Mapping[str, Any]) -> int:
    """0 if all is proved and the roads agree, 1 if not."""
    doubtful = verdicts["refuted"] or verdicts["undecided"] or not verdicts["methods_agree"]
    return DOUBTFUL if doubtful or verdicts["lagrange"] == "REFUTED" else 0


def lines(answer: Mapping[str, Any]) -> Iterator[str]:
    """The results in short."""
    yield click.style(answer["problem"], bold=True)
    for title, key in (("accelerations", "accelerations"), ("squares of speeds", "speed_squared"),
                       ("unknown forces", "reactions"), ("forces along the motion", "reactions_along_motion")):
        yield from table(title, answer[key])
    yield from table("energy", {"kinetic": answer["kinetic_energy"]["total"], "potential": answer["potential_energy"]})
    yield from _conditions(answer)
    yield ""
    yield verdict_line(answer["verdicts"])


def table(title: str, values: Mapping[str, str | None] | None) -> Iterator[str]:
    """One group of results."""
    known = {name: value for name, value in (values or {}).items() if value is not None}
    if known:
        yield click.style(title, dim=True)
        yield from (f"  {name} = {value}" for name, value in known.items())


def _conditions(answer: Mapping[str, Any]) -> Iterator[str]:
    for item in answer["conditions"]:
        place = ", ".join(f"{n} = {v}" for n, v in (item["at"] or {}).items())
        yield f"  contact {item['force']} is lost " + (f"at {place}" if place else f"where {item['vanishes']} = 0")


def verdict_line(verdicts: Mapping[str, Any]) -> str:
    """What was proved, in one line."""
    parts = [f"{verdicts['proved']} of {verdicts['steps']} steps proved"]
    if verdicts["methods"]:
        parts.append("methods agree" if verdicts["methods_agree"] else "METHODS DISAGREE")
    parts.append(f"Lagrange: {str(verdicts['lagrange']).lower()}")
    if verdicts["simulation"]:
        parts.append(f"simulation agrees to {verdicts['simulation']['max_relative_error']:.0e}")
    return "; ".join(parts)

"""`rbpsym tutor`: a problem worked out line by line, each line judged at once."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import click

from rbpsym.commands.arguments import FILE, found, name_argument

HINT, END = ("?", "hint"), ("", "quit", "exit")


@click.command("tutor")
@name_argument
@click.option("--record", metavar="FILE", type=FILE, help="Write the lines and their verdicts.")
def command(name: str, record: Path | None) -> int:
    """Work on a problem line by line: each line is judged at once, in any order.

    \b
    Examples:
      rbpsym tutor sliding-ladder
      rbpsym tutor my-problem.toml --record ana.json

    Lines are typed plainly (theta_ddot = -3*g/(4*ell)*cos(theta)) or in LaTeX. “?” gives a hint for the next
    step, more with each “?”; an empty line or the end of input ends.
    """
    import json

    from rbpsym.commands.progress import Progress
    from rbpsym.derive import derive
    from rbpsym.document.files import write_whole
    from rbpsym.statement.loader import load_problem
    from rbpsym.studio.tutor import Tutor

    path = found(name, ("problem",))[1]
    with Progress(f"deriving {path.stem}"):
        tutor = Tutor(derive(load_problem(path), simulation=False))
    lines, given, depth = list[str](), list[str](), 0
    for line in _typed():
        if line in HINT:
            depth += 1
            told, step = tutor.hint((*lines, *given), depth)
            click.echo(f"  {told}")
            if step:  # the next hint is of the step after it
                given, depth = [*given, step], 0
            continue
        judged = tutor.judge(line, lines)
        click.echo(f"  {judged.verdict}. {judged.says}")
        lines.append(line)
        depth = 0
    if record:
        click.echo(str(write_whole(record, json.dumps(tutor.record(lines), indent=2, ensure_ascii=False) + "\n")))
    return 0


def _typed() -> Iterator[str]:
    """The lines up to an empty one; Ctrl-D and Ctrl-C end as well, and the record is still written."""
    with suppress(click.Abort):
        while (line := click.prompt("", default="", show_default=False, prompt_suffix="> ").strip()) not in END:
            yield line

"""The command `rbpsym`. What a command needs is imported when that command runs.

`--help`, `list` and completion import neither sympy nor numpy, jinja2 or rich: a test says so.
"""

from __future__ import annotations

import atexit
import gc
import os
import sys
import traceback
from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import Any

import click

from rbpsym import __version__
from rbpsym.errors import RbpsymError

SELDOM = 200_000  # objects more, until the collector looks for circles: a derivation makes none
FINE, DOUBTFUL, BAD_INPUT, BROKEN, INTERRUPTED = 0, 1, 2, 70, 130

# each a module of `rbpsym.commands` that holds its `command`; in the order of --help
COMMANDS = ("list", "notes", "plot", "derive", "solve", "ask", "check", "certify", "explore", "worksheet", "grade", "new",
            "tutor", "studio", "schema", "lsp", "doctor")  # fmt: skip


class Rbpsym(click.Group):
    """The group of all commands; it turns every error into a sentence and an exit code."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of the commands, in the order in which one meets them."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name, imported now."""
        return import_module(f"rbpsym.commands.{cmd_name}").command if cmd_name in COMMANDS else None

    def resolve_command(self, ctx: click.Context, args: list[str]) -> tuple[str | None, click.Command | None, list[str]]:
        """The command that the first argument names; an unknown one is met with the nearest."""
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            from rbpsym.statement.source import did_you_mean

            hint = did_you_mean(args[0], COMMANDS, "commands")
            raise click.UsageError(f"there is no command “{args[0]}”; {hint}", ctx)
        return super().resolve_command(ctx, args)

    def main(self, args: Any = None, *, standalone_mode: bool = True, **extra: Any) -> Any:  # type: ignore[override]  # by name
        """Run; in standalone mode leave with the exit code that the README tells."""
        call = partial(super().main, args, standalone_mode=False, **{**extra, "prog_name": "rbpsym"})
        if not standalone_mode:
            return call()
        gc.set_threshold(SELDOM)
        atexit.register(gc.freeze)  # what is there at the end goes with the process
        return sys.exit(exit_code(call))


def exit_code(run: Callable[[], object]) -> int:
    """The exit code of a call, its errors told on stderr."""
    try:
        code = run()
        return code if isinstance(code, int) else FINE
    except RbpsymError as error:
        click.echo(str(error), err=True)
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return BAD_INPUT
    except (click.Abort, KeyboardInterrupt):
        click.echo("interrupted: nothing was written.", err=True)
        return INTERRUPTED
    except MemoryError:
        click.echo("there is not enough memory for this problem.", err=True)
        return BROKEN
    except Exception as error:
        click.echo(unexpected(error), err=True)
        return BROKEN


def unexpected(error: Exception) -> str:
    """The sentence for an error that is ours; with RBPSYM_DEBUG=1 its traceback too."""
    told = f"an error inside rbpsym {__version__}, not in your input: {type(error).__name__}: {error}"
    if os.environ.get("RBPSYM_DEBUG"):
        return "".join(traceback.format_exception(error)) + told
    return f"{told}\n  please report it with the problem file and what RBPSYM_DEBUG=1 rbpsym … prints."


@click.group(
    cls=Rbpsym,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="""\b
Begin here:
  rbpsym list              what ships with rbpsym
  rbpsym derive NAME       the derivation of one of them, in the terminal
  rbpsym notes NAME        lecture notes: PDF, HTML and LaTeX
  rbpsym explore NAME      a page in which it moves
  rbpsym new my-problem    a problem file of your own

\b
Exit codes: 0 fine, 1 something was refuted or is undecided, 2 bad input.
Completion: eval "$(_RBPSYM_COMPLETE=bash_source rbpsym)"  (or zsh_source, fish_source)""",
)
@click.version_option(__version__, "-V", "--version", prog_name="rbpsym", message="%(prog)s %(version)s")
def main() -> None:
    """Derive the plane motion of rigid bodies, prove every step, write lecture notes.

    A problem is a short TOML file that says what is true of a system: its bodies, what acts on
    them and what constrains them. It holds no result: rbpsym derives the equations and proves
    each of them.
    """

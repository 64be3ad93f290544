"""Files that are watched: something is done again each time one of them has changed."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from pathlib import Path

import click

from rbpsym.commands.arguments import stated
from rbpsym.derive import derive, physics_of
from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, field, replace
from rbpsym.proof.step import Derivation

PAUSE = 0.08  # seconds between two looks

Stamp = tuple[int, int]


def stamps(paths: Iterable[Path]) -> dict[Path, Stamp | None]:
    """When each file was written and its size; None if it is not there."""
    return {path: stamp(path) for path in paths}


def stamp(path: Path) -> Stamp | None:
    """Time of writing and size."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def watch(write: Callable[[], list[Path]], sources: Callable[[], list[Path]], until: Callable[[], bool]) -> int:
    """Writes, then again after each change of the sources, until told to stop (Ctrl-C stops it too).

    Returns 0. An error of the input is told, and the next change waited for.
    """
    click.echo("watching; Ctrl-C ends it.", err=True)
    try:
        while True:
            seen = stamps(sources())
            told(write)
            while stamps(sources()) == seen:
                if until():
                    return 0
                time.sleep(PAUSE)
    except KeyboardInterrupt:
        click.echo("ended.", err=True)
        return 0


def told(write: Callable[[], list[Path]]) -> None:
    """Write once; tell which files and how long it took, or what is wrong."""
    begun = time.perf_counter()
    try:
        files = write()
    except RbpsymError as error:
        click.echo(str(error), err=True)
        return
    names = ", ".join(path.name for path in files)
    click.echo(f"{time.strftime('%H:%M:%S')}  {names}  ({time.perf_counter() - begun:.2f} s)")


# --- derivations that are kept while a process watches files: only what an edit changes is derived anew


class KeptDerivations(Frozen):
    """The derivations of files, by path."""

    simulation: bool
    found: dict[Path, Derivation] = field(default_factory=dict)

    def derivation(self, path: Path) -> Derivation:
        """The derivation of a problem file as it is now. Raises what loading and deriving raise."""
        problem, before = stated(path), self.found.get(path)
        if before is not None and physics_of(before.study.problem) == physics_of(problem):
            self.found[path] = replace(before, study=before.study.under(problem))
        else:
            self.found[path] = derive(problem, simulation=self.simulation)
        return self.found[path]

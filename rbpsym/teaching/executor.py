"""Many jobs on one machine by a pool of processes, or on a cluster by dask.distributed; resumed after an interrupt.

What is done is noted in a journal, line by line; a run that was interrupted goes on from there. The
results come in the order of the jobs, so that they are the same bytes however they were made.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, as_completed
from contextlib import contextmanager, suppress
from multiprocessing import get_context
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen

# --- the journal of a long run: what is done, one line a job, so that an interrupt loses nothing
# The first line says what the run is about; a journal of another run is put aside, not mixed in. A line
# that was torn by a crash is dropped, and its job done again.


class Journal:
    """Results by the place of their job. Without a path nothing is kept. Use it in a `with`."""

    def __init__(self, path: Path | None, about: str) -> None:
        self.path, self.about = path, about
        self.results: dict[int, str] = {}
        self._file: BinaryIO | None = None

    def __enter__(self) -> Journal:
        if self.path is not None:
            self._file = _opened(self.path)
            self._resume(self._file)
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def enter(self, results: dict[int, str]) -> None:
        """Note results; they are on the disk when this returns."""
        self.results.update(results)
        if self._file is not None:
            lines = (json.dumps([place, text], ensure_ascii=False) for place, text in results.items())
            self._file.write("".join(f"{line}\n" for line in lines).encode())
            self._file.flush()
            os.fsync(self._file.fileno())

    def remove(self) -> None:
        """Everything is written: the journal is not needed any more."""
        if self.path is not None:
            self.path.unlink(missing_ok=True)

    def _resume(self, file: BinaryIO) -> None:
        """The results of whole lines after the first; what follows them is cut off."""
        head = (json.dumps({"about": self.about}) + "\n").encode()
        file.seek(0)
        if file.readline() != head:
            file.seek(0)
            file.truncate()
            file.write(head)
        good = file.tell()
        for line in file:
            entry = _entry(line)
            if entry is None:
                break
            self.results[entry[0]] = entry[1]
            good += len(line)
        file.seek(good)
        file.truncate()


def _entry(line: bytes) -> tuple[int, str] | None:
    with suppress(ValueError, TypeError):
        place, text = json.loads(line)
        if line.endswith(b"\n") and isinstance(place, int) and isinstance(text, str):
            return place, text
    return None


def _opened(path: Path) -> BinaryIO:
    """The journal, locked against a second run. Raises RbpsymError."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        file = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT, 0o600), "r+b")
    except OSError as error:
        raise RbpsymError(f"can't write {path}: {error.strerror}", instead="choose another folder with -o.") from error
    try:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except ImportError:
        pass
    except OSError:
        file.close()
        raise RbpsymError(f"another run works on {path.name} now", instead="wait until it ends, or stop it.") from None
    return file


# ---


Job = Any
Work = Callable[[tuple[Job, ...]], list[str]]
FEW = 64  # jobs that are done without a pool
DASK = "dask://"


class Interrupted(RbpsymError):
    """An interrupt; what is done is kept, and the same command goes on."""

    exit_code = 130


class Crew(Frozen):
    """Who works: processes of this machine (`processes`; 0: as many as there are cores), or a cluster."""

    address: str = ""
    processes: int = 0


def crew(executor: str, processes: int = 0) -> Crew:
    """The crew that `--executor` names: "" or "local", or dask://HOST:PORT. Raises RbpsymError."""
    if executor in ("", "local"):
        return Crew("", processes)
    host, colon, port = executor.removeprefix(DASK).rpartition(":")
    if not executor.startswith(DASK) or not colon or not host or not port.isdigit():
        raise RbpsymError(f"“{executor}” is no executor", instead="write local, or dask://HOST:PORT.")
    return Crew(f"tcp://{host}:{port}", processes)


def run(
    work: Work,
    jobs: Sequence[Job],
    who: Crew,
    journal: Journal,
    told: Callable[[int, int], None] = lambda done, of: None,
    size: int = 16,
    received: Callable[[str], str] = lambda result: result,
) -> list[str]:
    """The results of all jobs, in their order; those that the journal holds are not done again.

    `work` is a function of a module that takes some jobs and returns a text for each; `received` is what is done
    here with each text before it is noted (it returns what to keep). `told` hears how many are done. Raises
    Interrupted (what is done is kept), RbpsymError for a cluster out of reach.
    """
    with journal:
        waiting = [place for place in range(len(jobs)) if place not in journal.results]
        parts = [tuple(waiting[at : at + size]) for at in range(0, len(waiting), size)]
        told(len(journal.results), len(jobs))

        def note(part: tuple[int, ...], results: list[str]) -> None:
            journal.enter(dict(zip(part, map(received, results), strict=True)))
            told(len(journal.results), len(jobs))

        coming = _done(work, jobs, parts, who)
        try:
            for found in coming:
                note(*found)
        except KeyboardInterrupt:
            with suppress(KeyboardInterrupt):
                note(*coming.throw(KeyboardInterrupt))  # what was being done is done to its end
                for found in coming:
                    note(*found)
            done = f"interrupted: {len(journal.results)} of {len(jobs)} are done"
            raise Interrupted(done, instead="the same command goes on from there.") from None
        return [journal.results[place] for place in range(len(jobs))]


Parts = list[tuple[int, ...]]
Coming = Generator[tuple[tuple[int, ...], list[str]], None, None]


def _done(work: Work, jobs: Sequence[Job], parts: Parts, who: Crew) -> Coming:
    """(places, results) as they come."""
    if who.address or (sum(map(len, parts)) > FEW and _count(who) > 1):
        yield from _by_executor(work, jobs, parts, who)
        return
    for part in parts:
        yield part, work(tuple(jobs[place] for place in part))


def _count(who: Crew) -> int:
    """How many processes: as asked for, else one a core that may be used."""
    usable = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return who.processes or usable or 1


def _by_executor(work: Work, jobs: Sequence[Job], parts: Parts, who: Crew) -> Coming:
    with _executor(who) as pool:
        futures = {pool.submit(work, tuple(jobs[place] for place in part)): part for part in parts}
        try:
            for future in as_completed(list(futures)):
                yield futures.pop(future), future.result()
        except KeyboardInterrupt:
            begun = [(part, future) for future, part in futures.items() if not future.cancel()]
            yield from ((part, future.result()) for part, future in begun)
            raise
        finally:
            for future in futures:
                future.cancel()


@contextmanager
def _executor(who: Crew) -> Iterator[Executor]:
    """A cluster, or a pool of processes; where it is safe they are forked, and share what was worked out before."""
    if who.address:
        client = _client(who.address)
        try:
            yield client.get_executor(pure=False)
        finally:
            with suppress(Exception):
                client.close()
        return
    threads = 1 if sys.version_info >= (3, 12) else 2  # the second is the clock of the progress bar
    forks = sys.platform == "linux" and threading.active_count() <= threads
    context = get_context("fork" if forks else "spawn")
    with ProcessPoolExecutor(_count(who), mp_context=context, initializer=_begin_work) as pool:
        yield pool


def _begin_work() -> None:
    """An interrupt from the keyboard reaches all processes; the first of them deals with it.

    Typst sets a page with as many threads as there are cores; with a process on each core they would wait for each other.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.environ.setdefault("RAYON_NUM_THREADS", "1")


def _client(address: str) -> Any:
    """A client of the cluster. Raises RbpsymError if the extra or the cluster is not there."""
    try:
        from distributed import Client

        client: Any = Client  # it has no types
    except ImportError:
        hint = "install the extra: pip install 'rbpsym[cluster]'."
        raise RbpsymError("dask.distributed is not installed", instead=hint) from None
    try:
        return client(address, timeout=5)
    except OSError as error:
        host = address.removeprefix("tcp://")
        raise RbpsymError(f"no dask scheduler answers at {host}", instead="start one: dask scheduler.") from error

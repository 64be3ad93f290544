"""Many answers: the same bytes by one process, by a pool, by a cluster, and after an interrupt; nothing lost or done twice."""

from __future__ import annotations

import csv
import importlib.util
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.teaching.executor import Interrupted, Journal, crew, run
from rbpsym.teaching.grading.marking import grade
from rbpsym.teaching.model import ChoiceKey, FormulaKey, NumberKey, Student
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.ranges import measure_text
from rbpsym.typeset.text import to_text
from tests.teaching.readers import ROOT, need

NAME, SECRET = "falling-spool", "autumn"


def squares(jobs: tuple[tuple[int, str], ...]) -> list[str]:
    """The squares of numbers; each job leaves a line in a file, so that one sees what was done."""
    found = []
    for number, log in jobs:
        with open(log, "a", encoding="utf-8") as file:
            file.write(f"{number}\n")
        found.append(str(number**2))
    return found


def stopping(jobs: tuple[tuple[int, str], ...]) -> list[str]:
    """As `squares`, but an interrupt comes at the number 50."""
    if any(number == 50 for number, _ in jobs):
        raise KeyboardInterrupt
    return squares(jobs)


def numbers(count: int, log: Path) -> list[tuple[int, str]]:
    return [(number, str(log)) for number in range(count)]


@pytest.mark.parametrize("processes", [1, 2])
def test_results_come_in_order(processes: int, tmp_path: Path) -> None:
    heard = []
    jobs = numbers(150, tmp_path / "log")
    found = run(squares, jobs, crew("", processes), Journal(None, ""), lambda *state: heard.append(state), 8)
    assert found == [str(number**2) for number in range(150)]
    assert heard[0] == (0, 150) and heard[-1] == (150, 150)


@pytest.mark.parametrize("processes", [1, 2])
def test_an_interrupt_loses_nothing_and_repeats_nothing(processes: int, tmp_path: Path) -> None:
    log, path = tmp_path / "log", tmp_path / "journal"
    jobs = numbers(150, log)
    with pytest.raises(Interrupted, match="of 150 are done") as stopped:
        run(stopping, jobs, crew("", 1), Journal(path, "x"), size=8)
    assert stopped.value.exit_code == 130
    kept = set(log.read_text().split())
    assert kept == {str(number) for number in range(48)}
    found = run(squares, jobs, crew("", processes), Journal(path, "x"), size=8)
    assert found == [str(number**2) for number in range(150)]
    assert sorted(map(int, log.read_text().split())) == list(range(150))


def test_a_torn_line_is_done_again(tmp_path: Path) -> None:
    log, path = tmp_path / "log", tmp_path / "journal"
    jobs = numbers(10, log)
    whole = run(squares, jobs, crew(""), Journal(path, "x"), size=2)
    data = path.read_bytes()
    for cut in (1, 3, 9):
        path.write_bytes(data[:-cut])
        log.unlink()
        assert run(squares, jobs, crew(""), Journal(path, "x"), size=2) == whole
        assert log.read_text().split() == ["9"]
        assert path.read_bytes() == data


def test_the_journal_of_another_run_is_not_used(tmp_path: Path) -> None:
    log, path = tmp_path / "log", tmp_path / "journal"
    run(squares, numbers(4, log), crew(""), Journal(path, "one"), size=2)
    run(squares, numbers(4, log), crew(""), Journal(path, "other"), size=2)
    assert sorted(log.read_text().split()) == sorted("01230123")


def test_two_runs_do_not_mix(tmp_path: Path) -> None:
    with Journal(tmp_path / "journal", "x"), pytest.raises(RbpsymError, match="another run works"):
        run(squares, [], crew(""), Journal(tmp_path / "journal", "x"))


@pytest.mark.parametrize("text", ["spark://a:1", "dask://", "dask://host", "dask://:8786", "dask://host:port"])
def test_an_executor_that_is_none_gets_a_sentence(text: str) -> None:
    with pytest.raises(RbpsymError, match="is no executor"):
        crew(text)


# --- a class


@cache
def answers_of_class(count: int = 90) -> tuple[list[str], list[dict[str, str]]]:
    """A table of answers, right and wrong."""
    plan, rows = plan_of(NAME), []
    for number in range(count):
        sheet = plan.worksheet(Student(f"s{number:04}"), SECRET)
        row = {"student": f"s{number:04}"}
        for item in sheet.items:
            wrong = (number + int(item.id)) % 3 == 0
            match item.key:
                case FormulaKey(value=value, anticipated=known):
                    row[item.id] = to_text(
                        known[0].formula if wrong and known and known[0].formula else value, sheet.notation
                    )
                case NumberKey(measure=measure, anticipated=known):
                    row[item.id] = measure_text(known[0].number if wrong and known and known[0].number else measure)
                case ChoiceKey(right=right):
                    row[item.id] = "ab"[number % 2] if wrong else "abcdef"[right]
                case _:
                    row[item.id] = "=1+1" if wrong else "a"
        rows.append(row)
    return ["student", *(item.id for item in sheet.items)], rows


def table(folder: Path, count: int) -> Path:
    header, rows = answers_of_class()
    path = folder / "answers.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, header)
        writer.writeheader()
        writer.writerows(rows[:count])
    return path


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "rbpsym", "grade", NAME, *arguments, "--seed", SECRET]


def test_a_pool_makes_the_same_marks(tmp_path: Path) -> None:
    path = table(tmp_path, 90)
    alone = grade(NAME, path, secret=SECRET, processes=1, pages=True)
    pool = grade(NAME, path, secret=SECRET, processes=2, pages=True)
    assert alone == pool
    assert alone.students == 90 and len(alone.pages) == 90


@pytest.mark.parametrize("processes", ["1", "2"])
def test_an_interrupted_command_goes_on(processes: str, tmp_path: Path) -> None:
    """Ctrl-C reaches all processes of the command."""
    path, marks, journal = table(tmp_path, 90), tmp_path / "marks.csv", tmp_path / ".marks.csv.journal"
    call = command(str(path), "-o", str(marks), "--jobs", processes)
    first = subprocess.Popen(call, cwd=ROOT, stderr=subprocess.PIPE, text=True, start_new_session=True)
    for _ in range(3000):
        if journal.is_file() and journal.read_bytes().count(b"\n") > 1:
            break
        time.sleep(0.02)
    os.killpg(first.pid, signal.SIGINT)
    told = first.communicate(timeout=60)[1]
    if first.returncode == 0:
        pytest.skip("it was done before it could be interrupted")
    assert first.returncode == 130 and "goes on from there" in told and "Traceback" not in told
    assert not marks.exists() and journal.exists()
    done = subprocess.run(
        command(str(path), "-o", str(marks)), cwd=ROOT, capture_output=True, text=True, timeout=120, check=True
    )
    assert "90 students" in done.stdout and not journal.exists()
    assert (
        marks.read_text(encoding="utf-8-sig").replace("\n", "\r\n")
        == grade(NAME, path, secret=SECRET, processes=1).marks
    )


CLUSTER = """
from distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None, scheduler_port=0) as cluster:
        print(cluster.scheduler_address, flush=True)
        input()
"""


@contextmanager
def cluster(folder: Path) -> Iterator[str]:
    """A local cluster of two processes with two threads each: its address."""
    script = folder / "cluster.py"
    script.write_text(CLUSTER)
    server = subprocess.Popen(
        [sys.executable, str(script)], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    try:
        yield server.stdout.readline().strip().removeprefix("tcp://")
    finally:
        server.communicate("\n", timeout=30)


def test_a_cluster_makes_the_same_marks(tmp_path: Path) -> None:
    need(importlib.util.find_spec("distributed"), "dask.distributed")
    path, marks = table(tmp_path, 24), tmp_path / "marks.csv"
    with cluster(tmp_path) as address:
        call = command(str(path), "-o", str(marks), "--executor", f"dask://{address}")
        subprocess.run(call, cwd=ROOT, check=True, capture_output=True, timeout=120)
    with marks.open(encoding="utf-8-sig", newline="") as file:
        assert file.read() == grade(NAME, path, secret=SECRET, processes=1).marks


def test_no_cluster_gets_a_sentence(tmp_path: Path) -> None:
    need(importlib.util.find_spec("distributed"), "dask.distributed")
    call = command(str(table(tmp_path, 3)), "-o", str(tmp_path / "m.csv"), "--executor", "dask://127.0.0.1:9")
    done = subprocess.run(call, cwd=ROOT, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 2 and "no dask scheduler answers at 127.0.0.1:9" in done.stderr
    assert not (tmp_path / "m.csv").exists()

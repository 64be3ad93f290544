"""Manners: every error is a sentence with its exit code, help teaches, nothing is half-written."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result

import rbpsym
from rbpsym.cli import BROKEN, COMMANDS, INTERRUPTED, main
from rbpsym.errors import RbpsymError, StatementError, Undecided
from rbpsym.statement.library import problem_files
from tests.architecture.source import ROOT

LADDER = problem_files()["sliding-ladder"]


def run(*args: str, **env: str) -> Result:
    """A command in this process: quick. What a process itself does (its exit code, say) is seen by `process`."""
    return CliRunner().invoke(main, list(args), env=env, prog_name="rbpsym")


def process(*args: str, cwd: Path | None = None, **env: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "rbpsym", *args], cwd=cwd, capture_output=True, text=True, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT), **env},
    )  # fmt: skip


# --- help


@pytest.mark.parametrize("name", COMMANDS)
def test_help_of_every_command_shows_examples(name: str) -> None:
    text = run(name, "--help").output
    assert "Examples:" in text and f"rbpsym {name}" in text
    assert text.count("\n") < 60
    assert max(map(len, text.splitlines())) <= 100


def test_examples_of_help_use_options_that_exist() -> None:
    for name in COMMANDS:
        command = main.get_command(click.Context(main), name)
        known = {option for param in command.params for option in (*param.opts, *param.secondary_opts)}
        for line in re.findall(rf"^ +rbpsym {name} (.*)$", command.help, re.M):
            used = re.findall(r"(?<!\S)--?[a-z][a-z-]*", line.split("|")[0])
            assert set(used) <= known, line


def test_help_tells_exit_codes_and_every_command() -> None:
    text = run("--help").output
    assert "Exit codes" in text and all(re.search(rf"^  {name}\b", text, re.M) for name in COMMANDS)


def test_no_argument_shows_help() -> None:
    assert "Usage: " in process().stderr + process().stdout


def test_version() -> None:
    assert run("--version").output == f"rbpsym {rbpsym.__version__}\n"


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_script(shell: str) -> None:
    found = run(_RBPSYM_COMPLETE=f"{shell}_source")
    assert found.exit_code == 0 and "_RBPSYM_COMPLETE" in found.stdout


def test_completion_of_a_process() -> None:
    asked = {"_RBPSYM_COMPLETE": "zsh_complete", "COMP_WORDS": "rbpsym so", "COMP_CWORD": "1"}
    assert "solve" in process(**asked).stdout.split()


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        ("rbpsym so", "solve"),
        ("rbpsym solve sliding", "sliding-ladder"),
        ("rbpsym notes pap", "paper"),
        ("rbpsym notes paper --format pdf,ht", "pdf,html"),
        ("rbpsym derive sliding-ladder --detail b", "brief"),
    ],
)
def test_completion(words: str, offered: str) -> None:
    text = run_completion(words)
    assert offered in text.split(), text


def run_completion(words: str) -> str:
    count = len(words.split()) - 1
    return run(_RBPSYM_COMPLETE="zsh_complete", COMP_WORDS=words, COMP_CWORD=str(count)).stdout


# --- errors


def failing(error: BaseException, monkeypatch: pytest.MonkeyPatch) -> Result:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("rbpsym.commands.list.shelf", fail)
    return run("list")


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (StatementError("too few conditions"), 2),
        (RbpsymError("no"), 2),
        (Undecided("too hard"), 1),
        (KeyboardInterrupt(), INTERRUPTED),
        (ZeroDivisionError("oh"), BROKEN),
        (RecursionError("deep"), BROKEN),
        (MemoryError(), BROKEN),
    ],
)
def test_every_error_is_a_sentence(error: BaseException, code: int, monkeypatch: pytest.MonkeyPatch) -> None:
    found = failing(error, monkeypatch)
    assert found.exit_code == code
    assert found.stderr.strip() and "Traceback" not in found.stderr and not found.stdout


def test_an_error_of_ours_says_how_to_report_it(monkeypatch: pytest.MonkeyPatch) -> None:
    found = failing(ValueError("odd"), monkeypatch)
    assert "odd" in found.stderr and "report" in found.stderr and rbpsym.__version__ in found.stderr
    monkeypatch.setenv("RBPSYM_DEBUG", "1")
    assert "Traceback" in failing(ValueError("odd"), monkeypatch).stderr


def test_a_closed_pipe_is_no_error() -> None:
    command = f"{sys.executable} -m rbpsym derive sliding-ladder | head -1"
    done = subprocess.run(["bash", "-c", command], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout == "Sliding ladder\n"
    assert "Traceback" not in done.stderr and "Error" not in done.stderr


def test_an_interrupt_leaves_nothing(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "rbpsym", "notes", "paper", "-o", str(tmp_path / "out")]
    with subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
        time.sleep(0.6)
        running.send_signal(signal.SIGINT)
        _, told = running.communicate(timeout=60)
    assert running.returncode in (INTERRUPTED, -signal.SIGINT), told  # the shell tells both as 130
    assert "Traceback" not in told
    assert not list(tmp_path.rglob("*.*"))


BAD: list[tuple[tuple[str, ...], str]] = [
    (("solve", "no-such-thing-at-all"), "there is no problem"),
    (("solve", "paper"), "is a course"),
    (("derive", "sliding-lader"), "sliding-ladder"),
    (("notes", "papr"), "paper"),
    (("notes", "sliding-ladder", "--format", "docs"), "docs"),
    (("notes", "sliding-ladder", "--format", ""), "is not one of"),
    (("notes", "sliding-ladder", "--lang", "xx", "--no-simulation"), "xx"),
    (("notes", "sliding-ladder", "--engine", "word"), "word"),
    (("notes", "sliding-ladder", "-o", "-"), "./-"),
    (("derive", "sliding-ladder", "--method", "kane"), "kane"),
    (("derive", "sliding-ladder", "--detail", "high"), "high"),
    (("solve",), "NAME|FILE"),
    (("solve", "."), "is a folder"),
    (("new", "a b"), "can't be a name"),
    (("new", "../up"), "can't be a name"),
    (("new", "mine", "--template", "no-such"), "there is no problem"),
    (("list", "--jsn"), "--json"),
    (("slove", "sliding-ladder"), "solve"),
]


@pytest.mark.parametrize(("args", "says"), BAD, ids=lambda value: " ".join(value) if isinstance(value, tuple) else "")
def test_bad_input(args: tuple[str, ...], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    found = run(*args)
    assert found.exit_code == 2, found
    assert says in found.stderr and "Traceback" not in found.stderr
    assert not found.stdout and not list(tmp_path.iterdir())


def test_bad_input_of_a_process(tmp_path: Path) -> None:
    found = process("derive", "sliding-lader", cwd=tmp_path)
    assert found.returncode == 2 and "sliding-ladder" in found.stderr and "Traceback" not in found.stderr
    assert not found.stdout and not list(tmp_path.iterdir())


@pytest.mark.parametrize("content", [b"", b"\xff\xfe\x00", b"not toml at all", b"[parameters]\n" * 2, b"x" * 70_000])
def test_files_that_are_no_problems(content: bytes, tmp_path: Path) -> None:
    file = tmp_path / "bad.toml"
    file.write_bytes(content)
    found = run("notes", str(file), "-o", str(tmp_path / "out"))
    assert found.exit_code == 2 and "bad.toml" in found.stderr
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    found = run("notes", "sliding-ladder", "--no-simulation", "--format", "tex", "-o", str(tmp_path / "file" / "below"))
    assert found.exit_code == 2 and "Traceback" not in found.stderr
    assert "file" in found.stderr


# --- verdicts and exit codes


@pytest.mark.parametrize(
    "change",
    [
        {"refuted": 1}, {"undecided": 1}, {"methods_agree": False}, {"lagrange": "REFUTED"}, {"lagrange": "UNDECIDED"},
        {"simulation": {"max_relative_error": 1e-3}}, {"simulation": {"max_relative_error": float("nan")}},
    ],
    ids=str,
)  # fmt: skip
def test_a_doubt_is_exit_code_1(change: dict[str, object]) -> None:
    from rbpsym.commands.solve import exit_code

    fine = {"refuted": 0, "undecided": 0, "methods_agree": True, "lagrange": "PROVED",
            "simulation": {"max_relative_error": 1e-12}}  # fmt: skip
    assert exit_code(fine) == 0
    assert exit_code({**fine, "simulation": None}) == 0
    assert exit_code({**fine, **change}) == 1


# --- new


def test_new_from_a_template_is_that_problem(tmp_path: Path) -> None:
    assert run("new", "mine", "--template", "sliding-ladder", "-o", str(tmp_path)).exit_code == 0
    mine, theirs = rbpsym.load_problem(tmp_path / "mine.toml"), rbpsym.load_problem(LADDER)
    assert (mine.name, mine.bodies, mine.constraints) == ("mine", theirs.bodies, theirs.constraints)


def test_new_never_overwrites(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text("precious")
    found = run("new", "mine.toml", "-o", str(tmp_path))
    assert found.exit_code == 2 and "already" in found.stderr
    assert (tmp_path / "mine.toml").read_text() == "precious"


# --- the rest of the world


def test_commands_work_away_from_the_checkout(tmp_path: Path) -> None:
    found = process("solve", "sliding-ladder", "--json", "--no-simulation", cwd=tmp_path)
    assert json.loads(found.stdout)["degrees_of_freedom"] == 1


def test_output_without_a_terminal_has_no_colours() -> None:
    assert "\x1b" not in process("derive", "sliding-ladder", "--no-simulation").stdout + run("list").stdout


@pytest.mark.parametrize("columns", ["50", "80"])
def test_prose_is_wrapped(columns: str) -> None:
    from rbpsym.typeset.escaping import columns as wide

    text = CliRunner().invoke(main, ["derive", "sliding-ladder"], env={"COLUMNS": columns}).output
    prose = [line for line in text.splitlines() if line.startswith("  ") and not line.startswith("   ")]
    assert max(map(wide, prose)) <= int(columns)


def test_every_block_of_a_document_can_be_shown() -> None:
    from typing import get_args

    from rbpsym.document.model import Block, OwnBlock
    from rbpsym.document.writers.terminal import BLOCKS

    assert set(BLOCKS) == set(get_args(Block)) - {OwnBlock}  # which the writers of its room know


# --- public names


def test_public_names_are_there_whatever_was_imported_first() -> None:
    code = ("import rbpsym.solve, rbpsym.derive\nfrom rbpsym import solve, derive, rod, gravity\n"
            "assert callable(solve) and callable(derive) and callable(rod)\n")  # fmt: skip
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0
    for name in dir(rbpsym):
        assert getattr(rbpsym, name) is not None
    with pytest.raises(AttributeError, match="nonsense"):
        rbpsym.nonsense


def test_importing_rbpsym_is_light() -> None:
    code = "import sys, rbpsym; assert not {'click', 'sympy', 'numpy'} & set(sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0

"""Papers of a class: the same bytes by processes, a cluster and another Python; killed runs go on."""

from __future__ import annotations

import importlib.util
import os
import signal
import subprocess
import sys
import time
from hashlib import sha256
from pathlib import Path

import pytest

from tests.teaching.readers import ROOT, need
from tests.teaching.test_scale import cluster

NAME, COUNT = "falling-spool", 200


def command(folder: Path, *more: str, count: int = COUNT) -> list[str]:
    call = [sys.executable, "-m", "rbpsym", "worksheet", NAME, "--variants", str(count), "--seed", "autumn", "--key"]
    call += ["--format", "tex"]
    return [*call, "-o", str(folder), *more]


def done(call: list[str], **more: object) -> subprocess.CompletedProcess:
    return subprocess.run(call, cwd=ROOT, capture_output=True, text=True, timeout=240, check=True, **more)


def digests(folder: Path) -> dict[str, str]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): sha256(path.read_bytes()).hexdigest() for path in files}


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The papers of a run that nothing disturbed, and the record of what was handed out."""
    folder = tmp_path_factory.mktemp("whole")
    done(command(folder, "--jobs", "1"))
    found = digests(folder)
    assert len(found) == 2 * COUNT + 1 and not [name for name in found if name.endswith("journal")]
    return found


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL], ids=["interrupt", "kill"])
def test_a_stopped_run_goes_on(how: signal.Signals, whole: dict[str, str], tmp_path: Path) -> None:
    journal = tmp_path / ".worksheets.journal"
    first = subprocess.Popen(
        command(tmp_path, "--jobs", "2"), cwd=ROOT, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
        start_new_session=True,
    )  # fmt: skip
    for _ in range(2000):
        if journal.is_file() and journal.read_bytes().count(b"\n") > 1:
            break
        time.sleep(0.01)
    os.killpg(first.pid, how)
    told = first.communicate(timeout=60)[1]
    if first.returncode == 0:
        pytest.skip("it was done before it could be stopped")
    assert "Traceback" not in told and journal.exists()
    assert (first.returncode, "goes on from there" in told) == ((130, True) if how == signal.SIGINT else (-9, False))
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.tex")}
    noted = [line for line in journal.read_text().splitlines()[1:] if line.endswith("]")]
    assert noted and len(kept) < 2 * COUNT
    (tmp_path / f".{NAME}-001.tex.a1b2c3d4").write_text("half", encoding="utf-8")  # as a kill may leave it
    done(command(tmp_path, "--jobs", "2"))
    assert digests(tmp_path) == whole
    again = {str(path) for path, when in kept.items() if path.stat().st_mtime_ns != when}
    assert not [line for line in noted if any(path in line for path in again)], "what was noted is not made again"


def test_a_cluster_makes_the_same_papers(tmp_path: Path) -> None:
    need(importlib.util.find_spec("distributed"), "dask.distributed")
    done(command(tmp_path / "here", count=24))
    with cluster(tmp_path) as address:
        done(command(tmp_path / "papers", "--executor", f"dask://{address}", count=24))
    found = digests(tmp_path / "papers")
    assert len(found) == 48 + 1 and found == digests(tmp_path / "here")


def test_an_executor_that_is_none_gets_a_sentence(tmp_path: Path) -> None:
    call = command(tmp_path, "--executor", "dask://nowhere", count=3)
    found = subprocess.run(call, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert found.returncode == 2 and "is no executor" in found.stderr and not list(tmp_path.iterdir())


def test_the_code_on_the_paper_gives_the_same_bytes_in_another_process(tmp_path: Path) -> None:
    """Whatever the order of hashes there is."""
    made = {}
    for seed in ("1", "2"):
        folder = tmp_path / seed
        env = {**os.environ, "PYTHONHASHSEED": seed}
        done([*command(folder, "--solution", "--format", "pdf,tex,html", count=1)], env=env)
        made[seed] = digests(folder)
    assert made["1"] == made["2"] and len(made["1"]) == 8 + 1
    [page] = (tmp_path / "1").glob("*.tex")
    code = next(word for word in page.read_text().replace("}", " ").split() if word.startswith(f"{NAME}.en."))
    folder = tmp_path / "again"
    call = [
        sys.executable,
        "-m",
        "rbpsym",
        "worksheet",
        "--from-code",
        code,
        "--seed",
        "autumn",
        "--key",
        "-o",
        str(folder),
    ]
    done(call, env={**os.environ, "PYTHONHASHSEED": "3"})
    [paper, key] = sorted(folder.rglob("*.pdf"), key=lambda path: len(path.parts))
    assert "pdf" in paper.suffix and "key" in key.name

"""The page in Chromium: notes, edits, errors, exports, links, offline, a phone, axe; and the server of its files."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from http.client import HTTPConnection
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.studio import serving
from rbpsym.studio.serving import BUILT, HOST, server
from tests.architecture.source import ROOT
from tests.npm import MODULES

needs_page = pytest.mark.skipif(
    shutil.which("node") is None or shutil.which("chromium") is None
    or not (MODULES / "axe-core").is_dir() or not (BUILT / "index.html").is_file(),
    reason="needs Node, Chromium, npm install --prefix .ci and make studio",
)  # fmt: skip


@pytest.fixture
def small(tmp_path: Path) -> Iterator[int]:
    """The port of a site of two files, in a folder beside a secret."""
    (tmp_path / "site").mkdir()
    (tmp_path / "secret.html").write_text("secret", encoding="utf-8")
    (tmp_path / "site" / "index.html").write_text("page", encoding="utf-8")
    (tmp_path / "site" / "a.wasm").write_bytes(b"\0asm")
    yield from _served(tmp_path / "site")


def _served(folder: Path) -> Iterator[int]:
    with server(folder=folder) as found:
        Thread(target=found.serve_forever, daemon=True).start()
        yield found.server_address[1]
        found.shutdown()


@pytest.mark.parametrize(
    ("path", "host", "status", "kind"),
    [
        ("/", HOST, 200, "text/html; charset=utf-8"),
        ("/a.wasm", "localhost", 200, "application/wasm"),
        ("/../secret.html", HOST, 404, None),
        ("/%2e%2e/secret.html", HOST, 404, None),
        ("/", "elsewhere.example", 404, None),
        ("/site", HOST, 404, None),
    ],
)
def test_only_its_own_files_are_served(small: int, path: str, host: str, status: int, kind: str | None) -> None:
    connection = HTTPConnection(HOST, small, timeout=10)
    connection.putrequest("GET", path, skip_host=True)
    connection.putheader("Host", f"{host}:{small}")
    connection.endheaders()
    found = connection.getresponse()
    assert found.status == status
    assert kind is None or found.headers["Content-Type"] == kind
    connection.close()


@needs_page
def test_every_file_of_the_page_has_a_kind() -> None:
    assert {path.suffix for path in serving.site(BUILT).values()} <= serving.KINDS.keys()


def test_without_the_page_it_is_said_how_to_get_it(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "rbpsym", "studio", "--site", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False, cwd=ROOT)
    assert done.returncode == 2
    assert "pip install rbpsym-studio" in done.stderr and "Traceback" not in done.stderr


def test_the_wheel_of_the_page_is_served(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`make studio` packs the site as a wheel; installed, it is what is served where no checkout has built one."""
    (tmp_path / "site" / "py").mkdir(parents=True)
    (tmp_path / "site" / "index.html").write_text("page", encoding="utf-8")
    (tmp_path / "site" / "py" / "engine.pack").write_bytes(b"pack")
    command = [sys.executable, str(ROOT / "studio" / "wheel.py"), "site", "."]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    target = tmp_path / "installed"
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", str(target)]
    subprocess.run([*pip, str(tmp_path / made.stdout.strip())], capture_output=True, text=True, check=True)
    monkeypatch.setattr(serving, "BUILT", tmp_path / "nowhere")
    with pytest.raises(RbpsymError):
        serving.site(serving.built())
    monkeypatch.syspath_prepend(str(target))
    assert set(serving.site(serving.built())) == {"/", "/index.html", "/py/engine.pack"}


def _driven(script: str) -> Any:
    """What a script saw that drives Chromium on the built page."""
    running = _served(BUILT)
    port = next(running)
    command = ["node", str(Path(__file__).with_name(script)), str(MODULES), f"http://{HOST}:{port}/"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    next(running, None)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


@needs_page
def test_a_page_around_it_sets_numbers_and_hears_of_states_and_scores() -> None:
    """In a frame of another origin: the address gives a number, messages set others, ask the engine, and bring the score."""
    seen = _driven("embedding.mjs")
    assert seen["moving"]["numbers"]["theta_0"] == 1.1
    assert seen["plays"]["numbers"]["theta_0"] == 1.3 and "nothing" not in seen["plays"]["numbers"]
    assert seen["plays"]["time"] >= 0.25
    assert seen["derived"]["proved"] == seen["derived"]["steps"] > 40
    assert seen["state"]["tab"] == "explorer" and "[bodies.ladder]" in seen["state"]["text"]
    assert seen["asked"]["verdict"] == "wrong"
    assert seen["refused"]["what"]
    assert seen["judged"][1] == "wrong" and seen["judged"][0].startswith("true")
    assert seen["score"]["lines"] == 1 and seen["score"]["of"] == 2 and 0 < seen["score"]["steps"] < seen["score"]["all"]
    assert seen["faults"] == []


@needs_page
def test_the_page_does_all_it_is_for() -> None:
    seen = _driven("browser.mjs")
    assert seen["title"] == "Sliding ladder"
    assert "49 of 49 steps proved" in seen["status"]
    assert seen["edited"] == 3
    assert "bodies.other has no “shape”" in seen["fault"]
    assert seen["panel"].splitlines()[1:3] == ["    [bodies.other]", "            ^^^^^"]
    assert seen["completed"] and seen["explorer"] and seen["released"] and seen["linked"]
    assert seen["pdf"] == ["sliding-ladder.pdf", "%PDF-"]
    assert seen["export"][0].endswith(".tex")
    assert "REFUTED" in seen["check"]
    assert seen["shelf"] == [["Sliding ladder with a spring"], []]
    assert seen["asked"][0].startswith("N_w at the start✓") and seen["asked"][1] == 1
    assert seen["sheet"] == "Sliding ladder" and seen["typed"] == "3\u2062g2\u2062ℓ"
    head, ana, lines, other = seen["records"]
    assert ana == ["Ana", "Sliding ladder", "0/1", ana[3], "1", "0/0"] and ana[3].startswith("0/") and len(head) == 6
    assert "wrong" in lines[0] and other == ["other.json", "this is no record"]
    assert "wrong" in seen["tutor"] and "2 times what it should be" in seen["tutor"]
    assert seen["glance"] == [1, 3]
    assert seen["formed"] and seen["axeForm"] == seen["axeTutor"] == []
    assert seen["renamed"] == ["2*L", "2*ell"]
    assert seen["offline"] == "Sliding ladder"
    assert seen["boot"] == "snapshot"
    assert seen["wider"] <= 0
    assert (seen["axe"], seen["axePhone"], seen["foreign"], seen["faults"]) == ([], [], [], [])

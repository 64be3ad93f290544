"""An editor's talk with `rbpsym lsp` over stdio."""

import json
import subprocess
import sys

TEXT = r"""A uniform ladder slides.
% rbpsym: problem = sliding-ladder
% rbpsym: T is the kinetic energy
% rbpsym: \omega is the speed of theta
% rbpsym: claim
\begin{equation}
  T = \frac{1}{3} M \ell^2 \omega^2
\end{equation}
"""
TOML = '[parameters]\nM = "mass: of the rod"\n\n[bodies.rod]\nshape = "rodd"\n'


def talk(messages):
    """What is answered, by id or method."""
    raw = b"".join(b"Content-Length: %d\r\n\r\n%s" % (len(b := json.dumps(m).encode()), b) for m in messages)
    done = subprocess.run([sys.executable, "-m", "rbpsym", "lsp"], input=raw, capture_output=True, check=True, timeout=300)
    found, rest = [], done.stdout
    while rest:
        head, _, rest = rest.partition(b"\r\n\r\n")
        size = int(head.split(b":")[1])
        found.append(json.loads(rest[:size]))
        rest = rest[size:]
    return found


def asked(number, method, uri="", line=0, character=0):
    return {"jsonrpc": "2.0", "id": number, "method": method,
            "params": {"textDocument": {"uri": uri}, "position": {"line": line, "character": character}}}  # fmt: skip


def test_an_editor_is_told_findings_meanings_and_what_can_be_written(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    paper, problem = tmp_path / "ladder.tex", tmp_path / "ladder.toml"
    paper.write_text(TEXT, encoding="utf-8")
    (tmp_path / "own.toml").write_text(TOML)
    opened = {"jsonrpc": "2.0", "method": "textDocument/didOpen"}
    tex, toml = paper.as_uri(), problem.as_uri()
    told = talk([
        asked(1, "initialize"),
        {**opened, "params": {"textDocument": {"uri": tex, "text": TEXT}}},
        asked(2, "textDocument/hover", tex, 5),
        asked(3, "textDocument/completion", tex, 1, 10),
        {**opened, "params": {"textDocument": {"uri": toml, "text": TOML}}},
        asked(4, "textDocument/hover", toml, 4, 2),
        asked(5, "textDocument/completion", toml, 4, 9),
        asked(8, "textDocument/completion", tex, 1, 20),
        asked(6, "textDocument/rename", toml),
        asked(7, "shutdown"),
        {"jsonrpc": "2.0", "method": "exit"},
    ])  # fmt: skip
    answers = {one["id"]: one for one in told if "id" in one}
    notes = {one["params"]["uri"]: one["params"]["diagnostics"] for one in told if "method" in one}
    assert answers[1]["result"]["capabilities"]["hoverProvider"]
    [wrong] = notes[tex]
    assert wrong["severity"] == 1 and "REFUTED" in wrong["message"] and r"\frac{2}{3}" in wrong["message"]
    assert wrong["range"]["start"]["line"] in (5, 6)
    assert "REFUTED" in answers[2]["result"]["contents"]
    assert "claim" in {item["label"] for item in answers[3]["result"]}
    problems = {item["label"]: item["detail"] for item in answers[8]["result"]}
    assert problems["sliding-ladder"] == "Sliding ladder" and "claim" not in problems
    assert problems["own.toml"] == "beside the text"
    [unknown] = notes[toml]
    assert "rodd" in unknown["message"] and unknown["range"]["start"]["line"] == 4
    assert "rod" in {item["label"] for item in answers[5]["result"]}
    assert answers[6]["error"]["code"] == -32601 and answers[7]["result"] is None

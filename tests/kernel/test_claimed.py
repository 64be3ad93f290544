"""Formulas of papers: what is proved is proved once more by Rocq, from laws, starts and ranges alone, or it is said why not."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from click.testing import CliRunner

from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import CERTIFIED, Result
from rbpsym.claims.run import Certificates, check_claims
from rbpsym.cli import main
from rbpsym.expr import tree as t
from rbpsym.kernel.claimed import NO_COQC, Notary, written_of
from tests.kernel.test_certify import needs_coqc

HEAD = 'title = "Claims"\nproblem = "atwood-with-massive-pulley"\n[symbols]\n\'I\' = "moment of inertia of pulley"\n'
RIGHT = {
    "acceleration": r"a = \frac{(M_1-M_2)g}{M_1+M_2+M_p/2}",
    "chain": r"I\alpha = \frac12 M_p R^2\alpha = (T_1-T_2)R",
    "energy": r"\frac12(M_1+M_2+\frac12M_p)v^2 - (M_1-M_2)gx = \text{const}",
}
LIMIT = "[[claim]]\nid = 'limit'\nlatex = '''T_1 = T_2'''\ngiven = '''M_p = 0'''\n"


def file_of(folder: Path, formulas: dict[str, str], more: str = "") -> Path:
    rows = "".join(f"[[claim]]\nid = '{id}'\nlatex = '''{latex}'''\n" for id, latex in formulas.items())
    (folder / "claims.toml").write_text(HEAD + rows + more, encoding="utf-8")
    return folder / "claims.toml"


def filed(path: Path) -> tuple[Notary, list[Result]]:
    notary = Notary()
    return notary, list(check_claims(load_claims(path), Certificates(None, notary=notary)))


@needs_coqc
def test_what_is_proved_is_certified_and_json_says_so(tmp_path) -> None:
    path = file_of(tmp_path, {**RIGHT, "wrong": "a = g", "other": "T_1 \\neq T_2"}, LIMIT)
    command = ["check", str(path), "--certify", "--json", "--no-cache"]
    told = json.loads(CliRunner().invoke(main, command, standalone_mode=False).output)
    rows = {row["id"]: row for row in told["results"]}
    assert all(rows[id]["certified"] for id in (*RIGHT, "limit")), rows
    assert "certified" not in rows["wrong"], "what is refuted is not asked"
    assert rows["other"]["certified"] is False and "no words" in rows["other"]["not_certified"]


@needs_coqc
def test_a_wrong_formula_is_not_certified_whoever_files_it(tmp_path) -> None:
    """What is filed as proved and is not: refused for its proof, by the search or by coqc."""
    notary, found = filed(file_of(tmp_path, RIGHT))
    for place, item in enumerate(notary.filed):
        left, right = item.node.items[:2]
        notary.filed[place] = replace(item, node=t.Chain((left, t.Mul((t.TWO, right))), ("=",)))
    told = [result.rocq for result in notary.settled(found)][:2]
    assert len(told) == 2 and CERTIFIED not in told


def test_a_limit_that_is_given_stands_beside_no_sign_that_contradicts_it(tmp_path) -> None:
    """M_p = 0 is put in: beside M_p > 0 as a hypothesis anything would follow."""
    notary, _ = filed(file_of(tmp_path, {}, LIMIT))
    whole = written_of(notary.filed[0].ground.world.study, {"limit": notary.filed[0]})
    [lemma] = whole.lemmas["limit"]
    sides = [side for claim in (*lemma.premises.values(), lemma.claim) for side in (claim.left, claim.right)]
    assert len(lemma.premises) > 0 and not any("M_p" in t.names(side) for side in sides)


def test_without_coqc_nothing_is_certified(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.kernel.coqc.has_coqc", lambda: False)
    command = ["check", str(file_of(tmp_path, RIGHT)), "--certify", "--no-cache"]
    told = CliRunner().invoke(main, command, standalone_mode=False).output
    assert "0 of 3 certified by Rocq" in told and NO_COQC[:20] in told


def test_nothing_is_asked_unless_it_is_wanted(tmp_path) -> None:
    told = CliRunner().invoke(main, ["check", str(file_of(tmp_path, RIGHT)), "--no-cache"], standalone_mode=False).output
    assert "Rocq" not in told and "3 PROVED" in told

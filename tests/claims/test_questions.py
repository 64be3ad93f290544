"""A symbol of a claims file may mean the answer to a question."""

from pathlib import Path

from rbpsym.claims.loader import load_claims
from rbpsym.claims.run import Certificates, check_claims

FILE = r"""
title = "a drum on a slope"
source = "none"
problem = "disk-on-incline"
[symbols]
'\mu_0' = "smallest mu for which it does not slip"
'v_1' = "speed of drum.cm where s = R"
[[claim]]
id = "mu"
latex = '''\mu_0 = \frac13\tan\beta'''
[[claim]]
id = "v"
latex = '''v_1^2 = \frac43 g R\sin\beta'''
[[claim]]
id = "wrong"
latex = '''\mu_0 = \frac12\tan\beta'''
"""


def test_a_claim_may_speak_of_what_is_asked(tmp_path: Path) -> None:
    path = tmp_path / "drum.toml"
    path.write_text(FILE, encoding="utf-8")
    found = {result.id: str(result.outcome) for result in check_claims(load_claims(path), Certificates(None))}
    assert found == {"mu": "PROVED", "v": "PROVED", "wrong": "REFUTED"}

"""Hostile answers get a sentence, quickly, and touch nothing."""

from __future__ import annotations

import random
import sys
from pathlib import Path
from time import process_time

import pytest

from rbpsym.teaching.grading.answer import grade_answer, grade_number
from rbpsym.teaching.grading.ground import bare_ground
from rbpsym.teaching.grading.judgement import Judgement

GROUND = bare_ground(dict.fromkeys("m M g ell R k a b".split(), "positive") | {"theta": "real"})
KEY = "m*g*ell/(m + M)"
REFUSED = [
    "__import__('os').system('touch /tmp/owned')", "().__class__.__bases__[0]", "open('/etc/passwd').read()",
    "exec(compile('1','','exec'))", "lambda: 0", "m.__init__", "{% include '/etc/passwd' %}", "${7*7}",
    "9^9^9", "9**9**9**9", "m^9999999", "m^(9^9)", "100!", "m!", "(" * 10_000, "(" * 10_000 + "m" + ")" * 10_000,
    "((" * 400 + "m" + "))" * 400, "\u202em*g", "m\u200bg", "m\u2066g\u2069", "\ufeffm", "m\x00g", "\ud800",
    r"\input{/etc/passwd}", r"\write18{ls}", r"\def\x{\x\x}\x", r"\loop\repeat", r"\catcode`\@=11", r"\csname x\endcsname",
    "=cmd|' /C calc'!A0", "=HYPERLINK(\"http://x\",\"y\")", "+1+cmd|' /C calc'!A0", "@SUM(1+1)*cmd|' /C calc'!A0",
    "<script>alert(1)</script>", "<!DOCTYPE x [<!ENTITY a \"b\">]>&a;", "' OR 1=1 --", "../../etc/passwd", "%s%s%s%n",
    "m" * 1999, "1" * 500, "sin(" * 300, "-" * 1999 + "m", "\\frac" * 300, "{" * 900, "m_" * 500, "θ̈̈̈̈" * 100, "√" * 900,
]  # fmt: skip
LARGE = [
    "(m+g+ell+R+M)^60", "(((m+1)^8+1)^8+1)^8", "sin(1000 theta)", "cos(63 theta)^64",
    "*".join(f"(m+{k}*theta+g)" for k in range(1, 60)),
    "+".join(f"sqrt(m+{k})*sqrt(g+{k})" for k in range(1, 30)), "(m+1)^64/(g+1)^64+(ell+1)^64", "exp(exp(exp(exp(m))))",
    f"{KEY}*((m-g+ell-R+k-a)^6+1)/((m-g+ell-R+k-a)^6+1)", f"{KEY}*sqrt((m+g+ell+k+a)^8)/(m+g+ell+k+a)^4",
    f"{KEY}*(sin(theta)+cos(theta)+m)^30/(m+cos(theta)+sin(theta))^30", "sqrt(" * 20 + "m" + "+1)" * 20,
    "*".join(f"cos({k} theta)" for k in range(1, 50)), "+".join(f"1/(m+{k})" for k in range(1, 60)), "9999999999999^64*m",
    "ln(" * 12 + "m" + ")" * 12, "m^(1/63)*g^(1/61)*ell^(1/59)", "+".join(f"(m+{k})^(1/3)" for k in range(1, 30)),
    "exp(1000000)", "{{ 7*7 }}", "exp(m)^64*exp(g)^63", "tan(theta)" + "*tan(theta)" * 60, "m^m^m", "2^(2^(2^theta))",
]  # fmt: skip


@pytest.fixture(autouse=True, scope="module")
def _loaded() -> None:
    grade_answer("sqrt(m + g)*m/(m**2 - g**2)", KEY, GROUND)


def quickly(answer: str) -> Judgement:
    begin = process_time()
    found = grade_answer(answer, KEY, GROUND)
    assert process_time() - begin <= 0.2
    return found


@pytest.mark.parametrize("answer", REFUSED, ids=lambda answer: repr(answer[:30]))
def test_refused_with_a_sentence(answer: str) -> None:
    found = quickly(answer)
    assert found.status.value == "invalid" and found.credit == 0
    assert 10 < len(found.remarks[0].slots["why"]) < 1500
    assert not Path("/tmp/owned").exists()


@pytest.mark.parametrize("answer", LARGE, ids=lambda answer: answer[:30])
def test_large_answers_are_quick_and_never_right_by_chance(answer: str) -> None:
    found = quickly(answer)
    assert found.status.value in ("wrong", "undecided", "invalid") or answer.startswith(KEY)


@pytest.mark.parametrize("answer", REFUSED, ids=lambda answer: repr(answer[:30]))
def test_no_number(answer: str) -> None:
    begin = process_time()
    found = grade_number(answer, 5, "m")
    assert process_time() - begin <= 0.2
    assert found.credit == 0


def test_noise_never_raises() -> None:
    """Random strings of what answers are made of: a judgement, quickly, and no recursion error."""
    r = random.Random(4)
    pieces = ["m", "g", "theta", "(", ")", "+", "-", "*", "/", "^", "2", "sin", "sqrt", r"\frac", "{", "}", "=", "|", "_", "'",
              "θ", "°", "e", ",", ".", r"\dot", "dt", " ", "√", "²", "∛", "1e9", "%pi", "&", "$", "\n", "\t"]  # fmt: skip
    for _ in range(1500):
        quickly("".join(r.choice(pieces) for _ in range(r.randrange(1, 25))))
    assert sys.getrecursionlimit() <= 3000

"""Hostile answers get a sentence, quickly, and touch nothing."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

from rbpsym.teaching.grading.answer import grade_answer, grade_number
from rbpsym.teaching.grading.ground import bare_ground
from rbpsym.teaching.grading.judgement import Judgement
from tests.effort import at_most

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
    with at_most():
        return grade_answer(answer, KEY, GROUND)


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
    with at_most():
        found = grade_number(answer, 5, "m")
    assert found.credit == 0


def test_noise_never_raises() -> None:
    """Random strings of what answers are made of: a judgement, quickly, and no recursion error."""
    r = random.Random(4)
    pieces = ["m", "g", "theta", "(", ")", "+", "-", "*", "/", "^", "2", "sin", "sqrt", r"\frac", "{", "}", "=", "|", "_", "'",
              "θ", "°", "e", ",", ".", r"\dot", "dt", " ", "√", "²", "∛", "1e9", "%pi", "&", "$", "\n", "\t"]  # fmt: skip
    for _ in range(1500):
        quickly("".join(r.choice(pieces) for _ in range(r.randrange(1, 25))))
    assert sys.getrecursionlimit() <= 3000


MORE = [
    "[c for c in ().__class__.__base__.__subclasses__()]",
    "m.real",
    "m.__class__",
    "f'{m}'",
    "print(m)",
    "import os",
    "os.remove('/tmp/x')",
    "getattr(m,'x')",
    "globals()",
    "breakpoint()",
    "subs(m,1)",
    "m;import sys",
    "m\nimport os",
    "m#comment",
    "m//g",
    "m<<g",
    "m>>g",
    "m&g",
    "m|g",
    "m@g",
    "~m",
    "!m",
    "m?g:1",
    "m if g else 1",
    "lambda m:m",
    "yield",
    "await m",
    "m:=3",
    "{m:1}",
    "[m]*10**9",
    "(m,g)",
    "m,g",
    "'m'*9**9",
    '"m"',
    "b'm'",
    "0b1",
    "0o7",
    "0x10",
    "1_000",
    "1j",
    "1e400",
    "1e-400",
    "1E999999",
    "9" * 40,
    "9" * 1000,
    "9e" * 500,
    "1/" * 500 + "m",
    "m^" * 300 + "m",
    "m**" * 300 + "m",
    "m!" * 300,
    "m!!",
    "(m!)!",
    "2^2^2^2^2^2",
    "10^10^10",
    "m^1e9",
    "m^(1/0)",
    "1/0",
    "0/0",
    "m/(g-g)",
    "0^0",
    "0^-1",
    "sqrt(-1)",
    "ln(0)",
    "ln(-1)",
    "asin(2)",
    "tan(pi/2)",
    "sin(" * 50 + "m" + ")" * 50,
    "[" * 1000,
    "]" * 1000,
    "[(" * 500,
    "|" * 1000,
    "|m" * 500,
    "√" * 1000 + "m",
    "²" * 500,
    "m" + "²" * 500,
    "½" * 500,
    "1½" * 300,
    "1 1/2 " * 200,
    "m_" * 900,
    "_" * 1000,
    "m_{" * 300,
    "\\[" * 300,
    "\\[Theta]" * 150,
    "\\frac{" * 300,
    "\\sqrt[" * 200,
    "\\left(" * 200,
    "{\\over}" * 150,
    "\\sin^{-1}" * 150,
    "1\\frac{1}{2}" * 100,
    "\\log_{2}" * 100,
    "60^\\circ" * 100,
    "Sin[" * 200,
    "diff(" * 200,
    "diff(theta,t)" * 100,
    "D[theta,t]" * 100,
    "d/dt " * 200,
    "dθ/dt" * 200,
    "d(theta)/dt" * 100,
    "root(m," * 200,
    "pow(" * 200 + "m",
    "log_2(" * 200,
    "hypot(m,g)" * 100,
    "m[1]" * 300,
    "(t)" * 400,
    "θ(t)" * 300,
    "a:b" * 400,
    "1 000 " * 250,
    "1.2 x 10^3" * 150,
    "%" * 1000,
    "50%" * 400,
    "''" * 500,
    "θ'" * 500,
    "\u202e\u202d" * 10 + "m",
    "m\u200d g",
    "\u2063m",
    "\ufff9m",
    "\U000e0041m",
    "\u0301" * 500,
    "m\u0301\u0302",
    "İ",
    "ſin(theta)",
    "ﬁ",
    "\x1b[31mm",
    "\x07",
    "\x00",
    "\ud83d",
    "😀",
    "𝑚𝑔",
    "ｍ＊ｇ",
    "\\write18{rm -rf /}",
    "\\immediate\\openout",
    "\\newread",
    "\\directlua{os.exit()}",
    "\\begin{document}",
    "\\verb|m|",
    "\\href{javascript:alert(1)}{m}",
    "\\url{file:///etc/passwd}",
    "\\includegraphics{x}",
    "\\usepackage{shellesc}",
    "\\expandafter",
    "\\the\\year",
    "\\special{x}",
    "\\jobname",
    "^^5cinput",
    "=1+1",
    '=IMPORTXML("http://x")',
    "-1+cmd",
    "\t=1",
    "<img src=x onerror=alert(1)>",
    "]]><script>",
    "<!ENTITY % a SYSTEM 'file:///etc/passwd'>",
    "&lt;",
    "%00",
    "%n%n",
    "${jndi:ldap://x}",
    "{{config}}",
    "<%= 7*7 %>",
    "$(touch /tmp/owned)",
    "`id`",
    "; ls",
    "|| true",
    "../" * 100,
    "C:\\Windows",
    "\\\\host\\share",
    "NaN",
    "Infinity",
    "-inf",
    "None",
    "null",
    "True",
    "undefined",
    "e" * 1000,
    "pi" * 500,
    "ell" * 500,
    "theta" * 300,
    "sintheta" * 200,
    "mgl" * 500,
    "a b " * 400,
    "m+" * 900,
    "m-" * 900 + "m",
    "((m)" * 300,
    "(m+g)^64*(m+g)^64",
    "(m+g+ell+R)^64",
    "((m+g)^64)^8",
    "exp(" * 55 + "m" + ")" * 55,
    "(1/3)^(1/64)",
    "m^(63/64)" + "*g^(61/63)" * 5,
    "0." + "1" * 1500,
    "1" + "0" * 1500,
    "3.14159265358979323846264338327950288419716939937510",
    "\\" * 500,
    "$" * 500,
    "$$" * 200,
    "\\(\\(" * 100,
    "``",
    "`" * 500,
    "= = = m",
    "m=g=m=g",
    "=" * 500,
    "m≈" * 200,
    "T=" * 300,
    "T=T=T=m",
    "x̂",
    "⃗m",
    "m⃗",
]


@pytest.mark.parametrize("answer", MORE, ids=lambda answer: repr(answer[:30]))
def test_more_that_earns_nothing(answer: str) -> None:
    """Neither as a formula nor as a number; a sentence, soon, touching nothing."""
    with at_most():
        number = grade_number(answer, 4.2, "rad/s")
    for found in (quickly(answer), number):
        assert not found.credit and found.remarks
        assert all(len(str(remark.slots.get("why", "a sentence"))) >= 10 for remark in found.remarks)
    assert not Path("/tmp/owned").exists()

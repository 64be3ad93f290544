"""What is caught is meant: no bug of ours is taken for a refusal.

Caught are RbpsymErrors, what a library says of a file or a number, and exact division by zero. Where a broader
exception is caught, a line below says what raises it; a line that is not needed any more must go.
"""

from __future__ import annotations

import ast

from tests.architecture.source import PACKAGE

BROAD = frozenset(
    "Exception BaseException KeyError IndexError LookupError AttributeError TypeError ValueError RuntimeError "
    "StopIteration ArithmeticError AssertionError NameError".split()
)
READS = "text of a file: JSON, numbers, dates, names of files"
FLOATS = "floating-point functions, outside of their domain"
ALLOWED = {
    "cli.py": "the last net: a bug gets a sentence and exit code 70",
    "commands/findings.py": READS,
    "field/evaluate.py": "one look-up in a table, told as a ReadError",
    "field/modular.py": "pow(x, -1, p) at a pole",
    "proof/view.py": "pow(x, -1, p) at a pole",
    "kernel/claims.py": "data of a rule for which the exporter has no words: the step is told as not certified",
    "kernel/coqc.py": READS,
    "document/writers/page.py": "one look-up in a table, told as a DocumentError",
    "decide/domain.py": "a name that the point does not have",
    "decide/samples.py": FLOATS,
    "mechanics/elimination.py": "pow(x, -1, p) at a pole",
    "mechanics/numbers.py": "what becomes NoNumber; and text of an example's number",
    "statement/starter.py": FLOATS,
    "statement/library.py": READS,
    "statement/loader.py": READS,
    "studio/api.py": READS,
    "studio/following.py": "a name that the point does not have",
    "teaching/executor.py": f"a cluster's client that is closed twice; {READS}",
    "teaching/grading/intervals.py": "an enclosure that has no value, a name that the point does not have",
    "teaching/grading/quantity.py": "an enclosure that has no value, told as a ReadError",
    "teaching/grading/verdicts.py": "an enclosure that has no value, a name that the point does not have",
    "teaching/batch.py": READS,
    "teaching/retold.py": "a body, force, work or premise that a wrong physics has not: that differs, or is not told",
    "teaching/tasks/results.py": FLOATS,
    "claims/run.py": READS,
    "claims/theory.py": "moments beyond the second: one look-up in a table, told as Undecided",
    "claims/diagnosis_numbers.py": "a look in floating-point numbers, which chooses and never decides",
    "claims/papers/formats.py": READS,
    "claims/papers/source.py": READS,
    "oracles/lagrange.py": "pow(x, -1, p) at a pole",
}


def caught(tree: ast.AST) -> set[str]:
    """The names of all exceptions that are caught or suppressed; "" for a bare except."""
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ExceptHandler):
            kinds = node.type.elts if isinstance(node.type, ast.Tuple) else [node.type]
        elif isinstance(node, ast.Call) and getattr(node.func, "id", "") == "suppress":
            kinds = node.args
        else:
            continue
        found |= {"Exception" if kind is None else getattr(kind, "id", getattr(kind, "attr", "")) for kind in kinds}
    return found


def test_what_is_caught_is_meant() -> None:
    broad = {
        str(path.relative_to(PACKAGE))
        for path in sorted(PACKAGE.rglob("*.py"))
        if caught(ast.parse(path.read_text(encoding="utf-8"))) & BROAD
    }
    assert broad - ALLOWED.keys() == set(), "raise and catch an RbpsymError (NoNumber, NotApplicable, Undecided) instead"
    assert ALLOWED.keys() - broad == set(), "these lines are not needed any more"


def test_a_broad_except_is_seen() -> None:
    assert caught(ast.parse("try: pass\nexcept (KeyError, x.Outside): pass")) & BROAD
    assert caught(ast.parse("with suppress(Exception): pass")) & BROAD and caught(ast.parse("try: pass\nexcept: pass")) & BROAD

"""Mutants of the source: every place at which a small change can be made, and the changed text.

A site is found in the syntax tree and changed in the text, so that all else stays as it was. What is left out by rule:
docstrings, annotations, decorators, what is raised (the words of an error), module-level numbers in capitals (bounds of
effort and tolerances, whose exact size is no matter of right and wrong) and whether what is just as large is within them,
and `strict=True` (an assertion, not a choice).
"""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Site:
    """A change: `old` text from `start` to `end` becomes `new`; `function` is the qualified name around it."""

    file: str
    function: str
    line: int
    kind: str
    start: int
    end: int
    old: str
    new: str

    def mutated(self, text: str) -> str:
        """The source with the change."""
        return text[: self.start] + self.new + text[self.end :]

    def __str__(self) -> str:
        old, new = (" ".join(part.split())[:70] for part in (self.old, self.new))
        return f"{self.file}:{self.line} [{self.function or 'module'}] {self.kind}: {old} -> {new}"


COMPARISONS = {
    ast.Lt: ("<=", ">="), ast.LtE: ("<", ">"), ast.Gt: (">=", "<="), ast.GtE: (">", "<"), ast.Eq: ("!=",),
    ast.NotEq: ("==",), ast.In: ("not in",), ast.NotIn: ("in",), ast.Is: ("is not",), ast.IsNot: ("is",),
}  # fmt: skip
ORDERS = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)
OPERATORS = {
    ast.Add: ("-",), ast.Sub: ("+",), ast.Mult: ("/",), ast.Div: ("*",), ast.FloorDiv: ("*",), ast.Mod: ("*",),
    ast.Pow: ("*",), ast.BitAnd: ("|",), ast.BitOr: ("&",),
}  # fmt: skip
SKIPPED = (ast.Raise, ast.arg)


class _Finder(ast.NodeVisitor):
    """Walks a module and gathers its sites."""

    def __init__(self, file: str, text: str) -> None:
        self.file, self.text, self.found = file, text, []
        self.around: list[str] = []
        lines = text.splitlines(keepends=True)
        self.offsets = [0]
        for line in lines:
            self.offsets.append(self.offsets[-1] + len(line))
        self.lines = lines

    # --- places in the text

    def _at(self, line: int, column: int) -> int:
        return self.offsets[line - 1] + len(self.lines[line - 1].encode()[:column].decode())

    def _span(self, node: ast.AST) -> tuple[int, int]:
        return self._at(node.lineno, node.col_offset), self._at(node.end_lineno, node.end_col_offset)

    def _source(self, node: ast.AST) -> str:
        start, end = self._span(node)
        return self.text[start:end]

    def _add(self, node: ast.AST, kind: str, new: str) -> None:
        start, end = self._span(node)
        old = self.text[start:end]
        if old != new:
            self.found.append(Site(self.file, ".".join(self.around), node.lineno, kind, start, end, old, new))

    # --- where we are

    def _within(self, name: str, nodes) -> None:
        self.around.append(name)
        for node in nodes:
            self.visit(node)
        self.around.pop()

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        body = node.body[1:] if _is_text(node.body[0]) else node.body
        for default in (*node.args.defaults, *(d for d in node.args.kw_defaults if d)):
            self.visit(default)
        name = f"<locals>.{node.name}" if self.around and not self.around[-1].lstrip("_")[:1].isupper() else node.name
        self._within(name, body)

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        self._within(node.name, node.body[1:] if _is_text(node.body[0]) else node.body)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_Assign(self, node: ast.Assign) -> None:
        bound = not self.around and isinstance(node.targets[0], (ast.Name, ast.Tuple))
        values = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        if not (bound and all(_is_number(value) for value in values)):
            self.visit(node.value)

    def visit(self, node: ast.AST) -> None:
        if isinstance(node, SKIPPED) or (isinstance(node, ast.Expr) and _is_text(node)):
            return
        super().visit(node)

    # --- what can be changed

    def visit_Compare(self, node: ast.Compare) -> None:
        for k, op in enumerate(node.ops):
            sides = [node.left, *node.comparators]
            is_bound = any(isinstance(side, ast.Name) and side.id.isupper() for side in sides[k : k + 2])
            for new in COMPARISONS[type(op)][is_bound and isinstance(op, ORDERS) :]:
                signs = [new if j == k else _sign(other) for j, other in enumerate(node.ops)]
                texts = [f"{self._source(a)} {s}" for a, s in zip(sides, signs, strict=False)]
                self._add(node, "comparison", " ".join([*texts, self._source(sides[-1])]))
        self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> None:
        word = " or " if isinstance(node.op, ast.And) else " and "
        self._add(node, "and/or", "(" + word.join(f"({self._source(v)})" for v in node.values) + ")")
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        text = isinstance(node.left, (ast.Constant, ast.JoinedStr)) and not _is_number(node.left)
        for new in () if text else OPERATORS.get(type(node.op), ()):
            self._add(node, "operator", f"({self._source(node.left)}) {new} ({self._source(node.right)})")
        self.generic_visit(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> None:
        if isinstance(node.op, (ast.USub, ast.Not)):
            self._add(node, "sign" if isinstance(node.op, ast.USub) else "not", f"({self._source(node.operand)})")
        self.generic_visit(node)

    def visit_keyword(self, node: ast.keyword) -> None:
        if node.arg != "strict":
            self.visit(node.value)

    def visit_Constant(self, node: ast.Constant) -> None:
        if node.value is True or node.value is False:
            self._add(node, "constant", str(not node.value))
        elif _is_number(node):
            self._add(node, "constant", str(node.value + 1))

    def visit_If(self, node: ast.If) -> None:
        self._add(node.test, "branch", f"not ({self._source(node.test)})")
        self.generic_visit(node)

    def visit_IfExp(self, node: ast.IfExp) -> None:
        test, body, other = map(self._source, (node.test, node.body, node.orelse))
        self._add(node, "branch", f"({other}) if ({test}) else ({body})")
        self.generic_visit(node)

    def visit_Dict(self, node: ast.Dict) -> None:
        pairs = [(k, v) for k, v in zip(node.keys, node.values, strict=True) if k is not None]
        for (_, one), (_, two) in zip(pairs, pairs[1:], strict=False):
            first, second = self._source(one), self._source(two)
            if first != second:
                start, end = self._span(one)[0], self._span(two)[1]
                between = self.text[self._span(one)[1] : self._span(two)[0]]
                old, new = self.text[start:end], second + between + first
                around = ".".join(self.around)
                self.found.append(Site(self.file, around, one.lineno, "entries", start, end, old, new))
        self.generic_visit(node)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Places within an f-string are not kept by the syntax tree of 3.11."""


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _is_number(node: ast.AST) -> bool:
    if isinstance(node, ast.UnaryOp):
        return _is_number(node.operand)
    return isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool)


def _sign(op: ast.cmpop) -> str:
    words = {ast.Eq: "==", ast.NotEq: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Is: "is"}
    return {**words, ast.IsNot: "is not", ast.In: "in", ast.NotIn: "not in"}[type(op)]


def sites(home: Path, file: str) -> list[Site]:
    """All changes that can be made in a file (`is_sound` says whether one still is Python, and another program)."""
    text = (home / file).read_text(encoding="utf-8")
    finder = _Finder(file, text)
    finder.visit(ast.parse(text))
    return finder.found


def is_sound(home: Path, site: Site) -> bool:
    """Can the changed file be read, and does it say anything else?"""
    text = (home / site.file).read_text(encoding="utf-8")
    try:
        return ast.dump(ast.parse(site.mutated(text))) != ast.dump(ast.parse(text))
    except SyntaxError:
        return False

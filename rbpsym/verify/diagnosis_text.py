"""A repaired relation in the author's own LaTeX: what was not changed stays as it is printed."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.notation import tree as t
from rbpsym.notation.latex import to_latex
from rbpsym.notation.places import put, sites


def corrected(latex: str, relation: t.Chain, repaired: t.Chain, symbols: Mapping[str, str]) -> str:
    """The formula with one part of a relation replaced; "" if that part has no place in it."""
    old, new = relation, repaired
    while (pair := _only_change(old, new)) is not None:
        old, new = pair
    if old.span is None:
        return ""
    begin, end = old.span
    kept = {id(node) for _, node in sites(relation) if node.span}
    text, before, behind = _written(new, latex, kept, symbols), latex[:begin].rstrip(), latex[end:]
    gap = latex[len(before) : begin]
    if isinstance(old, t.Num | t.Sym) and isinstance(new, t.Mul) and re.match(r"\s*\^", behind):
        text = f"({text})"
    if text.startswith("-") and before.endswith("+"):
        before, text = before[:-1].rstrip(), f"- {text[1:].lstrip()}"
    elif isinstance(old, t.Neg) and not text.startswith("-") and not re.search(r"(?:[=({\[&]|\\approx|\\\\)$", before) and before:
        text = f"+ {text}"
    elif isinstance(new, t.Add) and not re.search(r"(?:[=+&]|\\approx|\\\\)$", before) and before:
        text = rf"\left({text}\right)"
    return f"{before}{gap}{text}{behind}".strip()


def _only_change(old: t.Node, new: t.Node) -> tuple[t.Node, t.Node] | None:
    """The only part in which two nodes of one kind differ; None if they differ themselves."""
    if type(old) is not type(new):
        return None
    ones, others = ([node for path, node in sites(node) if len(path) == 1] for node in (old, new))
    if len(ones) != len(others):
        return None
    pairs = [(one, other) for one, other in zip(ones, others, strict=True) if one is not other]
    whole = type(old) in (t.Chain, t.Add, t.Mul, t.Div, t.Neg, t.Group, t.Pow, t.Sqrt) or all(
        getattr(old, key, None) == getattr(new, key, None) for key in ("name", "wrt", "var", "order")
    )
    return pairs[0] if len(pairs) == 1 and whole and pairs[0][0].span else None


def _written(node: t.Node, latex: str, kept: set[int], symbols: Mapping[str, str]) -> str:
    """The LaTeX of a part: as printed if it was there, else its symbols as the author prints them."""
    if id(node) in kept:
        return latex[slice(*node.span)].strip()
    if isinstance(node, t.Neg):
        return f"-{_written(node.arg, latex, kept, symbols)}"
    names = sorted(t.names(node) - {"pi"})
    marks = {name: f"Q_{place}" for place, name in enumerate(names, 101)}
    for path, part in list(sites(node)):
        if isinstance(part, (t.Sym, t.Vec)) and part.name in marks:
            node = put(node, path, type(part)(marks[part.name]))
    text = to_latex(node)
    for name, mark in marks.items():
        own, drawn = symbols.get(name, name), re.escape(f"Q_{{{mark[2:]}}}")
        own = f"{own} " if re.search(r"\\[A-Za-z]+$", own) else own
        text = re.sub(rf"\\vec\{{{drawn}\}}|{drawn}", lambda _, own=own: own, text)
    return re.sub(r" +(?=[\^_)]|$)", "", text)

"""Repairs with what a formula does not hold itself: another symbol, a lost factor, dot, term, root, or degrees."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import partial

from rbpsym.algebra import Space
from rbpsym.algebra.present import present
from rbpsym.errors import RbpsymError
from rbpsym.frozen import dataclass, replace
from rbpsym.notation import tree as t
from rbpsym.notation.latex import to_latex
from rbpsym.notation.latex_grammar import DEGREE
from rbpsym.notation.places import Path, put, sites
from rbpsym.notation.text import to_text
from rbpsym.verify.claims_ground import Ground, Question
from rbpsym.verify.claims_integrals import valued
from rbpsym.verify.claims_model import Claim

_FAR = re.compile(r"\b(where|when|until|in|frequency|period|time|start|unknown|constant|defined|smallest|largest)\b")
LARGEST = 12  # number that is tried in place of another
MOST = 20  # other symbols that are tried
TURNS = ("sin", "cos", "tan")
Change = tuple[t.Node, str]  # what stands in place of a part, and what was changed in words
Rule = Callable[[t.Chain], Iterator["Repair"]]


@dataclass(frozen=True, slots=True)
class Repair:
    """A relation with one thing changed, what was changed in words, and with what it is read, if not with what it was."""

    relation: t.Chain
    words: str
    ground: Ground | None = None


def anywhere(change: Callable[[Path, t.Node], Iterator[Change]], ground: Ground | None = None) -> Rule:
    """The repairs that a change makes of each part of a relation in turn."""

    def repairs(relation: t.Chain) -> Iterator[Repair]:
        for path, node in sites(relation):
            for new, words in change(path, node):
                yield Repair(put(relation, path, new), words, ground)

    return repairs


def known(claim: Claim, ground: Ground) -> tuple[Ground, dict[str, str]]:
    """The ground with symbols of a claim that its formula does not use, and their phrases by name."""
    bounds, phrases = dict(ground.bounds), {}
    for latex, meaning in claim.setting.symbols.items():
        key = ground.glossary.names.get(latex)
        if key is None or _FAR.search(meaning.phrase) or len(phrases) >= MOST:
            continue
        with suppress(RbpsymError):
            bounds.setdefault(key, ground.world.bound(meaning.phrase))
            phrases[key[0]] = meaning.phrase
    return replace(ground, bounds=bounds), phrases


def edits(relation: t.Chain, claim: Claim, ground: Ground) -> Iterator[Repair]:
    """All of them, the likeliest first."""
    wide, phrases = known(claim, ground)
    for change in (_degrees, _numbers, _angles, partial(_others, phrases), partial(_lost, phrases)):
        yield from anywhere(change, wide)(relation)
    yield from _missing(relation, wide, phrases)


def _degrees(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, t.Num) and path and path[-1][0] in ("arg", "items"):
        yield t.mul(node, DEGREE), f"{to_text(node)} is in degrees"


def _numbers(path: Path, node: t.Node) -> Iterator[Change]:
    """Another small number, wherever one stands."""
    for other in range(1, LARGEST + 1) if isinstance(node, t.Num) and isinstance(node.value, int) else ():
        if other != node.value:
            yield t.Num(other), f"{other} in place of {to_text(node)}"


def _angles(path: Path, node: t.Node) -> Iterator[Change]:
    """Twice or half the angle; a root that is too much, or missing."""
    if isinstance(node, t.Fn) and node.name in TURNS:
        yield from ((t.Fn(node.name, t.mul(factor, node.arg)), f"the angle of {node.name}") for factor in (t.TWO, t.HALF))
    if isinstance(node, t.Sqrt):
        yield t.Group(node.arg), "the root is too much"
    if path and path[-1][0] in ("items", "num", "den"):
        yield t.Sqrt(node), "a root is missing"


def _missing(relation: t.Chain, ground: Ground, phrases: dict[str, str]) -> Iterator[Repair]:
    """The one term by which the sides differ."""
    named = {phrase: name for name, phrase in phrases.items()}
    question = Question(ground)
    for depth in ("identity", "motion"):
        left, right = (valued(side, ground) for side in relation.items)
        if isinstance(left, Space) or isinstance(right, Space):
            return
        term = present(question.seen(left, depth) - question.seen(right, depth))
        if any(isinstance(part, t.Add) for part in t.walk(term)) or not t.names(term) - {"pi"} <= named.keys():
            continue
        term = renamed(term, named)
        repaired = t.Chain((relation.items[0], t.add(relation.items[1], term)), ("=",))
        yield Repair(repaired, f"the term {to_text(term)} is missing", ground)


def renamed(node: t.Node, names: dict[str, str]) -> t.Node:
    """The formula with other names."""
    for path, part in list(sites(node)):
        if isinstance(part, t.Sym) and part.name in names:
            node = put(node, path, t.Sym(names[part.name]))
    return node


def _others(phrases: dict[str, str], path: Path, node: t.Node) -> Iterator[Change]:
    """A symbol that the formula does not hold in place of one that it does: a dot, an index, a length, a mass."""
    for name in phrases if isinstance(node, t.Sym) else ():
        if name != node.name:
            yield t.Sym(name), f"{to_text(t.Sym(name))} in place of {to_text(node)}"


def _lost(phrases: dict[str, str], path: Path, node: t.Node) -> Iterator[Change]:
    """A factor that is missing or too much in one term."""
    if not path or path[-1][0] not in ("terms", "items", "num", "den", "arg") or node == t.ZERO:
        return
    for symbol in map(t.Sym, phrases):
        yield t.mul(node, symbol), f"the factor {to_text(symbol)} is missing"
        if symbol.name in t.names(node):
            yield t.Div(node, symbol), f"the factor {to_text(symbol)} is too much"


# --- a repaired relation in the author's own LaTeX: what was not changed stays as it is printed


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

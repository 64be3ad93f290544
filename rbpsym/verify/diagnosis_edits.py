"""Repairs with what a formula does not hold itself: another symbol, a lost factor, dot, term, root, or degrees."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from rbpsym.algebra import Space
from rbpsym.algebra.present import present
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.latex_grammar import DEGREE
from rbpsym.notation.places import put, sites
from rbpsym.notation.text import to_text
from rbpsym.verify.claims_ground import Ground, Question
from rbpsym.verify.claims_integrals import valued
from rbpsym.verify.claims_model import Claim

_FAR = re.compile(r"\b(where|when|until|in|frequency|period|time|start|unknown|constant|defined|smallest|largest)\b")
LARGEST = 12  # number that is tried in place of another
MOST = 20  # other symbols that are tried
Edit = tuple[t.Chain, str, Ground]  # the repaired relation, what was changed, and with what it is read


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


def edits(relation: t.Chain, claim: Claim, ground: Ground) -> Iterator[Edit]:
    """All of them, the likeliest first."""
    wide, phrases = known(claim, ground)
    yield from _degrees(relation, wide)
    yield from _numbers(relation, wide)
    yield from _angles(relation, wide)
    yield from _others(relation, wide, phrases)
    yield from _lost(relation, wide, phrases)
    yield from _missing(relation, wide, phrases)


def _degrees(relation: t.Chain, ground: Ground) -> Iterator[Edit]:
    for path, node in sites(relation):
        if isinstance(node, t.Num) and path and (path[-1][0] == "arg" or path[-1][0] == "items"):
            yield put(relation, path, t.mul(node, DEGREE)), f"{to_text(node)} is in degrees", ground


def _numbers(relation: t.Chain, ground: Ground) -> Iterator[Edit]:
    """Another small number, wherever one stands."""
    for path, node in sites(relation):
        for other in range(1, LARGEST + 1) if isinstance(node, t.Num) and isinstance(node.value, int) else ():
            if other != node.value:
                yield put(relation, path, t.Num(other)), f"{other} in place of {to_text(node)}", ground


def _angles(relation: t.Chain, ground: Ground) -> Iterator[Edit]:
    """Twice or half the angle; a root that is too much, or missing."""
    for path, node in sites(relation):
        if isinstance(node, t.Fn) and node.name in ("sin", "cos", "tan"):
            for factor in (t.TWO, t.HALF):
                yield put(relation, path, t.Fn(node.name, t.mul(factor, node.arg))), f"the angle of {node.name}", ground
        if isinstance(node, t.Sqrt):
            yield put(relation, path, t.Group(node.arg)), "the root is too much", ground
        if path and path[-1][0] in ("items", "num", "den"):
            yield put(relation, path, t.Sqrt(node)), "a root is missing", ground


def _missing(relation: t.Chain, ground: Ground, phrases: dict[str, str]) -> Iterator[Edit]:
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
        yield t.Chain((relation.items[0], t.add(relation.items[1], term)), ("=",)), f"the term {to_text(term)} is missing", ground


def renamed(node: t.Node, names: dict[str, str]) -> t.Node:
    """The formula with other names."""
    for path, part in list(sites(node)):
        if isinstance(part, t.Sym) and part.name in names:
            node = put(node, path, t.Sym(names[part.name]))
    return node


def _others(relation: t.Chain, ground: Ground, phrases: dict[str, str]) -> Iterator[Edit]:
    """A symbol that the formula does not hold in place of one that it does: a dot, an index, a length, a mass."""
    for path, node in sites(relation):
        for name in phrases if isinstance(node, t.Sym) else ():
            if name != node.name:
                yield put(relation, path, t.Sym(name)), f"{to_text(t.Sym(name))} in place of {to_text(node)}", ground


def _lost(relation: t.Chain, ground: Ground, phrases: dict[str, str]) -> Iterator[Edit]:
    """A factor that is missing or too much in one term."""
    for path, node in sites(relation):
        if not path or path[-1][0] not in ("terms", "items", "num", "den", "arg") or node == t.ZERO:
            continue
        for name in phrases:
            symbol = t.Sym(name)
            yield put(relation, path, t.mul(node, symbol)), f"the factor {to_text(symbol)} is missing", ground
            if name in t.names(node):
                yield put(relation, path, t.Div(node, symbol)), f"the factor {to_text(symbol)} is too much", ground

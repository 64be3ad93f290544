"""Repairs with what a formula does not hold itself: another symbol, a lost factor, dot, term, root, or degrees."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import partial

from rbpsym.claims.ground import EqualityQuestion, Ground
from rbpsym.claims.integrals import valued
from rbpsym.claims.model import Claim, Meaning
from rbpsym.claims.refute import carried_out
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.numerals import DEGREE
from rbpsym.expr.places import Path, put, sites
from rbpsym.field import NOTHING, Scalar, Space, depends_on, without_even_roots
from rbpsym.frozen import Frozen, replace
from rbpsym.present.forms import present
from rbpsym.present.style import PLAIN
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.text import to_text

_FAR = re.compile(r"\b(where|when|until|in|frequency|period|time|start|unknown|constant|defined|smallest|largest)\b")
LARGEST = 12  # number that is tried in place of another
MOST = 24  # other symbols that are tried
MOST_SUMS, LONGEST = 16, 12  # places where a term may be missing; parts of such a term
TURNS = ("sin", "cos", "tan")
Change = tuple[t.Node, str]  # what stands in place of a part, and what was changed in words
Rule = Callable[[t.Chain], Iterator["Repair"]]


Pairs = set[tuple[t.Node, t.Node]]  # which factor an author prints before which


class Repair(Frozen):
    """A relation with one thing changed, what was changed in words, and with what it is read, if not with what it was."""

    relation: t.Chain
    words: str
    ground: Ground | None = None


def anywhere(change: Callable[[Path, t.Node], Iterator[Change]], ground: Ground | None = None) -> Rule:
    """The repairs that a change makes of each part of a relation in turn."""

    def repairs(relation: t.Chain) -> Iterator[Repair]:
        for path, node in alone_last(relation):
            for new, words in change(path, node):
                yield Repair(put(relation, path, new), words, ground)

    return repairs


def alone_last(relation: t.Chain) -> list[tuple[Path, t.Node]]:
    """The parts of a relation; last a symbol that is all of a side, which is what the others are said of."""
    return sorted(sites(relation), key=lambda item: len(item[0]) == 1 and isinstance(item[1], t.Sym))


def known(claim: Claim, ground: Ground, *, far: bool = False) -> tuple[Ground, dict[str, str]]:
    """The ground with symbols of a claim that its formula does not use, and their phrases by name; or with the author's of which
    it takes `far` longer to say what they come to."""
    bounds, phrases = dict(ground.bounds), dict[str, str]()
    own = ground.world.symbols

    def place(item: tuple[str, Meaning]) -> tuple[bool, bool, int]:
        """Those of the formula first, then the author's, then the short ones."""
        latex, meaning = item
        return ground.glossary.names.get(latex) not in ground.bounds, own.get(latex) == meaning.phrase, len(latex)

    for latex, meaning in sorted(claim.setting.symbols.items(), key=place):
        key, is_far = ground.glossary.names.get(latex), bool(_FAR.search(meaning.phrase))
        if key is None or is_far != far or len(phrases) >= MOST or (far and own.get(latex) == meaning.phrase):
            continue
        with suppress(RbpsymError):
            found = ground.world.bound(meaning.phrase)
            if found.scalar != NOTHING:  # nobody means what vanishes
                bounds.setdefault(key, found)
                phrases[key[0]] = meaning.phrase
    return replace(ground, bounds=bounds), phrases


def edits(relation: t.Chain, claim: Claim, ground: Ground) -> Iterator[Repair]:
    """All of them, the likeliest first."""
    wide, phrases = known(claim, ground)
    products = [list(map(_base, part.factors)) for part in t.walk(relation) if isinstance(part, t.Mul)]
    pairs = {(one, other) for factors in products for k, one in enumerate(factors) for other in factors[k + 1 :]}
    values = {name: own for name in {*t.names(relation), *phrases} if (own := _value_of(name, wide)) is not None}
    moving = {t.Sym(name) for name, own in values.items() if any(depends_on(own, other) for other in wide.motion.scope.rates)}
    rank = {t.Sym(name): key for name, key in getattr(getattr(ground.world, "study", None), "style", PLAIN).rank.items()}
    pairs |= {(a, b) for a in rank for b in rank if rank[a] < rank[b] and (b, a) not in pairs}  # as one is used to print them
    lost = partial(_lost, phrases, pairs, moving)
    for change in (_degrees, numbers, _angles, partial(_others, phrases), _excess, lost, partial(_lost_inside, phrases)):
        yield from anywhere(change, wide)(relation)
    wider, others = known(claim, ground, far=True)
    yield from anywhere(partial(_others, others), wider)(relation)
    yield from _missing(relation, wide, phrases)
    yield from anywhere(partial(_lost, others, pairs, moving), wider)(relation)


def _degrees(path: Path, node: t.Node) -> Iterator[Change]:
    if isinstance(node, t.Num) and path and path[-1][0] in ("arg", "items"):
        yield t.mul(node, DEGREE), f"{to_text(node)} is in degrees"


def numbers(path: Path, node: t.Node) -> Iterator[Change]:
    """Another small number, wherever one stands; 0 where it is all of a side."""
    if not (isinstance(node, t.Num) and isinstance(node.value, int)):
        return
    for other in range({"items": 0, "factors": 2}.get(path[-1][0], 1) if path else 1, LARGEST + 1):
        if t.Num(other) != node:
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
    named = {phrase: name for name, phrase in sorted(phrases.items(), key=lambda item: item[0] in t.names(relation))}
    question = EqualityQuestion(ground)
    found: dict[t.Chain, tuple[int, int, bool, int, t.Node]] = {}
    sides = {_value_of(side, ground) for side in relation.items if isinstance(side, t.Sym)} - {None}
    alone = {name for name in {*t.names(relation), *phrases} if _value_of(name, ground) in sides}  # by whatever symbol
    values = {name: own for name in phrases if name not in t.names(relation) and (own := _value_of(name, ground))}
    whole = any(isinstance(part, (t.Integral, t.PathIntegral)) for part in t.walk(relation))  # nothing else is to be carried out
    for depth in ("identity", "motion") if whole else ("identity", "motion", "start"):
        seen = {name: _seen(own, question, depth) for name, own in values.items()}
        for path, node in _summands(relation):
            value = None
            with suppress(RbpsymError, ZeroDivisionError):  # with a number beside it, it has no value
                value = _that_is_missing(relation, path, node, question, depth)
            for term in () if value is None else (*_symbols_of(value, seen), renamed(_told(value, relation, ground), named)):
                size = sum(1 + isinstance(part, t.Div) for part in t.walk(term) if not isinstance(part, t.Neg))
                sums = sum(isinstance(part, t.Add) for part in t.walk(term))
                known = t.names(term) - {"pi"} <= phrases.keys() and not alone & t.names(term)
                known = known and _value_of(t.add(node, term), ground) != NOTHING  # α − α
                inside = {name for part in t.walk(term) if isinstance(part, t.Fn) for name in t.names(part)}
                known = known and not _bare(term) & inside
                if known and size <= LONGEST and sums <= 1 and not isinstance(term, t.Add):
                    foreign = len(t.names(term) - t.names(relation))
                    key = (size, foreign, t.is_negative(term), -len(path), term)
                    found.setdefault(put(relation, path, _joined(node, term)), key)
    for repaired, (*_, term) in sorted(found.items(), key=lambda item: item[1][:4]):
        yield Repair(repaired, f"the term {to_text(term)} is missing", ground)


def _joined(node: t.Node, term: t.Node) -> t.Node:
    """The sum with one more term, in front of a minus with which it would begin."""
    first = node.terms[0] if isinstance(node, t.Add) else node
    return t.add(term, node) if t.is_negative(first) and not t.is_negative(term) else t.add(node, term)


def _bare(node: t.Node) -> set[str]:
    """The symbols that stand in no function; no missing term holds an angle and its sine, θ/sin θ."""
    if isinstance(node, t.Sym | t.Fn):
        return {node.name} if isinstance(node, t.Sym) else set()
    return {name for part in t.children(node) for name in _bare(part)}


def _told(value: Scalar, relation: t.Chain, ground: Ground) -> t.Node:
    """The value as a formula; without its constant where a symbol is known up to a constant only."""
    found = present(value)
    if not isinstance(found, t.Add) or not any(ground.kind(name) == "up to a constant" for name in t.names(relation)):
        return found
    return t.add(*(term for term in found.terms if t.names(term) & ground.motion.scope.rates.keys()))


def _value_of(node: t.Node | str, ground: Ground) -> Scalar | None:
    """Of a node or name; None if it has none, or is a vector."""
    with suppress(RbpsymError, ZeroDivisionError):
        found = valued(t.Sym(node) if isinstance(node, str) else node, ground)
        return found if isinstance(found, Scalar) else None
    return None


def _symbols_of(value: Scalar, values: Mapping[str, Scalar | None]) -> Iterator[t.Node]:
    """Symbols that have this value, or its opposite."""
    for name, own in values.items():
        if own in (value, -value):
            yield t.Sym(name) if own == value else t.Neg(t.Sym(name))


def _seen(value: Scalar, question: EqualityQuestion, depth: str) -> Scalar | None:
    return carried_out(value, question) if depth == "start" else question.seen(value, depth)


def _summands(relation: t.Chain) -> list[tuple[Path, t.Node]]:
    """Where one more term can stand: sides, the right one first, parentheses, above and below the bar."""
    parents = dict(sites(relation))
    found = [(path, node) for path, node in parents.items() if path and node != t.ZERO and _is_summand(path, node, parents)]
    return sorted(found, key=lambda item: item[0][0] != ("items", 1))[:MOST_SUMS]


def _is_summand(path: Path, node: t.Node, parents: Mapping[Path, t.Node]) -> bool:
    kind = path[-1][0]
    if kind == "factors":  # a parenthesis of which one term is left
        return isinstance(node, (t.Sym, t.Fn, t.Num, t.Neg, t.Add))
    return kind in ("items", "num", "den") or (kind == "arg" and isinstance(parents[path[:-1]], (t.Group, t.Sqrt)))


def _that_is_missing(relation: t.Chain, path: Path, node: t.Node, question: EqualityQuestion, depth: str) -> Scalar | None:
    """The term x for which the gap (a + b x)/(1 + d x) of the sides is zero, found from its values at 0, 1 and 2.

    Under a root it is found from what the root should be.
    """
    places = dict(sites(relation))
    above = next((path[:k] for k in range(len(path) - 1, 0, -1) if isinstance(places[path[:k]], t.Sqrt)), None)
    wanted: Scalar | Space = NOTHING
    if above is not None:
        more, root = _that_is_missing(relation, above, places[above], question, depth), valued(places[above], question.ground)
        if more is None or isinstance(root, Space):
            return None
        wanted = (more + root) * (more + root)
    gaps = []
    for number in range(3):
        whole = put(relation, path, t.add(node, t.Num(number)) if number else node)
        items = (dict(sites(whole))[(*above, ("arg", None))],) if above else whole.items
        left, right = [*(valued(item, question.ground) for item in items), wanted][:2]
        if isinstance(left, Space) or isinstance(right, Space):
            return None
        gaps.append(_seen(left - right, question, depth))
    first, second, third = gaps
    if first is None or second is None or third is None or first == second or second == third:
        return None
    d = (second * 2 - third - first) / ((third - second) * 2)
    b = second * (d + 1) - first
    return None if b == first - first else without_even_roots(-first / b)


def renamed(node: t.Node, names: dict[str, str]) -> t.Node:
    """The formula with other names."""
    for path, part in list(sites(node)):
        if isinstance(part, t.Sym) and part.name in names:
            node = put(node, path, t.Sym(names[part.name]))
    return node


def _others(phrases: dict[str, str], path: Path, node: t.Node) -> Iterator[Change]:
    """A symbol that the formula does not hold in place of one that it does: a dot, an index, a length, a mass."""
    base = node.name.partition("_")[0] if isinstance(node, t.Sym) else ""
    for name in sorted(phrases, key=lambda name: name.partition("_")[0] != base) if base else ():  # first another index
        if t.Sym(name) != node:
            yield t.Sym(name), f"{to_text(t.Sym(name))} in place of {to_text(node)}"


def _lost(phrases: dict[str, str], pairs: Pairs, moving: set[t.Sym], path: Path, node: t.Node) -> Iterator[Change]:
    """A factor that is missing or too much in one term."""
    if not path or path[-1][0] not in ("terms", "items", "num", "den", "arg") or node == t.ZERO:
        return
    for symbol in map(t.Sym, phrases):
        for factor in (symbol, t.Pow(symbol, t.TWO)):
            if isinstance(node, t.Div) and isinstance(node.num, t.Add):
                yield t.Mul((node, factor)), f"the factor {to_text(factor)} is missing"
            if not _holds_quotient(node):  # above the bar, and behind the sign
                yield _among_factors(node, factor, pairs, moving), f"the factor {to_text(factor)} is missing"
        if not isinstance(node, t.Add) and symbol.name in t.names(node) and symbol not in getattr(node, "factors", ()):
            yield t.Div(node, symbol), f"the factor {to_text(symbol)} is too much"


def _excess(path: Path, node: t.Node) -> Iterator[Change]:
    """A factor of a product that is too much."""
    factors = node.factors if isinstance(node, t.Mul) else ()
    for k, one in enumerate(factors):
        if isinstance(one, t.Sym):
            yield t.mul(*factors[:k], *factors[k + 1 :]), f"the factor {to_text(one)} is too much"


def _lost_inside(phrases: dict[str, str], path: Path, node: t.Node) -> Iterator[Change]:
    """A term that is missing where it stands in no sum of sides: what is raised, or in a function, (R − a)² and cos(θ − β)."""
    if path and path[-1][0] in ("base", "arg") and isinstance(node, (t.Sym, t.Add)):
        for symbol in (t.Sym(name) for name in phrases if name not in t.names(node)):
            yield from ((t.add(node, one), f"the term {to_text(one)} is missing") for one in (t.Neg(symbol), symbol))


def _holds_quotient(node: t.Node) -> bool:
    inner = node.arg if isinstance(node, t.Neg) else node
    return inner is not node or any(isinstance(part, t.Div) and t.names(part) for part in getattr(inner, "factors", (inner,)))


def _among_factors(node: t.Node, factor: t.Node, pairs: Pairs, moving: set[t.Sym]) -> t.Node:
    """The product with one more factor: in the author's order, else in front of functions and sums, and a constant in front of
    what moves."""
    factors, symbol = node.factors if isinstance(node, t.Mul) else (node,), _base(factor)
    behind = [(symbol, _base(part)) in pairs for part in factors]
    before = [(_base(part), symbol) in pairs for part in factors]
    ends = moving if symbol not in moving else set()
    plain = [not t.names(part) or (isinstance(_base(part), t.Sym) and _base(part) not in ends) for part in factors]
    place = len(factors) - before[::-1].index(True) if any(before) else 0
    place = behind.index(True) if any(behind) else max(place, [*plain, False].index(False))
    return t.mul(*factors[:place], factor, *factors[place:])


def _base(node: t.Node) -> t.Node:
    return node.base if isinstance(node, t.Pow) else node


# --- a repaired relation in the author's own LaTeX: what was not changed stays as it is printed


def corrected(latex: str, relation: t.Chain, repaired: t.Chain, symbols: Mapping[str, str]) -> str:
    """The formula with one part of a relation replaced; "" if that part has no place in it."""
    old: t.Node = relation
    new: t.Node = repaired
    while (pair := _only_change(old, new)) is not None:
        old, new = pair
    if old.span is None:
        return ""
    begin, end = _begin(latex, old), _end(old)
    kept = {id(node) for _, node in sites(relation) if node.span}
    text, before, behind = _written(new, latex, kept, symbols), latex[:begin].rstrip(), latex[end:]
    gap = latex[len(before) : begin]
    if isinstance(old, t.Num | t.Sym) and isinstance(new, t.Mul) and re.match(r"\s*\^", behind):
        text = f"({text})"
    if len(text) > 1 and re.search(r"\\[dt]?frac\s*(?:\d|\{[^{}]*\}|\\[a-zA-Z]+\s*)?$", before):  # as \frac takes it
        text = f"{{{text}}}"
    elif text.startswith("-") and before.endswith("+"):
        before, text = before[:-1].rstrip(), f"- {text[1:].lstrip()}"
    elif isinstance(old, t.Neg) and not text.startswith("-") and not re.search(r"(?:[=({\[&]|\\approx|\\\\)$", before) and before:
        text = f"+ {text}"
    elif isinstance(new, t.Add) and before and not _stands_alone(before, behind):
        text = rf"\left({text}\right)"
    return f"{before}{gap}{text}{behind}".strip()


def _begin(latex: str, node: t.Node) -> int:
    r"""Where a part begins, with the \left of its first parenthesis."""
    start = node.span[0] if node.span else 0
    sized = re.search(r"\\(?:left|[bB]igg?l?)\s*$", latex[:start])
    return sized.start() if sized else start


def _end(node: t.Node) -> int:
    return node.span[1] if node.span else 0


def _only_change(old: t.Node, new: t.Node) -> tuple[t.Node, t.Node] | None:
    """The only part in which two nodes of one kind differ; None if they differ themselves."""
    if type(old) is not type(new) or _is_printed_in_one(old):
        return None
    ones, others = ([node for path, node in sites(node) if len(path) == 1] for node in (old, new))
    if len(ones) != len(others):
        return None
    pairs = [(one, other) for one, other in zip(ones, others, strict=True) if one is not other]
    whole = type(old) in (t.Chain, t.Add, t.Mul, t.Div, t.Neg, t.Group, t.Pow, t.Sqrt) or all(
        getattr(old, key, None) == getattr(new, key, None) for key in ("name", "wrt", "var", "order")
    )
    return pairs[0] if len(pairs) == 1 and whole and pairs[0][0].span else None


def _stands_alone(before: str, behind: str) -> bool:
    """May a sum stand here without parentheses?"""
    inside = before.endswith(("{", "(", "[")) and behind.lstrip().startswith(("}", ")", "]", r"\right"))
    return inside or bool(re.search(r"(?:[=+&]|\\approx|\\\\)$", before))


def _is_printed_in_one(node: t.Node) -> bool:
    r"""Does the exponent stand within its base, as in \\sin^2 x?"""
    base, exponent = (node.base.span, node.exponent.span) if isinstance(node, t.Pow) else (None, None)
    return base is not None and exponent is not None and base[0] <= exponent[0] < base[1]


def _written(node: t.Node, latex: str, kept: set[int], symbols: Mapping[str, str]) -> str:
    """The LaTeX of a part: as printed if it was there, else its symbols as the author prints them."""
    if id(node) in kept:
        return latex[_begin(latex, node) : _end(node)].strip()
    if isinstance(node, t.Neg):
        return f"-{_written(node.arg, latex, kept, symbols)}"
    if isinstance(node, t.Deriv) and r"dot{" in latex and node.wrt == "t":
        return rf"\{'d' * node.order}ot{{{_written(node.of, latex, kept, symbols)}}}"
    if isinstance(node, t.Add) and all(id(term) in kept for term in node.terms[1:]):
        rest = latex[_begin(latex, node.terms[1]) : _end(node.terms[-1])].strip()
        sign = "" if t.is_negative(node.terms[1]) else "+ "
        return f"{_written(node.terms[0], latex, kept, symbols)} {sign}{rest}"
    if isinstance(node, t.Add) and all(id(term) in kept for term in node.terms[:-1]):
        sign, last = ("-", node.terms[-1].arg) if isinstance(node.terms[-1], t.Neg) else ("+", node.terms[-1])
        begin = latex[_begin(latex, node.terms[0]) : _end(node.terms[-2])].strip()
        return f"{begin} {sign} {_written(last, latex, kept, symbols)}"
    names = sorted(t.names(node) - {"pi"})
    marks = {name: f"Q_{place}" for place, name in enumerate(names, 101)}
    for path, part in list(sites(node)):
        if isinstance(part, (t.Sym, t.Vec)) and part.name in marks:
            node = put(node, path, type(part)(marks[part.name]))
    text = to_latex(node)
    for name, mark in marks.items():
        own, drawn = symbols.get(name, name), re.escape(f"Q_{{{mark[2:]}}}")
        own = f"{own} " if re.search(r"\\[A-Za-z]+$", own) else own
        text = re.sub(rf"\\vec\{{{drawn}\}}|{drawn}", own.replace("\\", r"\\"), text)
    return re.sub(r" +(?=[\^_)]|$)", "", text)

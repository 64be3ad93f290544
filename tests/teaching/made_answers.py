"""Answers made from keys by rewriters that share no code with the engine: right ones, wrong ones, typed in many ways.

An expression is a nested tuple: numbers and names are strings, the rest is (operator, part, ...). Whether a
made answer is right is known from how it was made, and checked in floating point.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

Expr = str | tuple
SIGNS = {
    **dict.fromkeys(("m", "M", "g", "ell", "R", "k", "h", "I", "mu", "F", "v"), "positive"),
    **dict.fromkeys(("theta", "beta", "omega", "x"), "real"),
}


def p(*parts: Expr) -> Expr:
    """A product."""
    return ("*", *parts)


def s(*parts: Expr) -> Expr:
    """A sum."""
    return ("+", *parts)


def q(above: Expr, below: Expr) -> Expr:
    """A quotient."""
    return ("/", above, below)


def n(part: Expr) -> Expr:
    """Minus a part."""
    return ("-", part)


def w(part: Expr, power: int) -> Expr:
    """A power."""
    return ("^", part, str(power))


def f(name: str, part: Expr) -> Expr:
    """A function."""
    return ("f", name, part)


SIN, COS = f("sin", "theta"), f("cos", "theta")
KEYS: tuple[Expr, ...] = (
    p("m", "g", "ell"),
    q(p("3", "g", SIN), p("2", "ell")),
    q(p("m", "g"), s("m", "M")),
    n(
        q(
            p(s(q("m", "2"), "M"), "g", "ell", SIN),
            s(q(p("m", w("ell", 2)), "3"), p("M", w("ell", 2)), q(p("M", w("R", 2)), "2")),
        )
    ),
    f("sqrt", q(p("2", "g", "h"), s("1", q("I", p("m", w("R", 2)))))),
    f("sqrt", p("2", "g", "ell", s("1", n(COS)))),
    q(p("2", "g", f("sin", "beta")), "3"),
    p("m", "g", s(p("3", COS), n("2"))),
    s(p("m", "g", COS), p("m", "ell", w("omega", 2))),
    p(q("1", "2"), "m", w("ell", 2), w("omega", 2)),
    s(q(p("m", w("ell", 2)), "3"), p("M", w("ell", 2))),
    p("2", "pi", f("sqrt", q(s(p("m", w("ell", 2)), "I"), p("m", "g", "ell")))),
    q(p("g", s(f("sin", "beta"), n(p("mu", f("cos", "beta"))))), s("1", q("I", p("m", w("R", 2))))),
    q(p("m", "M", "g"), s("m", p("2", "M"))),
    p("mu", "m", "g", f("cos", "beta")),
    q("F", p("m", "R")),
    s(w("v", 2), p("2", "g", "h")),
    q(p("6", "m", "v"), p(s("m", p("3", "M")), "ell")),
    s(p("k", "x"), n(p("m", "g"))),
    f("sqrt", s(q("k", "m"), n(q("g", "ell")))),
    p("m", "g", "ell", s("1", n(COS))),
    q(p(s("m", n("M")), "g"), s("m", "M", q("I", w("R", 2)))),
    q(p("I", "omega"), s("I", p("m", w("R", 2)))),
    p("ell", s(p(SIN, f("sin", "beta")), p(COS, f("cos", "beta")))),
    q(p("m", w("v", 2)), p("2", "mu", "M", "g")),
    p("M", "R", q("omega", "2")),
    s(p(q("1", "2"), "k", w("x", 2)), p("m", "g", "h")),
    q(p("3", "m", w("omega", 2), "ell"), p("4", s("M", "m"))),
    p("R", f("tan", "beta")),
    n(q(p("k", "x"), s("m", q("I", w("R", 2))))),
)


# --- rewriting: each returns an equal expression, or None where it does not apply


def _shuffled(e: Expr, r: random.Random) -> Expr | None:
    if e[0] not in ("+", "*") or isinstance(e, str):
        return None
    parts = list(e[1:])
    r.shuffle(parts)
    return (e[0], *parts)


def _expanded(e: Expr, r: random.Random) -> Expr | None:
    if e[0] != "*":
        return None
    sums = [part for part in e[1:] if part[0] == "+"]
    if not sums:
        return None
    rest = [part for part in e[1:] if part is not sums[0]]
    return ("+", *(p(*rest, term) for term in sums[0][1:]))


def _split_fraction(e: Expr, r: random.Random) -> Expr | None:
    if e[0] == "/" and e[1][0] == "+":
        return ("+", *(q(term, e[2]) for term in e[1][1:]))
    return p(q("1", e[2]), e[1]) if e[0] == "/" else None


def _scaled_fraction(e: Expr, r: random.Random) -> Expr | None:
    factor = r.choice(["2", "3", "6", "m", "R"])
    return q(p(factor, e[1]), p(factor, e[2])) if e[0] == "/" else None


def _trig(e: Expr, r: random.Random) -> Expr | None:
    """Identities of sines and cosines."""
    if e[:2] == ("f", "sin"):
        return p("2", f("sin", q(e[2], "2")), f("cos", q(e[2], "2")))
    if e[:2] == ("f", "cos"):
        return s("1", n(p("2", w(f("sin", q(e[2], "2")), 2))))
    if e[:2] == ("f", "tan"):
        return q(f("sin", e[2]), f("cos", e[2]))
    return None


def _half_root(e: Expr, r: random.Random) -> Expr | None:
    return ("^", e[2], q("1", "2")) if e[:2] == ("f", "sqrt") else None


def _rooted(e: Expr, r: random.Random) -> Expr | None:
    """√(a/b) is √(ab)/b for b > 0, and √a is √(4a)/2."""
    return q(f("sqrt", p("4", e[2])), "2") if e[:2] == ("f", "sqrt") else None


def _square(e: Expr, r: random.Random) -> Expr | None:
    return p(e[1], e[1]) if e[0] == "^" and e[2] == "2" else None


def _added_nothing(e: Expr, r: random.Random) -> Expr | None:
    extra = r.choice(["m", "ell", COS])
    return s(e, extra, n(extra))


def _pythagoras(e: Expr, r: random.Random) -> Expr | None:
    return p(e, s(w(SIN, 2), w(COS, 2)))


def _double_minus(e: Expr, r: random.Random) -> Expr | None:
    return n(n(e)) if e[0] == "+" else p("-1", e[1]) if e[0] == "-" else None


REWRITES: tuple[Callable[[Expr, random.Random], Expr | None], ...] = (
    _shuffled, _expanded, _split_fraction, _scaled_fraction, _trig, _half_root, _rooted, _square, _added_nothing,
    _pythagoras, _double_minus,
)  # fmt: skip


# --- mutations: each returns an expression that should differ


def _sign(e: Expr, r: random.Random) -> Expr | None:
    if isinstance(e, tuple) and e[0] == "+":
        place = r.randrange(1, len(e))
        return (*e[:place], n(e[place]), *e[place + 1 :])
    return None


def _dropped(e: Expr, r: random.Random) -> Expr | None:
    if isinstance(e, tuple) and e[0] in "+*" and len(e) > 2:
        place = r.randrange(1, len(e))
        return (*e[:place], *e[place + 1 :])
    return None


def _swapped(e: Expr, r: random.Random) -> Expr | None:
    other = {"sin": "cos", "cos": "sin", "tan": "sin"}
    return f(other[e[1]], e[2]) if isinstance(e, tuple) and e[0] == "f" and e[1] in other else None


def _other_number(e: Expr, r: random.Random) -> Expr | None:
    return str(int(e) + r.choice([1, 2])) if isinstance(e, str) and e.isdigit() else None


def _other_name(e: Expr, r: random.Random) -> Expr | None:
    swaps = {"m": "M", "M": "m", "ell": "R", "R": "ell", "theta": "beta", "beta": "theta", "v": "omega"}
    return swaps.get(e) if isinstance(e, str) else None


def _other_power(e: Expr, r: random.Random) -> Expr | None:
    return ("^", e[1], "3") if isinstance(e, tuple) and e[0] == "^" else None


MUTATIONS = (_sign, _dropped, _swapped, _other_number, _other_name, _other_power)


def places(e: Expr, way: tuple[int, ...] = ()) -> Iterator[tuple[int, ...]]:
    """The places of all parts (exponents and names of functions left out)."""
    yield way
    if isinstance(e, tuple):
        last = len(e) - 1 if e[0] == "^" else len(e)
        for place in range(2 if e[0] == "f" else 1, last):
            yield from places(e[place], (*way, place))


def changed(e: Expr, way: tuple[int, ...], change: Callable[[Expr], Expr | None]) -> Expr | None:
    """The expression with the part at a place changed."""
    if not way:
        return change(e)
    inner = changed(e[way[0]], way[1:], change)
    return None if inner is None else (*e[: way[0]], inner, *e[way[0] + 1 :])


def once(e: Expr, rules: tuple, r: random.Random) -> Expr:
    """One of the rules applied at one place."""
    for _ in range(60):
        rule, way = r.choice(rules), r.choice(list(places(e)))
        found = changed(
            e, way, lambda part, rule=rule: rule(part, r) if isinstance(part, tuple) or rule in MUTATIONS else None
        )
        if found is not None:
            return found
    return e


# --- floating point


def number(e: Expr, at: dict[str, float]) -> float:
    """The value in floating point."""
    if isinstance(e, str):
        return math.pi if e == "pi" else at[e] if e in at else float(e)
    op, *parts = e
    if op == "f":
        return getattr(math, parts[0])(number(parts[1], at))
    values = [number(part, at) for part in parts]
    return {"+": sum, "*": math.prod, "-": lambda v: -v[0], "/": lambda v: v[0] / v[1], "^": lambda v: v[0] ** v[1]}[
        op
    ](values)


def gap(a: Expr, b: Expr, seed: int) -> float:
    """The greatest relative difference at random points that satisfy the signs; infinite where one has no value."""
    r, worst, seen = random.Random(seed), 0.0, 0
    for _ in range(40):
        at = {
            name: r.uniform(0.2, 1.4) * (1 if sign == "positive" else r.choice([1, -1])) for name, sign in SIGNS.items()
        }
        try:
            x, y = number(a, at), number(b, at)
        except (ValueError, ZeroDivisionError, OverflowError):
            continue
        if isinstance(x, complex) or isinstance(y, complex):
            continue
        seen += 1
        worst = max(worst, abs(x - y) / (abs(x) + abs(y) + 1e-12))
    return worst if seen >= 5 else math.inf


# --- typing


@dataclass(frozen=True)
class Dialect:
    """How someone types: the sign of products, letters, powers, quotients, roots."""

    times: str
    names: dict[str, str]
    power: Callable[[str, str], str]
    over: Callable[[str, str], str]
    call: Callable[[str, str], str]


GREEK = {"theta": "θ", "beta": "β", "omega": "ω", "mu": "μ", "pi": "π", "ell": "ℓ"}
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
DIALECTS = {
    "plain": Dialect("*", {}, lambda b, x: f"{b}^{x}", lambda a, b: f"{a}/{b}", lambda g, x: f"{g}({x})"),
    "python": Dialect(" * ", {}, lambda b, x: f"{b}**{x}", lambda a, b: f"{a} / {b}", lambda g, x: f"{g}({x})"),
    "spaces": Dialect(" ", {}, lambda b, x: f"{b}^{x}", lambda a, b: f"({a}/{b})", lambda g, x: f"{g}({x})"),
    "unicode": Dialect("·", GREEK, lambda b, x: b + x.translate(RAISED) if x.isdigit() else f"{b}^{x}",
                       lambda a, b: f"{a}/{b}", lambda g, x: ("√" if g == "sqrt" else g) + f"({x})"),
    "letters": Dialect(" ", {**GREEK, "ell": "l"}, lambda b, x: f"{b}^{x}", lambda a, b: f"(({a})/({b}))",
                       lambda g, x: f"{g}({x})"),
    "latex": Dialect(" ", {**{k: "\\" + k for k in GREEK}}, lambda b, x: f"{b}^{{{x}}}",
                     lambda a, b: rf"\frac{{{a}}}{{{b}}}",
                     lambda g, x: rf"\sqrt{{{x}}}" if g == "sqrt" else rf"\{g}\left({x}\right)"),
    "latex dots": Dialect(r" \cdot ", {**{k: "\\" + k for k in GREEK}}, lambda b, x: f"{b}^{{{x}}}",
                          lambda a, b: rf"\dfrac{{{a}}}{{{b}}}",
                          lambda g, x: rf"\sqrt{{{x}}}" if g == "sqrt" else rf"\{g}({x})"),
}  # fmt: skip
RANK = {"+": 1, "-": 1, "*": 2, "/": 2, "^": 3, "f": 4}


def typed(e: Expr, d: Dialect, within: int = 0) -> str:
    """The expression as it is typed in a dialect."""
    if isinstance(e, str):
        text = d.names.get(e, e)
        return f"({text})" if text.startswith("-") and within else text
    text = _typed(e, d)
    return f"({text})" if RANK[e[0]] < within or (within == 3 and e[0] == "f") else text


def _typed(e: tuple, d: Dialect) -> str:
    op, *parts = e
    is_latex = d.over("a", "b").startswith("\\")
    if op == "f":
        return d.call(parts[0], typed(parts[1], d))
    if op == "+":
        texts = [typed(part, d, 1) if part[0] != "-" else typed(part, d) for part in parts]
        return "+".join(texts).replace("+-", "-")
    if op == "-":
        return "-" + typed(parts[0], d, 2)
    if op == "*":
        return d.times.join(_factor(part, d) for part in parts)
    if op == "/":
        bounds = (0, 0) if is_latex else (2, 3)
        return d.over(typed(parts[0], d, bounds[0]), typed(parts[1], d, bounds[1]))
    return d.power(
        typed(parts[0], d, 4 if parts[0][0] != "f" or is_latex else 3), typed(parts[1], d, 4 if not is_latex else 0)
    )


def _factor(part: Expr, d: Dialect) -> str:
    text = typed(part, d, 2)
    needs = (part[0] == "/" and not d.over("a", "b").startswith(("\\", "("))) or (
        isinstance(part, str)
        and part[:1].isdigit()
        and "*" not in d.times
        and "·" not in d.times
        and "cdot" not in d.times
    )
    return f"({text})" if needs and not text.startswith("(") else text


@dataclass(frozen=True)
class Made:
    """An answer with its key and whether it is right."""

    key: str
    answer: str
    is_right: bool
    dialect: str


def made_answers(each: int = 20, seed: int = 1) -> list[Made]:
    """`each` right and as many wrong answers for every key."""
    found, seen = [], set()
    for place, key in enumerate(KEYS):
        r = random.Random(seed * 1000 + place)
        for rules, is_right in ((REWRITES, True), (MUTATIONS, False)):
            for _ in range(each):
                made = key
                for _ in range(r.choice([1, 1, 2, 3])):
                    made = once(made, REWRITES, r) if is_right or (rules is MUTATIONS and r.random() < 0.4) else made
                made = made if is_right else once(made, MUTATIONS, r)
                difference = gap(key, made, seed)
                if (is_right and difference > 1e-9) or (not is_right and not 1e-6 < difference < math.inf):
                    continue
                name = r.choice(list(DIALECTS))
                answer = Made(typed(key, DIALECTS["plain"]), typed(made, DIALECTS[name]), is_right, name)
                if answer not in seen:
                    found.append(answer)
                    seen.add(answer)
    return found

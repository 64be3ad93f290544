"""A first draft of the comments by which a text carries its claims.

The symbols of its displays are found, problems beside the text and those that ship are tried by proving displays, with
symbols of the text matched to their names and to what such letters usually mean; what is not proved is a guess, and marked
so that nothing takes it for said.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from itertools import islice, product
from pathlib import Path
from typing import Any

from rbpsym.claims.check import Checker
from rbpsym.claims.ground import glossary, name_of
from rbpsym.claims.integrals import with_dimensions
from rbpsym.claims.loader import is_claims
from rbpsym.claims.model import Claim, Meaning, Outcome, Setting
from rbpsym.claims.papers.check import printed
from rbpsym.claims.papers.walk import Formula, Paper
from rbpsym.claims.run import Worlds
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.latex.names import drawn_name
from rbpsym.expr.latex.reader import latex_ways
from rbpsym.expr.symbol_table import Drawn, SymbolTable
from rbpsym.frozen import Frozen, replace
from rbpsym.quantity.bound import parts
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_table

FEW, MOST_SECTIONS = 2, 40
_EMPTY = frozenset(["the", "and", "its", "for", "with", "from", "whose", "that", "this", "are", "has", "one", "two"])
_HEADING = re.compile(
    r"^(?:#{1,6} |=+ |\\(?:chapter|(?:sub)*section)\*?\s*[\[{])|^\S[^\n]*\n(?:={4,}|-{4,}|~{4,}|\^{4,}|\*{4,})[ \t]*$", re.M
)
MOST_PROBLEMS, MOST_FORMULAS, MOST_WAYS, MOST_TRIES = 6, 12, 24, 240
USUAL = {  # what a letter usually means; C is a coordinate, B a body
    "ω": ("speed of C", "frequency of C", "angular velocity of B"), "α": ("acceleration of C", "angular acceleration of B"),
    "v": ("speed of C", "magnitude of velocity of B.cm"), "a": ("acceleration of C",), "T": ("kinetic energy", "period of C"),
    "K": ("kinetic energy",), "V": ("potential energy", "magnitude of velocity of B.cm"), "U": ("potential energy",),
    "E": ("energy",), "I": ("moment of inertia of B about B.cm", "moment of inertia of B about O"),
    "L": ("Lagrangian", "angular momentum of B about B.cm", "angular momentum of B about O"),
}  # fmt: skip


class _Any(dict[Drawn, tuple[str, ...]]):
    """A table in which every drawn letter has a name; words in a sentence have none."""

    def get(self, drawn: Drawn, default: Any = ()) -> Any:
        unit = drawn in [Drawn(base, accent="hat") for base in "ijkıȷ"]
        return default if unit or drawn == Drawn("Δ") or re.search(r"[^\w']", drawn.base) else (name_of(drawn),)


ANY = SymbolTable(_Any(), varies=lambda name: True, open=True)


_Told = tuple[frozenset[str], frozenset[str]]


class Fit(Frozen):
    """A problem, the displays that hold in it, and what the symbols of the text mean there."""

    problem: str
    symbols: Mapping[str, str]
    formulas: tuple[Formula, ...]


def symbols_of(formula: Formula, paper: Paper) -> tuple[str, ...]:
    """The symbols of a display, as they are printed; () if it can't be read."""
    try:
        latex = printed(formula, paper).latex
        trees = latex_ways(latex, ANY, whole=True).trees
    except RbpsymError:
        return ()
    parts = (node for node in t.walk(_depending(trees[0])) if isinstance(node, (t.Sym, t.Vec)) and node.name != "pi")
    return tuple(dict.fromkeys(latex[slice(*node.span)].strip() for node in parts if node.span))


def _depending(node: t.Node) -> t.Node:
    """The formula without the names of which a name may be a function."""
    node = t.mapped(node, _depending)
    if not isinstance(node, t.Formal) or node.kind != "value":
        return node
    listed = node.parts[1].parts if isinstance(node.parts[1], t.Formal) and node.parts[1].kind == "list" else node.parts[1:]
    return node.parts[0] if all(isinstance(part, (t.Sym, t.Vec)) for part in listed) else node


def sections(paper: Paper) -> list[Paper]:
    """The parts of a text between its headings, each of which may be about its own problem; a short one goes with the next."""
    text, begin, found = paper.text.text, 0, []
    ends = [heading.start() for heading in _HEADING.finditer(text)] + [len(text)]
    for end in ends if len(ends) <= MOST_SECTIONS else ends[-1:]:
        part = replace(paper.text, text=" " * begin + text[begin:end])  # what stands in it keeps its place
        formulas = tuple(formula for formula in paper.formulas if begin <= formula.offset < end)
        one = replace(paper, text=part, formulas=formulas)
        if len(_shown(one)) >= FEW or end == len(text):
            found.append(one)
            begin = end
    return found


_BEFORE, _BEHIND = re.compile(r"[ \t>*+-]*(?:\d+[.)]\s*)?(?:\$|\\\()\s*"), re.compile(r"\s*(?:\$|\\\))[.,; \t]*(?:\n|\Z)")


def _shown(paper: Paper) -> list[Formula]:
    """The relations that are displayed, or stand alone in a line or an item of a list."""
    return [formula for formula in paper.formulas if formula.is_relation and (formula.displayed or _is_alone(formula, paper))]


def _is_alone(formula: Formula, paper: Paper) -> bool:
    text, end = paper.text.text, formula.offset + len(formula.latex)
    line = text.rfind("\n", 0, formula.offset) + 1
    return bool(_BEFORE.fullmatch(text, line, formula.offset) and _BEHIND.match(text, end))


def fits(paper: Paper, worlds: Worlds) -> list[Fit]:
    """The problems in which displays are proved, the one with most of them first. Bounded by the number of tries."""
    found = {formula: symbols_of(formula, paper) for formula in _shown(paper)}
    readable = {formula: symbols for formula, symbols in found.items() if 1 < len(symbols) < 9}
    tried = list(islice(readable.items(), MOST_FORMULAS))
    left, fitting = [MOST_TRIES], []
    for name in _likely(paper, {symbol for symbols in found.values() for symbol in symbols}, _told(worlds.folder)):
        one = _fit(name, tried, paper, worlds, left)
        fitting += [one] if one.formulas else []
    return sorted(fitting, key=lambda fit: -len(fit.formulas))


def _likely(paper: Paper, symbols: set[str], told: Mapping[str, _Told]) -> list[str]:
    """The names of the problems whose title and letters are most like those of the text, those of files beside it first."""
    words, letters = set(_words(paper.text.text)), {s.strip("\\ ") for s in symbols}

    def likeness(name: str) -> float:
        title, own = told[name]
        return 3 * len(title & words) / max(len(title), 1) + len(own & letters) / max(len(own), 1)

    return sorted(told, key=lambda name: (name in problem_files(), -likeness(name), name))[:MOST_PROBLEMS]


@lru_cache(maxsize=1)
def _told(folder: Path) -> Mapping[str, _Told]:
    """Of each problem beside a text, and each that ships, the words of its title and its letters, as its file stands."""
    tables = {path.stem: load_table(path).data for path in folder.glob("*.toml") if not is_claims(path)}
    tables = {name: table for name, table in tables.items() if "bodies" in table}
    tables |= {name: tomllib.loads(path.read_text("utf-8")) for name, path in problem_files().items()}
    letters = {name: {*table.get("parameters", ()), *table.get("coordinates", ())} for name, table in tables.items()}
    return {name: (frozenset(_words(f"{name} {_title(tables[name])}")), frozenset(own)) for name, own in letters.items()}


def _title(table: Mapping[str, Any]) -> str:
    title = table.get("title", "")
    return title if isinstance(title, str) else str(title.get("en", ""))


def _words(text: str) -> list[str]:
    """What a text speaks of."""
    return [word for word in re.findall(r"[a-z]{3,}", text.lower()) if word not in _EMPTY]


def _fit(name: str, tried: list[tuple[Formula, tuple[str, ...]]], paper: Paper, worlds: Worlds, left: list[int]) -> Fit:
    """What of the text holds in one problem; a symbol keeps the meaning with which a display was proved first."""
    known: dict[str, str] = {}
    held: list[Formula] = []
    world = worlds.problem(name)
    for formula, symbols in tried:
        for meanings in islice(product(*(_meanings(s, world, known) for s in symbols)), MOST_WAYS):
            left[0] -= 1
            several = len(set(meanings)) == len(symbols)
            if left[0] >= 0 and several and _holds(formula, dict(zip(symbols, meanings, strict=True)), name, paper, worlds):
                known |= dict(zip(symbols, meanings, strict=True))
                held.append(formula)
                break
    return Fit(name, known, tuple(held))


def _meanings(symbol: str, world: ProblemWorld, known: Mapping[str, str]) -> list[str]:
    """What a symbol may mean in a problem: its own name, what such a letter usually means, another name."""
    if symbol in known:
        return [known[symbol]]
    found = drawn_name(symbol)
    if found in (own := _own(world)):
        return [own[found]]
    patterns = USUAL.get(found[0].base, ()) if found else ()
    coordinates = world.study.system.independent or ("",)
    usual = [
        re.sub(r"\bC\b", coordinate, re.sub(r"\bB\b", body, pattern))
        for pattern in patterns for coordinate in coordinates for body in world.study.system.bodies
    ]  # fmt: skip
    return list(dict.fromkeys(usual)) or [q.name for q in world.study.problem.parameters]


def _own(world: ProblemWorld) -> dict[tuple[Drawn, bool] | None, str]:
    r"""What the problem's own symbols are called, by how they are drawn: \dot\theta and \dot{\theta} are one."""
    return {drawn_name(latex): name for latex, name in world.symbols.items()}


def _holds(formula: Formula, meanings: Mapping[str, str], name: str, paper: Paper, worlds: Worlds) -> bool:
    """Is the display proved, and does that tell something: of what is not nothing, in dimensions that fit?"""
    symbols = {symbol: Meaning(phrase) for symbol, phrase in meanings.items()}
    shown, world = printed(formula, paper), worlds.problem(name)
    claim = Claim("draft", Setting(name, problem=name, symbols=symbols), shown)
    try:
        if any(not any(parts(world.bound(phrase))) for phrase in meanings.values()):
            return False
        table = with_dimensions(glossary(symbols), claim.setting, world)
        trees = latex_ways(shown.latex, table, whole=True).trees
    except RbpsymError:
        return False
    fits = table.faults is None or not all(map(table.faults, trees))
    return fits and Checker(worlds, witnesses=False).check_safely(claim).outcome is Outcome.PROVED


def draft(paper: Paper, folder: Path) -> list[tuple[Formula, list[str]]]:
    """(the display before which they stand, what comments say) of each section; problems of one's own lie in `folder`."""
    worlds = Worlds(folder.resolve())
    return [told for part in sections(paper) for told in _of_section(part, worlds)]


def _of_section(paper: Paper, worlds: Worlds) -> list[tuple[Formula, list[str]]]:
    """Problem and symbols, claims, and guesses behind a “?”."""
    displays = _shown(paper)
    every = dict.fromkeys(symbol for formula in displays for symbol in symbols_of(formula, paper))
    best, *others = fits(paper, worlds) or [Fit("", {}, ())]
    if len(best.formulas) < min(max(FEW, len(displays) / 3), len(displays)):  # a few are true of too many problems
        best, others = Fit("", {}, ()), [best, *others]
    own = _own(worlds.problem(best.problem)) if best.problem else {}
    bound = best.symbols.items()
    head = [f": problem = {best.problem}"] if best.problem else ["? problem = NAME"]
    head += [f": {symbol} is the {phrase}" for symbol, phrase in bound if own.get(drawn_name(symbol)) != phrase]
    head += [f"? {fit.problem} fits too, {len(fit.formulas)} displays" for fit in others if fit.problem]
    drawn = {symbol: drawn_name(symbol) for symbol in every}
    rates = {symbol for symbol, found in drawn.items() if found and found[0].dots and _still(found) in drawn.values()}
    unknown = (symbol for symbol in every if symbol not in best.symbols and drawn[symbol] not in own and symbol not in rates)
    head += [f"? {symbol} is {_guess(symbol)}" for symbol in unknown]
    claims = ((formula, [": claim" if formula.displayed else ": claim inline"]) for formula in best.formulas)
    return [*((formula, head) for formula in displays[:1]), *claims]


def _still(drawn: tuple[Drawn, bool]) -> tuple[Drawn, bool]:
    """The symbol whose rate it is."""
    return replace(drawn[0], dots=0), drawn[1]


def _guess(symbol: str) -> str:
    """What a letter usually means, for one to change."""
    found = drawn_name(symbol)
    return f"the {' or '.join(USUAL.get(found[0].base if found else '', ('...',)))}"

"""The first section of the notes: what is given, in words, with the drawings and the table of symbols."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from rbpsym.derivation.step import Derivation
from rbpsym.document.figures.describe import describe, describe_free_body
from rbpsym.document.figures.free_body import free_body
from rbpsym.document.figures.schematic import schematic
from rbpsym.document.model import Block, FigureBlock, Inlines, Math, Paragraph, Section, Table, Text, words
from rbpsym.document.sketches import sketch_of
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.statement.model import Body, Element, PointRef, Problem


def statement_section(derivation: Derivation, said: Words, level: int) -> Section:
    """What the system is, how it starts, its drawing, free-body diagrams and symbols."""
    problem = derivation.study.problem
    text: list[Inlines] = [_bodies(problem, said)]
    text += [found for e in (*problem.constraints, *problem.interactions) if (found := _element(e, problem, said))]
    text += [_freedom(derivation, said), *_start(problem, said)]
    blocks: list[Block] = [Paragraph(_sentences(text)), *_figures(derivation, said), _symbols(problem, said),
                           Paragraph(said.say("statement.conventions"))]
    return Section(said.say("section.statement"), tuple(blocks), said.prefix + "section.statement", level)


def _sentences(parts: list[Inlines]) -> Inlines:
    """Sentences with a space between them."""
    found: list = []
    for part in parts:
        found += [Text(" ")] if found else []
        found += part
    return tuple(found)


def _bodies(problem: Problem, said: Words) -> Inlines:
    described = [said.say("statement.body", name=said.body(b.name), shape=_shape(b, said)) for b in problem.bodies]
    return said.say("statement", bodies=described, count=len(described))


def _shape(body: Body, said: Words) -> Inlines:
    if body.mass is None or not said.has(f"shape.{body.shape.kind}"):
        return said.say("shape.varying")
    return said.say(f"shape.{body.shape.kind}", mass=body.mass, **body.shape.sizes)


def _element(element: Element, problem: Problem, said: Words) -> Inlines:
    slots = SLOTS.get(element.kind, _other)(element, problem, said)
    key = slots.pop("key", f"statement.{element.kind}")
    return said.say(key, force=t.Vec(element.name), **slots)


def _name(ref: PointRef, said: Words) -> str:
    return said.body(ref.body) if ref.body else ref.label


def _pivot(element: Element, problem: Problem, said: Words) -> dict:
    return {"body": _name(element["point"], said)}


def _pair(element: Element, problem: Problem, said: Words) -> dict:
    first, second = element["points"]
    if second.body is None:
        first, second = second, first
    slots = {"first": _name(first, said), "second": _name(second, said)}
    if element.kind == "weld":
        slots |= {"couple": t.Sym(element["couple"])}
        return slots if first.body else slots | {"key": "statement.weld_ground"}
    return slots if first.body else {"key": "statement.pivot", "body": slots["second"]}


def _contact(element: Element, problem: Problem, said: Words) -> dict:
    line = element["line"]
    return {"body": _name(element["point"], said), "line": _equation(line)}


def _equation(line) -> t.Node:
    """The line as an equation, coefficients 0 and 1 left out."""
    return t.equation(t.add(t.mul(line.a, t.Sym("x")), t.mul(line.b, t.Sym("y"))), line.c)


def _ends(element: Element, said: Words) -> dict:
    first, second = element["between"]
    return {"first": _point(first, said), "second": _point(second, said)}


def _point(ref: PointRef, said: Words) -> Inlines:
    """A point in words: "the end of the rod", "the fixed point O"."""
    if ref.body is None:
        return said.say("point.fixed", point=t.Sym(ref.label) if ref.label.isidentifier() else ref.label)
    return said.say("point.of", point=str(ref.point).replace("_", " "), body=said.body(ref.body))


def _other(element: Element, problem: Problem, said: Words) -> dict:
    return {"key": "statement.other", "kind": element.kind}


SLOTS: Mapping[str, Callable[[Element, Problem, Words], dict]] = {
    "pivot": _pivot, "pin": _pair, "weld": _pair, "contact": _contact,
    "gravity": lambda e, p, w: {"g": e["g"]},
    "spring": lambda e, p, w: {"stiffness": e["stiffness"], "natural": e["natural_length"], **_ends(e, w)},
    "damper": lambda e, p, w: {"coefficient": e["coefficient"], **_ends(e, w)},
    "torsion-spring": lambda e, p, w: {"stiffness": e["stiffness"]},
    "rotary-damper": lambda e, p, w: {"coefficient": e["coefficient"]},
    "force": lambda e, p, w: {"point": _point(e["on"], w)},
    "couple": lambda e, p, w: {"couple": e["couple"], "body": w.body(e["on"])},
}


def _freedom(derivation: Derivation, said: Words) -> Inlines:
    names = [t.Sym(name) for name in derivation.study.system.independent]
    return said.say("statement.freedom", coordinates=names, count=len(names))


def _start(problem: Problem, said: Words) -> Iterator[Inlines]:
    places = [t.equation(t.Sym(c.name), c.start) for c in problem.coordinates if c.start is not None]
    speeds = [t.equation(t.Sym(f"{c.name}_dot"), c.speed) for c in problem.coordinates
              if c.speed is not None and c.speed != t.ZERO and c.start is not None]
    if places and speeds:
        yield said.say("statement.moving", place=places, speed=speeds)
    elif places:
        yield said.say("statement.rest", place=places)


def _figures(derivation: Derivation, said: Words) -> Iterator[Block]:
    sketch = sketch_of(derivation)
    notation = _notation(derivation)
    alt = describe(sketch, said.language, notation)
    yield FigureBlock((schematic(sketch),), said.say("caption.schematic"), alt, said.prefix + "figure.system")
    bodies = [body.name for body in sketch.bodies]
    alts = " ".join(describe_free_body(sketch, name, said.language, notation) for name in bodies)
    yield FigureBlock(tuple(free_body(sketch, name) for name in bodies), said.say("caption.free_bodies"), alts,
                      said.prefix + "figure.free")


def _notation(derivation: Derivation):
    from rbpsym.document.notes import notation_of

    return notation_of(derivation)


def _symbols(problem: Problem, said: Words) -> Table:
    quantities = [*problem.parameters, *(c.quantity for c in problem.coordinates)]
    rows = tuple(
        ((Math(t.Sym(q.name)),), words(said.meaning(q.name, q.meaning)), words(str(q.dimension)))
        for q in quantities if q.name not in problem.implicit
    )
    header = tuple(said.say(f"header.{key}") for key in ("symbol", "meaning", "dimension"))
    return Table(header, rows, said.say("caption.parameters"), "cll", said.prefix + "table.symbols")

"""The first section of the notes: what is given, in words, with the drawing, the symbols and the conventions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from rbpsym.chapters.endings import begun
from rbpsym.document.model import Block, Inlines, Math, Paragraph, Ref, Section, Table, Text, words
from rbpsym.document.needless import is_struck
from rbpsym.document.notes_figures import figure_label, figure_with_forces, is_drawn_beside, system_figure
from rbpsym.document.notes_sentences import element_sentences, sentences_of, touched
from rbpsym.document.places import growth
from rbpsym.document.words import Words, capital, sentences, small
from rbpsym.expr import tree as t
from rbpsym.pictures.pose import DrawnPose
from rbpsym.proof.grounds import Said
from rbpsym.proof.step import BodyRef, Derivation
from rbpsym.quantities import NUMBER, Quantity
from rbpsym.statement.model import Body, Coordinate, Element, Phase, PlacedShape, Problem
from rbpsym.statement.references import unused

REST = (None, t.ZERO)

# --- the table of symbols: parameters, coordinates, their rates and their values at the start


Row = tuple[Inlines, Inlines, Inlines]


def symbols_table(derivation: Derivation, said: Words) -> Table:
    """Symbol, meaning and dimension of all that the statement names."""
    problem = derivation.study.problem
    header = tuple(said.say(f"header.{key}") for key in ("symbol", "meaning", "dimension"))
    rows = [*_parameters(problem, said), *_coordinates(problem, said), *_starts(problem, said)]
    return Table(header, tuple(rows), said.say("caption.parameters"), "cll", said.prefix + "table.symbols")


def _parameters(problem: Problem, said: Words) -> Iterator[Row]:
    left_out = {*problem.implicit, *unused(problem)}
    for quantity in problem.parameters:
        if quantity.name not in left_out:
            yield _row(t.Sym(quantity.name), quantity, dimension_words(quantity, said), said)


def _row(letter: t.Node, quantity: Quantity, dimension: Inlines, said: Words) -> Row:
    return (Math(letter),), words(said.meaning(quantity.name, quantity.meaning)), dimension


def _coordinates(problem: Problem, said: Words) -> Iterator[Row]:
    """Each coordinate, and its rates where the notation has letters of their own for them."""
    for coordinate in problem.coordinates:
        quantity, letter = coordinate.quantity, t.Sym(coordinate.name)
        angle = quantity.dimension == NUMBER
        yield _row(letter, quantity, said.say("dimension.angle") if angle else dimension_words(quantity, said), said)
        rates = [f"{coordinate.name}_{dots}" for dots in ("dot", "ddot")]
        own = [t.Sym(rate) for rate in rates if rate in problem.notation]
        if own and rates[0] in problem.notation:
            yield said.say("plain", text=own), said.say("symbols.rates", coordinate=letter, count=len(own)), ()


def _starts(problem: Problem, said: Words) -> Iterator[Row]:
    """The constants at which the coordinates and speeds start."""
    for coordinate in problem.coordinates:
        pairs = ((coordinate.start, coordinate.name), (coordinate.speed, f"{coordinate.name}_dot"))
        found = [(start, t.Sym(of)) for start, of in pairs if isinstance(start, t.Sym) and start.name in problem.implicit]
        if found:
            letters = said.say("plain", text=[start for start, _ in found])
            yield letters, said.say("symbols.start", of=[of for _, of in found], count=len(found)), ()


def dimension_words(quantity: Quantity, said: Words) -> Inlines:
    """The dimension by name, in the language of the notes."""
    key = f"dimension.{str(quantity.dimension).replace(' ', '_')}"
    return said.say(key) if said.has(key) else words(str(quantity.dimension))


# ---


def statement_section(derivation: Derivation, said: Words, level: int, asked: Iterable[Block] = ()) -> Section:
    """What the system is, how it starts, what is asked, its drawing, its symbols and the conventions."""
    problem, pose = derivation.study.problem, DrawnPose(derivation.study)
    ground = Said(derivation.study)
    text = [_bodies(problem, said, ground), *element_sentences(pose, said)]
    motion = [_freedom(derivation, said), *_start(problem, said, ground), *_phases(pose, said)]
    symbols = symbols_table(derivation, said)
    figure = figure_with_forces if is_drawn_beside(derivation, said) else system_figure
    blocks: list[Block] = [
        Paragraph(sentences(text)),
        Paragraph(sentences([*motion, *(() if said.is_full else _letters(symbols, (*text, *motion), said))])),
        *asked,
        figure(derivation, said),
        *((symbols,) if said.is_full else ()),
        Paragraph(sentences(list(_conventions(pose, said)))),
    ]
    return Section(said.say("section.statement"), tuple(blocks), said.prefix + "section.statement", level)


def _letters(symbols: Table, told: tuple[Inlines, ...], said: Words) -> Iterator[Inlines]:
    """What the letters of a table mean that the sentences told so far do not speak of: one that only stands in the equation of a
    place is not told by it."""
    nodes = [part.node for inlines in told for part in inlines if isinstance(part, Math)]
    alone = {name for node in nodes if not isinstance(node, t.Chain) for name in t.names(node)}
    moving = {*alone, *(f"{name}_dot" for name in alone)}
    known = alone.union(*(t.names(node) for node in nodes if isinstance(node, t.Chain) and t.names(node.items[0]) & moving))
    new = [
        (*letters, Text(" ("), *meaning, Text(")")) if any(part != Text("") for part in meaning) else letters
        for letters, meaning, _ in symbols.rows
        if known.isdisjoint(name for part in letters if isinstance(part, Math) for name in t.names(part.node))
    ]
    if new:
        yield said.say("statement.letters", letters=new)


def _bodies(problem: Problem, said: Words, ground: Said) -> Inlines:
    """ "A thin uniform rod of mass m and length ℓ moves in a vertical plane."""
    described = [_described(body, said) for body in problem.bodies]
    return capital(said.say("statement.vertical", ground=ground, bodies=described, count=len(described)))


def _described(body: Body, said: Words) -> Inlines:
    """The shape with its sizes; the body's name where the shape does not say it already."""
    shape, name = _shape(body, said), said.body(body.name)
    spoken = "".join(part.text for part in shape if isinstance(part, Text))
    return shape if name in spoken.split() else said.say("statement.named", body=said.stressed(body.name), shape=shape)


def _shape(body: Body, said: Words) -> Inlines:
    if body.mass is None or not said.has(f"shape.{body.shape.kind}"):
        return said.say("shape.varying")
    known = said.problem is None or t.names(body.mass).isdisjoint(said.problem.unstated)
    weight: dict[str, Any] = {"mass": body.mass} if known else {}
    parts = [_part(part, said) for part in body.shape.parts if not part.removed]
    holes = [_part(part, said) for part in body.shape.parts if part.removed]
    if parts and all(said.has(f"part.{part.shape.kind}") for part in body.shape.parts):
        return said.say("shape.cut" if holes else "shape.made", parts=parts, holes=holes, **weight)
    kind = body.shape.called if said.has(f"shape.{body.shape.called}") else body.shape.kind
    sizes: dict[str, Any] = {key: size for key, size in body.shape.sizes.items() if known or key != "moment"}
    kind = "square" if kind == "rectangle" and sizes["width"] == sizes["height"] else kind
    return said.say(f"part.{kind}" if not known and said.has(f"part.{kind}") else f"shape.{kind}", **weight, **sizes)


def _part(part: PlacedShape, said: Words) -> Inlines:
    """A part of a composite by its shape and sizes."""
    key = f"part.{part.shape.kind}"
    sizes: dict[str, Any] = dict(part.shape.sizes)
    found = said.say(key, **sizes) if said.has(key) else ()
    return found if part.count is None else said.say("shape.repeated", often=part.count, part=found)


def _freedom(derivation: Derivation, said: Words) -> Inlines:
    """How many degrees of freedom there are, and what describes them."""
    study = derivation.study
    names = set(study.system.independent)
    own = [c for c in study.problem.coordinates if c.name in names]
    described = [_coordinate(c, said, len(own)) for c in own]
    if study.problem.is_at_rest:
        return said.say("statement.spread")
    if not own:
        return said.say("statement.driven" if study.system.has_clock else "statement.still", ground=Said(study))
    key = f"number.{len(own)}"
    number = said.say(key) if said.has(key) else len(own)
    if derivation.study.at_start and study.ties:
        return said.say("statement.tied", coordinates=described)
    return said.say("statement.freedom", coordinates=described, number=number, count=len(own))


def _coordinate(coordinate: Coordinate, said: Words, count: int) -> Inlines:
    meaning = said.meaning(coordinate.name, coordinate.quantity.meaning)
    letter = t.Sym(coordinate.name)
    if not meaning:
        return said.say("statement.letter", letter=letter)
    return said.say("statement.coordinate", letter=letter, meaning=meaning, count=count)


def _start(problem: Problem, said: Words, ground: Said) -> Iterator[Inlines]:
    """Where it starts, and how fast."""
    begun = [c for c in problem.coordinates if c.start is not None]
    places = [t.equation(t.Sym(c.name), c.start) for c in begun if c.start is not None]
    free = ground.study.system.independent if ground.study else ()  # others' speeds are told where they are stated (and agree)
    speeds = [t.equation(t.Sym(f"{c.name}_dot"), c.speed or t.ZERO) for c in begun if c.name in free or c.speed not in REST]
    is_moving = any(c.speed not in REST for c in begun)
    beside = said.say("statement.with", speed=speeds) if speeds else ()
    if places:
        key = "statement.moving" if is_moving else "statement.rest"
        yield said.say(key, ground=ground, place=places, speed=speeds, beside=beside)
    kept = [t.equation(t.Sym(f"{c.name}_dot"), c.speed or t.ZERO) for c in problem.kept]
    given = [t.equation(t.Sym(f"{c.name}_ddot"), c.acceleration) for c in problem.coordinates if c.acceleration is not None]
    if problem.unstated and given:
        yield said.say("statement.led", rates=given)
    if kept:
        yield said.say("statement.kept", rates=kept, coordinates=[t.Sym(c.name) for c in problem.kept])


def _phases(pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """That there are further phases, and what is stated of each."""
    names = [said.say("statement.phase", name=said.named(phase.name)) for phase in pose.study.problem.phases]
    if names and not is_struck(pose.study):
        yield said.say("statement.phases", names=names, count=len(names))
    yield from phase_sentences(pose, said)


def _conventions(pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """The axes, the positive sense, and which way each coordinate grows."""
    yield said.say("statement.conventions", figure=Ref(figure_label(said)))
    found: dict[tuple[str, str], list[t.Node]] = {}
    for coordinate in pose.study.problem.coordinates:
        way, body = growth(coordinate.name, pose)
        if way:
            found.setdefault((way, body if way == "against" else ""), []).append(t.Sym(coordinate.name))
    for (way, body), letters in found.items():
        slots: dict[str, Any] = {"body": BodyRef(body)} if body else {}
        yield said.say(f"growth.{way}", coordinates=letters, count=len(letters), **slots)


# --- what the statement says of later phases: what begins each, what strikes then, what holds from then on, and what no more


def phase_sentences(pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """What is stated of each later phase, as sentences."""
    before = pose.study.problem
    for phase in before.phases:
        yield _begins(phase, before, pose, said)
        for element in phase.impulses:
            yield from sentences_of(element, pose, said)
        yield from _changes(phase.problem, before, pose, said)
        before = phase.problem


def _begins(phase: Phase, before: Problem, pose: DrawnPose, said: Words) -> Inlines:
    """At which event."""
    subject = next((e for e in (phase.gap, *before.constraints) if e is not None and e.name == phase.subject), None)
    slots: dict[str, Any] = {} if subject is None else touched(subject, pose, said)
    if phase.subject:
        slots |= {"force": _letter(subject) if subject else (), "coordinate": t.Sym(phase.subject)}
    name = said.say("statement.phase", name=said.named(phase.name))
    return said.say(f"statement.event.{begun(phase).replace(' ', '_')}", phase=name, value=phase.value, **slots)


def _changes(problem: Problem, before: Problem, pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    """What is new since the phase before, and what has gone."""
    new, old = ([*each.constraints, *each.interactions] for each in (problem, before))
    known, kept = [_stated(e) for e in old], {e.name for e in new}
    told = [sentence for e in new if _stated(e) not in known for sentence in sentences_of(e, pose, said)]
    if gone := [_letter(e) for e in old if e.name not in kept]:
        told.append(said.say("statement.gone", letters=gone, count=len(gone)))
    if told:
        yield said.say("statement.from_then", sentence=small(told[0]))
        yield from told[1:]


def _stated(element: Element) -> Element:
    """The element but for the sense of a slip, which is that of the motion."""
    return element.with_values(slip=None, side=None)


def _letter(element: Element) -> t.Node:
    return (t.Sym if element.kind in ("string", "link") else t.Vec)(element.name)

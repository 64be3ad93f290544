"""The table of roads: which lines each takes, and which unknown forces drop out of them."""

from __future__ import annotations

from collections.abc import Sequence

from rbpsym.chapters.methods.roads import Road
from rbpsym.document.model import Inlines, Math, Table, Text
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.proof.step import BodyRef, PhraseRef


def roads_table(roads: Sequence[Road], said: Words) -> Table:
    """Road, lines, unknown forces that drop out, unknown forces that stay; the road of the notes is marked."""
    header = tuple(said.say(f"roads.{key}") for key in ("road", "lines", "drop", "stay"))
    rows = tuple((_road(road, said), (Text(str(road.lines)),), _names(road.drop), _names(road.stay)) for road in roads)
    return Table(header, rows, said.say("roads.caption"), "pcll", said.prefix + "table.roads")


def _names(names: Sequence[str]) -> Inlines:
    parts = [part for name in names for part in (Text(", "), Math(t.Sym(name)))]
    return tuple(parts[1:]) or (Text("–"),)


def _road(road: Road, said: Words) -> Inlines:
    mark = (Text("→ "),) if road.is_taken else ()
    if road.first is None:
        return said.say(f"roads.{road.kind}")
    bodies = [BodyRef(name) for name in road.first.bodies]
    told = PhraseRef("bodies", {"bodies": bodies, "count": len(bodies)})
    return (*mark, *said.say(f"roads.{road.kind}", label=_label(road, said), bodies=told))


def _label(road: Road, said: Words) -> Inlines:
    """A fixed point or an axis by its letter, what meets at a crossing by the forces, other points as the file names them."""
    label = road.first.label if road.first else ""
    if road.kind == "crossing":
        return _names(label.split(", "))
    if road.kind == "fixed" or label in ("x", "y"):
        return (Math(t.Sym(label)),)
    return said.label(label)

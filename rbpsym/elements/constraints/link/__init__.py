"""A light rigid rod: read as a straight string that may push as well."""

from dataclasses import replace

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import string_path
from rbpsym.statement.rules import Bodies, Element, Scope


def _as_string(element: Element, scope: Scope, bodies: Bodies) -> Element:
    ends = element["points"]
    if len(ends) != 2 or any(turn.sense for turn in ends):
        raise element.error("must join two points", 'write points = ["O", "bob.center"].')
    values = {"path": ends, "length": element["length"], "rigid": True}
    string_path(replace(element, values=values), scope, bodies)
    return replace(element, kind="string", values=values)


KIND = element(
    __name__,
    "a light rigid rod between two points: it keeps their distance, and pulls or pushes",
    "light-rod",
    rules=(_as_string,),
    points="path: the two points that it joins",
    length="length, positive, of time, optional: its length, which may change with the time t (a telescope); absent: as at "
    "the start",
)

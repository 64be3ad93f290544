"""A string, taut between its ends."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import string_path
from rbpsym.statement.model import Element, Problem
from rbpsym.statement.paths import tensions


def _told(element: Element, problem: Problem) -> str:
    first, *_, last = path = element["path"]
    if element.values.get("rigid"):
        return "_link"
    if len(tensions(element)) > 1:
        return "_turning"
    over, wound = "_over" * (len(path) > 2), "_wound" * any(turn.sense for turn in (first, last))
    return f"{over}{wound}" or "_straight"


KIND = element(
    __name__,
    "a massless inextensible string, taut between its ends and round pulleys and drums; it pulls",
    "rope",
    rules=(string_path,),
    holds="tension",
    told=_told,
    path="path: what it joins, from end to end: points (to one of a body on its way it is tied), and round bodies with the "
    "sense in which it runs round them, going along the path: “cw pulley”, “ccw drum”; on an axle of another radius than the "
    "body's "
    '`{ around = "yoyo", radius = "r", sense = "ccw" }`, round a smooth fixed pulley '
    '`{ around = "Q", radius = "R", sense = "cw" }`, over a smooth peg `{ around = "Q" }`',
    length="length, positive, of time, optional: length between two points, which may change with the time t (a winch): "
    "“L - u*t”; absent: as at the start",
)

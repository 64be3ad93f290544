"""The signs of mechanical drawings: springs, hatching, supports, dimensions, senses of rotation."""

from __future__ import annotations

import math

from rbpsym.pictures.figures import scene as s

Items = tuple[s.Item, ...]


def between(start: s.Point, end: s.Point, share: float, aside: float = 0.0) -> s.Point:
    """The point at a share of the way, moved aside to the left."""
    (x, y), (u, v) = start, end
    length = math.hypot(u - x, v - y) or 1.0
    left = (-(v - y) / length, (u - x) / length)
    return x + share * (u - x) + aside * left[0], y + share * (v - y) + aside * left[1]


def spring(start: s.Point, end: s.Point) -> Items:
    """A zigzag with straight ends."""
    length = math.dist(start, end)
    turns = max(4, min(12, round(length / 0.22)))
    lead = min(0.25, 0.15 * length) / (length or 1.0)
    inner = [
        between(start, end, lead + (1 - 2 * lead) * (n + 0.5) / (2 * turns), 0.13 * (-1) ** n) for n in range(2 * turns)
    ]
    ends = between(start, end, lead), between(start, end, 1 - lead)
    return (s.Polyline((start, ends[0], *inner, ends[1], end), "spring"),)


def damper(start: s.Point, end: s.Point) -> Items:
    """A piston in a pot."""
    a, b = 0.42, 0.62

    def at(share: float, aside: float = 0.0) -> s.Point:
        return between(start, end, share, aside)

    return (
        s.Polyline((start, at(a)), "spring"),
        s.Polyline((at(b, 0.16), at(a, 0.16), at(a, -0.16), at(b, -0.16)), "spring"),
        s.Polyline((at(0.54, 0.11), at(0.54, -0.11)), "spring"),
        s.Polyline((at(0.54), end), "spring"),
    )


def string(start: s.Point, end: s.Point) -> Items:
    """A thin line."""
    return (s.Polyline((start, end), "line"),)


LINKS = {"spring": spring, "damper": damper, "string": string}


def coil(at: s.Point) -> Items:
    """The spiral of a torsion spring."""
    turns = [n * math.pi / 8 for n in range(37)]
    return (s.Polyline(tuple(s.polar(at, 0.1 + 0.018 * turn, turn) for turn in turns), "spring"),)


def hatching(start: s.Point, end: s.Point, depth: float = 0.22) -> Items:
    """A solid edge: the line, and short strokes on its right-hand side."""
    length = math.dist(start, end)
    count = max(2, round(length / 0.2))
    strokes = tuple(
        (between(start, end, n / count), between(start, end, (n - 0.8) / count, -depth)) for n in range(1, count + 1)
    )
    return s.Strokes(strokes), s.Polyline((start, end), "line")


def support(at: s.Point, away: float) -> Items:
    """A pivot's bracket: a triangle on a hatched edge that lies in the direction `away`."""
    foot = s.polar(at, 0.42, away)
    left, right = s.polar(foot, 0.27, away - math.pi / 2), s.polar(foot, 0.27, away + math.pi / 2)
    out, far = s.polar(foot, 0.45, away - math.pi / 2), s.polar(foot, 0.45, away + math.pi / 2)
    return (s.Polyline((at, left, right), "support", closed=True), *hatching(out, far, 0.18))


def clamp(at: s.Point, away: float) -> Items:
    """A weld to the ground: a hatched edge through the point."""
    out, far = s.polar(at, 0.5, away - math.pi / 2), s.polar(at, 0.5, away + math.pi / 2)
    return hatching(far, out)


def anchor(at: s.Point, away: float) -> Items:
    """A fixed end: a short hatched edge across the direction in which the ground lies."""
    out, far = s.polar(at, 0.3, away - math.pi / 2), s.polar(at, 0.3, away + math.pi / 2)
    return (*hatching(out, far, 0.18), *dot(at))


def edge(at: s.Point, below: float) -> Items:
    """A corner on which something lies."""
    left, right = s.polar(at, 0.5, below - 0.45), s.polar(at, 0.5, below + 0.45)
    return (s.Polyline((left, at, right), "ground"),)


def bore(center: s.Point, radius: float) -> Items:
    """A round hole in solid ground: short strokes outside."""
    return s.Strokes(rim_strokes(center, radius, 0.0, math.tau)), s.Circle(center, radius, "rim")


def bowl(center: s.Point, radius: float) -> Items:
    """The lower half of a round hollow."""
    return s.Strokes(rim_strokes(center, radius, math.pi, math.tau)), s.Arc(center, radius, math.pi, math.tau, "line")


def rim_strokes(center: s.Point, radius: float, start: float, end: float) -> tuple[tuple[s.Point, s.Point], ...]:
    """Hatching outside an arc."""
    count = max(12, round((end - start) * radius / 0.2))
    turns = [start + (n + 0.5) * (end - start) / count for n in range(count)]
    lean = 0.12 / (1 + radius)
    return tuple((s.polar(center, radius, turn), s.polar(center, radius + 0.17, turn + lean)) for turn in turns)


def joint(at: s.Point) -> Items:
    """A pin."""
    return (s.Circle(at, 0.08, "joint"),)


def dot(at: s.Point) -> Items:
    """A marked point."""
    return (s.Circle(at, 0.05, "dot"),)


def dimension(start: s.Point, end: s.Point, aside: float) -> Items:
    """A line with two heads beside the length it measures, and thin lines that lead to it."""
    a, b = between(start, end, 0, aside), between(start, end, 1, aside)
    reach = aside + math.copysign(0.1, aside)
    leads = tuple(
        s.Polyline((between(start, end, n, 0.3 * aside), between(start, end, n, reach)), "dimension") for n in (0, 1)
    )
    return (*leads, s.Polyline((a, b), "dimension", heads="both"))


def angle_arc(at: s.Point, start: float, end: float, radius: float) -> Items:
    """A dashed line to count from, and an arc with a head."""
    reference = s.Polyline((at, s.polar(at, 1.35 * radius, start)), "guide")
    return reference, s.Arc(at, radius, start, end, "angle", heads="end")


def turning(at: s.Point, sign: int = 1, radius: float = 0.4, style: str = "axis") -> s.Arc:
    """Three quarters of a turn with a head: counter-clockwise for +1."""
    start = -math.pi / 4 if sign > 0 else math.pi + math.pi / 4
    return s.Arc(at, radius, start, start + sign * 1.5 * math.pi, style, heads="end")


def arrow(start: s.Point, end: s.Point, style: str = "force") -> s.Polyline:
    """An arrow."""
    return s.Polyline((start, end), style, heads="end")


def away_from(at: s.Point, others: list[s.Point]) -> float:
    """The direction, along an axis, that leads away from the middle of some points."""
    if not others:
        return -math.pi / 2
    middle = tuple(sum(values) / len(others) for values in zip(*others, strict=True))
    right = math.pi / 2
    return round(s.direction(middle, at) / right) * right if math.dist(middle, at) > 1e-9 else -right

"""What is kept until a slip has gone: the angular momentum about a point through which friction acts, and what it gives."""

from __future__ import annotations

from rbpsym.algebra import Scalar, substitute, symbol
from rbpsym.derivation.chapters.ending import Ending, speed_name
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import BodyRef, PhraseRef, Step
from rbpsym.mechanics.kept import Kept, until_no_slip
from rbpsym.mechanics.state import at_start
from rbpsym.mechanics.system import Force
from rbpsym.notation import tree as t


def write(draft: Draft, ending: Ending, slip: Scalar) -> list[Step]:
    """The steps; none where what is kept does not give the speeds at the end."""
    found = until_no_slip(draft.study, slip, ending.state)
    for name in draft.study.system.independent if found else ():
        draft.context.scalars[speed_name(draft, name, ending.number)] = ending.state.speeds[name]
    return [_step(draft, ending, kept, slip) for kept in found]


def _step(draft: Draft, ending: Ending, kept: Kept, slip: Scalar) -> Step:
    letters = draft.study.letters
    point = t.Sym(kept.label or letters.free("C", taken=letters.things))
    bodies = [BodyRef(name) for name in kept.bodies]
    return draft.add(
        f"kept.{kept.label or 'there'}.{'.'.join(kept.bodies)}",
        "kept_until",
        t.system([_unchanged(draft, ending, kept.value), t.equation(draft.show(_then(draft, ending, slip)), t.ZERO)]),
        f"phases.until.{'named' if kept.label else 'there'}",
        bodies=PhraseRef("bodies", {"bodies": bodies, "count": len(bodies)}),
        point=point,
        place=draft.show_vector(kept.where),
        silent=_those("phases.quiet", kept.silent, point),
        cancel=_those("phases.cancel", kept.cancel, point),
        data={"kept": kept, "ending": ending},
    )


def _those(key: str, forces: tuple[Force, ...], point: t.Node) -> PhraseRef:
    names = [t.Vec(name) for name in dict.fromkeys(force.name for force in forces)]
    return PhraseRef(key if names else "torque.none", {"forces": names, "count": len(names), "point": point})


def _unchanged(draft: Draft, ending: Ending, value: Scalar) -> t.Node:
    """L at the end = L at the start, positive where both are negative."""
    value = -value if isinstance(draft.show(value), t.Neg) else value
    begun = {f"{name}_dot": speed for name, speed in at_start(draft.study).speeds.items()}
    return t.equation(draft.show(_then(draft, ending, value)), draft.show(substitute(value, begun)))


def _then(draft: Draft, ending: Ending, value: Scalar) -> Scalar:
    """A value at the end, its speeds as letters."""
    names = draft.study.system.independent
    images = {f"{name}_dot": symbol(speed_name(draft, name, ending.number)) for name in names}
    return substitute(substitute(value, images), ending.state.places)

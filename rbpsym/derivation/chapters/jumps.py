"""What a blow leaves as it is: one equation for each momentum that no unknown impulse changes."""

from __future__ import annotations

from rbpsym.derivation.chapters.blow import Blow, minus, new_value, old_value
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import BodyRef, PhraseRef, Step
from rbpsym.mechanics.jumps import Jump, road
from rbpsym.notation import tree as t


def write(draft: Draft, blow: Blow) -> list[Step]:
    """The equations that give the speeds just after; none where those of the single bodies are as few."""
    return [_step(draft, blow, jump) for jump in road(blow.moment, blow.phase.impulses)]


def _step(draft: Draft, blow: Blow, jump: Jump) -> Step:
    kind = "torque" if jump.is_turning else "force"
    letters, silent = draft.study.letters, _unknown(jump)
    names = [t.Vec(name) for name in silent]
    point = t.Sym(jump.label or letters.free("C", taken=letters.things))
    axis = {"x": t.Unit("x"), "y": t.Unit("y")}.get(jump.label, draft.show_vector(jump.where))
    bodies = [BodyRef(name) for name in jump.bodies]
    where = ("named" if jump.label else "there") if jump.is_turning else "along"
    reason = {"forces": names, "count": len(names), "point": point, "axis": axis}
    return draft.add(
        f"jump.{kind}.{jump.label or 'there'}.{'.'.join(jump.bodies)}",
        "jump",
        _statement(draft, blow, jump),
        f"phases.{'grown' if jump.given else 'kept'}.{where}",
        premises=draft.those("state.speed", "state.place", *(f"law.blow.{body}" for body in jump.bodies)),
        bodies=PhraseRef("bodies", {"bodies": bodies, "count": len(bodies)}),
        point=point,
        place=draft.show_vector(jump.where),
        axis=axis,
        silent=PhraseRef(f"phases.silent.{kind if names else 'inner'}", reason),
        data={"jump": jump, "blow": blow},
    )


def _unknown(jump: Jump) -> list[str]:
    """The unknown impulses that drop out, once each."""
    return list(dict.fromkeys(force.name for force in jump.silent))


def _statement(draft: Draft, blow: Blow, jump: Jump) -> t.Node:
    """after = before, or after - before = what is given; turned round where both sides are negative."""
    after, given = (new_value(draft, blow, value) for value in (jump.after, jump.given))
    before = old_value(draft, blow, jump.before)
    if isinstance(draft.show(after), t.Neg):
        after, before, given = -after, -before, -given
    shown = [draft.show(value) for value in (after, before, given)]
    if not given:
        return t.equation(*shown[:2])
    return t.equation(t.add(shown[0], *([minus(shown[1])] if before else [])), shown[2])

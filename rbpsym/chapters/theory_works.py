"""Works in the theory: of the net force and torque, about a fixed axis, of single forces; and potential energy."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.chapters.theory_ground import OMEGA, POWERS, VECTORS, F, TheoryContext, V, plane_vector, s
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Space, cartesian, symbol

if TYPE_CHECKING:
    from rbpsym.chapters.theory import TheoryWriter


KINDS = ("T", "theta")


def potential_energy(w: TheoryWriter) -> None:
    """W_T + W_θ = W_nc − ΔE_p, whatever part of each work the conservative forces do."""
    given = {f"cal_W_{kind}_c": symbol(f"P_{kind}_c") for kind in KINDS}
    rest = {f"cal_W_{kind}_nc": POWERS[f"cal_W_{kind}"] - given[f"cal_W_{kind}_c"] for kind in KINDS}
    lost, left = (sum(works.values(), NOTHING) for works in (given, rest))
    works = {**w.context.works, **given, **rest, "cal_W_c": lost, "cal_W_nc": left}
    rates = {**w.context.rates, "U": -lost}  # what potential energy is: it falls as these forces work
    w.context = replace(w.context, works=works, rates=rates, scalars={**w.context.scalars, "E_p": symbol("U")})
    change = t.Neg(t.Delta(t.Sym("E_p")))
    conservative = t.Add(tuple(t.Sym(f"cal_W_{kind}_c") for kind in KINDS))
    others = t.Add((t.Sym("cal_W_nc"), change))
    every = t.Add(tuple(t.Sym(f"cal_W_{kind}_{part}") for kind in KINDS for part in ("c", "nc")))
    both = t.Add(tuple(t.Sym(f"cal_W_{kind}") for kind in KINDS))
    rule, falls = "theory_rates", t.equation(conservative, change)
    w.add("potential", t.equation(t.Sym("cal_W_c"), conservative, change), rule, ["work_energy"], where=falls)
    w.add("split_works", t.equation(every, others), rule, ["potential"], where=_parts())
    w.add("works_and_potential", t.equation(both, others), rule, ["split_works"], is_result=True)
    _conserved(w)


def _parts() -> t.Relations:
    """Each work is that of the conservative forces and that of all others."""
    parts = [tuple(t.Sym(f"cal_W_{kind}{end}") for end in ("", "_c", "_nc")) for kind in KINDS]
    whole = t.equation(t.Sym("cal_W_nc"), t.Add(tuple(rest for *_, rest in parts)))
    return t.Relations((*(t.equation(both, t.Add((own, rest))) for both, own, rest in parts), whole))


def _conserved(w: TheoryWriter) -> None:
    """Where E_K + E_p stays constant, the works of all other forces add up to nothing."""
    before = dict(w.context.works)
    left = before["cal_W_T"] + before["cal_W_theta"] - before["cal_W_T_c"]
    works = {**before, "cal_W_theta_c": left, "cal_W_theta_nc": before["cal_W_theta"] - left}
    rates = {**w.context.rates, "U": -(before["cal_W_T_c"] + left)}
    others = t.Add(tuple(t.Sym(f"cal_W_{kind}_nc") for kind in KINDS))
    energy = t.Delta(t.Group(t.Add((t.Sym("E_K"), t.Sym("E_p")))))
    w.add("energy_change", t.equation(energy, others), "theory_rates", ["work_energy", "works_and_potential", "split_works"])
    context = replace(w.context, works=works, rates=rates)
    statement = t.equation(others, energy, t.ZERO)
    w.add("conserved", statement, "theory_rates", ["energy_change"], context=context, where=t.equation(energy, t.ZERO))


HALVES = t.Add((t.Sym("cal_W_T"), t.Sym("cal_W_theta")))


def kinetic(mass: str, speed: t.Node) -> t.Node:
    """½ M V² or ½ I ω²."""
    return t.mul(t.Div(t.ONE, t.TWO), t.Sym(mass), t.Pow(speed, t.TWO))


def works(w: TheoryWriter) -> None:
    """The work–energy theorem in its two halves and as a whole."""
    along = t.PathIntegral(t.Vec("F_net"), t.Vec("R_cm"))
    turn = t.PathIntegral(t.Sym("tau_cm"), t.Sym("varphi"), "times")
    translation = t.Delta(t.Group(kinetic("M", t.Vec("V_cm"))))
    rotation = t.Delta(t.Group(kinetic("I_cm", t.Vec("omega"))))
    rule = "theory_rates"
    w.add("translational_work", t.equation(t.Sym("cal_W_T"), along, translation), rule, ["newton"], is_result=True)
    w.add("rotational_work", t.equation(t.Sym("cal_W_theta"), turn, rotation), rule, ["euler"], is_result=True)
    _of_one_force(w)
    each = t.Sum(t.PathIntegral(t.Vec("F_ext_i"), t.Vec("r_i")))
    w.add(
        "work_energy",
        t.equation(t.Sym("cal_W"), each, HALVES, t.Delta(t.Sym("E_K"))),
        rule,
        ["velocity", "newton", "torque_sum", "euler", "translational_work", "rotational_work", "work_of_force", "energy"],
        is_result=True,
    )
    _about_fixed_axis(w)


def _of_one_force(w: TheoryWriter) -> None:
    place = t.Group(t.Add((t.Vec("R_cm"), t.Vec("s"))))
    translation = t.PathIntegral(t.Vec("F"), t.Vec("R_cm"))
    rotation = t.PathIntegral(t.Group(t.Cross(t.Vec("s"), t.Vec("F"))), t.Vec("varphi"))
    statement = t.equation(t.Sym("cal_w"), t.PathIntegral(t.Vec("F"), place), t.Add((translation, rotation)))
    w.add("work_of_force", statement, "theory_rates", ["velocity"])


def _about_fixed_axis(w: TheoryWriter) -> None:
    """About a fixed axis the torque about the axis does the whole work."""
    torque = t.Dot(t.Vec("tau_net"), t.Unit("z"))
    about = t.Integral(torque, "varphi", t.Sym("varphi_A"), t.Sym("varphi_B"))
    letter, change = t.Sym("cal_W_theta_O"), t.Delta(t.Group(kinetic("I_O", t.Vec("omega"))))
    rule = "theory_rates"
    about_axis, whole = ["fixed_velocity", "steiner", "fixed_torque"], ["energy", "work_energy", "fixed_axis_work"]
    w.add("fixed_axis_work", t.equation(letter, about, change), rule, about_axis, fixed=True, is_result=True)
    w.add("fixed_work", t.equation(letter, HALVES), rule, [*about_axis[:2], *whole], fixed=True)


def ideal_forces(w: TheoryWriter) -> None:
    """Forces whose two works cancel: at a point at rest, at a smooth contact, between two bodies."""
    _pivot(w)
    _contact(w)
    _pair(w)


def _none(
    w: TheoryWriter, id: str, context: TheoryContext, works: tuple[str, ...], *where: t.Node, is_result: bool = False
) -> None:
    """The works add up to nothing, with what the names mean in the context."""
    statement, taken = t.equation(t.Add(tuple(t.Sym(name) for name in works)), t.ZERO), t.Relations(where)
    w.add(id, statement, "theory_rates", ["work_of_force"], context=context, is_result=is_result, where=taken)


def _speed(centre: str = "R_cm", arm: str = "s") -> t.Node:
    """The velocity of the point where a force acts."""
    return t.Deriv(t.Group(t.Add((t.Vec(centre), t.Vec(arm)))))


def _two_works(end: str = "", *, of: str = "") -> Iterator[t.Node]:
    """What the two works of a force are, or on the second body (`of`) those of its opposite."""
    centre, arm, force = (t.Vec("R_2"), t.Vec("s_2"), t.Neg(t.Vec("F"))) if of else (t.Vec("R_cm"), t.Vec("s"), t.Vec("F"))
    yield t.equation(t.Sym(f"cal_w_T{end}"), t.PathIntegral(force, centre))
    yield t.equation(t.Sym(f"cal_w_theta{end}"), t.PathIntegral(t.Group(t.Cross(arm, force)), t.Vec(f"varphi{of}")))


def _pivot(w: TheoryWriter) -> None:
    """A force whose point of application doesn't move along it does W_T + W_θ = 0."""
    velocity = -Space(z=OMEGA).cross(s)
    powers = {**POWERS, "cal_w_T": F.dot(velocity), "cal_w_theta": s.cross(F).z * OMEGA}
    context = replace(w.context, vectors={**VECTORS, "V_cm": velocity}, works=powers)
    _none(w, "ideal_pivot", context, ("cal_w_T", "cal_w_theta"), *_two_works(), t.equation(_speed(), t.ZERO), is_result=True)


def _contact(w: TheoryWriter) -> None:
    """A smooth contact: the point slides along the line, the force is normal to it."""
    normal, along = symbol("N"), symbol("u")
    force, slide = Space(cartesian(NOTHING, normal)), Space(cartesian(along, NOTHING))
    velocity = slide - Space(z=OMEGA).cross(s)
    powers = {**POWERS, "cal_w_T": force.dot(velocity), "cal_w_theta": s.cross(force).z * OMEGA}
    context = replace(w.context, vectors={**VECTORS, "V_cm": velocity, "F": force}, works=powers)
    across = t.equation(t.Dot(t.Vec("F"), _speed()), t.ZERO)
    _none(w, "ideal_contact", context, ("cal_w_T", "cal_w_theta"), *_two_works(), across)


def _pair(w: TheoryWriter) -> None:
    """Action and reaction at one point of two bodies: the powers cancel, wherever the centres are."""
    second = symbol("omega_q")
    lever = plane_vector("q_x", "q_y")
    point = V + Space(z=OMEGA).cross(s)
    other = point - Space(z=second).cross(lever)
    powers = {
        "cal_w_T_1": F.dot(V),
        "cal_w_theta_1": s.cross(F).z * OMEGA,
        "cal_w_T_2": -F.dot(other),
        "cal_w_theta_2": -(lever.cross(F).z * second),
    }
    opposite = _two_works("_2", of="_2")
    together = t.equation(_speed(), _speed("R_2", "s_2"))
    context = replace(w.context, works={**POWERS, **powers})
    _none(w, "ideal_pair", context, tuple(powers), *_two_works("_1"), *opposite, together)

"""Works in the theory: of the net force and torque, about a fixed axis, of single forces; and potential energy."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.chapters.theory_ground import OMEGA, POWERS, VECTORS, F, TheoryContext, V, plane_vector, s
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Space, cartesian, symbol

if TYPE_CHECKING:
    from rbpsym.chapters.theory import Writer


KINDS = ("T", "theta")


def potential_energy(w: Writer) -> None:
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
    w.add("potential", t.equation(t.Sym("cal_W_c"), conservative, change), "theory_rates", ["work_energy"])
    w.add("split_works", t.equation(every, others), "theory_rates", ["potential"])
    w.add("works_and_potential", t.equation(both, others), "theory_rates", ["split_works"], is_result=True)
    _conserved(w)


def _conserved(w: Writer) -> None:
    """Where E_K + E_p stays constant, the works of all other forces add up to nothing."""
    before = dict(w.context.works)
    left = before["cal_W_T"] + before["cal_W_theta"] - before["cal_W_T_c"]
    works = {**before, "cal_W_theta_c": left, "cal_W_theta_nc": before["cal_W_theta"] - left}
    rates = {**w.context.rates, "U": -(before["cal_W_T_c"] + left)}
    others = t.Add(tuple(t.Sym(f"cal_W_{kind}_nc") for kind in KINDS))
    energy = t.Delta(t.Group(t.Add((t.Sym("E_K"), t.Sym("E_p")))))
    w.add("energy_change", t.equation(energy, others), "theory_rates", ["work_energy", "works_and_potential"])
    context = replace(w.context, works=works, rates=rates)
    statement = t.equation(others, energy, t.ZERO)
    w.add("conserved", statement, "theory_rates", ["energy_change"], context=context)


HALVES = t.Add((t.Sym("cal_W_T"), t.Sym("cal_W_theta")))


def kinetic(mass: str, speed: t.Node) -> t.Node:
    """½ M V² or ½ I ω²."""
    return t.mul(t.Div(t.ONE, t.TWO), t.Sym(mass), t.Pow(speed, t.TWO))


def works(w: Writer) -> None:
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
        ["translational_work", "rotational_work", "work_of_force", "energy"],
        is_result=True,
    )
    _about_fixed_axis(w)


def _of_one_force(w: Writer) -> None:
    place = t.Group(t.Add((t.Vec("R_cm"), t.Vec("s"))))
    translation = t.PathIntegral(t.Vec("F"), t.Vec("R_cm"))
    rotation = t.PathIntegral(t.Group(t.Cross(t.Vec("s"), t.Vec("F"))), t.Vec("varphi"))
    statement = t.equation(t.Sym("cal_w"), t.PathIntegral(t.Vec("F"), place), t.Add((translation, rotation)))
    w.add("work_of_force", statement, "theory_rates", ["velocity"])


def _about_fixed_axis(w: Writer) -> None:
    """About a fixed axis the torque about the axis does the whole work."""
    torque = t.Dot(t.Vec("tau_net"), t.Unit("z"))
    about = t.Integral(torque, "varphi", t.Sym("varphi_A"), t.Sym("varphi_B"))
    letter, change = t.Sym("cal_W_theta_O"), t.Delta(t.Group(kinetic("I_O", t.Vec("omega"))))
    rule = "theory_rates"
    w.add("fixed_axis_work", t.equation(letter, about, change), rule, ["fixed_torque"], fixed=True, is_result=True)
    w.add("fixed_work", t.equation(letter, HALVES), rule, ["fixed_axis_work", "work_energy"], fixed=True)


def ideal_forces(w: Writer) -> None:
    """Forces whose two works cancel: at a point at rest, at a smooth contact, between two bodies."""
    _pivot(w)
    _contact(w)
    _pair(w)


def _none(w: Writer, id: str, context: TheoryContext, works: tuple[str, ...], *, is_result: bool = False) -> None:
    """The works add up to nothing, with what the names mean in the context."""
    statement = t.equation(t.Add(tuple(t.Sym(name) for name in works)), t.ZERO)
    w.add(id, statement, "theory_rates", ["work_of_force"], context=context, is_result=is_result)


def _pivot(w: Writer) -> None:
    """A force whose point of application doesn't move along it does W_T + W_θ = 0."""
    velocity = -Space(z=OMEGA).cross(s)
    powers = {**POWERS, "cal_w_T": F.dot(velocity), "cal_w_theta": s.cross(F).z * OMEGA}
    context = replace(w.context, vectors={**VECTORS, "V_cm": velocity}, works=powers)
    _none(w, "ideal_pivot", context, ("cal_w_T", "cal_w_theta"), is_result=True)


def _contact(w: Writer) -> None:
    """A smooth contact: the point slides along the line, the force is normal to it."""
    normal, along = symbol("N"), symbol("u")
    force, slide = Space(cartesian(NOTHING, normal)), Space(cartesian(along, NOTHING))
    velocity = slide - Space(z=OMEGA).cross(s)
    powers = {**POWERS, "cal_w_T": force.dot(velocity), "cal_w_theta": s.cross(force).z * OMEGA}
    context = replace(w.context, vectors={**VECTORS, "V_cm": velocity, "F": force}, works=powers)
    _none(w, "ideal_contact", context, ("cal_w_T", "cal_w_theta"))


def _pair(w: Writer) -> None:
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
    _none(w, "ideal_pair", replace(w.context, works={**POWERS, **powers}), tuple(powers))

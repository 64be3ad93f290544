"""Potential energy in the theory: the works of conservative forces are minus its change."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.algebra.scalar import NOTHING, symbol
from rbpsym.derivation.theory_ground import POWERS
from rbpsym.notation import tree as t

if TYPE_CHECKING:
    from rbpsym.derivation.theory import Writer

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

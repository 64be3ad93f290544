"""Positions of rest, their stability, and small oscillations of one coordinate about them."""

from __future__ import annotations

from rbpsym.chapters import decay, modes, open_balance
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, root, short
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.oscillation import where_stable as stable_form
from rbpsym.mechanics.rest import resting_forces
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL


def write(draft: Draft, *, where_stable: bool = False) -> None:
    """The chapter; `where_stable`: of places whose stability depends on the parameters, as they are where they are stable,
    with long shapes of modes too."""
    draft.chapter = "oscillations"
    if draft.study.equilibria:
        _rest(draft)
    for place, item in enumerate(draft.study.equilibria, 1):
        _equilibrium(draft, stable_form(item) if where_stable else item, place, whole=where_stable)
    if draft.study.open_balance:
        open_balance.write(draft, draft.study.open_balance)


def laws(draft: Draft) -> dict[str, str]:
    """The chapter, and the ids of the linear equations of the coordinates about what is stable."""
    write(draft, where_stable=True)
    near = (step for step in draft.steps if step.rule == "linearization" and step.data["proved"] != "unstable")
    rows = [step.id for step in draft.steps if step.rule == "linear_system"]
    return dict.fromkeys(draft.study.system.independent, *rows[-1:]) | {step.data["name"]: step.id for step in near}


def _rest(draft: Draft) -> None:
    """The generalized forces at rest, which vanish there and nowhere else."""
    forces = [force for force in resting_forces(draft.study.system, draft.study.dynamics) if force]
    rows = [t.equation(draft.show(force, factor=True), t.ZERO) for force in forces]
    draft.add("rest", "rest", t.system(rows), "oscillations.rest", level=FULL,
              premises=draft.those(*(f"motion.{n}" for n in draft.study.system.independent)), count=len(rows))  # fmt: skip


def _equilibrium(draft: Draft, item: Equilibrium, place: int, *, whole: bool) -> None:
    rows = [t.equation(t.Sym(name), draft.show(value)) for name, value in item.at.items()]
    linear = _is_linearized(draft, item)
    proved, names = item.nature.proved, draft.study.system.independent
    nature = NATURES[proved] if proved != "open" or item.where is not None or item.nature.conditions else "undecided"
    draft.add(f"equilibrium.{place}", "equilibrium", t.system(rows), f"oscillations.{nature}" + (".alone" if item.stable else ""),
              level=FULL, premises=["rest", *draft.those(*(f"motion.{name}" for name in names))],
              names=[t.Sym(name) for name in item.at], others=[t.Sym(name) for name in names if name not in item.at],
              count=len(rows), place=rows, data={**item.facts, "proved": proved, "factors": item.linear.factors},
              obligations=draft.asked(item.valid))  # fmt: skip
    if linear:
        _linearized(draft, item, place, f"oscillations.linear.{LINEAR[proved]}", rows)
    elif item.stable or (item.linear.is_damped and proved == "open"):
        modes.write(draft, item, place, whole=whole)


NATURES = {"minimum": "stable", "asymptotic": "asymptotic", "unstable": "unstable", "open": "unclear"}
LINEAR = {**NATURES, "asymptotic": "stable"}


def _is_linearized(draft: Draft, item: Equilibrium) -> bool:
    """Whether one coordinate and one frequency tell the whole small motion."""
    names, linear = draft.study.system.independent, item.linear
    single = len(names) == 1 or (len(item.frequencies_squared) == 1 and not linear.is_damped)
    known = draft.study.dynamics.accelerations is not None
    fixed = not any(depends_on(value, n) for value in item.at.values() for n in names)
    pulls = bool(item.frequencies_squared) or not is_zero(linear.stiffness[0][0])
    plain = single and known and fixed and pulls and not linear.tied and len(item.at) == 1
    if not plain or not linear.is_damped:
        return plain
    signs = [sign(entry, draft.study.assumptions).kind for [[entry]] in (linear.damping, linear.stiffness)]
    return signs[0] == "positive" and (signs[1] == "negative" or item.nature.proved != "unstable")


def _linearized(draft: Draft, item: Equilibrium, place: int, phrase: str, there: list[t.Chain]) -> None:
    """q̈ ≈ -ϑ² (q - q₀) - (damping) q̇, and the frequency."""
    [name] = item.at
    square, damping = _square(item), NOTHING
    if item.linear.is_damped:
        damping = short(item.linear.damping[0][0] / item.inertia[0][0])
    shown = draft.show(square, factor=True)
    deviation = t.add(t.Sym(name), t.neg(draft.show(item.at[name]))) if item.at[name] else t.Sym(name)
    pull = _linear(shown, deviation)
    drag = t.neg(t.mul(draft.show(damping, factor=True), t.Sym(f"{name}_dot"))) if damping else t.ZERO
    draft.add(f"linear.{place}", "linearization", t.relation(t.Sym(f"{name}_ddot"), "~", t.add(pull, drag)),
              f"{phrase}_damped" if damping and item.stable else phrase, place=there,
              premises=[f"equilibrium.{place}", *draft.those(f"motion.{name}")], coordinate=t.Sym(name),
              data={**item.facts, "name": name, "proved": item.nature.proved, "factors": item.linear.factors},
              obligations=draft.asked(item.valid))  # fmt: skip
    if item.stable:
        _frequencies(draft, item, place, shown, damping)


def _square(item: Equilibrium) -> Scalar:
    """What multiplies -(q - q₀) in the acceleration."""
    if len(item.stiffness) == 1:
        return short(item.stiffness[0][0] / item.inertia[0][0])
    return item.frequencies_squared[0]


def _frequencies(draft: Draft, item: Equilibrium, place: int, shown: t.Node, damping: Scalar) -> None:
    """ϑ without damping, and with it."""
    square = _square(item)
    letter = t.Sym(draft.free(_letter(draft, item)))
    draft.context.scalars[letter.name] = root(square)
    draft.add(f"frequency.{place}", "motion_of_mode", t.equation(t.Pow(letter, t.TWO), shown),
              f"oscillations.frequency{'_undamped' if damping else ''}.alone", name=t.Sym(next(iter(item.at))),
              premises=[f"linear.{place}"], is_result=not damping, letter=letter,
              data={**item.facts, "decay": NOTHING, "square": square, "undamped": bool(damping)})  # fmt: skip
    if damping:
        decay.swinging(draft, item, damping / 2, square, str(place), letter.name.removeprefix("vartheta"), "alone")


def _letter(draft: Draft, item: Equilibrium) -> str:
    """The angular frequency; numbered if there are several stable places, those that may be stable after them."""
    stable = [other.at for other in draft.study.equilibria if other.stable]
    if item.at not in stable:
        stable += [other.at for other in draft.study.equilibria if other.where is not None]
    return f"vartheta_{stable.index(item.at) + 1}" if item.at in stable and len(stable) > 1 else "vartheta"


def _linear(shown: t.Node, deviation: t.Node) -> t.Node:
    around = t.Group(deviation) if isinstance(deviation, t.Add) else deviation
    return t.neg(t.mul(shown, around))

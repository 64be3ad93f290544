"""The work-energy theorem in its two halves, with the ledger of the works of every force.

W_T = ∫F·dR_cm changes ½MV², W_θ = ∫τ_cm dφ changes ½I_cm ω²; the forces of ideal constraints do
W_T + W_θ = 0. Works are first written with the unknown forces as symbols, then worked out.
"""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.chapters.forces import force_node, tag
from rbpsym.chapters.methods import known_works, net_work, spring_works, work_by_bodies, works_together
from rbpsym.chapters.methods.known_works import over_coordinates
from rbpsym.chapters.methods.net_work import HALVES
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, derivative, short, substitute, symbol
from rbpsym.mechanics import energy
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.motion import ForceWork, Work
from rbpsym.mechanics.system import Force
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL, STANDARD, BodyRef, StepRef

NAME = "work-energy"


def write(draft: Draft) -> Mapping[str, Scalar] | None:
    """The steps; returns the acceleration that the theorem gives for one degree of freedom."""
    if not draft.study.system.independent and not draft.study.system.has_clock:
        draft.skip(NAME, "skipped.no_freedom")
        return None
    draft.chapter = "work"
    works = draft.study.works
    if not works:
        draft.skip(NAME, "skipped.no_forces")
        return None
    for item in works:
        _symbols(draft, item)
    for item in works:
        _integrals(draft, item)
    net_work.write(draft, works)
    spring_works.write(draft)
    together = works_together.found(draft)
    parts = work_by_bodies.found(draft)
    _theorem(draft, works, STANDARD if together is None else FULL)
    _whole(draft, works, STANDARD if together is None and (parts is None or parts.level == FULL) else FULL)
    if together is not None:
        works_together.write(draft, together)
    known_works.about_axes(draft)
    if parts is not None:
        work_by_bodies.write(draft, parts)
    return _acceleration(draft)


def write_done(draft: Draft) -> None:
    """The works along the motion, once the forces along it are known."""
    draft.chapter = "work"
    for item in draft.study.works:
        if draft.has(f"work.{item.force}.{item.on}"):
            _done(draft, item)


def name_of(draft: Draft, item: ForceWork, half: str) -> str:
    """𝒲_T or 𝒲_θ of a force on a body."""
    return draft.free(f"cal_W_{half}_{tag(draft, _forces(draft, item)[0])}")


def _forces(draft: Draft, item: ForceWork) -> list[Force]:
    return [f for f in draft.study.system.forces if (f.name, f.on) == (item.force, item.on)]


def _symbols(draft: Draft, item: ForceWork) -> None:
    """The rates F·V and τ_cm ω, by components, are what the symbols of the works mean."""
    state = draft.study.system.bodies[item.on]
    forces = _forces(draft, item)
    push = sum((f.vector.x * state.velocity.x + f.vector.y * state.velocity.y for f in forces), NOTHING)
    turn = sum((torque_about_center(f, state) for f in forces), NOTHING) * state.omega
    draft.context.works[name_of(draft, item, "T")] = push
    draft.context.works[name_of(draft, item, "theta")] = turn
    draft.define(draft.free(f"varphi_{item.on}"), state.pose.angle)


def _integrals(draft: Draft, item: ForceWork) -> None:
    """Both works as integrals along the motion, with unknown forces as symbols."""
    rows = [row for half, word in HALVES if (row := _row(draft, item, half, getattr(item, word))) is not None]
    if not rows:
        return
    silent = not item.translational.parts and not item.rotational.parts
    draft.add(
        f"work.{item.force}.{item.on}",
        "work",
        t.system(rows),
        "work.none" if silent else "work.integrals",
        premises=draft.those(f"force.{item.force}.{item.on}", f"velocity.{item.on}", f"turning.{item.on}"),
        body=BodyRef(item.on),
        force=force_node(draft, _forces(draft, item)[0]),
    )


def _row(draft: Draft, item: ForceWork, half: str, work: Work) -> t.Node | None:
    letter, force = t.Sym(name_of(draft, item, half)), _forces(draft, item)[0]
    if half == "T":
        if not force.vector:
            return None
        path = t.PathIntegral(force_node(draft, force), t.Vec(draft.of_body("R", item.on)))
    else:
        torque = draft.free(f"tau_cm_{tag(draft, force)}")
        if not draft.study.system.bodies[item.on].moment:
            return None
        path = t.PathIntegral(t.Sym(torque), t.Sym(draft.free(f"varphi_{item.on}")), "times")
    return t.equation(letter, path, over_coordinates(draft, work.parts))


def _theorem(draft: Draft, works: tuple[ForceWork, ...], level: int) -> None:
    """The halves for each body."""
    is_known = draft.study.dynamics.accelerations is not None  # else only the whole can be decided
    for name, state in draft.study.system.bodies.items() if is_known else ():
        own = [item for item in works if item.on == name]
        for (half, word), kinetic in zip(HALVES, _kinetic_nodes(draft, name), strict=True):
            terms = [t.Sym(name_of(draft, i, half)) for i in own if getattr(i, word).parts]
            value = energy.translational_energy(state) if half == "T" else energy.rotational_energy(state)
            if not terms and not value:
                continue
            change = t.Delta(t.Group(kinetic))
            statement = t.equation(t.add(*terms), change) if terms else t.equation(change, t.ZERO)
            draft.add(
                f"theorem.{half}.{name}",
                "work_energy",
                statement,
                f"work.theorem.{word}",
                body=BodyRef(name),
                premises=[f"work.{i.force}.{i.on}" for i in own],
                count=len(terms),
                level=level,
            )


def _kinetic_nodes(draft: Draft, name: str) -> tuple[t.Node, t.Node]:
    """½ M V² and ½ I ω² of a body."""
    mass = draft.show(draft.study.system.bodies[name].mass)
    velocity, omega = t.Vec(draft.of_body("V", name)), t.Sym(draft.of_body("omega", name))
    moment = t.Sym(draft.of_body("I", name))
    return t.half_square(mass, velocity), t.half_square(moment, omega)


def _whole(draft: Draft, works: tuple[ForceWork, ...], level: int) -> None:
    """What is left when the works that cancel are dropped equals the change of the kinetic energy."""
    left = [i for i in works if not draft.study.dynamics.workless.get(i.force, False)]
    terms = [t.Sym(name_of(draft, i, half)) for i in left for half, word in HALVES if getattr(i, word).parts]
    total = sum(draft.study.kinetic, NOTHING)
    statement = t.equation(t.add(*terms), t.Delta(t.Group(draft.show_brief(total))))
    draft.add(
        "theorem.whole",
        "work_energy",
        statement,
        "work.theorem.whole",
        variant="cancelled" if len(left) < len(works) else "all",
        level=level,
        premises=[s.id for s in draft.steps if s.id.startswith(("theorem.", "workless."))],
    )


def _done(draft: Draft, item: ForceWork) -> None:
    """The works worked out along the motion from the start."""
    for half, word in HALVES:
        work = getattr(item, word)
        if not work.parts or work.value is None:
            continue
        letter = t.Sym(name_of(draft, item, half))
        items = [letter, draft.show(work.value, factor=True)]
        draft.add(
            f"done.{half}.{item.force}.{item.on}",
            "work_done",
            t.equation(*items),
            "work.done",
            premises=[f"work.{item.force}.{item.on}", *_along_motion(draft, item)],
            body=BodyRef(item.on),
            force=force_node(draft, _forces(draft, item)[0]),
            half=word,
            level=2,
        )


def _along_motion(draft: Draft, item: ForceWork) -> tuple[str, ...]:
    """The steps that say what the unknown parts of a force are, in the end along the motion."""
    names = [name for force in _forces(draft, item) for name in force.unknowns]
    return draft.those(*(f"{kind}.{name}" for name in names for kind in ("along", "reaction")))


def _acceleration(draft: Draft) -> Mapping[str, Scalar] | None:
    """Σ (rates of work) = dT/dt, divided by the speed."""
    names = draft.study.system.independent
    if len(names) != 1:
        draft.skip(NAME, "skipped.one_equation" if names else "skipped.no_freedom", method=NAME, count=len(names))
        return None
    [name] = names
    letters = {name_of(draft, item, half) for item in draft.study.works for half, _ in HALVES}
    total = sum((draft.context.works[letter] for letter in sorted(letters)), NOTHING)
    gained = draft.context.rate_of(sum(draft.study.kinetic, NOTHING))
    row = short((gained - total) / symbol(f"{name}_dot"))
    rough = {n: v for n, v in draft.study.dynamics.reactions.items() if derivative(row, n)}
    row = short(substitute(row, rough)) if rough else row
    slope = derivative(row, f"{name}_ddot")
    rest = substitute(row, {f"{name}_ddot": NOTHING})
    value = short(-(rest / slope))
    draft.add(
        "motion.from_work",
        "solution",
        t.equation(t.Sym(f"{name}_ddot"), draft.show(value, factor=True)),
        "work.motion",
        premises=["theorem.whole"],
        source=StepRef("theorem.whole"),
        speed=t.Sym(f"{name}_dot"),
        level=FULL,
    )
    return {f"{name}_ddot": value}

"""Angular momentum of each body about the fixed origins: L = R × P + I_cm ω, orbital and spin part; what is kept of it, and
the steady motion that it allows.
"""

from __future__ import annotations

from collections.abc import Iterable

from rbpsym.chapters.inertia import moment_of, turning_together, turns_about
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, Space, function, names_in
from rbpsym.mechanics import energy
from rbpsym.mechanics.orbit import Orbit
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "momentum"
    for label in draft.study.origins:
        made = [body for body in draft.study.system.bodies if _of_body(draft, body, label)]
        if len(made) > 1 and any(draft.has(f"momentum.{body}.{label}") for body in made):
            _total(draft, made, label)


def momentum_name(draft: Draft, body: str, label: str) -> str:
    """L_rod (about O), L_rod_Q about another origin."""
    name = "L" if draft.is_single else f"L_{body}"
    return draft.free(name if label == "O" else f"{name}_{label}", "tot")


def _of_body(draft: Draft, body: str, label: str) -> bool:
    """Adds the step for one body; False if its momentum vanishes."""
    state, origin = draft.study.system.bodies[body], draft.study.origins[label]
    orbital, spin = energy.orbital_momentum(state, origin), energy.spin_momentum(state)
    name = momentum_name(draft, body, label)
    draft.context.vectors[name] = Space(z=orbital + spin)
    if not orbital and not spin:
        return False
    if not orbital and any(draft.has(f"momentum.{body}.{other}") for other in draft.study.origins):
        return True  # the spin part is the same about every point
    formula: t.Node = t.Cross(_arm(draft, body, label), t.Vec(draft.of_body("P", body)))
    if state.moment and state.omega:
        formula = t.add(formula, t.mul(t.Sym(draft.of_body("I", body)), t.Vec(draft.of_body("omega", body))))
    statement = t.equation(t.Vec(name), formula, along_z(draft, orbital, spin), *_as_one(draft, body, label, orbital, spin))
    draft.add(f"momentum.{body}.{label}", "angular_momentum", statement, _phrase(orbital, spin),
              premises=draft.those(f"position.{body}", f"velocity.{body}", f"moment.{body}"), body=BodyRef(body),
              point=t.Sym(label),
              data={"origin": origin, "bodies": (body,), "value": orbital + spin, "orbital": orbital, "spin": spin})  # fmt: skip
    return True


def _arm(draft: Draft, body: str, label: str) -> t.Node:
    position = t.Vec(draft.of_body("R", body))
    if label == "O":
        return position
    origin = draft.define_vector(draft.free(f"r_{label}"), draft.study.origins[label])
    return t.Group(t.add(position, t.neg(origin)))


def along_z(draft: Draft, *parts: Scalar) -> t.Node:
    """(a + b) k."""
    shown = [draft.show_brief(part) for part in parts if part]
    return t.mul(t.add(*shown), t.Unit("z"))


def _as_one(draft: Draft, body: str, label: str, orbital: Scalar, spin: Scalar) -> tuple[t.Node, ...]:
    """I_O ω where the body turns about the origin; then the two parts taken together if they are alike."""
    state = draft.study.system.bodies[body]
    total = orbital + spin
    value = (along_z(draft, total),) if orbital and spin and len(total.num) == 1 else ()
    if turns_about(draft.study, state).get(label):
        about = t.Sym(draft.free(f"I_{label}" if draft.is_single else f"I_{body}_{label}"))
        if about.name in draft.context.scalars:
            return (t.mul(about, t.Vec(draft.of_body("omega", body))), *value)
    return value


def _phrase(orbital: Scalar, spin: Scalar) -> str:
    if orbital and spin:
        return "momentum.both"
    return "momentum.orbital" if orbital else "momentum.spin"


def _turning(draft: Draft, label: str) -> tuple[t.Node, ...]:
    """(I_rod + I_disk) ω k where all bodies turn about the origin together."""
    if not turning_together(draft, label):
        return ()
    moments = [moment_of(draft, name, label) for name in draft.study.system.bodies]
    omega = next(iter(draft.study.system.bodies.values())).omega
    return (t.mul(t.add(*moments), draft.show(omega), t.Unit("z")),)


def _total(draft: Draft, bodies: list[str], label: str) -> None:
    """The sum over the bodies."""
    origin = draft.study.origins[label]
    value = sum((draft.context.vectors[momentum_name(draft, b, label)].z for b in bodies), NOTHING)
    name = draft.free("L" if label == "O" else f"L_{label}", "tot")
    draft.context.vectors[name] = Space(z=value)
    sum_ = t.add(*(t.Vec(momentum_name(draft, body, label)) for body in bodies))
    draft.add(f"momentum.total.{label}", "angular_momentum",
              t.equation(t.Vec(name), sum_, *_turning(draft, label), along_z(draft, value)), "momentum.total",
              premises=draft.those(*(f"momentum.{b}.{label}" for b in bodies)), point=t.Sym(label),
              data={"origin": origin, "bodies": tuple(bodies), "value": value})  # fmt: skip


def kept(draft: Draft) -> list[str]:
    """The ids of the steps that say which momenta ∂E/∂q̇ are kept."""
    return [_kept(draft, name, momentum) for name, momentum in draft.study.kept_momenta.items()]


def _kept(draft: Draft, name: str, momentum: Scalar) -> str:
    """The balance of forces may have said it of the whole."""
    known = (step for step in draft.steps if step.rule == "conservation" and step.data["value"] == momentum)
    if (said := next(known, None)) is not None:
        return said.id
    return draft.add(
        f"kept.{name}",
        "conservation",
        t.equation(draft.define(draft.free(f"p_{name}"), momentum), draft.show(momentum)),
        "energy.momentum",
        is_result=True,
        premises=draft.those(f"motion.{name}"),
        data={"value": momentum},
        coordinate=t.Sym(name),
    ).id


def kept_speeds(draft: Draft, wanted: Iterable[str]) -> None:
    """The speeds that they give from the start, those that are wanted."""
    momenta = kept(draft)
    for speed in wanted:
        name = speed.removesuffix("_dot")
        draft.add(f"speed_at.{name}", "kept_speed",
                  t.equation(t.Sym(speed), draft.show(draft.study.momentum_speeds[speed], factor=True)), "energy.speed",
                  premises=momenta, name=t.Sym(name), is_result=True,
                  data={"speed": speed, "speeds": draft.study.momentum_speeds, "momenta": tuple(momenta)})  # fmt: skip


def steady_motion(draft: Draft, name: str, known: Orbit) -> None:
    """The momenta that are kept, the speeds that they give, the place, and the square of the frequency."""
    draft.chapter = "course"
    gained = (draft.study.dynamics.accelerations or {})[f"{name}_ddot"]
    kept = draft.study.kept_speeds if names_in(gained) & draft.study.kept_speeds.keys() else {}
    if kept:
        kept_speeds(draft, kept)
    speeds = draft.those(*(f"speed_at.{speed.removesuffix('_dot')}" for speed in kept))
    data = {"name": name, "speeds": speeds, "place": known.place}
    phrase = f"course.orbit.{'place' if kept else 'beside'}"
    draft.add("orbit.place", "steady_place", t.equation(t.Sym(name), draft.show(known.place)), phrase,
              premises=draft.those(f"motion.{name}", *speeds), name=t.Sym(name), data=data)  # fmt: skip
    letter = draft.define(draft.free("vartheta"), function("sqrt", known.square))
    square = t.equation(t.Pow(letter, t.TWO), draft.show(known.square, factor=True))
    draft.add("orbit.frequency", "steady_frequency", square, "course.orbit.frequency", data=data, is_result=True,
              premises=draft.those(f"motion.{name}", *speeds, "orbit.place"), letter=letter, name=t.Sym(name),
              obligations=draft.asked(known.valid))  # fmt: skip

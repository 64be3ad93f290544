"""The steady motion of what keeps a momentum from its start, and the frequency of small oscillations about it."""

from __future__ import annotations

from rbpsym.algebra import function, names_in
from rbpsym.derivation.chapters import momentum
from rbpsym.derivation.draft import Draft
from rbpsym.mechanics.orbit import Orbit
from rbpsym.notation import tree as t


def write(draft: Draft, name: str, known: Orbit) -> None:
    """The momenta that are kept, the speeds that they give, the place, and the square of the frequency."""
    draft.chapter = "course"
    gained = draft.study.dynamics.accelerations[f"{name}_ddot"]
    kept = draft.study.kept_speeds if names_in(gained) & draft.study.kept_speeds.keys() else {}
    if kept:
        momentum.kept_speeds(draft, kept)
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

"""What is written in the explorer: formulas as MathML beside their plain text, names of forces and bodies."""

from __future__ import annotations

from typing import Any

from rbpsym.algebra.present import present
from rbpsym.document.accents import accented
from rbpsym.document.sketches import force_node
from rbpsym.document.words import Words
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.mathml import to_mathml
from rbpsym.notation.speech import to_speech
from rbpsym.notation.text import to_text


def label(node: t.Node, notation: Notation) -> dict[str, str]:
    """A formula as MathML, as text, and as it is spoken."""
    return {
        "math": accented(to_mathml(node, notation)),
        "text": to_text(node, notation),
        "spoken": to_speech(node, notation),
    }


def force_labels(system: System, notation: Notation, said: Words) -> dict[str, dict[str, Any]]:
    """By “force@body”: the name of the force, and of the body if there are several."""
    several = len(system.bodies) > 1
    found = {}
    for force in system.forces:
        is_told = force_node(system, force) == t.Vec(f"{force.name}_{force.on}")
        body = said.body(force.on) if several and not is_told else ""
        key = f"{force.name}@{force.on}"
        found.setdefault(key, {**label(force_node(system, force), notation), "on": body})
        if force.couple:
            found[key] |= {"couple": label(couple_node(force), notation)["math"]}
    return found


def couple_node(force: Force) -> t.Node:
    """A couple by its letter if it has one, else by the name of its force."""
    shown = present(force.couple)
    plain = shown.arg if isinstance(shown, t.Neg) else shown
    return shown if isinstance(plain, t.Sym) else t.Sym(force.name)

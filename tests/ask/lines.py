"""Particles on a line under a force that is stated as a formula."""

from __future__ import annotations

from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Problem

DIMENSIONS = {
    "m": "mass", "k": "stiffness", "b": "damping", "c": "linear density", "g": "acceleration", "F": "force",
    "Omega": "angular speed", "v_1": "speed", "d": "length", "mu": "number", "x_1": "length",
}  # fmt: skip


def on_line(force: str, *, start: str = "x_0", speed: str = "v_0", more: str = "") -> Problem:
    """A particle of mass m on the axis of x, with this force along it."""
    told = "\n".join(f'{name} = "{dimension}: {name}"' for name, dimension in DIMENSIONS.items())
    text = f"""
title = "Line"
[parameters]
{told}
{more}
[coordinates.x]
meaning = "place"
dimension = "length"
start = "{start}"
speed = "{speed}"
[bodies.block]
meaning = "block"
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.P]
type = "force"
on = "block.center"
force = ["{force}", "0"]
"""
    return load_text(text, file="line.toml", name="line")

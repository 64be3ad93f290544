"""Plots of a derivation: its own formulas as curves, drawn as scenes like all other figures."""

"""Lagrange's equations, and the simulation in maximal coordinates."""

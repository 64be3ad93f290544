"""Texts with formulas: found, read, and bound to what they claim."""

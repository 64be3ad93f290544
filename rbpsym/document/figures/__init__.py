"""Figures: a scene of plain geometry, its printers, and the drawing of a system's sketch."""

"""Plain functions from a statement to the equations of its motion; no formula is known beforehand."""

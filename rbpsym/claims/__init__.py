"""Formulas that somebody claims: decided, diagnosed, compared."""

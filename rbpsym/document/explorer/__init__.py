"""The explorer: one HTML file in which a derived system moves; its numbers are those of the derivation."""

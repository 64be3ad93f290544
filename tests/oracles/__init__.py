"""Oracles for assertions: the simulation at many parameter sets against all that a derivation says of the motion."""

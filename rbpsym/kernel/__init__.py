"""Derivations written for a proof kernel that we did not write: Rocq."""

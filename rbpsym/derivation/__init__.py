"""Derivations: graphs of steps, each with its rule, premises, statement and certificate."""

"""Mutants of the source that change nothing that can be seen, by the name that `mutants.key` gives them, with the reason."""

EQUIVALENT: dict[str, str] = {}

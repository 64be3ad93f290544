"""Verdicts, witnesses, signs from declared ranges, domains, dimensions."""

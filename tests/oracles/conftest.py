"""At the end of a run: how much was compared with the simulation, and what was not, by name and with the reason."""

from __future__ import annotations

from collections import Counter

MISSING, DRAWS, SETS = "not compared", "drawn again", "sets"


def pytest_terminal_summary(terminalreporter) -> None:
    found = [pair for report in terminalreporter.getreports("passed") for pair in report.user_properties]
    found += [pair for report in terminalreporter.getreports("failed") for pair in report.user_properties]
    sets = sum(value for name, value in found if name == SETS)
    if not sets:
        return
    draws: Counter[str] = Counter()
    reasons: dict[str, list[str]] = {}
    for name, value in found:
        if name == DRAWS:
            draws.update(value)
        elif name == MISSING:
            what, reason = value
            reasons.setdefault(reason, []).append(what)
    write = terminalreporter.write_line
    write(f"oracles: {sets} sets compared, {sum(draws.values())} drawn again")
    for reason, count in draws.most_common():
        write(f"  drawn again {count}: {reason}")
    for reason, whats in sorted(reasons.items()):
        write(f"  not compared {len(whats)}: {reason}")
        if terminalreporter.config.option.verbose > 0:
            for what in sorted(whats):
                write(f"    {what}")

"""The kinds of tasks; `registry.TASKS` is the table."""

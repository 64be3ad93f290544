"""The kinds of tasks, one module each; `registry.TASKS` is the table."""

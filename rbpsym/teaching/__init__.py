"""Worksheets from derivations: tasks, misconceptions, numbers, keys, exports and grading."""

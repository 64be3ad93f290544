"""Answers are read, judged, and given marks."""

"""Curves of a motion."""

"""Drawings of systems and free bodies."""

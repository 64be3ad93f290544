"""Worksheets in the formats of learning platforms."""

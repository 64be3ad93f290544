"""Exact arithmetic: the field of rational functions in quantities, sines, cosines and roots."""

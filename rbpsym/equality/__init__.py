"""Verdicts: is a formula zero, of one sign, of one dimension?"""

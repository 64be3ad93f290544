"""Figures and plots: from plain numbers to scenes."""

"""The roads to the equations of motion."""

"""Misconceptions as operators on the physics: each changes the model as a student does; the same engine runs."""

"""Methods: roads from the same statement to the equations of motion, which must agree."""

"""Independent roads to the same results, and what they say of each other."""

"""The face for Python: problems stated with sympy's symbols, models that answer with sympy's expressions."""

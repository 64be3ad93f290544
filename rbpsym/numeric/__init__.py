"""Numbers: formulas as functions of arrays, and motions integrated. For pictures, keys and the oracle; never a verdict."""

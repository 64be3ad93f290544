"""Steps: what they need, what they owe, and the rules with their checkers."""

"""Questions about a problem in the words of its statement, and their answers, derived and proved."""

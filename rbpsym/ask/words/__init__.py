"""A book's English: a grammar that says what a question means in the language that the engine answers."""

"""Values as display trees in textbook form."""

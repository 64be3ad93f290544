"""What looks at each kind of step, apart from what made it."""

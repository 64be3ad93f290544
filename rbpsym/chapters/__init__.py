"""What a derivation tells, and in which order."""

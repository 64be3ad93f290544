"""Roads that are independent of the derivation: oracles for the equations of motion."""

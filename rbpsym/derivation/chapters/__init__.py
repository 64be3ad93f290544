"""The parts of a derivation that all methods share: kinematics, inertia, momentum, forces, oscillations."""

"""From a method of `sympy.physics.mechanics` to plain `Equations`. Import the module you need."""

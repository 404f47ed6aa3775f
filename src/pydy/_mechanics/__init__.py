"""Equations of motion formed from bodies, loads and frames. Import the module you need."""

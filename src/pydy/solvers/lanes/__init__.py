"""The compiled loops of many trajectories at a time, and what calls them."""

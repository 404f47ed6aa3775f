"""Problems and their motions: a model with numbers, its integration, and checks of the result."""

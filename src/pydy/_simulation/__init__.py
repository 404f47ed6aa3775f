"""Problems and their motions: a model with its numbers, integrated, and judged."""

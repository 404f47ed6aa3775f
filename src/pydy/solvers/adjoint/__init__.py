"""Back through the steps of an integration: exact derivatives of a scalar of what came of it."""

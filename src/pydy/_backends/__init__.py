"""Back ends: each turns a Program into a Kernel. Import the module you need."""

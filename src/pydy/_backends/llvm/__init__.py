"""Programs as machine code: LLVM IR written as text, compiled, kept, linked."""

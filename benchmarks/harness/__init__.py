"""What the benchmark scripts share. Runs in every environment: nothing here imports pydy."""

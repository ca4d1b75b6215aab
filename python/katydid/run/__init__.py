"""How a script component runs: inputs in, one run an iteration, outputs out."""

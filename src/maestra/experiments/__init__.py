"""The paper's experiments, reproducible: fewest demonstrations, and learning curves."""

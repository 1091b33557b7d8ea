"""The board, its tokens, and what was played on it. Knows nothing else."""

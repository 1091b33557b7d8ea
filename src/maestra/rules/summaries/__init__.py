"""From an exercise's many preconditions to the few rules that say the same."""

"""The STRIPS side: literals, actions with preconditions, and whether a play can be completed."""

"""The forms a rule can have, one module a family."""

"""How patients get on: curves and tables, sessions step by step, exports."""

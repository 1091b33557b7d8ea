"""Boards: where tokens lie, simulated or played back."""

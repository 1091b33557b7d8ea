"""Robots: who speaks, shows, points and moves tokens."""

"""Patients: who they are, how the robot treats them, what they play, and erasing them."""

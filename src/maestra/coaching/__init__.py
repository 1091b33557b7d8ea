"""Beside patient and caregiver: sessions as pure state machines, and the ports they use."""

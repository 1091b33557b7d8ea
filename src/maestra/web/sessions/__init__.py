"""Sessions: begun, watched, steered, ended."""

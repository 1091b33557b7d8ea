"""The versions of the tables, each following from the one before."""

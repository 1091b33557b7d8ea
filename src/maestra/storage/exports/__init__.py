"""The record for other programs: tables, BIDS, XES. Pseudonyms only, and nobody who was erased."""

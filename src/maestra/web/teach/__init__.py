"""Teaching an exercise on the screen: played on a board, understood beside it, kept as it goes."""

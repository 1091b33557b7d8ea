"""The rules worth considering, by what they are about: one generator for each family.

Nothing here is a list of exercises: attributes, values, places and amounts are those of the
decks and plays. A generator may propose anything; `proposals.surviving` keeps what holds.
"""

"""Numbers that look random and are not: the mixing of SplitMix64.

The constants and the mixing are those of the public reference [1].

[1] Pseudo-random numbers/Splitmix64, Rosetta Code (after Steele, Lea, Flood, Fast splittable
pseudorandom number generators, OOPSLA 2014).
"""

from typing import Final

MASK: Final = 2**64 - 1
"""Numbers are from 0 to this."""
GOLDEN: Final = 0x9E3779B97F4A7C15
"""What is added to a state from one number to the next."""


def mixed(state: int) -> int:
    """A number that any change of `state`, which is 0 to `MASK`, changes all over."""
    state = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    state = ((state ^ (state >> 27)) * 0x94D049BB133111EB) & MASK
    return state ^ (state >> 31)

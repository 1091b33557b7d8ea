"""Learn a tabletop exercise from demonstrations, say its rules in words and judge moves."""

from typing import Final

__all__ = ["__version__"]

__version__: Final = "0.1.0"

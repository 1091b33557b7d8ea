"""The screens that pages are tried on."""

from enum import Enum


class Size(Enum):
    """Width and height in CSS pixels."""

    DESKTOP = (1280, 800)
    TABLET = (820, 1180)
    PHONE = (360, 740)

    @property
    def width(self) -> int:
        """In CSS pixels."""
        return self.value[0]

    @property
    def height(self) -> int:
        """In CSS pixels."""
        return self.value[1]

    @property
    def is_touched(self) -> bool:
        """Whether there is a finger instead of a mouse."""
        return self is not Size.DESKTOP

"""A voice: espeak-ng as a subprocess; a sentence waits until the one before it is out.

Speed is words a minute and volume 0 to 200 in espeak-ng; ours is 0 to 100 %. Where the program is
missing nothing is said, and the screen says it all the same.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from typing import Final

from maestra.coaching.commands import Command, Say
from maestra.coaching.events import Event
from maestra.coaching.settings import Settings

PROGRAM: Final = "espeak-ng"
LONGEST_S: Final = 30.0
"""No sentence takes longer; a program that does hangs."""


def voice_of(settings: Settings) -> tuple[str, ...]:
    """The program's options for the settings' language, speed and volume."""
    return (
        "-v",
        settings.language.value,
        "-s",
        str(settings.speech_wpm),
        "-a",
        str(2 * settings.volume),
    )


class SpeechRobot:
    """Speaks what is said; has no hand, so it leaves moves to other robots."""

    def __init__(self, settings: Settings, program: str = PROGRAM) -> None:
        """Speak in the settings' language, speed and volume."""
        self._program = shutil.which(program)
        self._options = voice_of(settings)
        self._speaking: subprocess.Popen[bytes] | None = None

    @property
    def can_speak(self) -> bool:
        """Whether the program is there."""
        return self._program is not None

    def carry_out(self, command: Command) -> Sequence[Event]:
        """Speak a phrase once the one before it is out."""
        if isinstance(command, Say) and self._program is not None:
            self._hush()
            self._speaking = subprocess.Popen(
                [self._program, *self._options, "--", command.text],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
        return []

    def outcomes(self) -> Sequence[Event]:
        """None: what is said has no outcome."""
        return []

    def close(self) -> None:
        """Let the last sentence end."""
        self._hush()

    def _hush(self) -> None:
        speaking, self._speaking = self._speaking, None
        if speaking is None:
            return
        try:
            speaking.wait(LONGEST_S)
        except subprocess.TimeoutExpired:
            speaking.kill()
            speaking.wait()

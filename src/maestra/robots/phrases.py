"""Sentences spoken into sound files, for browsers that have no voice of their own.

A sentence that was spoken before is taken from a folder: the same words in the same voice have the
same name there, a digest of both. What the folder holds can be made again, so it is kept small.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import tempfile
import threading
from contextlib import suppress
from pathlib import Path
from typing import Final

from maestra.coaching.settings import Settings
from maestra.robots.speech import PROGRAM, voice_of

LONGEST_S: Final = 10.0
"""To speak one sentence into a file; it takes 20 to 50 ms, and a program that needs more hangs."""
MOST_CHARACTERS: Final = 2_000
"""Of what is said at once; no moment of a session says more."""
MOST_BYTES: Final = 64 * 2**20
"""In the folder: a sentence takes about 100 kB, so several hundred."""
AT_ONCE: Final = 2
"""Programs that speak at the same time: more would only wait for one another."""
_SUFFIX: Final = ".wav"


class NoVoiceError(Exception):
    """No program speaks, or it failed; the words stand on the screen all the same."""


class Phrases:
    """Speaks sentences into files. All methods are for any thread."""

    def __init__(
        self, folder: Path, program: str = PROGRAM, *, most_bytes: int = MOST_BYTES
    ) -> None:
        """Keep files in `folder`, which is made when it is first needed."""
        self._folder = folder
        self._program = shutil.which(program)
        self._most_bytes = most_bytes
        self._speaking = threading.BoundedSemaphore(AT_ONCE)

    @property
    def can_speak(self) -> bool:
        """Whether the program is there."""
        return self._program is not None

    def spoken(self, text: str, settings: Settings) -> bytes:
        """`text` as a WAV file, in the settings' language, speed and volume.

        Raises:
            NoVoiceError: it cannot be spoken.
        """
        options, words = voice_of(settings), text[:MOST_CHARACTERS]
        name = hashlib.sha256("\0".join((*options, words)).encode()).hexdigest()
        path = self._folder / f"{name}{_SUFFIX}"
        with suppress(OSError):
            sound = path.read_bytes()
            os.utime(path)  # used lately: it is kept longest
            return sound
        sound = self._speak(options, words)
        with suppress(OSError):  # a folder that cannot be written to only costs time
            self._keep(path, sound)
        return sound

    def _speak(self, options: tuple[str, ...], text: str) -> bytes:
        if self._program is None:
            raise NoVoiceError(PROGRAM)
        command = [self._program, *options, "--stdout", "--", text]
        try:
            with self._speaking:
                done = subprocess.run(
                    command,
                    check=True,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.DEVNULL,
                    timeout=LONGEST_S,
                )
        except (OSError, subprocess.SubprocessError) as error:
            raise NoVoiceError(PROGRAM) from error
        return _whole(done.stdout)

    def _keep(self, path: Path, sound: bytes) -> None:
        """Keep it under its name all at once, and let the oldest go if there is too much."""
        self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        number, draft = tempfile.mkstemp(dir=self._folder)
        with os.fdopen(number, "wb") as file:
            file.write(sound)
        Path(draft).replace(path)
        kept = sorted(
            ((one.stat().st_mtime_ns, one.stat().st_size, one) for one in self._folder.iterdir()),
            reverse=True,
        )
        size = 0
        for _, bytes_of_one, one in kept:
            size += bytes_of_one
            if size > self._most_bytes:
                one.unlink(missing_ok=True)


def _whole(sound: bytes) -> bytes:
    """A WAV file with its lengths filled in.

    A program that writes to a pipe does not know them beforehand; browsers that take the file at
    its word would wait for hours of sound.
    """
    head, data = 44, b"data"
    if len(sound) < head or sound[36:40] != data:
        return sound
    riff = (len(sound) - 8).to_bytes(4, "little")
    length = (len(sound) - head).to_bytes(4, "little")
    return sound[:4] + riff + sound[8:40] + length + sound[head:]

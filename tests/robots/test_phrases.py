"""Sentences spoken into files, with a program of the test's own in the voice's place."""

from __future__ import annotations

import io
import os
import stat
import wave
from pathlib import Path

import pytest

from maestra.coaching.settings import Settings
from maestra.language import Language
from maestra.robots import phrases as spoken
from maestra.robots.phrases import NoVoiceError, Phrases


def voice(folder: Path, body: str) -> str:
    """A program that notes how often it is asked."""
    path = folder / "voice"
    path.write_text(f'#!/bin/sh\necho "$@" >> "{folder}/asked"\n{body}\n')
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


def asked(folder: Path) -> list[str]:
    return (folder / "asked").read_text().splitlines()


def test_a_sentence_is_spoken_once_and_kept(tmp_path: Path) -> None:
    phrases = Phrases(tmp_path / "kept", voice(tmp_path, "printf sound"))
    settings = Settings(language=Language.CA, speech_wpm=120, volume=50)
    assert phrases.can_speak
    assert phrases.spoken("Molt bé; $(rm -r /) -v en", settings) == b"sound"
    assert phrases.spoken("Molt bé; $(rm -r /) -v en", settings) == b"sound"
    assert asked(tmp_path) == ["-v ca -s 120 -a 100 --stdout -- Molt bé; $(rm -r /) -v en"]
    phrases.spoken("Molt bé; $(rm -r /) -v en", Settings(language=Language.CA, speech_wpm=130))
    assert len(asked(tmp_path)) == 2


def test_the_oldest_sentences_go_when_there_are_too_many(tmp_path: Path) -> None:
    phrases = Phrases(tmp_path / "kept", voice(tmp_path, "printf sound"), most_bytes=10)
    for number, text in enumerate(("one", "two")):
        phrases.spoken(text, Settings())
        for kept in (tmp_path / "kept").iterdir():
            os.utime(kept, (number, number))
    phrases.spoken("one", Settings())  # used again: younger than the other
    phrases.spoken("three", Settings())
    assert len(list((tmp_path / "kept").iterdir())) == 2
    phrases.spoken("one", Settings())
    phrases.spoken("three", Settings())
    assert len(asked(tmp_path)) == 3


@pytest.mark.parametrize("body", ["exit 1", "exec sleep 20"])
def test_a_voice_that_fails_or_hangs_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str
) -> None:
    monkeypatch.setattr(spoken, "LONGEST_S", 0.2)
    with pytest.raises(NoVoiceError):
        Phrases(tmp_path / "kept", voice(tmp_path, body)).spoken("Hello.", Settings())


def test_without_a_voice_nothing_is_spoken(tmp_path: Path) -> None:
    phrases = Phrases(tmp_path, "no-such-program")
    assert not phrases.can_speak
    with pytest.raises(NoVoiceError):
        phrases.spoken("Hello.", Settings())


def test_a_folder_that_cannot_be_made_only_costs_time(tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("a file")
    phrases = Phrases(tmp_path / "kept", voice(tmp_path, "printf sound"))
    assert phrases.spoken("Hello.", Settings()) == b"sound"
    assert phrases.spoken("Hello.", Settings()) == b"sound"


@pytest.mark.parametrize("language", Language)
def test_the_real_voice_speaks_every_language_in_a_file_that_says_its_length(
    tmp_path: Path, language: Language
) -> None:
    phrases = Phrases(tmp_path)
    assert phrases.can_speak, "the tests need espeak-ng, which `make test` installs"
    sound = phrases.spoken("12, 19.", Settings(language=language))
    with wave.open(io.BytesIO(sound)) as read:
        seconds = read.getnframes() / read.getframerate()
    assert 0.3 < seconds < 10

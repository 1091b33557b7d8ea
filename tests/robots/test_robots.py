"""One contract for all robots; the screen writes, the voice speaks."""

from __future__ import annotations

import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from maestra.coaching.commands import (
    AskCaregiver,
    Command,
    Express,
    Expression,
    Gesture,
    GestureName,
    LookAt,
    Matter,
    MoveToken,
    PointAt,
    Record,
    Say,
    Show,
    View,
)
from maestra.coaching.events import RobotDone, RobotFailed
from maestra.coaching.ports import Robot
from maestra.coaching.settings import Settings
from maestra.core.board import Cell, Column, Row
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.robots import speech
from maestra.robots.screen import ScreenRobot
from maestra.robots.speech import SpeechRobot

HERE, THERE = Cell(Row(2), Column(1)), Cell(Row(1), Column(1))
MOVE = MoveToken(3, TokenId("a"), HERE, THERE)
EVERY: tuple[Command, ...] = (
    Say("praise", {}, "Very good!"),
    Express(Expression.HAPPY),
    Gesture(GestureName.NOD),
    LookAt((HERE,)),
    PointAt((HERE, THERE)),
    Show(View.RULES, lines=("One rule.",)),
    Show(View.ENDED),
    Record("begun", {}),
    AskCaregiver(1, Matter.CHECK_BOARD, "Please look."),
)


def refuses(_token: TokenId, _cell: Cell) -> None:
    raise InvalidError([Fault("destination", "taken", "an empty cell")])


def silent_screen() -> Robot:
    return ScreenRobot(lambda _: None)


def mute_voice() -> Robot:
    return SpeechRobot(Settings(), "no-such-program")


@pytest.mark.parametrize("make", [silent_screen, mute_voice])
def test_a_robot_takes_every_command_and_only_moves_have_outcomes(
    make: Callable[[], Robot],
) -> None:
    robot = make()
    for command in EVERY:
        assert list(robot.carry_out(command)) == []
    assert list(robot.outcomes()) == []
    robot.close()


def test_the_screen_writes_what_is_said_shown_and_asked() -> None:
    lines: list[str] = []
    robot = ScreenRobot(lines.append)
    for command in EVERY:
        robot.carry_out(command)
    assert lines == ["Very good!", "One rule.", "[Please look.]"]
    assert robot.pointed_at == (HERE, THERE)


def test_a_screen_moves_tokens_only_with_a_hand() -> None:
    moved: list[tuple[TokenId, Cell]] = []
    with_hand = ScreenRobot(lambda _: None, lambda token, cell: moved.append((token, cell)))
    assert with_hand.carry_out(MOVE) == [RobotDone(3)]
    assert moved == [(TokenId("a"), THERE)]
    (failed,) = ScreenRobot(lambda _: None).carry_out(MOVE)
    assert isinstance(failed, RobotFailed)
    (failed,) = ScreenRobot(lambda _: None, refuses).carry_out(MOVE)
    assert failed == RobotFailed(3, "destination: taken, expected an empty cell")


def program(folder: Path, body: str) -> Path:
    path = folder / "voice"
    path.write_text(f"#!/bin/sh\n{body}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def test_the_voice_speaks_one_sentence_after_another(tmp_path: Path) -> None:
    voice = program(tmp_path, f'echo "$@" >> {tmp_path}/said')
    settings = Settings(language=Language.CA, speech_wpm=120, volume=50)
    robot = SpeechRobot(settings, str(voice))
    assert robot.can_speak
    for text in ("Hola.", "Molt bé!"):
        robot.carry_out(Say("praise", {}, text))
    robot.close()
    assert (tmp_path / "said").read_text().splitlines() == [
        "-v ca -s 120 -a 100 -- Hola.",
        "-v ca -s 120 -a 100 -- Molt bé!",
    ]


def test_a_voice_that_hangs_is_cut_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(speech, "LONGEST_S", 0.05)
    robot = SpeechRobot(Settings(), str(program(tmp_path, "exec sleep 20")))
    robot.carry_out(Say("praise", {}, "Hello."))
    robot.close()


def test_a_missing_voice_is_no_fault() -> None:
    assert not SpeechRobot(Settings(), "no-such-program").can_speak

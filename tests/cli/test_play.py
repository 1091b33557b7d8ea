"""A session on the terminal: piped moves, a record, and the same session again."""

from __future__ import annotations

import json
import os
import pty
from pathlib import Path
from typing import cast

import pytest

from maestra.app import record_to_read
from maestra.cli import playing
from maestra.cli.outputs import Said
from maestra.cli.screen import Screen
from maestra.coaching.recording import read_session
from maestra.coaching.running import Running
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.paper_rules import paper_exercise
from tests.cli.running import EXAMPLES, Ran, learned, maestra


def play(folder: Path, typed: str, *options: str | Path, name: str = "ascending") -> Ran:
    exercise = folder / f"{name}.json"
    if not exercise.exists():
        exercise = learned(folder, name, "--learner", "grounded")
    record = folder / "session.jsonl"
    where = ("--data", folder / "data", "--keys", folder / "keys")
    wanted = ("--patient", "anna", "--seed", "5", "--quiet", "--record", record)
    return maestra("play", exercise, *wanted, *where, *options, typed=typed.encode())


DECK = ("--deck", EXAMPLES / "ascending.jsonl", "-o")
ASCENDING = "19\n23\n32\n34 4\n36\n"


def test_a_whole_session_is_played_recorded_and_replayed(tmp_path: Path) -> None:
    ran = play(tmp_path, ASCENDING)
    assert ran.code == 0, ran
    assert ran.err == ""
    with (tmp_path / "session.jsonl").open("rb") as file:
        start, events = read_session(file, "session.jsonl")
        assert start.patient == "anna"
        assert len(list(events)) == 11
    shown = maestra("replay", tmp_path / "session.jsonl")
    assert shown.code == 0
    said = [line for line in shown.out.splitlines() if line.strip().startswith("say ")]
    assert all(line.strip()[5:-1] in ran.out for line in said)
    again = maestra("replay", tmp_path / "session.jsonl", "--json")
    assert [json.loads(line)["at"] for line in again.out.splitlines()][-1] == 5_000


def test_the_same_seed_and_moves_give_the_same_transcript(tmp_path: Path) -> None:
    one, other = tmp_path / "one", tmp_path / "other"
    for folder in (one, other):
        folder.mkdir()
    assert play(one, ASCENDING).out == play(other, ASCENDING).out


def test_wrong_moves_hints_and_waiting(tmp_path: Path) -> None:
    typed = "63\nundo\nhint\nwait 30\nshow me\nfoo\nhelp\n19 9\n19 1\n23 1\n19 1\nquit\n"
    ran = play(tmp_path, typed)
    assert ran.code == 1
    assert "There is no token foo." in ran.out
    assert "The columns go from 1 to 5." in ran.out
    assert "There is already a token in column 1." in ran.out
    assert "moves it to the first empty column" in ran.out


def test_the_end_of_what_is_typed_ends_the_session(tmp_path: Path) -> None:
    ran = play(tmp_path, "19\ndone\n")
    assert ran.code == 1
    shown = maestra("replay", tmp_path / "session.jsonl")
    assert "end-ordered" in shown.out
    assert "done-said" in shown.out


def test_a_full_row_takes_no_more(tmp_path: Path) -> None:
    ran = play(tmp_path, "19 5\n23 4\n32 3\n34 2\n36 1\n46\n")
    assert "The goal row is full." in ran.out


def test_settings_are_kept_for_the_patient_and_may_be_given(tmp_path: Path) -> None:
    settings = tmp_path / "settings.json"
    written = {"format": "maestra.settings/1", "settings": {"language": "ca", "level": 2}}
    settings.write_text(json.dumps(written))
    first = play(tmp_path, ASCENDING, "--settings", settings)
    assert "Cada fitxa" in first.out
    assert "Cada fitxa" in play(tmp_path, ASCENDING).out
    assert "Cada ficha" in play(tmp_path, ASCENDING, "--lang", "es").out


def test_a_session_in_the_record_can_be_replayed(tmp_path: Path) -> None:
    play(tmp_path, ASCENDING)
    store = record_to_read(str(tmp_path / "data"), str(tmp_path / "keys"))
    (session,) = store.sessions()
    store.close()
    assert session.ended_utc is not None
    where = ("--data", tmp_path / "data", "--keys", tmp_path / "keys")
    kept = maestra("replay", session.session, *where)
    assert kept.out == maestra("replay", tmp_path / "session.jsonl").out
    missing = maestra("replay", "nobody", *where)
    assert missing.code == 2
    assert missing.err.startswith("maestra: session: nobody")


def test_a_patient_types_what_the_tokens_show_not_how_they_are_called(tmp_path: Path) -> None:
    assert maestra("tell", "Numbers from small to large", *DECK, tmp_path / "told.json").code == 0
    ran = play(tmp_path, "19\n", name="told")
    assert "There is no token 19." in ran.out


def test_a_start_has_a_right_move(tmp_path: Path) -> None:
    (tmp_path / "row.json").write_text(encode_exercise(paper_exercise("first-row")))
    ran = play(tmp_path, "hint\n" * 12, name="row")
    assert "No move is right" not in ran.out
    assert "row 2" in ran.out


def settings_with(folder: Path, **settings: object) -> Path:
    file = folder / "settings.json"
    file.write_text(json.dumps({"format": "maestra.settings/1", "settings": settings}))
    return file


def row_of(ran: Ran, play: int) -> str:
    """The board as it was first drawn in a play."""
    drawn = ran.out.split("Rest; then press Enter")[play]
    return drawn[drawn.index("├") : drawn.index("└")]


def test_a_sitting_has_as_many_plays_as_the_settings_say(tmp_path: Path) -> None:
    settings = settings_with(tmp_path, rounds=3)
    typed = f"{ASCENDING}\n{ASCENDING}\n{ASCENDING}"
    ran = play(tmp_path, typed, "--settings", settings)
    assert ran.code == 0, ran
    assert "Play 1 of 3 is done. Rest; then press Enter, or type quit." in ran.out
    assert "Play 2 of 3 is done." in ran.out
    assert "Play 3 of 3" not in ran.out
    assert len({row_of(ran, number) for number in range(3)}) == 3
    where = ("--data", tmp_path / "data", "--keys", tmp_path / "keys")
    report = json.loads(maestra("report", "anna", "--json", *where).out)
    assert len(report["exercises"][0]["sessions"]) == 3
    for name in ("session.jsonl", "session-2.jsonl", "session-3.jsonl"):
        with (tmp_path / name).open("rb") as file:
            assert read_session(file, name)[0].patient == "anna"
        assert maestra("replay", tmp_path / name).code == 0
    assert play(tmp_path, typed).out == ran.out


def test_a_sitting_ends_when_the_patient_has_enough(tmp_path: Path) -> None:
    settings = settings_with(tmp_path, rounds=3)
    left = play(tmp_path, f"{ASCENDING}quit\n", "--settings", settings)
    assert left.code == 0
    assert "Play 2" not in left.out
    assert play(tmp_path, ASCENDING).code == 0
    stopped = play(tmp_path, f"{ASCENDING}\n19\nquit\n")
    assert stopped.code == 1
    assert "Play 2" not in stopped.out


def test_a_sitting_without_a_file_keeps_none(tmp_path: Path) -> None:
    exercise = learned(tmp_path, "ascending", "--learner", "grounded")
    settings = settings_with(tmp_path, rounds=2)
    where = ("--data", tmp_path / "data", "--keys", tmp_path / "keys", "--settings", settings)
    typed = f"{ASCENDING}\n{ASCENDING}".encode()
    ran = maestra("play", exercise, "--patient", "anna", "--quiet", *where, typed=typed)
    assert ran.code == 0
    assert not list(tmp_path.glob("*-2*"))


def test_a_caregivers_own_words_are_said_and_kept_with_the_session(tmp_path: Path) -> None:
    words = tmp_path / "words.json"
    english = {"noun": "price", "things": "prices", "more": "dearer", "less": "cheaper"}
    own = {"value": {"en": english}}
    words.write_text(json.dumps({"format": "maestra.words/1", "attributes": own}))
    ran = play(tmp_path, "hint\n", "--words", words)
    assert "dearer" in ran.out
    words.unlink()
    said = maestra("replay", tmp_path / "session.jsonl")
    assert said.code == 0
    assert "dearer" in said.out
    missing = play(tmp_path, "", "--words", words)
    assert missing.code == 2
    words.write_text("{}")
    refused = play(tmp_path, "", "--words", words)
    assert refused.code == 2
    assert "words.json" in refused.err


class Under:
    """A session with nothing due, or with something after so many milliseconds."""

    session = None


def test_a_prompt_comes_when_it_is_due_at_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    ours, theirs = pty.openpty()
    waited = iter([10, None, None])

    def due(_session: object) -> int | None:
        return next(waited)

    monkeypatch.setattr(playing, "due", due)
    with os.fdopen(theirs, encoding="utf-8") as typed, os.fdopen(ours, "wb", 0) as hand:
        monkeypatch.setattr("sys.stdin", typed)
        under = cast("Running", Under())
        lines = playing.at_terminal(Screen("goal"), under)
        assert next(lines)[0] is None
        hand.write(b"19\n")
        line, now = next(lines)
        assert line == "19"
        assert 10 <= now < 60_000
        hand.write(b"\x04")
        assert next(lines, None) is None


def test_what_is_said_after_a_silence_stands_on_a_line_of_its_own(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ours, theirs = pty.openpty()
    with os.fdopen(theirs, encoding="utf-8") as typed, os.fdopen(ours, "wb", 0) as hand:
        monkeypatch.setattr("sys.stdin", typed)
        screen = Screen("goal")
        assert screen.line_within(0.0) is None
        assert screen.line_within(0.0) is None
        screen.show((Said("No hurry."),))
        hand.write(b"\xff\n")
        assert screen.line_within(60.0) == "?"
    assert capsys.readouterr().out == "> \nNo hurry.\n> "


def test_control_c_leaves_the_prompt_behind(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("select.select", interrupted)
    with pytest.raises(KeyboardInterrupt):
        Screen("goal").line_within(None)
    assert capsys.readouterr().out == "> \n"

"""Progress is worked out from what the record holds."""

import json
from itertools import pairwise
from math import isclose
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.coaching.chance import Chance
from maestra.coaching.fields import Milliseconds
from maestra.coaching.patients import patient_of
from maestra.coaching.ports import Entry, PatientId, SessionId, StoredSession
from maestra.coaching.progress import ExerciseProgress, SessionProgress, Trend, of_session, trend
from maestra.coaching.report import NOTHING, Chart, Report, draw
from maestra.coaching.session import Ending, Session
from maestra.coaching.settings import Profile, settings_for
from maestra.coaching.simulation import Simulation
from maestra.language import Language
from maestra.language.report_keys import ReportKey
from maestra.language.reports import decimal, report_words
from tests.coaching.plain_referee import game

STORED = StoredSession(
    SessionId("s"), PatientId("heron"), "ascending", 1, "{}", "2026-05-01T09:00:00+00:00"
)
Happening = tuple[int, str, dict[str, Any] | None]


def entries(*happenings: Happening) -> list[Entry]:
    """A record: at so many milliseconds an event, or a note with its fields."""
    made: list[Entry] = []
    for sequence, (at, what, fields) in enumerate(happenings, 1):
        if fields is None:
            kind, payload = "event", json.dumps({"at": at, "what": {"event": what}})
        else:
            said = {"command": "say"}
            note = {"command": "record", "note": what, "fields": fields}
            kind, payload = "commands", json.dumps([said, note])
        key = f"{sequence}"
        made.append(Entry(STORED.session, key, Milliseconds(at), "now", kind, payload, sequence))
    return made


def move(at: int, by: str = "patient", level: int = 0) -> Happening:
    return (at, "move", {"by": by, "level": level})


BEGUN: Happening = (0, "begun", {})


def lifted(at: int) -> Happening:
    return (at, "lifted", None)


def seen(*happenings: Happening) -> SessionProgress:
    return of_session(STORED, entries(*happenings))


def test_a_session_that_came_to_its_end_is_completed_and_another_is_not() -> None:
    assert seen(BEGUN, (900, "ended", {"ending": Ending.COMPLETE.value})).completed
    assert not seen(BEGUN, (900, "ended", {"ending": Ending.STOPPED.value})).completed
    assert not seen(BEGUN).completed


def test_first_attempts_are_the_patients_moves_without_a_refusal_before() -> None:
    refused: Happening = (3, "refused", {})
    found = seen(BEGUN, move(1), move(2, by="helper"), refused, refused, move(4), move(5))
    assert (found.steps, found.first_attempts, found.refused) == (4, 2, 2)
    assert found.first_attempt_share == 0.5


def test_reactions_are_taken_from_the_patients_turn_to_the_first_lifting() -> None:
    found = seen(
        BEGUN,
        lifted(700),
        lifted(800),
        move(1_000),
        lifted(1_400),
        (1_500, "refused", {}),
        lifted(1_700),  # to put it back
        (2_000, "returned", {}),
        lifted(2_300),
        move(2_500, by="helper"),  # not the patient's
        (2_600, "paused", {}),
        lifted(2_700),
        (5_000, "resumed", {}),
        (5_100, "board-lost", {}),
        (6_000, "board-back", {}),
        lifted(6_050),
        move(6_100),
        lifted(6_300),  # never placed
    )
    assert found.reactions == (700, 400, 50)
    assert found.reaction == 400
    assert found.lasted == 6_300


def test_assistance_is_the_mean_of_the_steps_levels() -> None:
    assert seen(BEGUN, move(1, level=4), move(2), move(3, level=2)).assistance == 2


def test_a_session_without_steps_has_nothing_to_measure() -> None:
    found = seen(BEGUN, (5, "start", None))
    assert (found.first_attempt_share, found.reaction, found.assistance) == (None, None, None)


def test_the_figures_agree_with_what_the_session_counted_itself() -> None:
    for seed in range(12):
        session, progress = played(seed)
        tally = session.tally
        assert progress.completed == (session.ending is Ending.COMPLETE)
        assert progress.first_attempts == tally.first_time
        assert progress.refused == tally.errors
        assert progress.steps == tally.moves + tally.by_others
        assert all(ms >= 0 for ms in progress.reactions)


def played(seed: int) -> tuple[Session, SessionProgress]:
    from maestra.coaching.commands import encode_commands  # noqa: PLC0415
    from maestra.coaching.events import encode_event  # noqa: PLC0415
    from maestra.coaching.playing import step  # noqa: PLC0415
    from maestra.coaching.session import new_session  # noqa: PLC0415

    profile = Profile()
    playing = game(settings=settings_for(profile), seed=seed)
    found = Simulation(playing, patient_of(profile, Chance(seed)), seed).play()
    state, made = new_session(playing), list[Entry]()
    for event in found.events:
        state, commands = step(state, event.what, event.at)
        for kind, value in (
            ("event", encode_event(event)),
            ("commands", encode_commands(commands)),
        ):
            key = f"{len(made)}"
            made.append(
                Entry(STORED.session, key, event.at, "now", kind, json.dumps(value), len(made) + 1)
            )
    return state, of_session(STORED, made)


# ---------------------------------------------------------------- trends


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ((1, 2, 3), Trend.TOO_FEW),
        ((1, None, 2, None, 3), Trend.TOO_FEW),
        ((1, 2, 3, 4), Trend.RISING),
        ((4, 3, 2, 1), Trend.FALLING),
        ((1, 2, 3, 2), Trend.STEADY),
        ((2, 2, 2, 2, 2), Trend.STEADY),
        ((1, 1, 1, 1, 2, 2, 2, 2), Trend.RISING),
    ],
)
def test_a_trend_is_seen_where_chance_would_hardly_make_it(
    values: tuple[float | None, ...], expected: Trend
) -> None:
    assert trend(values) is expected


@given(st.lists(st.integers(0, 5), max_size=12))
def test_a_trend_turns_with_the_order(values: list[int]) -> None:
    turned = {Trend.RISING: Trend.FALLING, Trend.FALLING: Trend.RISING}
    found = trend(values)
    assert trend(reversed(values)) is turned.get(found, found)


def test_an_order_made_by_chance_seldom_shows_a_trend() -> None:
    chance, shown = Chance(1), 0
    for _ in range(2_000):
        order, chance = chance.shuffled(range(10))
        shown += trend(order) in {Trend.RISING, Trend.FALLING}
    # One in twenty on each side; the steps of S make it somewhat less.
    assert 100 <= shown <= 220


# ---------------------------------------------------------------- the report


def an_exercise(*sessions: SessionProgress) -> ExerciseProgress:
    return ExerciseProgress("ascending <b>", sessions)


PLAYED = an_exercise(
    seen(BEGUN, lifted(2_000), move(3_000, level=1), (60_000, "ended", {"ending": "complete"})),
    seen(BEGUN, (1, "refused", {}), move(2, level=3), move(3, level=5)),
    seen(BEGUN),
)


def test_an_exercises_figures_are_over_all_its_steps() -> None:
    assert isclose(PLAYED.completion, 1 / 3)
    assert PLAYED.first_attempt_share is not None
    assert isclose(PLAYED.first_attempt_share, 2 / 3)
    assert PLAYED.reaction == 2_000
    assert PLAYED.assistance == 3


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize("key", ReportKey)
def test_each_language_has_each_word_of_a_report(language: Language, key: ReportKey) -> None:
    assert report_words(key, language, patient="P", number="1")


@pytest.mark.parametrize(("language", "expected"), [(Language.EN, "1.5"), (Language.CA, "1,5")])
def test_decimals_are_written_as_the_language_does(language: Language, expected: str) -> None:
    assert decimal(1.5, language) == expected


def test_a_report_says_what_was_measured() -> None:
    report = Report(PatientId("heron"), (PLAYED,), Language.EN)
    (row,) = report.summary().rows
    assert row == (
        "ascending <b>",
        "3",
        "33 %",
        "67 % (too few sessions)",
        "2.0 s (too few sessions)",
        "3.0 of 5 (too few sessions)",
    )
    first, _, last = report.sessions(PLAYED).rows
    assert first == ("2026-05-01 09:00", "yes", "1", "100 %", "2.0 s", "1.0 of 5", "1.0 min")
    assert last == ("2026-05-01 09:00", "no", "0", NOTHING, NOTHING, NOTHING, "0.0 min")


def test_the_page_stands_alone_and_escapes_what_people_wrote() -> None:
    page = Report(PatientId("<heron>"), (PLAYED,), Language.CA).page()
    assert page.startswith("<!DOCTYPE html>")
    assert '<html lang="ca">' in page
    assert "<heron>" not in page
    assert "&lt;heron&gt;" in page
    assert page.count("<svg") == 3
    assert not any(outside in page for outside in ("<script", "<link", "src=", "url("))


def test_a_report_on_nothing_says_so() -> None:
    report = Report(PatientId("heron"), (), Language.ES)
    assert "Todavía no se ha jugado ninguna sesión." in report.page()


def test_a_chart_has_a_mark_for_each_session_that_has_the_measure() -> None:
    drawn = draw(Chart("Reaction", (1.0, None, 3.0), 3.0), "Session")
    assert drawn.count("<circle") == 2
    assert "<title>Reaction: 1.0, –, 3.0</title>" in drawn
    heights = [float(part.split('"')[0]) for part in drawn.split('cy="')[1:]]
    assert all(lower > higher for lower, higher in pairwise(heights))

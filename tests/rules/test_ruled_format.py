"""Exercises made of rules as files."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, cast

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.json_lines import FormatError
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import (
    MAX_ALTERNATIVES,
    MAX_SAFE_RULES,
    Alternative,
    Evidence,
    Exam,
    LearnStatus,
    MeantRule,
    RuledExercise,
    meant_rules,
)
from maestra.rules.exercise_format import decode_exercise, encode_exercise
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.rule import MAX_RULES
from maestra.rules.setting import Play, Setting
from maestra.rules.token_tests import has
from scripts.write_schemas import schemas
from tests.rules import exercise_files
from tests.rules.exercise_files import Path, refusal
from tests.rules.exercise_strategies import demonstration_of, ruled_exercises

VALIDATOR: Any = Draft202012Validator(json.loads(schemas()["exercise-1.schema.json"]))

RISING = Ordered("value", Direction.RISING)
ODD = EveryToken(has("odd", "value"))


def small() -> RuledExercise:
    """Three numbers in rising order on two goal cells, with every kind of evidence."""
    deck = Deck(
        tuple(Token(TokenId(name), (("value", k),)) for k, name in enumerate("abc", start=1))
    )
    board = Board(3, 2)
    setting = Setting(deck, State(board, dict(zip(deck.by_id, board.storage_cells, strict=False))))
    first = Play.begin(setting).after(0, 0)
    play = first.after(2, 1)
    return RuledExercise(
        board,
        deck,
        meant_rules((RISING, FullRow()), (0.9, 1.0)),
        0.9,
        LearnStatus.LEARNED,
        (RISING, FullRow(), ODD),
        (Alternative((ODD, FullRow()), 0.1),),
        Evidence(
            (demonstration_of(play),),
            (
                Answer(RowQuestion(play), Reply.NO, 1),
                Answer(MoveQuestion(first, 1, 1), Reply.YES),
                Answer(RuleQuestion(ODD), Reply.UNSURE),
            ),
            (Exam("2026-11-22", 10, 9, 5, 5),),
        ),
    )


GOOD: dict[str, Any] = json.loads(encode_exercise(small()))


changed = partial(exercise_files.changed, GOOD)
without = partial(exercise_files.without, GOOD)


# ------------------------------------------------------------------ round trip


@given(ruled_exercises())
def test_an_exercise_that_is_written_and_read_is_the_same(exercise: RuledExercise) -> None:
    written = encode_exercise(exercise)
    assert decode_exercise(written.encode()) == exercise
    VALIDATOR.validate(json.loads(written))


def test_a_file_has_a_rule_a_line() -> None:
    lines = encode_exercise(small()).splitlines()
    assert lines[0] == '{"format": "maestra.exercise/1",'
    assert lines[lines.index(' "rules": [') + 1] == (
        '  {"id": "increasing-value", "rule": {"form": "ordered", "attribute": "value", '
        '"direction": "rising", "strict": true, "line": "row"}, "confidence": 0.9},'
    )
    assert ' "safe": [' in lines
    assert '"exams": [' in lines[-3]
    assert lines[-1] == " ]}}"


def test_what_need_not_be_there_may_be_left_out() -> None:
    short = json.loads(changed())
    del short["alternatives"], short["evidence"]
    short["rules"][0]["rule"] = {"form": "ordered", "attribute": "value", "direction": "rising"}
    read = decode_exercise(json.dumps(short).encode())
    assert read == replace(small(), alternatives=(), evidence=Evidence())


def test_plays_from_one_start_share_what_is_known_of_it() -> None:
    read = decode_exercise(changed())
    assert isinstance(read, RuledExercise)
    row, move, _ = (answer.question for answer in read.evidence.answers)
    assert isinstance(row, RowQuestion)
    assert isinstance(move, MoveQuestion)
    assert row.play.setting is move.position.setting


# ------------------------------------------------------------------ bad input

RULE = ("rules", 0, "rule")
SHOWN = ("evidence", "demonstrations", 0)
ROW = ("evidence", "answers", 0)
MOVE = ("evidence", "answers", 1)
MEANT = ("evidence", "answers", 2)
EXAM = ("evidence", "exams", 0)
NO_SUCH_RULE = {"form": "ordered", "attribute": "weight", "direction": "rising"}

WRONG: Sequence[tuple[str, bytes, str]] = [
    ("no kind", without("kind"), 'kind: missing, expected "grounded" or "ruled"'),
    ("another kind", changed((("kind",), "spoken")), 'kind: "spoken", expected "grounded" or'),
    ("a kind that is a number", changed((("kind",), 5)), 'kind: 5, expected "grounded" or'),
    ("an unknown field", changed((("level",), "A")), "level: unknown field, expected one of alt"),
    ("no rules", without("rules"), "rules: missing"),
    ("another status", changed((("status",), "sure")), 'status: "sure", expected one of learned'),
    ("a goal row off the board", changed((("board", "goal_row"), 4)), "board.goal_row: 4"),
    ("a deck with nothing", changed((("tokens",), {})), "tokens: no token"),
    ("a confidence above 1", changed((("confidence",), 2)), "confidence: 2.0, expected a number"),
    ("a confidence in words", changed((("confidence",), "high")), 'confidence: "high", expected'),
    ("a confidence of yes", changed((("confidence",), True)), "confidence: true, expected a num"),
    ("rules that are text", changed((("rules",), "odd")), 'rules: "odd", expected a list'),
    ("a rule that is a number", changed((RULE, 5)), "rules[0].rule: 5, expected"),
    ("a rule of no form", changed((RULE, {})), "rules[0].rule.form: missing"),
    (
        "a rule with a wrong part",
        changed(((*RULE, "direction"), "up")),
        'rules[0].rule.direction: "up", expected',
    ),
    (
        "a rule that the deck cannot be asked for",
        changed((RULE, NO_SUCH_RULE)),
        "rules[0].rule.weight: no token shows it, expected a deck with this attribute",
    ),
    (
        "a safe rule that the deck cannot be asked for",
        changed((("safe", 1), NO_SUCH_RULE)),
        "safe[1].weight: no token shows it",
    ),
    (
        "an alternative that the deck cannot be asked for",
        changed((("alternatives", 0, "rules", 0), NO_SUCH_RULE)),
        "alternatives[0].rules[0].weight: no token shows it",
    ),
    ("a safe rule that is none", changed((("safe", 0), "odd")), 'safe[0]: "odd", expected'),
    (
        "an alternative with no rule",
        changed((("alternatives", 0, "rules", 0), {"form": "x"})),
        'alternatives[0].rules[0].form: "x", expected one of',
    ),
    (
        "an alternative of weight 2",
        changed((("alternatives", 0, "weight"), 2)),
        "alternatives[0].weight: 2.0, expected a number from 0 to 1",
    ),
    ("an empty id", changed((("rules", 0, "id"), "")), "rules[0].id: an empty name"),
    (
        "an id twice",
        changed((("rules", 1, "id"), GOOD["rules"][0]["id"])),
        'rules: the id "increasing-value" 2 times, expected each id once',
    ),
    (
        "a rule's confidence below 0",
        changed((("rules", 0, "confidence"), -1)),
        "rules[0].confidence: -1.0, expected a number from 0 to 1",
    ),
    (
        "too many rules",
        changed((("rules",), [GOOD["rules"][0]] * (MAX_RULES + 1))),
        "rules: ",
    ),
    ("an unknown field of evidence", changed((("evidence", "x"), 1)), "evidence.x: unknown field"),
    (
        "a demonstration of another format",
        changed(((*SHOWN, "format"), "maestra.exercise/1")),
        "evidence.demonstrations[0].format: ",
    ),
    (
        "a demonstration with an impossible move",
        changed(((*SHOWN, "moves", 1, "origin"), [3, 2])),
        "evidence.demonstrations[0].moves[1].origin: ",
    ),
    (
        "a demonstration with a move within storage",
        changed(((*SHOWN, "moves", 1, "destination"), [3, 2])),
        "evidence.demonstrations[0].moves[1]: a move from row 3 to row 3, expected",
    ),
    ("a strange reply", changed(((*ROW, "answer"), "so")), "evidence.answers[0].answer: "),
    ("a strange question", changed(((*ROW, "kind"), "so")), "evidence.answers[0].kind: "),
    (
        "a row without its position",
        without(*ROW, "position"),
        "evidence.answers[0].position: missing, expected a field of this name",
    ),
    (
        "a row with a rule",
        changed(((*ROW, "rule"), GOOD["safe"][0])),
        "evidence.answers[0].rule: a field, expected none in a question of kind row",
    ),
    (
        "a position that cannot be",
        changed(((*ROW, "position", "start", "a"), [9, 9])),
        "evidence.answers[0].position.start.a: [9, 9] is off the board",
    ),
    (
        "a wrong cell of another row",
        changed(((*ROW, "wrong"), [2, 1])),
        "evidence.answers[0].wrong: [2, 1], expected a cell of the goal row, 1",
    ),
    (
        "a wrong cell off the row",
        changed(((*ROW, "wrong"), [1, 3])),
        "evidence.answers[0].wrong: [1, 3], expected a cell of the goal row, 1",
    ),
    ("a wrong cell of one", changed(((*ROW, "wrong"), [1])), "evidence.answers[0].wrong: [1]"),
    (
        "a wrong cell of a right row",
        changed(((*ROW, "answer"), "yes")),
        'evidence.answers[0].wrong: 1, expected nothing: only after "no" to a row',
    ),
    (
        "a wrong cell of a move",
        changed(((*MOVE, "wrong"), [1, 1])),
        "evidence.answers[1].wrong: ",
    ),
    (
        "a move of an unknown token",
        changed(((*MOVE, "move", "token"), "z")),
        "evidence.answers[1].move.token: z, expected a token that lies in storage",
    ),
    (
        "a move of a token that was placed",
        changed(((*MOVE, "move", "token"), "a")),
        "evidence.answers[1].move.token: a, expected a token that lies in storage",
    ),
    (
        "a move from elsewhere",
        changed(((*MOVE, "move", "origin"), [3, 2])),
        "evidence.answers[1].move.origin: [3, 2], expected [2, 2], where it lies",
    ),
    *(
        (
            f"a move to {cell}",
            changed(((*MOVE, "move", "destination"), cell)),
            "evidence.answers[1].move.destination: ",
        )
        for cell in ([1, 1], [2, 2], [1, 3], [1, 0])
    ),
    ("a question about no rule", changed(((*MEANT, "rule"), 5)), "evidence.answers[2].rule: 5"),
    (
        "an exam that more agreed to than there was",
        changed(((*EXAM, "agreed"), 11)),
        "evidence.exams[0].agreed: 11, expected 0 to 10, how many were shown",
    ),
    (
        "an exam with more near misses found than there were",
        changed(((*EXAM, "near_misses_agreed"), 6)),
        "evidence.exams[0].near_misses_agreed: 6, expected 0 to 5",
    ),
    ("an exam of half a play", changed(((*EXAM, "plays"), 0.5)), "exams[0].plays: 0.5, expected"),
    ("an exam of no day", changed(((*EXAM, "date"), "")), "evidence.exams[0].date: an empty"),
]


@pytest.mark.parametrize(
    ("content", "told"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG]
)
def test_a_bad_exercise_is_refused_with_the_path_of_what_is_wrong(
    content: bytes, told: str
) -> None:
    line = refusal(content)
    assert told in line
    assert line.isprintable()


def test_every_fault_is_told_at_once() -> None:
    line = refusal(
        changed(
            ((*RULE, "direction"), "up"),
            (("safe", 0), {}),
            ((*EXAM, "agreed"), 11),
            (("board", "goal_row"), 9),
            (("tokens", "a", "value"), "x"),
        )
    )
    places = ("board.goal_row", "tokens.", "rules[0].rule.direction", "safe[0].form", "agreed")
    assert all(place in line for place in places)


def paths(value: Any, at: Path = ()) -> list[Path]:  # noqa: ANN401 - JSON
    """Every field and element of a JSON value."""
    parts: list[tuple[str | int, Any]] = []
    if isinstance(value, dict):
        parts = list(cast("dict[str | int, Any]", value).items())
    if isinstance(value, list):
        parts = list(enumerate(cast("Sequence[object]", value)))
    return [at, *(path for step, one in parts for path in paths(one, (*at, step)))]


PATHS = [path for path in paths(GOOD) if path]
STRANGE = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-3, 10**20)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(max_size=4)
    | st.sampled_from(["row", "move", "rule", "ruled", "full-row", "yes"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner),
    max_leaves=4,
)


@given(st.lists(st.tuples(st.sampled_from(PATHS), STRANGE), min_size=1, max_size=3))
def test_no_change_of_a_field_raises_anything_but_a_format_error(
    changes: list[tuple[Path, object]],
) -> None:
    try:
        content = changed(*changes)
    except (KeyError, IndexError, TypeError):
        return  # an earlier change took the place of this one away
    try:
        exercise = decode_exercise(content)
    except FormatError as error:
        told = str(error)
    else:
        told = ""
        assert decode_exercise(encode_exercise(exercise).encode()) == exercise
        VALIDATOR.validate(json.loads(content))
    assert told.isprintable()


# ------------------------------------------------------------------ what cannot be built


def test_an_exercise_of_too_much_cannot_be_built() -> None:
    much = (RISING,) * (MAX_RULES + 1)
    faults: dict[str, Callable[[], RuledExercise]] = {
        "rules": lambda: replace(
            small(), rules=tuple(MeantRule(str(k), RISING, 1) for k in range(MAX_RULES + 1))
        ),
        "safe": lambda: replace(small(), safe=(RISING,) * (MAX_SAFE_RULES + 1)),
        "alternatives[0].rules": lambda: replace(small(), alternatives=(Alternative(much, 0.1),)),
        "alternatives": lambda: replace(
            small(), alternatives=(Alternative((), 0),) * (MAX_ALTERNATIVES + 1)
        ),
    }
    for where, build in faults.items():
        with pytest.raises(InvalidError) as caught:
            build()
        assert [fault.where for fault in caught.value.faults] == [where]


def test_ids_are_made_of_what_the_rules_say_and_differ() -> None:
    rules = meant_rules((RISING, ODD, RISING), (1, 0.5, 0))
    assert [one.id for one in rules] == [
        "increasing-value",
        "only-odd-value",
        "increasing-value-2",
    ]
    assert [one.confidence for one in rules] == [1, 0.5, 0]
    assert replace(small(), rules=rules).conjunction == (RISING, ODD, RISING)


def test_a_question_about_a_move_that_no_board_could_make_cannot_be_asked() -> None:
    play = Play.begin(Setting(small().deck, demonstration_start()))
    for token, cell in ((3, 0), (-1, 0), (0, 2), (0, -1)):
        with pytest.raises(InvalidError):
            MoveQuestion(play, token, cell)


def demonstration_start() -> State:
    return small().evidence.demonstrations[0].start


def test_a_wrong_cell_off_the_row_cannot_be_answered() -> None:
    play = Play.begin(Setting(small().deck, demonstration_start()))
    assert Answer(RowQuestion(play), Reply.NO, 1).wrong == 1
    for wrong in (-1, 2):
        with pytest.raises(InvalidError):
            Answer(RowQuestion(play), Reply.NO, wrong)

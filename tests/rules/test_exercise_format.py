import json
from collections.abc import Sequence
from functools import partial
from typing import Any, cast

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.json_lines import FormatError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner, learn_grounded
from maestra.rules import exercise_format
from maestra.rules.exercise import GroundedExercise
from maestra.rules.exercise_format import ExerciseJson, decode_exercise, encode_exercise
from maestra.rules.judging import Judge
from maestra.rules.strips.vocabulary import Level
from scripts.write_schemas import schemas
from tests.rules import exercise_files
from tests.rules.ascending import exercise_of, paper_lesson
from tests.rules.exercise_files import Path, refusal
from tests.rules.lessons import Lesson, lessons
from tests.rules.positions import positions_of

VALIDATOR: Any = Draft202012Validator(json.loads(schemas()["exercise-1.schema.json"]))


def learn(lesson: Lesson) -> GroundedExercise:
    learner = GroundedLearner(lesson.vocabulary)
    for demonstration in lesson.demonstrations:
        learner.show(demonstration)
    return learner.exercise()


def small() -> GroundedExercise:
    """Two plays with two tokens on a board with two columns: B, so that it has all literals."""
    deck = Deck(
        (
            Token(TokenId("a"), (("value", 1),)),
            Token(TokenId("b"), (("value", 2),)),
        )
    )
    board = Board(2, 2)
    start = State(board, dict(zip((TokenId("a"), TokenId("b")), board.storage_cells, strict=True)))
    moves = tuple(
        Move(token, start.cells[token], to)
        for token, to in zip(start.cells, board.goal_cells, strict=True)
    )
    plays = [Demonstration(deck, start, moves), Demonstration(deck, start, moves[:1])]
    return learn_grounded(plays, Level.B, ["less-than", "odd", "destination", "same-column"])


GOOD: dict[str, Any] = json.loads(encode_exercise(small()))


changed = partial(exercise_files.changed, GOOD)
without = partial(exercise_files.without, GOOD)


# ------------------------------------------------------------------ round trip


@given(lessons())
def test_an_exercise_that_is_written_and_read_is_the_same(lesson: Lesson) -> None:
    exercise = learn(lesson)
    assert decode_exercise(encode_exercise(exercise).encode()) == exercise


@given(lessons())
def test_an_exercise_that_was_read_judges_alike(lesson: Lesson) -> None:
    exercise = learn(lesson)
    read = decode_exercise(encode_exercise(exercise).encode())
    judges = [Judge(one, lesson.deck) for one in (exercise, read)]
    for play in lesson.demonstrations:
        one, other = (judge.judge(play.start, play.moves) for judge in judges)
        assert one == other
        for position in positions_of(play):
            first, second = (set(judge.allowed_moves(position)) for judge in judges)
            assert first == second


@given(lessons())
def test_every_exercise_is_written_as_the_schema_says(lesson: Lesson) -> None:
    VALIDATOR.validate(json.loads(encode_exercise(learn(lesson))))


def test_the_papers_exercise_has_an_action_a_line() -> None:
    exercise = exercise_of(paper_lesson())
    written = encode_exercise(exercise)
    lines = [line for line in written.splitlines() if '"precondition"' in line]
    assert len(lines) == len(exercise.model.preconditions) == 30
    first = json.loads(lines[0].strip().removesuffix(","))
    assert first["shown"] == {"value": 19}
    assert (first["step"], first["seen"]) == (1, 2)
    assert {"feature": "destination", "value": [1, 1]} in first["precondition"]
    assert written.endswith(" ]}\n")


def test_a_letter_with_an_accent_is_written_as_it_is() -> None:
    deck = Deck((Token(TokenId("a"), (("letter", "ñ"),)),))
    state = State(Board(2, 1), {TokenId("a"): Cell(Row(2), Column(1))})
    exercise = learn_grounded([Demonstration(deck, state, ())])
    assert '"letter": "ñ"' in encode_exercise(exercise)


def test_the_order_of_fields_and_a_number_with_a_fraction_do_not_matter() -> None:
    turned = dict(reversed(GOOD.items())) | {"tokens": {"b": {"value": 2.0}, "a": {"value": 1}}}
    assert decode_exercise(json.dumps(turned, indent=3).encode()) == small()


# ------------------------------------------------------------------ bad input

FIRST = ("actions", 0)
LITERAL = (*FIRST, "precondition", 0)
DELETION = (*FIRST, "deletions", 0)
NOT_ONE = (
    "not one of the exercise's literals, expected a literal over its own features, cells and "
    "tokens, at level B"
)

WRONG: Sequence[tuple[str, bytes, str]] = [
    ("not JSON", b"{", "not JSON"),
    ("a list", b"[]", "expected a JSON object"),
    ("another format", changed((("format",), "maestra.demonstration/1")), "format: "),
    ("a newer version", changed((("format",), "maestra.exercise/2")), "needs a newer Maestra"),
    ("no format", without("format"), "format: missing"),
    ("an unknown field", changed((("colour",), 1)), "colour: unknown field, expected one of"),
    ("a missing field", without("actions"), "actions: missing"),
    (
        "another kind",
        changed((("kind",), "rules")),
        'kind: "rules", expected "grounded" or "ruled"',
    ),
    ("another level", changed((("level",), "D")), 'level: "D", expected A, B or C'),
    ("a board too large", changed((("board", "rows"), 101)), "board.rows: 101, expected"),
    ("a goal row off the board", changed((("board", "goal_row"), 3)), "board.goal_row: 3"),
    ("no token", changed((("tokens",), {})), "tokens: no token"),
    ("a token of lists", changed((("tokens", "a", "value"), [1])), "tokens.a.value: [1]"),
    ("mixed values", changed((("tokens", "b", "value"), "x")), 'tokens.b.value: "x"'),
    (
        "an unknown feature",
        changed((("features", 2), "od:value")),
        "features[2].od:value: unk",
    ),
    ("a feature twice", changed((("features", 2), "odd:value")), 'features[3]: "odd:value" twice'),
    ("a feature of no attribute", changed((("features", 2), "odd")), 'features[2]: "odd", '),
    ("a feature that is a number", changed((("features", 2), 7)), "features[2]: 7"),
    ("no length", changed((("lengths",), [])), "lengths: nothing, expected at least one"),
    ("a length below 0", changed((("lengths", 0), -1)), "lengths[0]: -1, expected a whole"),
    ("a length too large", changed((("lengths", 0), 100_001)), "lengths[0]: 100001"),
    ("a length of a half", changed((("lengths", 0), 1.5)), "lengths[0]: 1.5"),
    ("no demonstration", changed((("demonstrations",), 0)), "demonstrations: 0, expected a"),
    ("too few", changed((("demonstrations",), 1)), "actions[0].seen: 2, expected at most 1"),
    ("an action that is none", changed((FIRST, 7)), "actions[0]: 7, expected a JSON object"),
    (
        "an unknown field of an action",
        changed(((*FIRST, "name"), "x")),
        "actions[0].name: unknown field, expected one of deletions, precondition, seen, shown",
    ),
    (
        "an action of an unknown token",
        changed(((*FIRST, "shown", "value"), 3)),
        'actions[0].shown: {"value": 3}, expected what a token of the exercise shows',
    ),
    (
        "an action that shows a list",
        changed(((*FIRST, "shown", "value"), [3])),
        "actions[0].shown.value: [3], expected a number or a string",
    ),
    ("an action that shows a yes", changed(((*FIRST, "shown", "value"), True)), "shown.value: tr"),
    ("step 0", changed(((*FIRST, "step"), 0)), "actions[0].step: 0, expected a whole number"),
    (
        "a step after the longest play",
        changed(((*FIRST, "step"), 3)),
        "actions[0].step: 3, expected at most 2, the moves of the longest play",
    ),
    (
        "an action twice",
        changed((("actions", 1), GOOD["actions"][0])),
        "actions[1]: move-v1-t1 twice, expected each action once",
    ),
    ("never seen", changed(((*FIRST, "seen"), 0)), "actions[0].seen: 0, expected a whole"),
    (
        "more deletions than seen",
        changed(
            ((*FIRST, "seen"), 1),
            ((*FIRST, "deletions"), [{"demonstration": n, "literals": "1"} for n in (1, 2)]),
        ),
        "actions[0].deletions: 2 deletions, expected at most 1, `seen`",
    ),
    (
        "a deletion by a demonstration that was not shown",
        changed(((*DELETION, "demonstration"), 3)),
        "actions[0].deletions[0].demonstration: 3, expected a later demonstration than before",
    ),
    (
        "deletions out of order",
        changed(
            ((*FIRST, "deletions"), [{"demonstration": 1, "literals": "1"}] * 2),
        ),
        "actions[0].deletions[1].demonstration: 1, expected a later demonstration than before",
    ),
    *(
        (
            f"deleted literals {bits}",
            changed(((*DELETION, "literals"), bits)),
            "actions[0].deletions[0].literals: ",
        )
        for bits in ("", "0", "0f", "xyz", "F", "0x1", "-1", 5)
    ),
    *(
        (
            f"deletions that do not add up: {bits}",
            changed(((*DELETION, "literals"), bits)),
            "actions[0]: its precondition and deletions do not add up",
        )
        for bits in ("1", "f" * 40)
    ),
    (
        "a precondition that says too little",
        without(*LITERAL),
        "actions[0]: its precondition and deletions do not add up",
    ),
    (
        "a literal twice",
        changed((LITERAL, GOOD["actions"][0]["precondition"][1])),
        "actions[0].precondition[1]: a literal twice, expected each once",
    ),
    (
        "a literal of nothing",
        changed((LITERAL, {})),
        "precondition[0]: no field, expected",
    ),
    (
        "a literal of fields that do not go together",
        changed((LITERAL, {"cell": [1, 1], "value": 1})),
        "precondition[0]: cell and value, expected feature and value, or cell and relation",
    ),
    (
        "a literal with an unknown field",
        changed(((*LITERAL, "colour"), 1)),
        "precondition[0].colour: unknown field",
    ),
    (
        "a literal that is text",
        changed((LITERAL, "odd")),
        'precondition[0]: "odd", expected',
    ),
    (
        "a cell of three",
        changed((LITERAL, {"cell": [1, 1, 1], "feature": "odd:value"})),
        ".cell: ",
    ),
    *(
        (
            f"a literal that the exercise lacks: {literal}",
            changed((LITERAL, literal)),
            f"actions[0].precondition[0]: {NOT_ONE}",
        )
        for literal in (
            {"feature": "destination", "value": [1, 3]},
            {"feature": "destination", "value": 1},
            {"feature": "same-column", "value": False},
            {"feature": "same-column", "value": 1},
            {"feature": "origin", "value": [1, 1]},
            {"feature": "odd:value", "value": True},
            {"feature": "", "value": True},
            {"cell": [2, 1], "feature": "odd:value"},
            {"cell": [1, 1], "feature": "even:value"},
            {"cell": [1, 1], "feature": "less-than:value"},
            {"cell": [1, 1], "relation": "odd:value", "converse": False},
            {"cell": [1, 1], "relation": "same:value", "converse": False},
            {"cell": [1, 1], "shown": {"value": 3}},
            {"cell": [0, 0], "shown": {"value": 1}},
        )
    ),
    (
        "a literal that asks for nonsense",
        changed((LITERAL, {"feature": "destination", "value": "x"})),
        'precondition[0].value: "x", expected true, a whole number or a cell, [row, column]',
    ),
    (
        "a literal with a null",
        changed((LITERAL, {"feature": None, "value": True})),
        "precondition[0].feature: null",
    ),
]


@pytest.mark.parametrize(
    ("content", "told"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG]
)
def test_a_bad_exercise_is_refused_with_the_path_of_what_is_wrong(
    content: bytes, told: str
) -> None:
    assert told in refusal(content)


def test_every_fault_is_told_at_once() -> None:
    wrong = changed(
        ((*FIRST, "step"), 9), (("actions", 1, "seen"), 9), ((*LITERAL, "value"), [9, 9])
    )
    line = refusal(wrong)
    assert "actions[0].step" in line
    assert "actions[0].precondition[0]" in line
    assert "actions[1].seen" in line
    both = refusal(changed((("board", "goal_row"), 9), (("tokens", "b", "value"), "x")))
    assert "board.goal_row" in both
    assert "tokens.b.value" in both


def test_each_kind_of_literal_is_read() -> None:
    kinds = {
        tuple(sorted(literal)) for action in GOOD["actions"] for literal in action["precondition"]
    }
    assert kinds == {
        ("feature", "value"),
        ("cell", "converse", "relation"),
        ("cell", "feature"),
        ("cell", "shown"),
    }


def test_a_file_that_is_too_large_is_refused_unread(monkeypatch: pytest.MonkeyPatch) -> None:
    content = changed()
    monkeypatch.setattr(exercise_format, "MAX_EXERCISE_BYTES", len(content))
    assert decode_exercise(content) == small()
    monkeypatch.setattr(exercise_format, "MAX_EXERCISE_BYTES", 2**20)
    assert refusal(b" " * (2**20 + 1)) == "a file larger than 1 MB, expected an exercise"


def read_or_refuse(content: bytes) -> None:
    """Read what can be read, which must survive a round trip; anything else is one line."""
    try:
        exercise = decode_exercise(content)
    except FormatError as error:
        told = str(error)
    else:
        told = ""
        assert decode_exercise(encode_exercise(exercise).encode()) == exercise
    assert told.isprintable()


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
    | st.sampled_from(["odd:value", "is-1:value", "less-than:value", "C", "1", "ff"]),
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
    read_or_refuse(content)


@given(st.data())
def test_no_change_of_a_byte_raises_anything_but_a_format_error(data: st.DataObject) -> None:
    content = bytearray(changed())
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(content) - 1))
        piece = data.draw(st.binary(max_size=3))
        content[at : at + data.draw(st.integers(0, 3))] = piece
    read_or_refuse(bytes(content))


# ------------------------------------------------------------------ the schema


@pytest.mark.parametrize(
    "literal",
    [{}, {"cell": [1, 1], "value": 1}, {"feature": "odd", "value": 1, "cell": [1, 1]}, {"x": 1}],
)
def test_fields_of_a_literal_that_do_not_go_together_are_refused_by_the_schema_too(
    literal: object,
) -> None:
    assert not VALIDATOR.is_valid(json.loads(changed((LITERAL, literal))))
    assert VALIDATOR.is_valid(json.loads(changed()))


def test_the_schema_names_no_default_for_the_fields_of_a_literal() -> None:
    literal = ExerciseJson.model_json_schema()["$defs"]["LiteralJson"]
    assert all("default" not in field for field in literal["properties"].values())
    assert len(literal["oneOf"]) == 4

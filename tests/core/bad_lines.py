"""Lines that are no demonstration, each with what a person reads about it."""

import json
from collections.abc import Mapping, Sequence
from copy import deepcopy
from typing import Any, Final

from maestra.core.formats import DEMONSTRATION_FORMAT

Path = tuple[str | int, ...]

GOOD: Mapping[str, object] = {
    "format": DEMONSTRATION_FORMAT,
    "board": {"rows": 4, "columns": 5, "goal_row": 1},
    "tokens": {"04A3B2": {"value": 19}, "04A3B3": {"value": 23, "colour": "red"}},
    "start": {"04A3B2": [2, 1], "04A3B3": [3, 4]},
    "moves": [
        {"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]},
        {"token": "04A3B3", "origin": [3, 4], "destination": [1, 2]},
    ],
}
LINE = json.dumps(GOOD).encode()


def changed(*changes: tuple[Path, object], line: Mapping[str, object] = GOOD) -> bytes:
    """The good line with some fields changed."""
    fields: Any = deepcopy(dict(line))
    for path, value in changes:
        within = fields
        for step in path[:-1]:
            within = within[step]
        within[path[-1]] = value
    return json.dumps(fields).encode()


def without(name: str) -> bytes:
    return json.dumps({key: value for key, value in GOOD.items() if key != name}).encode()


WRONG_SHAPE: Final[Sequence[tuple[str, bytes, str]]] = [
    (
        "a start off the board",
        changed((("start", "04A3B3"), [0, -4])),
        "start.04A3B3: [0, -4] is off the board, expected row 1 to 4 and column 1 to 5",
    ),
    (
        "an unknown field",
        changed((("colour",), "red")),
        (
            "colour: unknown field, expected one of board, cycles, format, label, lexicon, moves, "
            "orders, relations, source, start, times_ms, tokens"
        ),
    ),
    (
        "an unknown field of the board",
        changed((("board", "cols"), 5)),
        "board.cols: unknown field, expected one of columns, goal_row, rows",
    ),
    (
        "an unknown field of a move",
        changed((("moves", 1, "orgin"), [3, 4])),
        "moves[1].orgin: unknown field, expected one of destination, origin, token",
    ),
    ("no board", without("board"), "board: missing, expected a field of this name"),
    ("no tokens", without("tokens"), "tokens: missing, expected a field of this name"),
    (
        "a move without destination",
        changed((("moves", 1), {"token": "04A3B3", "origin": [3, 4]})),
        "moves[1].destination: missing, expected a field of this name",
    ),
    ("the board a number", changed((("board",), 20)), "board: 20, expected a JSON object"),
    ("tokens a list", changed((("tokens",), [19])), "tokens: [19], expected a JSON object"),
    (
        "a token a number",
        changed((("tokens", "04A3B2"), 19)),
        "tokens.04A3B2: 19, expected a JSON object",
    ),
    ("moves an object", changed((("moves",), {})), "moves: {}, expected a list"),
    ("a move a list", changed((("moves", 0), [1])), "moves[0]: [1], expected a JSON object"),
    (
        "no rows",
        changed((("board", "rows"), 0)),
        "board.rows: 0, expected a whole number from 1 to 100",
    ),
    (
        "rows in words",
        changed((("board", "rows"), "4")),
        'board.rows: "4", expected a whole number from 1 to 100',
    ),
    (
        "a cell by name",
        changed((("start", "04A3B2"), "l21")),
        'start.04A3B2: "l21", expected a cell, [row, column]',
    ),
    (
        "half a cell",
        changed((("moves", 0, "origin"), [2])),
        "moves[0].origin: [2], expected a cell, [row, column]",
    ),
    (
        "a cell and a half",
        changed((("start", "04A3B2"), [2.5, 1])),
        "start.04A3B2: [2.5, 1], expected a cell, [row, column]",
    ),
    (
        "an empty id",
        changed((("tokens", ""), {})),
        'tokens.: "", expected text of 1 to 1000 characters without control characters',
    ),
    (
        "an id that would move the cursor",
        changed((("moves", 0, "token"), "\x1b[2J")),
        (
            r'moves[0].token: "\u001b[2J", '
            "expected text of 1 to 1000 characters without control characters"
        ),
    ),
    ("no tokens in tokens", changed((("tokens",), {})), "tokens: no token, expected at least one"),
    (
        "a value that is a list",
        changed((("tokens", "04A3B2", "value"), [19])),
        "tokens.04A3B2.value: [19], expected a number or a string",
    ),
    (
        "a value that is true",
        changed((("tokens", "04A3B2", "value"), True)),
        "tokens.04A3B2.value: true, expected a number or a string",
    ),
    (
        "a value beyond 64 bits",
        changed((("tokens", "04A3B2", "value"), 10**15 + 1)),
        "tokens.04A3B2.value: 1000000000000001, expected a number from -10^15 to 10^15",
    ),
    (
        "an order of numbers",
        changed((("cycles",), {"value": [19, 23]})),
        ("cycles.value[0]: 19, expected text of 1 to 1000 characters without control characters"),
    ),
    (
        "a relation of three",
        changed((("relations",), {"partner": [["cup", "saucer", "spoon"]]})),
        'relations.partner[0]: ["cup", "saucer", "spoon"], expected a pair of names',
    ),
    (
        "a lexicon in one string",
        changed((("lexicon",), "CURIE")),
        'lexicon: "CURIE", expected a list',
    ),
    (
        "a label that is a number",
        changed((("label",), 1)),
        "label: 1, expected text of at most 1000 characters without control characters",
    ),
    (
        "a time before the start",
        changed((("times_ms",), [-1, 0])),
        "times_ms[0]: -1, expected a whole number of milliseconds from 0",
    ),
    ("only bad tokens", changed((("tokens",), {"T": 1})), "tokens.T: 1, expected a JSON object"),
    (
        "an order of nothing",
        changed((("orders",), {"size": []})),
        "orders.size: no value, expected the values in their order",
    ),
    (
        "a source of another kind",
        changed((("source",), "dream")),
        'source: "dream", expected one of board, file, simulated',
    ),
]
"""What the JSON Schema refuses too: what it is, the line, the fault in words."""

WRONG_PLAY: Final[Sequence[tuple[str, bytes, str]]] = [
    (
        "two tokens on a cell",
        changed((("start", "04A3B3"), [2, 1])),
        "start.04A3B3: [2, 1] is taken, expected a cell of its own (04A3B2 lies there)",
    ),
    (
        "a token moved from where it is not",
        changed((("moves", 0, "origin"), [2, 2])),
        "moves[0].origin: 04A3B2 is not on [2, 2], expected [2, 1], where it lies",
    ),
    (
        "a move to an occupied cell",
        changed((("moves", 1, "destination"), [1, 1])),
        "moves[1].destination: [1, 1] is taken by 04A3B2, expected an empty cell",
    ),
    (
        "a move off the board",
        changed((("moves", 1, "destination"), [1, 6])),
        "moves[1].destination: [1, 6] is off the board, expected row 1 to 4 and column 1 to 5",
    ),
    (
        "an unknown token is moved",
        changed((("moves", 0, "token"), "04A3B9")),
        "moves[0].token: unknown token 04A3B9, expected a token of the deck",
    ),
    (
        "an unknown token lies on the board",
        changed((("start", "04A3B9"), [4, 4])),
        "start.04A3B9: unknown token, expected a token of the deck",
    ),
    (
        "a token lies nowhere",
        changed((("start",), {"04A3B2": [2, 1]}), (("moves",), [])),
        "start.04A3B3: missing, expected a cell for each token",
    ),
    (
        "a goal row below the board",
        changed((("board", "goal_row"), 5)),
        "board.goal_row: 5, expected a row of the board, 1 to 4",
    ),
    (
        "numbers and strings under one name",
        changed((("tokens", "04A3B3", "value"), "C")),
        'tokens.04A3B3.value: "C", expected a number as on the other tokens',
    ),
    (
        "an order without a token's value",
        changed((("orders",), {"colour": ["blue", "green"]})),
        'tokens.04A3B3.colour: "red", expected a value of orders.colour',
    ),
    (
        "a time too few",
        changed((("times_ms",), [0])),
        "times_ms: length 1, expected 2, one for each move",
    ),
    (
        "times that fall",
        changed((("times_ms",), [5, 4])),
        (
            "times_ms: times that run backwards or too far, "
            "expected times that rise from 0, up to 10^15"
        ),
    ),
]
"""What only the reader can refuse, for a field contradicts another."""

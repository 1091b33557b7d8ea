"""Decks that are ready, and decks made from what a caregiver writes in a form."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from enum import Enum
from itertools import product
from typing import Final, TypeAlias, assert_never

from maestra.core.board import Board, Row
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import LETTER, MAX_NUMBER, Deck, Token, TokenId, Value
from maestra.rules.paper import LETTER_DECK, NUMBER_DECK

NUMBER: Final = "value"
WORD: Final = "word"
KIND: Final = "category"
COLOUR: Final = "colour"
SHAPE: Final = "shape"
PICTURE: Final = "picture"

LEAST_ROWS: Final = 2
MOST_ROWS: Final = 8
MOST_COLUMNS: Final = 10
"""Sides of a board that fits a screen with cells that a finger can hit."""
MOST_TOKENS: Final = (MOST_ROWS - 1) * MOST_COLUMNS
"""So many storage cells has the largest board."""
MOST_LETTERS: Final = 40
"""Of what stands on a token: more could not be read."""
MOST_PROPERTIES: Final = 6
"""Columns of the table of tokens: more are not overlooked."""

SPARE_ROWS: Final = 2
"""Empty lines at the end of the table, for more tokens."""

COLOURS: Final = ("red", "blue", "green", "yellow")
Say: TypeAlias = Callable[[str], str]
"""A word in the caregiver's language."""


class Unfit(Enum):
    """Why something cannot be on tokens, for a sentence in the caregiver's language."""

    NO_NUMBER = "no-number"
    TOO_LONG = "too-long"
    TOO_MANY_TOKENS = "too-many-tokens"
    TOO_MANY_PROPERTIES = "too-many-properties"
    TOO_MANY_FILES = "too-many-files"
    """Or none."""
    LARGE_FILE = "large-file"
    NO_PICTURE = "no-picture"
    LARGE_PICTURE = "large-picture"


class UnfitError(InvalidError):
    """What a caregiver typed or sent cannot be on tokens."""

    def __init__(self, why: Unfit, fault: Fault) -> None:
        """The one fault, and its kind."""
        super().__init__([fault])
        self.why = why


class Ready(Enum):
    """What can be chosen with one click."""

    NUMBERS = "numbers"
    LETTERS = "letters"
    WORDS = "words"
    SHAPES = "shapes"


def ready_deck(which: Ready, say: Say) -> Deck:
    """A deck to begin with at once."""
    match which:
        case Ready.NUMBERS:
            return NUMBER_DECK
        case Ready.LETTERS:
            return LETTER_DECK
        case Ready.WORDS:
            return words_deck(_words(say))
        case Ready.SHAPES:
            return shapes_deck(COLOURS, shapes(say)[:3])
        case _:
            assert_never(which)


def shapes(say: Say) -> tuple[str, ...]:
    """The shapes that tokens are drawn in."""
    return (
        say("circle"),
        say("square"),
        say("triangle"),
        say("diamond"),
        say("star"),
        say("hexagon"),
        say("cross"),
    )


def _words(say: Say) -> str:
    fruit = (say("apple"), say("pear"), say("plum"), say("grape"), say("cherry"))
    animals = (say("dog"), say("cat"), say("horse"), say("cow"), say("sheep"))
    lines = [f"{one}, {say('fruit')}" for one in fruit]
    return "\n".join([*lines, *(f"{one}, {say('animal')}" for one in animals)])


# ---------------------------------------------------------------- what a caregiver writes


def numbers_deck(first: int, last: int, step: int) -> Deck:
    """The numbers from first to last.

    Raises:
        InvalidError: too many.
    """
    step = max(1, abs(step))
    numbers = range(min(first, last), max(first, last) + 1, step)
    if len(numbers) > MOST_TOKENS:
        raise _too_many("numbers", len(numbers))
    return _deck([[(NUMBER, number)] for number in numbers])


def listed_deck(text: str) -> Deck:
    """The numbers that are listed, apart by commas or spaces.

    Raises:
        InvalidError: something that is no number, or too many, or none.
    """
    found = [one for one in re.split(r"[\s,;]+", text) if one]
    wrong = [one for one in found if _as_number(one) is None]
    if wrong:
        raise UnfitError(Unfit.NO_NUMBER, Fault("numbers", wrong[0], "a number"))
    return _deck([[(NUMBER, _as_number(one) or 0)] for one in found])


def letters_deck(text: str) -> Deck:
    """The letters, each a token; what is no letter is passed over.

    Raises:
        InvalidError: none, or too many.
    """
    return _deck([[(LETTER, one.upper())] for one in text if one.isalpha()])


def words_deck(text: str) -> Deck:
    """A word a line; after a comma, what kind of thing it is.

    Raises:
        InvalidError: none, too many, or too long.
    """
    tokens: list[list[tuple[str, Value]]] = []
    for line in filter(str.strip, text.splitlines()):
        word, _, kind = (part.strip() for part in line.partition(","))
        shown: list[tuple[str, Value]] = [(WORD, word)] if word else []
        tokens.append([*shown, (KIND, kind)] if kind else shown)
    return _deck([one for one in tokens if one])


def shapes_deck(colours: Sequence[str], shown: Sequence[str]) -> Deck:
    """Each colour in each shape.

    Raises:
        InvalidError: none, or too many.
    """
    if not shown:
        return _deck([[(COLOUR, one)] for one in colours])
    if not colours:
        return _deck([[(SHAPE, one)] for one in shown])
    return _deck([[(COLOUR, one), (SHAPE, other)] for one, other in product(colours, shown)])


def pictures_deck(names: Sequence[str], before: Sequence[Token] = ()) -> Deck:
    """The tokens with pictures that were there before, and one for each of these names.

    Raises:
        InvalidError: none, too many, or a name that is too long.
    """
    kept = [token.attributes for token in before if token.value(PICTURE) is not None]
    return _deck([*kept, *([(PICTURE, name)] for name in names)])


# ---------------------------------------------------------------- the table of tokens


@dataclass(frozen=True, slots=True)
class Table:
    """All tokens of a deck as a table: one a line, what it shows a column."""

    properties: tuple[str, ...]
    ordered: frozenset[str]
    """Properties whose words are in an order: that in which the table has them."""
    rows: tuple[tuple[str, tuple[str, ...]], ...]
    """Each token's id, and what it shows; empty where it shows nothing."""
    words: tuple[str, ...] = ()
    """Words that letters may spell."""


def table_of(deck: Deck) -> Table:
    """A deck as a table, ordered ones in their order."""
    # What stands in large comes first, what kind of thing it is last.
    names = tuple(sorted(deck.scales, key=lambda name: (name == KIND, name)))
    tokens = sorted(deck.tokens, key=lambda one: _place(deck, one))
    rows = tuple(
        (str(token.id), tuple(_written(token.value(name)) for name in names)) for token in tokens
    )
    return Table(names, frozenset(deck.orders), rows, deck.lexicon)


def deck_of(table: Table) -> Deck:
    """The deck that a table says; empty lines and columns are left out.

    Raises:
        InvalidError: no token, too many tokens or properties, a property twice, too long a text.
    """
    kept = [k for k, name in enumerate(table.properties) if name.strip()]
    names = [table.properties[k].strip() for k in kept]
    if len(names) > MOST_PROPERTIES:
        fault = Fault("properties", f"{len(names)} properties", f"at most {MOST_PROPERTIES}")
        raise UnfitError(Unfit.TOO_MANY_PROPERTIES, fault)
    numeric = {
        name
        for k, name in zip(kept, names, strict=True)
        if all(_as_number(shown[k]) is not None for _, shown in table.rows if shown[k].strip())
    }
    tokens: list[list[tuple[str, Value]]] = []
    for _, shown in table.rows:
        own = [(name, shown[k].strip()) for k, name in zip(kept, names, strict=True)]
        filled = [(name, _value(text, is_number=name in numeric)) for name, text in own if text]
        if filled:
            tokens.append(filled)
    orders = {
        name: tuple(
            dict.fromkeys(text for own in tokens if isinstance(text := dict(own).get(name), str))
        )
        for name in names
        if name in table.ordered and name not in numeric
    }
    return _deck(tokens, {name: order for name, order in orders.items() if order}, table.words)


# ---------------------------------------------------------------- boards


def board_for(deck: Deck, wanted: Board | None = None) -> Board:
    """The board that was wanted, or the paper's, with as many rows more as the tokens need.

    Raises:
        InvalidError: there is none so large.
    """
    board = wanted or Board()
    rows = board.rows
    while (rows - 1) * board.columns < len(deck.tokens):
        rows += 1
    if rows > MOST_ROWS:
        raise _too_many("tokens", len(deck.tokens))
    return Board(rows, board.columns, board.goal_row)


def fit(board: Board) -> Board:
    """The board, if it fits a screen.

    Raises:
        InvalidError: it does not.
    """
    demand_sides(board.rows, board.columns)
    return board


def demand_few(deck: Deck) -> None:
    """Refuse a deck that no board has room for.

    Raises:
        InvalidError: it is one.
    """
    if len(deck.tokens) > MOST_TOKENS:
        raise _too_many("tokens", len(deck.tokens))


def sized(rows: int, columns: int, *, goal_at_the_end: bool) -> Board:
    """A board of this size, its goal row at the patient's side or far from it.

    Raises:
        InvalidError: it would not fit a screen.
    """
    demand_sides(rows, columns)
    return Board(rows, columns, Row(rows if goal_at_the_end else 1))


def demand_sides(rows: int, columns: int) -> None:
    """Refuse a board that would not fit a screen.

    Raises:
        InvalidError: it would not.
    """
    faults = [
        Fault(name, str(side), f"{least} to {most}")
        for name, side, least, most in (
            ("rows", rows, LEAST_ROWS, MOST_ROWS),
            ("columns", columns, 1, MOST_COLUMNS),
        )
        if not least <= side <= most
    ]
    if faults:
        raise InvalidError(faults)


def _deck(
    tokens: Iterable[Sequence[tuple[str, Value]]],
    orders: Mapping[str, tuple[str, ...]] | None = None,
    words: Sequence[str] = (),
) -> Deck:
    """Tokens that show this, each with an id made of it."""
    made: list[Token] = []
    seen: Counter[str] = Counter()
    for shown in tokens:
        for name, value in shown:
            if len(str(value)) > MOST_LETTERS or len(name) > MOST_LETTERS:
                expected = f"at most {MOST_LETTERS} letters"
                raise UnfitError(Unfit.TOO_LONG, Fault("tokens", str(value), expected))
        name = "-".join(str(value) for _, value in shown)
        seen[name] += 1
        mark = "" if seen[name] == 1 else f"-{seen[name]}"
        made.append(Token(TokenId(f"{name}{mark}"), tuple(shown)))
    if len(made) > MOST_TOKENS:
        raise _too_many("tokens", len(made))
    return Deck(tuple(made), orders or {}, lexicon=tuple(words))


def _too_many(where: str, found: int) -> UnfitError:
    fault = Fault(where, f"{found} tokens", f"at most {MOST_TOKENS}")
    return UnfitError(Unfit.TOO_MANY_TOKENS, fault)


def _as_number(text: str) -> Value | None:
    """The number that is written, with a point or a comma; None where there is none."""
    try:
        number = Decimal(text.strip().replace(",", "."))
    except InvalidOperation:
        return None
    if not number.is_finite() or not -MAX_NUMBER <= number <= MAX_NUMBER:
        return None
    return int(number) if number == number.to_integral_value() else number


def _value(text: str, *, is_number: bool) -> Value:
    number = _as_number(text) if is_number else None
    return text if number is None else number


def _written(value: Value | None) -> str:
    return "" if value is None else str(value)


def _place(deck: Deck, token: Token) -> tuple[int, ...]:
    """Where the token stands in the table: by the deck's orders, else as it is."""
    values = ((order, token.value(name)) for name, order in deck.orders.items())
    return tuple(order.index(value) if isinstance(value, str) else -1 for order, value in values)

"""What is said of places of a line and of the tokens there: the parts that rules share."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final, cast

from maestra.language.keys import Key, Predicate
from maestra.language.of_tokens import Tokens, adjective, amount, said_of
from maestra.language.phrases import Count, Degree, Nth, Numeral, Phrase, Say, opposite, say
from maestra.language.wordings import ATTRIBUTE, About, Part, Wording, put
from maestra.rules.fields import Position
from maestra.rules.forms.base import LAST, MIDDLE
from maestra.rules.forms.conditions import At
from maestra.rules.forms.counting import Count as Counted
from maestra.rules.forms.timing import Filling
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import Anything, Extreme, TokenTest


@dataclass(frozen=True, slots=True)
class Along:
    """What a rule goes by."""

    line: Line


@dataclass(frozen=True, slots=True)
class Filled:
    """How the row is filled."""

    filling: Filling


@dataclass(frozen=True, slots=True)
class Spot:
    """A place of a line."""

    position: Position
    line: Line


@dataclass(frozen=True, slots=True)
class Stage:
    """The k-th of a pattern, and what is asked of it."""

    nth: int
    test: TokenTest


@dataclass(frozen=True, slots=True)
class Peak:
    """The most or the least of the row."""

    attribute: str
    extreme: Extreme


@dataclass(frozen=True, slots=True)
class Choice:
    """The most or the least of those left in storage."""

    attribute: str
    extreme: Extreme


def first_said(table: tuple[Wording, ...], thing: object, about: About) -> Say:
    """The phrase by the first line of `table` that can say `thing`."""
    lines = ((wording.says, wording.phrases(thing, about)) for wording in table)
    key, parts = next((key, parts) for key, parts in lines if parts is not None)
    return say(cast("Key", key), **parts)


def _nth(position: int, _: About) -> Phrase | None:
    return Nth(position) if position > 0 else None


def _nth_from_end(position: int, _: About) -> Phrase | None:
    return Nth(-position) if position < 0 else None


_NTH: Final = Part("nth", _nth)
_NTH_BACK: Final = Part("nth", _nth_from_end, lambda number, _: -number)

LINES: Final = (
    put(Key.ALONG_THE_ROW, Along, {"line": Line.ROW}),
    put(Key.IN_TIME, Along, {"line": Line.TIME}),
)
FILLINGS: Final = (
    put(Key.LEFT_TO_RIGHT, Filled, {"filling": Filling.LEFT_TO_RIGHT}),
    put(Key.RIGHT_TO_LEFT, Filled, {"filling": Filling.RIGHT_TO_LEFT}),
    put(Key.ENDS_FIRST, Filled, {"filling": Filling.ENDS_FIRST}),
    put(Key.MIDDLE_FIRST, Filled, {"filling": Filling.MIDDLE_FIRST}),
)
SPOTS: Final = (
    put(Key.MIDDLE_OF_ROW, Spot, {"position": MIDDLE, "line": Line.ROW}),
    put(Key.LAST_OF_ROW, Spot, {"position": LAST, "line": Line.ROW}),
    put(Key.LAST_PLACED, Spot, {"position": LAST, "line": Line.TIME}),
    put(Key.NTH_PLACED, Spot, {"line": Line.TIME}, nth=(_NTH, "position")),
    put(Key.NTH_FROM_RIGHT, Spot, {"line": Line.ROW}, nth=(_NTH_BACK, "position")),
    put(Key.NTH_FROM_LEFT, Spot, {"line": Line.ROW}, nth=(_NTH, "position")),
)

ALONG: Final = (
    Part(
        "line",
        lambda line, about: first_said(LINES, Along(line), about),
        lambda along, _: along.line,
        Line.ROW,
    ),
    "line",
)
PLACE: Final = (
    Part(
        "spot",
        lambda place, about: spot(place[0], place[1], about),
        lambda found, _: (found.position, found.line),
    ),
    "position",
    "line",
)
PLACE_OF_ROW: Final = Part(
    "spot",
    lambda position, about: spot(position, Line.ROW, about),
    lambda found, _: found.position if found.line is Line.ROW else None,
)
TEST: Final = Part("test", lambda test, about: Tokens(about.board, about.deck).passes(test))
AMOUNT: Final = (
    Part(
        "amount",
        lambda pair, _: amount(pair[0], Numeral(pair[1])),
        lambda quantity, _: (quantity.comparison, quantity.number),
    ),
    "comparison",
    "number",
)
WHOLE_AMOUNT: Final = (
    Part(
        "amount",
        lambda pair, _: amount(pair[0], Count(pair[1])),
        lambda quantity, _: (
            (quantity.comparison, quantity.number) if isinstance(quantity.number, int) else None
        ),
    ),
    "comparison",
    "number",
)


def spot(position: Position, line: Line, about: About) -> Say:
    """The token at a place of the line."""
    return first_said(SPOTS, Spot(position, line), about)


STAGES: Final = (
    put(Key.NTH_FREE, Stage, {"test": Anything()}, nth=_NTH),
    put(Key.NTH_DOES, Stage, nth=_NTH, does=(TEST, "test")),
)

_MOST, _LEAST = (adjective(Degree.MOST), "attribute"), (adjective(Degree.LEAST), "attribute")

PEAKS: Final = (
    put(
        Predicate.MOST,
        Peak,
        {"extreme": Extreme.HIGHEST},
        adjective=_MOST,
        attribute=ATTRIBUTE,
    ),
    put(
        Predicate.LEAST,
        Peak,
        {"extreme": Extreme.LOWEST},
        adjective=_LEAST,
        attribute=ATTRIBUTE,
    ),
)
TAKINGS: Final = (
    *(
        put(predicate, Choice, {"attribute": attribute, "extreme": extreme})
        for predicate, attribute, extreme in (
            (Predicate.LEFTMOST, ORIGIN_COLUMN, Extreme.LOWEST),
            (Predicate.RIGHTMOST, ORIGIN_COLUMN, Extreme.HIGHEST),
            (Predicate.TOPMOST, ORIGIN_ROW, Extreme.LOWEST),
            (Predicate.BOTTOMMOST, ORIGIN_ROW, Extreme.HIGHEST),
        )
    ),
    put(
        Predicate.MOST_LEFT,
        Choice,
        {"extreme": Extreme.HIGHEST},
        adjective=_MOST,
        attribute=ATTRIBUTE,
    ),
    put(
        Predicate.LEAST_LEFT,
        Choice,
        {"extreme": Extreme.LOWEST},
        adjective=_LEAST,
        attribute=ATTRIBUTE,
    ),
)


def _peak(fields: tuple[str, Extreme, bool], about: About) -> Phrase:
    attribute, extreme, negated = fields
    said = said_of(PEAKS, Peak(attribute, extreme), about)
    return opposite(said) if negated else said


PEAK: Final = (
    Part("peak", _peak, lambda read, _: (read[0].attribute, read[0].extreme, read[1])),
    "attribute",
    "extreme",
    "negated",
)
CHOICE: Final = (
    Part(
        "choice",
        lambda pair, about: said_of(TAKINGS, Choice(*pair), about),
        lambda read, _: None if read[1] else (read[0].attribute, read[0].extreme),
    ),
    "attribute",
    "extreme",
)

CONDITIONS: Final = (
    put(Key.SUBJECT_DOES, At, subject=PLACE, does=(TEST, "test")),
    put(Key.ROW_HAS_ONE_THAT, Counted, {"number": 1}, amount=WHOLE_AMOUNT, does=(TEST, "test")),
    put(Key.ROW_HAS_MANY_THAT, Counted, amount=WHOLE_AMOUNT, does=(TEST, "test")),
)


def _condition(condition: At | Counted, about: About) -> Phrase | None:
    return first_said(CONDITIONS, condition, about)


CONDITION: Final = Part("condition", _condition)


def number_of_tokens(pair: tuple[Any, int], _: About) -> Phrase | None:
    """How many tokens there are, for a noun to agree with."""
    return Count(pair[1])

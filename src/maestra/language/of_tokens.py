"""What is said of a token: features and tests, as phrases."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from types import MappingProxyType
from typing import Final, cast

from maestra.core.board import Board
from maestra.core.tokens import Deck, Scale, Value
from maestra.language.keys import Key, Predicate
from maestra.language.phrases import (
    Adjective,
    Count,
    Degree,
    Does,
    InRow,
    Joint,
    Kind,
    Numeral,
    Phrase,
    Say,
    Several,
    Things,
    ValueNamed,
    opposite,
    say,
)
from maestra.language.wordings import (
    ATTRIBUTE,
    COUNT,
    ORIGINS,
    About,
    Part,
    Wording,
    put,
)
from maestra.rules.canonical import listed
from maestra.rules.features import TokenFeature
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Extreme,
    Has,
    Not,
    TokenTest,
)


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number, and how another one compares to it."""

    comparison: Comparison
    number: Value


QUANTITIES: Final = tuple(
    put(key, Quantity, {"comparison": comparison}, k=(COUNT, "number"))
    for key, comparison in (
        (Key.EXACTLY, Comparison.EQUAL),
        (Key.AT_LEAST, Comparison.AT_LEAST),
        (Key.AT_MOST, Comparison.AT_MOST),
        (Key.MORE_THAN, Comparison.MORE),
        (Key.FEWER_THAN, Comparison.LESS),
        (Key.NOT_EXACTLY, Comparison.DIFFERENT),
    )
)
"""How many, or how much."""
_QUANTITY_KEYS: Final = MappingProxyType(
    {cast("Comparison", one.fixed["comparison"]): cast("Key", one.says) for one in QUANTITIES}
)


def amount(comparison: Comparison, number: Phrase) -> Say:
    """How many, or how much: at least three."""
    return say(_QUANTITY_KEYS[comparison], k=number)


def adjective(degree: Degree, *, many: bool = False) -> Part:
    """What the greater or lesser of tokens is called under the attribute."""
    called = "things" if many else "thing"
    return Part(
        f"{degree.value}_{called}", lambda attribute, _: Adjective(attribute, degree, many)
    )


def _shown(pair: tuple[str, str], about: About) -> Phrase | None:
    attribute, written = pair
    return ValueNamed(attribute, _typed(attribute, written, about.deck))


def _typed(attribute: str, written: str, deck: Deck) -> Value:
    """The value of the deck that a feature's name writes so."""
    for token in deck.tokens:
        value = token.value(attribute)
        if value is not None and str(value) == written:
            return value
    return written


def _compared_text(pair: tuple[str, Value], _: About) -> Phrase | None:
    attribute, value = pair
    return ValueNamed(attribute, value) if isinstance(value, str) else None


def _compared_number(pair: tuple[Comparison, Value], _: About) -> Phrase | None:
    comparison, value = pair
    return None if isinstance(value, str) else amount(comparison, Numeral(value))


def _storage_row(written: str, about: About) -> Phrase | None:
    return board_row(about.board, int(written)) if written.isdigit() else None


def storage_row_of(row: int, about: About) -> int | None:
    """The storage row that is this row of the board; None for the goal row."""
    goal = about.board.goal_row
    return None if row == goal else row - (row > goal)


def _written_row(row: int, about: About) -> str | None:
    storage = storage_row_of(row, about)
    return None if storage is None else str(storage)


def board_row(board: Board, storage_row: int) -> InRow:
    """A storage row, counted from 1 with the goal row passed over, as a row of the board."""
    return InRow(storage_row + (storage_row >= board.goal_row))


def _as_number(written: str) -> Value:
    return Decimal(written) if "." in written else int(written)


_PARAMETER: Final = Part(
    "number", lambda written, _: Numeral(_as_number(written)), lambda number, _: str(number)
)
_DIGITS: Final = Part(
    "number", lambda written, _: Count(int(written)), lambda number, _: str(number)
)
_SHOWN: Final = (
    Part("value", _shown, lambda pair, _: (pair[0], str(pair[1]))),
    "attribute",
    "parameter",
)
_TEXT: Final = (
    Part("value", _compared_text, lambda pair, _: pair if isinstance(pair[1], str) else None),
    "attribute",
    "value",
)
_AMOUNT: Final = (
    Part(
        "amount",
        _compared_number,
        lambda quantity, _: (quantity.comparison, quantity.number),
    ),
    "comparison",
    "value",
)
_ROW: Final = (Part("row", _storage_row, _written_row), "parameter")
_COLUMN: Final = (
    Part(
        "number",
        lambda written, _: Numeral(int(written)) if written.isdigit() else None,
        lambda number, _: str(number),
    ),
    "parameter",
)
_NUMBERS: Final = frozenset({Scale.NUMBER, Scale.NOMINAL})
_ORDERS: Final = frozenset({Scale.ORDER, Scale.CYCLE})
_LETTERS: Final = frozenset({Scale.LETTER})


def _among(predicate: Predicate, extreme: Extreme, degree: Degree) -> tuple[Wording, Wording]:
    called = (adjective(degree, many=True), "attribute")
    of_row = {
        Predicate.AMONG_MOST: Predicate.AMONG_MOST_OF_ROW,
        Predicate.AMONG_LEAST: Predicate.AMONG_LEAST_OF_ROW,
    }[predicate]
    full = {"extreme": extreme, "number": None}
    numbered = (Part("number", lambda n, _: None if n is None else Count(n)), "number")
    return (
        put(of_row, Among, full, adjective=called, attribute=ATTRIBUTE),
        put(
            predicate,
            Among,
            {"extreme": extreme},
            count=numbered,
            adjective=called,
            attribute=ATTRIBUTE,
        ),
    )


def _compared(
    comparison: Comparison, numbers: Predicate, orders: Predicate, letters: Predicate
) -> tuple[Wording, ...]:
    """To a value that is no number: larger than, after, after in the alphabet."""
    fixed = {"comparison": comparison}
    degree = Degree.MORE if comparison is Comparison.MORE else Degree.LESS
    called = (adjective(degree), "attribute")
    return (
        put(letters, Compared, fixed, other=_TEXT, attribute=ATTRIBUTE, scales=_LETTERS),
        put(orders, Compared, fixed, other=_TEXT, attribute=ATTRIBUTE, scales=_ORDERS),
        put(
            numbers,
            Compared,
            fixed,
            other=_TEXT,
            adjective=called,
            attribute=ATTRIBUTE,
            scales=_NUMBERS,
        ),
    )


TESTS: Final[tuple[Wording, ...]] = (
    *(
        put(predicate, Has, {"family": name, "parameter": ""}, attribute=ATTRIBUTE)
        for name, predicate in (
            ("odd", Predicate.ODD),
            ("even", Predicate.EVEN),
            ("prime", Predicate.PRIME),
            ("vowel", Predicate.VOWEL),
            ("consonant", Predicate.CONSONANT),
        )
    ),
    *(
        put(predicate, Has, {"family": family}, k=(part, "parameter"), attribute=ATTRIBUTE)
        for family, predicate, part in (
            ("multiple-of", Predicate.MULTIPLE_OF, _PARAMETER),
            ("digits", Predicate.DIGITS, _DIGITS),
            ("above", Predicate.ABOVE, _PARAMETER),
            ("below", Predicate.BELOW, _PARAMETER),
        )
    ),
    put(Predicate.FROM_ROW, Has, {"family": "is", "attribute": ORIGIN_ROW}, row=_ROW),
    put(Predicate.FROM_COLUMN, Has, {"family": "is", "attribute": ORIGIN_COLUMN}, column=_COLUMN),
    put(Predicate.IS, Has, {"family": "is"}, value=_SHOWN, attribute=ATTRIBUTE),
    put(Predicate.AMOUNT, Compared, amount=_AMOUNT, attribute=ATTRIBUTE),
    *_compared(Comparison.MORE, Predicate.MORE, Predicate.AFTER, Predicate.AFTER_IN_ALPHABET),
    *_compared(Comparison.LESS, Predicate.LESS, Predicate.BEFORE, Predicate.BEFORE_IN_ALPHABET),
    *(
        put(predicate, Compared, {"comparison": comparison}, other=_TEXT, attribute=ATTRIBUTE)
        for comparison, predicate in (
            (Comparison.EQUAL, Predicate.LEVEL),
            (Comparison.AT_LEAST, Predicate.LEVEL_OR_AFTER),
            (Comparison.AT_MOST, Predicate.LEVEL_OR_BEFORE),
            (Comparison.DIFFERENT, Predicate.BEFORE_OR_AFTER),
        )
    ),
    *_among(Predicate.AMONG_MOST, Extreme.HIGHEST, Degree.MOST),
    *_among(Predicate.AMONG_LEAST, Extreme.LOWEST, Degree.LEAST),
    put(Predicate.ANYTHING, Anything),
    put(Predicate.NOTHING, Not, {"of": Anything()}),
)
"""What can be asked of one token."""


def said_of(
    table: tuple[Wording, ...],
    thing: object,
    about: About,
    subject: Phrase | None = None,
    **more: Phrase,
) -> Does:
    """What is said of `subject`, by the first line of `table` that can say `thing`."""
    lines = ((wording, wording.phrases(thing, about)) for wording in table)
    wording, parts = next((wording, parts) for wording, parts in lines if parts is not None)
    found = MappingProxyType({**parts, **more})
    return Does(cast("Predicate", wording.says), found, subject, wording.negated)


@dataclass(frozen=True, slots=True)
class Tokens:
    """Says things of the tokens of one deck on one board."""

    board: Board
    deck: Deck

    def has(self, feature: TokenFeature, subject: Phrase | None = None) -> Does:
        """That a token has a feature."""
        return said_of(TESTS, Has(feature), self, subject)

    def kind(self, test: TokenTest) -> Kind | None:
        """Tokens that pass a test, if there is a short way to call them."""
        if not isinstance(test, Has) or test.feature.attribute in ORIGINS:
            return None
        said = self.has(test.feature)
        things = Things(test.feature.attribute)
        return Kind(said.predicate, MappingProxyType({**said.parts, "things": things}))

    def value_of(self, test: TokenTest) -> ValueNamed | None:
        """The value that a test asks for, if it is just one and not about the origin."""
        if not isinstance(test, Has):
            return None
        value = self.has(test.feature).parts.get("value")
        return value if isinstance(value, ValueNamed) else None

    def passes(self, test: TokenTest, subject: Phrase | None = None) -> Does | Several:
        """That a token passes a test, in its canonical form."""
        match test:
            case Either() | Both():
                kind = type(test)
                members = tuple(self.passes(each, subject) for each in listed(kind, test))
                return Several(members, Joint.OR if kind is Either else Joint.AND)
            case Not(Anything()):
                return said_of(TESTS, test, self, subject)
            case Not(of):
                return opposite(self.passes(of, subject))
            case _:
                return said_of(TESTS, test, self, subject)

"""What is said of a token: features and tests, as phrases."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Board
from maestra.core.tokens import Deck, Scale, Value
from maestra.language.keys import Predicate
from maestra.language.phrases import (
    Adjective,
    AttributeNamed,
    Count,
    Degree,
    Does,
    InRow,
    Joint,
    Kind,
    Numeral,
    Phrase,
    Several,
    Things,
    ValueNamed,
    does,
    opposite,
)
from maestra.rules.features import TokenFeature
from maestra.rules.registry import PARAMETER_FEATURES
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

_PLAIN: Final = MappingProxyType(
    {
        "odd": Predicate.ODD,
        "even": Predicate.EVEN,
        "prime": Predicate.PRIME,
        "vowel": Predicate.VOWEL,
        "consonant": Predicate.CONSONANT,
    }
)


@dataclass(frozen=True, slots=True)
class Tokens:
    """Says things of the tokens of one deck on one board."""

    board: Board
    deck: Deck

    def has(self, feature: TokenFeature, subject: Phrase | None = None) -> Does:
        """That a token has a feature."""
        predicate, parts = self._feature(feature)
        return Does(predicate, MappingProxyType(parts), subject)

    def kind(self, test: TokenTest) -> Kind | None:
        """Tokens that pass a test, if there is a short way to call them."""
        if not isinstance(test, Has) or test.feature.attribute in {ORIGIN_ROW, ORIGIN_COLUMN}:
            return None
        predicate, parts = self._feature(test.feature)
        things = Things(test.feature.attribute)
        return Kind(predicate, MappingProxyType({**parts, "things": things}))

    def passes(self, test: TokenTest, subject: Phrase | None = None) -> Does | Several | None:
        """That a token passes a test; None if every token does."""
        match test:
            case Anything():
                return None
            case Has(feature):
                return self.has(feature, subject)
            case Compared(attribute, comparison, value):
                return self._compares(attribute, comparison, value, subject)
            case Among():
                return self._is_among(test, subject)
            case Not(of):
                said = self.passes(of, subject)
                return does(Predicate.NOTHING, subject) if said is None else opposite(said)
            case Either(first, second):
                return self._joined((first, second), Joint.OR, subject)
            case Both(first, second):
                return self._joined((first, second), Joint.AND, subject)
            case _:
                assert_never(test)

    def compares(self, attribute: str, *, greater: bool) -> Predicate:
        """What is said of the greater, or the less, of two; it needs an `adjective`."""
        scale = self.deck.scales.get(attribute, Scale.NUMBER)
        match scale:
            case Scale.LETTER:
                return Predicate.AFTER_IN_ALPHABET if greater else Predicate.BEFORE_IN_ALPHABET
            case Scale.ORDER | Scale.CYCLE:
                return Predicate.AFTER if greater else Predicate.BEFORE
            case Scale.NUMBER | Scale.NOMINAL:
                return Predicate.MORE if greater else Predicate.LESS
            case _:
                assert_never(scale)

    def _joined(
        self, tests: tuple[TokenTest, TokenTest], joint: Joint, subject: Phrase | None
    ) -> Does | Several | None:
        said = [self.passes(test, subject) for test in tests]
        needed = tuple(each for each in said if each is not None)
        if len(needed) < len(said):
            # "or anything" asks nothing, "and anything" asks nothing more.
            return None if joint is Joint.OR or not needed else needed[0]
        return Several(needed, joint)

    def _feature(self, feature: TokenFeature) -> tuple[Predicate, dict[str, Phrase]]:
        attribute = AttributeNamed(feature.attribute)
        if feature.name in _PLAIN:
            return _PLAIN[feature.name], {}
        family = next(name for name in PARAMETER_FEATURES if feature.name.startswith(f"{name}-"))
        parameter = feature.name.removeprefix(f"{family}-")
        match family:
            case "multiple-of":
                return Predicate.MULTIPLE_OF, {"k": Numeral(int(parameter))}
            case "digits":
                return Predicate.DIGITS, {"k": Count(int(parameter))}
            case "above" | "below":
                predicate = Predicate.ABOVE if family == "above" else Predicate.BELOW
                return predicate, {"k": Numeral(Decimal(parameter)), "attribute": attribute}
            case _:
                return self._is(feature.attribute, self._value(feature.attribute, parameter))

    def _value(self, attribute: str, written: str) -> Value:
        """The value of the deck that a feature's name writes so."""
        for token in self.deck.tokens:
            value = token.value(attribute)
            if value is not None and str(value) == written:
                return value
        return written

    def _is(self, attribute: str, value: Value) -> tuple[Predicate, dict[str, Phrase]]:
        if attribute == ORIGIN_ROW:
            return Predicate.FROM_ROW, {"row": board_row(self.board, int(value))}
        if attribute == ORIGIN_COLUMN:
            return Predicate.FROM_COLUMN, {"column": Numeral(int(value))}
        named = ValueNamed(attribute, value)
        return Predicate.IS, {"value": named, "attribute": AttributeNamed(attribute)}

    def _compares(
        self, attribute: str, comparison: Comparison, value: Value, subject: Phrase | None
    ) -> Does | Several:
        """That what a token shows compares so to a value; "at least" is "not below"."""
        if comparison in {Comparison.AT_LEAST, Comparison.AT_MOST, Comparison.DIFFERENT}:
            return opposite(self._compares(attribute, comparison.opposite, value, subject))
        if comparison is Comparison.EQUAL:
            predicate, parts = self._is(attribute, value)
            return Does(predicate, MappingProxyType(parts), subject)
        greater = comparison is Comparison.MORE
        named = AttributeNamed(attribute)
        if isinstance(value, str):
            predicate = self.compares(attribute, greater=greater)
            adjective = Adjective(attribute, Degree.MORE if greater else Degree.LESS)
            other = ValueNamed(attribute, value)
            return does(predicate, subject, other=other, adjective=adjective, attribute=named)
        predicate = Predicate.ABOVE if greater else Predicate.BELOW
        return does(predicate, subject, k=Numeral(value), attribute=named)

    def _is_among(self, test: Among, subject: Phrase | None) -> Does:
        number = self.board.columns if test.number is None else test.number
        highest = test.extreme is Extreme.HIGHEST
        return does(
            Predicate.AMONG_MOST if highest else Predicate.AMONG_LEAST,
            subject,
            count=Count(number),
            adjective=Adjective(
                test.attribute, Degree.MOST if highest else Degree.LEAST, many=True
            ),
            attribute=AttributeNamed(test.attribute),
        )


def board_row(board: Board, storage_row: int) -> InRow:
    """A storage row, counted from 1 with the goal row passed over, as a row of the board."""
    return InRow(storage_row + (storage_row >= board.goal_row))

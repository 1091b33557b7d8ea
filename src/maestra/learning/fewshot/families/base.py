"""What a generator of proposals yields, and what generators share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Final, TypeAlias

from maestra.learning.fewshot.prior import ALONG_TIME_BITS, SELDOM_BITS, Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.counting import CompareCounts, Count
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.timing import Before, Follows
from maestra.rules.pairs import Compare, Relation
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.token_tests import Comparison, Either, Has, Not, TokenTest

USUAL_FEATURES: Final = frozenset({"odd", "even", "vowel", "consonant"})
"""Features that everybody thinks of, besides named values."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """One rule, or a few that are meant together."""

    kind: Kind
    rules: tuple[Rule, ...]
    bits: float | None = None
    """What the parameters cost; None: as much as naming one among all proposals of the kind."""

    @property
    def seldom(self) -> float:
        """Bits more if it speaks of a feature that few people think of."""
        return SELDOM_BITS if any(_is_seldom(rule, self.kind) for rule in self.rules) else 0.0


Generator: TypeAlias = Callable[[Shown], Iterator[Proposal]]


def each(kind: Kind, rules: Iterable[Rule], bits: float | None = None) -> Iterator[Proposal]:
    """Each rule as a proposal of its own."""
    return (Proposal(kind, (rule,), bits) for rule in rules)


def along_lines(
    shown: Shown, kind: Kind, rules: Callable[[Line], Iterable[Rule]]
) -> Iterator[Proposal]:
    """What is meant along the row, and where time tells something, the same in time."""
    along_row = list(rules(Line.ROW))
    yield from each(kind, along_row)
    if shown.timed:
        yield from each(kind, rules(Line.TIME), ALONG_TIME_BITS + one_of(len(along_row)))


def later(line: Line) -> float:
    """Bits more for what is meant along the line instead of along the row."""
    return 0.0 if line is Line.ROW else ALONG_TIME_BITS


def pairs(which: Pairs, relations: Sequence[Relation]) -> Callable[[Line], Iterable[Rule]]:
    """For a line the rules that such pairs stand in each of the relations."""
    return lambda line: [EachPair(which, relation, line) for relation in relations]


def crossing(shown: Shown) -> list[Relation]:
    """What one attribute shows is what another shows: a category named by its token."""
    setting = shown.setting
    return [
        Compare(one, Comparison.EQUAL, two)
        for one, two in permutations(setting.deck.scales, 2)
        if set(setting.values(one)) & set(setting.values(two)) - {None}
    ]


def _is_seldom(rule: Rule, kind: Kind) -> bool:
    match rule:
        case Count(test) if kind is Kind.SO_MANY_OF_EACH:
            return not _is_named(test)
        case EveryToken(test) | AllOfThem(test) | Count(test) | At(_, test):
            return not _is_usual(test)
        case CompareCounts(first) | Before(first) | Follows(first) | IfThen(At(_, first)):
            # What follows on what, and what there is more of, people say of kinds.
            return not _is_named(first)
        case _:
            return False


def _is_named(test: TokenTest) -> bool:
    return isinstance(test, Has) and test.feature.name.startswith("is-")


def _is_usual(test: TokenTest) -> bool:
    match test:
        case Has(feature):
            return feature.name in USUAL_FEATURES or _is_named(test)
        case Not(of):
            return _is_usual(of)
        case Either(first, second):
            return _is_usual(first) and _is_usual(second)
        case _:
            return True

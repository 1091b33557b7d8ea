"""What a generator of proposals yields, and what generators share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Final, TypeAlias

from maestra.learning.fewshot.prior import ALONG_TIME_BITS, SELDOM_BITS, Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.conditions import At
from maestra.rules.forms.counting import Count
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
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
        return SELDOM_BITS if any(map(_speaks_of_seldom, self.rules)) else 0.0


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


def _speaks_of_seldom(rule: Rule) -> bool:
    match rule:
        case EveryToken(test) | AllOfThem(test) | Count(test) | At(_, test):
            return _is_seldom(test)
        case _:
            return False


def _is_seldom(test: TokenTest) -> bool:
    match test:
        case Has(feature):
            return feature.name not in USUAL_FEATURES and not feature.name.startswith("is-")
        case Not(of):
            return _is_seldom(of)
        case Either(first, second):
            return _is_seldom(first) or _is_seldom(second)
        case _:
            return False

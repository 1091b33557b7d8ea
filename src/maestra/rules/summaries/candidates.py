"""The rules that every play of a model keeps: candidates for its summary.

Looked for are the rules that preconditions can speak of: in which order the goal cells are
filled, where tokens come from, which tokens are used, how neighbours compare, and whether the
row is the same every time. Order is taken strictly; "not smaller than" has no literal to show it.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Final

from maestra.core.tokens import Attributes, Scale
from maestra.rules.features import PairFeature, TokenFeature, token_feature_holds
from maestra.rules.forms.base import Direction
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.pairs import Named, Relation, Step, Times, different, same
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Mask, bits
from maestra.rules.summaries.evidence import Evidence
from maestra.rules.token_tests import Both, Has, Not, TokenTest

_ORDERS: Final = frozenset({"less-than", "before"})
_PREFERRED: Final = (
    Filling.LEFT_TO_RIGHT,
    Filling.RIGHT_TO_LEFT,
    Filling.ENDS_FIRST,
    Filling.MIDDLE_FIRST,
)


@dataclass(frozen=True)
class Chosen:
    """A candidate, and what it leaves."""

    rule: Rule
    mask: Mask = -1
    """The tokens that pass it, of a selection."""
    before: tuple[Mask, ...] | None = None
    """For each token those that may lie on its left, of a rule about neighbours."""


@dataclass(frozen=True)
class GivenRow:
    """A row that is always the same, and for each of its cells the tokens that may lie there."""

    rule: Pattern
    masks: tuple[Mask, ...]


@dataclass(frozen=True)
class Candidates:
    """Finds the rules that every play keeps; `evidence` places tokens from storage only."""

    evidence: Evidence

    @cached_property
    def lengths(self) -> frozenset[int]:
        """After how many moves a play may end."""
        return self.evidence.exercise.lengths

    @cached_property
    def _columns_at(self) -> tuple[frozenset[Index], ...]:
        """For each step, from 0, the goal cells that are filled then."""
        destinations = self.evidence.destinations
        return tuple(
            frozenset(cell.column - 1 for cell in destinations.get(step, ()))
            for step in range(1, max(self.lengths) + 1)
        )

    @cached_property
    def filling(self) -> FillOrder | None:
        """The order in which the goal cells are filled, if it is one that has a name."""
        for filling in _PREFERRED:
            order = FillOrder(filling)
            levels = _levels(order, self.evidence.vocabulary.board.columns)
            if len(levels) == 1:
                continue  # that is any order
            steps = [set(level) for level in levels for _ in level]
            if all(cells <= level for cells, level in zip(self._columns_at, steps, strict=False)):
                return order
        return None

    @cached_property
    def fixed_order(self) -> tuple[Index, ...] | None:
        """The goal cell of each step, if it is always the same."""
        cells = [min(cells) for cells in self._columns_at if len(cells) == 1]
        return tuple(cells) if len(cells) == len(self._columns_at) else None

    @cached_property
    def levels(self) -> tuple[tuple[Index, ...], ...]:
        """The goal cells in the order they are filled; of one level in any order."""
        columns = self.evidence.vocabulary.board.columns
        if self.filling is not None:
            return _levels(self.filling, columns)
        if self.fixed_order is not None:
            rest = tuple(cell for cell in range(columns) if cell not in self.fixed_order)
            return (*((cell,) for cell in self.fixed_order), *((rest,) if rest else ()))
        return (tuple(range(columns)),)

    @cached_property
    def _origins(self) -> frozenset[tuple[int, int, int]]:
        """Row and column of every origin, with the column of its destination."""
        return frozenset(
            (origin.row, origin.column, end.column)
            for by_shown in self.evidence.routes.values()
            for routes in by_shown.values()
            for origin, end in routes
        )

    @cached_property
    def storage_row(self) -> int | None:
        """The row of the board that every token comes from, if there are others."""
        board = self.evidence.vocabulary.board
        rows = {row for row, _, _ in self._origins}
        return min(rows) if len(rows) == 1 and board.rows > 2 else None  # noqa: PLR2004 - a goal row and one more

    @cached_property
    def same_column(self) -> bool:
        """Whether every token stays in its column."""
        return bool(self._origins) and all(column == to for _, column, to in self._origins)

    def sources(self) -> Iterator[Rule]:
        """Where tokens come from."""
        if self.storage_row is not None:
            goal = self.evidence.vocabulary.board.goal_row
            yield from_row(self.storage_row - (self.storage_row > goal))
        if self.same_column:
            yield StraightUp()

    def selections(self) -> list[Chosen]:
        """Which tokens are used, as few rules as say it; a positive one before its negation."""
        used = 0
        for tokens in self.evidence.tokens.values():
            used |= tokens
        everything = sum(self.evidence.of_shown)
        if not used:
            return []
        positive: list[Chosen] = []
        negative: list[Chosen] = []
        for feature in self._token_features():
            having = sum(
                mask
                for mask, shown in zip(
                    self.evidence.of_shown, self.evidence.vocabulary.shown, strict=True
                )
                if token_feature_holds(feature, shown)
            )
            if not used & ~having and having != everything:
                positive.append(Chosen(EveryToken(Has(feature)), having))
            if not used & having and having:
                rule = EveryToken(Not(Has(feature)))
                negative.append(Chosen(rule, everything & ~having))
        return _without_superfluous([*positive, *negative])

    def _token_features(self) -> Iterator[TokenFeature]:
        """Those that count, and what several tokens show of an attribute without an order."""
        vocabulary = self.evidence.vocabulary
        yield from (f for f in vocabulary.features if isinstance(f, TokenFeature))
        for attribute, scale in vocabulary.deck.scales.items():
            if scale is Scale.NOMINAL:
                values = [token.value(attribute) for token in vocabulary.deck.tokens]
                shared = {value for value in values if value and values.count(value) > 1}
                yield from (TokenFeature(f"is-{v}", attribute) for v in sorted(map(str, shared)))

    def neighbours(self) -> list[Chosen]:
        """How neighbours in the row compare; only if each step has its cell."""
        if any(len(level) > 1 for level in self.levels[: max(self.lengths)]):
            return []
        chosen: list[Chosen] = []
        links = list(self._adjacent())
        for feature in self.evidence.vocabulary.pair_features:
            for rule, related in self._rules_of(feature):
                kept = all(
                    not self._accepted_left(left, right, token) & ~related[token]
                    for left, right in links
                    for token in bits(self._tokens_on(right))
                )
                if links and kept and self._narrows(related, chosen):
                    chosen.append(Chosen(rule, before=related))
        return chosen

    def _narrows(self, related: tuple[Mask, ...], chosen: list[Chosen]) -> bool:
        """Whether a relation refuses some neighbours that those chosen so far accept."""
        used = sum(self.evidence.of_shown)
        for token in bits(used):
            accepted = used & ~(1 << token)
            for other in chosen:
                accepted &= other.before[token] if other.before is not None else -1
            if accepted & ~related[token]:
                return True
        return False

    def _adjacent(self) -> Iterator[tuple[Index, Index]]:
        """The pairs of goal cells next to each other of those that are filled."""
        filled = sorted(cell for level in self.levels[: max(self.lengths)] for cell in level)
        return pairwise(filled)

    def _step_of(self, cell: Index) -> int:
        return self.levels.index((cell,)) + 1

    def _tokens_on(self, cell: Index) -> Mask:
        return self.evidence.tokens[self._step_of(cell)]

    def _accepted_left(self, left: Index, right: Index, token: Index) -> Mask:
        """The tokens that the preconditions accept on `left` with `token` on `right`."""
        evidence, cells = self.evidence, self.evidence.vocabulary.board.goal_cells
        before, after = self._step_of(left), self._step_of(right)
        others = self._tokens_on(left) & ~(1 << token)
        if before < after:
            return others & evidence.fit(after, cells[left], token)
        return sum(
            1 << other
            for other in bits(others)
            if evidence.fit(before, cells[right], other) >> token & 1
        )

    def _rules_of(self, feature: PairFeature) -> Iterator[tuple[Rule, tuple[Mask, ...]]]:
        """The rules about neighbours that a feature can say, each with what may lie left."""
        forth, back = self._related(feature)
        if feature.name in _ORDERS:
            yield Ordered(feature.attribute, Direction.RISING), forth
            yield Ordered(feature.attribute, Direction.FALLING), back
            return
        for relation, related in _relations(feature, (forth, back)):
            yield EachPair(Pairs.NEIGHBOURS, relation), related

    def _related(self, feature: PairFeature) -> tuple[tuple[Mask, ...], tuple[Mask, ...]]:
        """For each token those to which it is the second of the pair, and those it is first to."""
        place = self._side_of(feature)
        forth = self._masks(place)
        return forth, (forth if feature.symmetric else self._masks(place + 1))

    def _side_of(self, feature: PairFeature) -> int:
        """Where the feature's literals stand among those of a cell; its converse is the next."""
        features = self.evidence.vocabulary.pair_features
        earlier = features[: features.index(feature)]
        return sum(1 if other.symmetric else 2 for other in earlier)

    def _masks(self, place: int) -> tuple[Mask, ...]:
        """For each token those that make this literal of a cell hold by lying there."""
        evidence = self.evidence
        masks = [
            sum(
                mask
                for pattern, mask in zip(patterns, evidence.of_shown, strict=True)
                if pattern >> place & 1
            )
            for patterns in map(evidence.vocabulary.patterns, range(len(evidence.of_shown)))
        ]
        return tuple(masks[shown] for shown in evidence.shown_of)

    def given_row(self) -> GivenRow | None:
        """The row that every play makes, if it is always the same and can be told by features."""
        on_cell: dict[Index, set[int]] = {}
        for by_shown in self.evidence.routes.values():
            for shown, routes in by_shown.items():
                for _, end in routes:
                    on_cell.setdefault(end.column - 1, set()).add(shown)
        filled = sorted(on_cell)
        if not filled or filled != list(range(len(filled))):
            return None
        if any(len(on_cell[cell]) > 1 for cell in filled):
            return None
        row = [min(on_cell[cell]) for cell in filled]
        if any(row.count(shown) > self.evidence.of_shown[shown].bit_count() for shown in row):
            return None
        tests = [self._just(self.evidence.vocabulary.shown[shown]) for shown in row]
        known = tuple(test for test in tests if test is not None)
        if len(known) < len(tests):
            return None
        return GivenRow(Pattern(known), tuple(self.evidence.of_shown[shown] for shown in row))

    def _just(self, shown: Attributes) -> TokenTest | None:
        """The test that only tokens showing this pass: by one attribute, if that is enough."""
        everything = self.evidence.vocabulary.shown
        if sum(set(shown) <= set(other) for other in everything) > 1:
            return None
        alone = [pair for pair in shown if sum(pair in other for other in everything) == 1]
        tests: list[TokenTest] = [
            Has(TokenFeature(f"is-{value}", name)) for name, value in (alone[:1] or shown)
        ]
        return functools.reduce(Both, tests) if tests else None


def _levels(order: FillOrder, length: int) -> tuple[tuple[Index, ...], ...]:
    """The goal cells in the order they are filled, those of which either is next together."""
    keys = order.keys(length)
    return tuple(
        tuple(cell for cell in range(length) if keys[cell] == key) for key in sorted(set(keys))
    )


def _relations(
    feature: PairFeature, related: tuple[tuple[Mask, ...], tuple[Mask, ...]]
) -> Iterator[tuple[Relation, tuple[Mask, ...]]]:
    """How the rule language says a feature of the left and the right one of two neighbours."""
    forth, back = related
    attribute = feature.attribute
    match feature.name:
        case "same":
            yield same(attribute), forth
        case "different":
            yield different(attribute), forth
        case "successor":
            yield Step(attribute, 1), forth
            yield Step(attribute, -1), back
        case "twice":
            yield Times(attribute, 2), forth
        case name:
            yield Named(name, directed=True), forth


def _without_superfluous(found: list[Chosen]) -> list[Chosen]:
    """Those that are needed: the last ones are tried first to do without."""
    needed = list(found)
    for chosen in reversed(found):
        rest = [other for other in needed if other is not chosen]
        if _all_of(rest) == _all_of(needed):
            needed = rest
    return needed


def _all_of(chosen: list[Chosen]) -> Mask:
    mask = -1
    for each in chosen:
        mask &= each.mask
    return mask

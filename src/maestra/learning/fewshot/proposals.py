"""The rules worth considering: one generator for each family, fed by what was shown.

Nothing here is a list of exercises: attributes, values, places and amounts are those of the
decks and plays. A generator may propose anything; `surviving` keeps what holds of the plays.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, permutations, product
from math import comb, perm
from typing import Final, TypeAlias

from maestra.core.tokens import Scale, Value
from maestra.learning.fewshot.prior import (
    ALONG_TIME_BITS,
    FAMILY_BITS,
    KIND_BITS,
    SELDOM_BITS,
    UNUSUAL_BITS,
    USUALLY_ADDED,
    Kind,
    amount_bits,
    one_of,
    round_bits,
)
from maestra.learning.fewshot.shown import Shown, as_number, distance, quotient, total
from maestra.learning.fewshot.space import looks_at_start, same_tokens
from maestra.learning.fewshot.token_tests import extremes, thresholds
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Operation, Total
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template, given_row
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import (
    AddUp,
    Apart,
    Compare,
    Named,
    Relation,
    Step,
    Times,
    different,
    same,
)
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Play, bits
from maestra.rules.token_tests import (
    Among,
    Anything,
    Comparison,
    Either,
    Extreme,
    Has,
    Not,
    TokenTest,
    has,
    passing,
)

MAX_EITHER: Final = 40
"""Simple tests that are paired by `or`; of more, as on a deck of names, none is."""
REPEATED: Final = ("AB", "ABC", "AAB", "ABB", "AABB")
HOLE_BITS: Final = 2.0
"""For each goal cell that a model row has no token for."""
CHAIN: Final = 3
"""Named tokens that are asked for one after the other."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """One rule, or a few that are meant together."""

    kind: Kind
    rules: tuple[Rule, ...]
    bits: float | None = None
    """What the parameters cost; None: as much as naming one among all proposals of the kind."""

    @property
    def seldom(self) -> float:
        """What it costs more to speak of a feature that few people think of."""
        return max(map(_seldom, self.rules))


USUAL_FEATURES: Final = frozenset({"odd", "even", "vowel", "consonant"})


def _seldom(rule: Rule) -> float:
    match rule:
        case EveryToken(test) | AllOfThem(test) | Count(test) | At(_, test):
            return SELDOM_BITS if _is_seldom(test) else 0.0
        case _:
            return 0.0


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


Generator: TypeAlias = Callable[[Shown], Iterator[Proposal]]


def _each(kind: Kind, rules: Iterable[Rule], cost: float | None = None) -> Iterator[Proposal]:
    return (Proposal(kind, (rule,), cost) for rule in rules)


def _timed(
    shown: Shown, kind: Kind, rules: Callable[[Line], Iterable[Rule]]
) -> Iterator[Proposal]:
    """What is meant along the row, and where time tells something, the same in time."""
    along_row = list(rules(Line.ROW))
    yield from _each(kind, along_row)
    if shown.timed:
        cost = ALONG_TIME_BITS + one_of(len(along_row))
        yield from _each(kind, rules(Line.TIME), cost)


def selections(shown: Shown) -> Iterator[Proposal]:
    """Only these tokens; all of these."""
    setting = shown.setting
    tests = shown.kinds_and_features

    def selects(test: TokenTest) -> bool:
        return any(play.setting.movable & ~passing(play.setting, test) for play in shown.plays)

    yield from _each(Kind.ONLY, map(EveryToken, tests))
    yield from _each(Kind.ONLY_NOT, (EveryToken(Not(test)) for test in tests))
    if len(tests) <= MAX_EITHER:
        twos = (Either(one, two) for one, two in combinations(tests, 2))
        yield from _each(Kind.ONLY_EITHER, (EveryToken(test) for test in twos if selects(test)))
    beyond = list(thresholds(setting))
    yield from _each(Kind.ONLY_BEYOND, map(EveryToken, beyond))
    yield from _each(
        Kind.ONLY_EXTREME, (EveryToken(test) for test in extremes(setting) if selects(test))
    )
    for test in tests:
        yield Proposal(Kind.ALL_OF_THEM, (EveryToken(test), AllOfThem(test)))
        yield Proposal(Kind.AT_LEAST_ALL, (AllOfThem(test),))
    for limit in beyond:
        yield Proposal(Kind.ALL_BEYOND, (EveryToken(limit), AllOfThem(limit)))


def orders(shown: Shown) -> Iterator[Proposal]:
    """Order and shape."""
    for attribute, direction in product(shown.ordinal, Direction):
        ties = shown.has_ties(attribute)
        for strict in (True, False):
            kind = Kind.ORDER if strict is not ties else Kind.ORDER_LOOSE
            cost = one_of(2 * len(shown.ordinal))
            yield Proposal(kind, (Ordered(attribute, direction, strict),), cost)
            if shown.timed:
                in_time = Ordered(attribute, direction, strict, Line.TIME)
                loose = 0.0 if strict is not ties else 1.0
                yield Proposal(Kind.ORDER_IN_TIME, (in_time,), cost + loose)
    for line in shown.lines:
        later = 0.0 if line is Line.ROW else ALONG_TIME_BITS
        cost = later + one_of(len(shown.ordinal))
        for attribute in shown.ordinal:
            yield Proposal(Kind.SHAPE, (Zigzag(attribute, line),), cost)
            for direction in Direction:
                yield Proposal(Kind.SHAPE, (RiseAndFall(attribute, direction, line),), cost + 1)
            yield Proposal(Kind.EQUAL_STEPS, (EqualSteps(attribute, line=line),), cost)
            if attribute in shown.numeric:
                ratio = EqualSteps(attribute, ratio=True, line=line)
                yield Proposal(Kind.EQUAL_RATIO, (ratio,), cost)
            if shown.scales[attribute] is Scale.CYCLE:
                for direction in Direction:
                    cyclic = CyclicOrdered(attribute, direction, line)
                    yield Proposal(Kind.CYCLIC, (cyclic,), later + 1)
    places = (MIDDLE, *range(1, shown.setting.length + 1))
    ends = (MIDDLE, 1, shown.setting.length)
    for attribute, extreme, place in product(shown.ordinal, Extreme, places):
        if (
            place in ends
            or shown.setting.length % 2 == 0
            or place != shown.setting.length // 2 + 1
        ):
            seldom = 0.0 if place in ends else 3.0
            rule = ExtremeAt(attribute, extreme, _position(shown, place))
            cost = one_of(6 * len(shown.ordinal)) + seldom
            yield Proposal(Kind.EXTREME_AT, (rule,), cost)


def _position(shown: Shown, place: int) -> Position:
    return LAST if place == shown.setting.length else Position(place)


def groupings(shown: Shown) -> Iterator[Proposal]:
    """Kinds together and apart, partners, so many of each."""
    names = shown.named_attributes
    yield from _timed(shown, Kind.BLOCKS, lambda line: (Blocks(name, line) for name in names))
    for kind, which, relates in (
        (Kind.NEIGHBOURS_DIFFER, Pairs.NEIGHBOURS, different),
        (Kind.ALL_ALIKE, Pairs.ALL, same),
        (Kind.ALL_DIFFERENT, Pairs.ALL, different),
    ):
        along = _pairs(which, [relates(name) for name in names])
        yield from (
            _timed(shown, kind, along)
            if kind is Kind.NEIGHBOURS_DIFFER
            else _each(kind, along(Line.ROW))
        )
    alike: list[Relation] = [same(name) for name in names]
    yield from _each(Kind.MIRRORED, _pairs(Pairs.MIRRORED, alike)(Line.ROW))
    yield from _each(Kind.PAIRED_ALIKE, _pairs(Pairs.TWO_BY_TWO, alike)(Line.ROW))
    named: list[Relation] = [Named(name) for name in shown.setting.deck.relations]
    yield from _each(Kind.PARTNERS, _pairs(Pairs.TWO_BY_TWO, named)(Line.ROW))
    for which in (Pairs.NEIGHBOURS, Pairs.MIRRORED, Pairs.FIRST_WITH_REST, Pairs.ALL):
        yield from _each(Kind.NEIGHBOURS_RELATED, _pairs(which, named)(Line.ROW))
    classes: list[Relation] = [
        Compare(one, Comparison.EQUAL, two)
        for one, two in permutations(shown.setting.deck.scales, 2)
        if set(shown.setting.values(one)) & set(shown.setting.values(two)) - {None}
    ]
    for which in (Pairs.NEIGHBOURS, Pairs.FIRST_WITH_REST):
        yield from _each(Kind.NEIGHBOURS_RELATED, _pairs(which, classes)(Line.ROW))


def _pairs(which: Pairs, relations: Sequence[Relation]) -> Callable[[Line], Iterable[Rule]]:
    return lambda line: (EachPair(which, relation, line) for relation in relations)


def arithmetic(shown: Shown) -> Iterator[Proposal]:
    """Steps, ratios, distances, sums, equations."""
    length = shown.setting.length
    for attribute in shown.ordinal:
        cost = one_of(len(shown.ordinal))
        steps = [Step(attribute, n) for n in shown.steps(attribute)]
        aparts = [Apart(attribute, n) for n in shown.amounts(attribute, distance)]
        for step in steps:
            usual = shown.scales[attribute] in (Scale.CYCLE, Scale.ORDER) and abs(step.amount) == 1
            kind = Kind.SUCCESSORS if usual else Kind.STEP
            amount = 0.5 if usual else amount_bits(step.amount)
            yield Proposal(kind, (EachPair(Pairs.NEIGHBOURS, step),), cost + amount)
        for apart in aparts:
            rule = EachPair(Pairs.NEIGHBOURS, apart)
            yield Proposal(Kind.APART, (rule,), cost + amount_bits(apart.amount))
    for attribute in shown.numeric:
        cost = one_of(len(shown.numeric))
        for factor in shown.amounts(attribute, quotient):
            rule = EachPair(Pairs.NEIGHBOURS, Times(attribute, factor))
            yield Proposal(Kind.RATIO, (rule,), cost + amount_bits(factor))
        span = shown.span(attribute)
        for number in shown.amounts(attribute, total):
            for which, more in (
                (Pairs.NEIGHBOURS, 0.0),
                (Pairs.TWO_BY_TWO, 0.0),
                (Pairs.MIRRORED, 2.0),
            ):
                rule = EachPair(which, AddUp(attribute, number))
                amount = more + round_bits(number, 2 * span)
                yield Proposal(Kind.ADD_UP, (rule,), cost + amount)
        yield from _totals(shown, attribute, cost, span * length)
        places = [Position(k) for k in range(1, length + 1)]
        for result, operation in product(places, Operation):
            others = [place for place in places if place != result]
            for one, two in combinations(others, 2):
                usual = (one, two) == (1, 2) and result in (3, length)
                constant = 0 if operation is Operation.SUM else 1
                rule = Equation(attribute, (one, two), (result,), constant, operation)
                if usual:
                    yield Proposal(Kind.EQUATION, (rule,), cost + 1.5)
                else:
                    yield Proposal(
                        Kind.EQUATION_ANYWHERE, (rule,), cost + one_of(6 * comb(length, 3))
                    )


def _totals(shown: Shown, attribute: str, cost: float, span: float) -> Iterator[Proposal]:
    sums = sorted(
        {found for play in shown.plays if (found := shown.sum_of(play, attribute)) is not None}
    )
    for found in sums:
        if (number := as_number(found)) is not None:
            rule = Total(attribute, Comparison.EQUAL, number)
            yield Proposal(Kind.TOTAL, (rule,), cost + round_bits(number, span / 3))
    if sums:
        low, high = int(sums[0]), -(-sums[-1] // 1)
        for unit in (10, 50, 100):
            bound = one_of(span / unit)
            least, most = unit * (low // unit), unit * -(-int(high) // unit)
            for number in {least, least - unit} - {0}:
                if number > 0:
                    rule = Total(attribute, Comparison.AT_LEAST, number)
                    yield Proposal(Kind.TOTAL_BEYOND, (rule,), cost + bound + 1)
                    yield Proposal(
                        Kind.UNTIL_TOTAL, (UntilTotal(attribute, number),), cost + bound
                    )
            for number in {most, most + unit}:
                rule = Total(attribute, Comparison.AT_MOST, number)
                yield Proposal(Kind.TOTAL_BEYOND, (rule,), cost + bound + 1)


def patterns(shown: Shown) -> Iterator[Proposal]:
    """Rows and templates that repeat, and the same row every time."""
    length = shown.setting.length
    yield from _timed(
        shown,
        Kind.ALTERNATING,
        lambda line: (
            *(Pattern(two, repeat=True, line=line) for two in shown.contrasts),
            *(Template(name, "AB", repeat=True, line=line) for name in shown.named_attributes),
        ),
    )
    for line in shown.lines:
        later = 0.0 if line is Line.ROW else ALONG_TIME_BITS
        for name in shown.named_attributes:
            cost = later + one_of(len(shown.named_attributes))
            tests = shown.kinds[name]
            for three in permutations(tests, CHAIN):
                amount = one_of(perm(len(tests), CHAIN))
                yield Proposal(
                    Kind.REPEATED, (Pattern(three, repeat=True, line=line),), cost + amount
                )
            for letters in REPEATED[1:]:
                rule = Template(name, letters, repeat=True, line=line)
                yield Proposal(Kind.REPEATED, (rule,), cost + 2)
            for letters in shown.templates_of(name, line):
                if letters in ("A" * (length - 1) + "B", "A" + "B" * (length - 1)):
                    amount = 0.5
                else:
                    amount = length - 1 + (len(set(letters)) - 2) * 3.0
                yield Proposal(Kind.TEMPLATE, (Template(name, letters, line=line),), cost + amount)
    for attribute in shown.setting.deck.scales:
        for row in shown.rows_of(attribute):
            values = len(set(shown.setting.values(attribute)))
            if attribute in shown.kinds:
                cost = length * one_of(values) + one_of(len(shown.named_attributes))
                yield Proposal(Kind.TEMPLATE_NAMED, (given_row(attribute, row),), cost)
            else:
                cost = one_of(perm(shown.setting.movable.bit_count(), length))
                yield Proposal(Kind.GIVEN_ROW, (given_row(attribute, row),), cost)


def counts(shown: Shown) -> Iterator[Proposal]:
    """So many of a kind, so many kinds, more of one than of another."""
    length = shown.setting.length
    tests = shown.kinds_and_features
    cost = one_of(len(tests) * (length - 1))
    for test in tests:
        found = sorted(play.count(passing(play.setting, test)) for play in shown.plays)
        for number in sorted({found[0], found[-1]}):
            if 0 < number < length:
                yield Proposal(Kind.COUNT, (Count(test, Comparison.EQUAL, number),), cost)
            if number > 0:
                at_least = Count(test, Comparison.AT_LEAST, number)
                yield Proposal(Kind.COUNT_BEYOND, (at_least,), cost + 0.5)
            if number < length:
                at_most = Count(test, Comparison.AT_MOST, number)
                yield Proposal(Kind.COUNT_BEYOND, (at_most,), cost + 0.5)
    for attribute in shown.unique:
        values = shown.setting.values(attribute)
        for token in shown.plays[0].tokens:
            if values[token] is not None:
                contains = Count(has(f"is-{values[token]}", attribute), Comparison.AT_LEAST, 1)
                choices = one_of(len(values) * len(shown.unique))
                yield Proposal(Kind.CONTAINS, (contains,), choices)
    for one, two in shown.contrasts:
        for play in shown.plays:
            a, b = (play.count(passing(play.setting, test)) for test in (one, two))
            if a + b == len(play.tokens) and 0 < a <= b:
                both = (Count(one, Comparison.EQUAL, a), Count(two, Comparison.EQUAL, b))
                yield Proposal(
                    Kind.SO_MANY_OF_EACH, both, one_of(len(shown.contrasts) * length / 2)
                )
    for order in (Comparison.MORE, Comparison.AT_LEAST, Comparison.EQUAL):
        yield from _each(Kind.MORE_OF, (CompareCounts(a, order, b) for a, b in shown.contrasts))
    for attribute in shown.named_attributes:
        found = sorted(Kinds(attribute, Comparison.EQUAL, 0).amount(p) for p in shown.plays)
        cost = one_of(len(shown.named_attributes) * 3)
        for number in sorted({found[0], found[-1]} - {0}):
            yield Proposal(Kind.KINDS, (Kinds(attribute, Comparison.EQUAL, number),), cost)
            for order in (Comparison.AT_LEAST, Comparison.AT_MOST):
                yield Proposal(Kind.KINDS, (Kinds(attribute, order, number),), cost + 1.5)
    placed = {len(play.tokens) for play in shown.plays}
    if len(placed) == 1 and not shown.full:
        so_long = Count(Anything(), Comparison.EQUAL, placed.pop())
        yield Proposal(Kind.SO_LONG, (so_long,), one_of(length))


def places(shown: Shown) -> Iterator[Proposal]:
    """What is asked of one place or two, and conditions on the ends."""
    tests = shown.kinds_and_features
    ends = [FIRST, LAST, *([MIDDLE] if shown.setting.length % 2 else [])]
    between = [
        Position(k) for k in range(2, shown.setting.length) if shown.setting.length + 1 != 2 * k
    ]
    yield from _each(Kind.AT_END, (At(place, test) for place in ends for test in tests))
    yield from _each(Kind.AT_PLACE, (At(place, test) for place in between for test in tests))
    if shown.timed:
        cost = ALONG_TIME_BITS + one_of(2 * len(tests))
        timed = (At(place, test, Line.TIME) for place in (FIRST, LAST) for test in tests)
        yield from _each(Kind.AT_END, timed, cost)
    yield from _each(
        Kind.IF_THEN,
        (
            IfThen(At(FIRST, one), At(LAST, last))
            for one, two in shown.contrasts
            for last in (one, two)
        ),
    )
    relations: list[Relation] = [r(a) for a in shown.named_attributes for r in (same, different)]
    relations += [Named(name) for name in shown.setting.deck.relations]
    relations += [
        Compare(a, order) for a in shown.ordinal for order in (Comparison.LESS, Comparison.MORE)
    ]
    spots = [*map(Position, range(1, shown.setting.length)), LAST]
    for one, two in combinations(spots, 2):
        kind = Kind.TWO_PLACES if (one, two) == (FIRST, LAST) else Kind.TWO_PLACES_FAR
        yield from _each(kind, (TwoPlaces(one, two, relation) for relation in relations))


def sources(shown: Shown) -> Iterator[Proposal]:
    """Where tokens come from."""
    rows, columns = shown.origins[ORIGIN_ROW], shown.origins[ORIGIN_COLUMN]
    yield from _each(Kind.FROM_ROW, map(EveryToken, rows))
    yield from _each(Kind.FROM_ROW, (EveryToken(Not(row)) for row in rows), one_of(len(rows)) + 3)
    yield from _each(Kind.FROM_ROW, (AllOfThem(row) for row in rows), one_of(len(rows)) + 3)
    yield from _each(Kind.FROM_COLUMN, map(EveryToken, columns))
    yield from _each(
        Kind.FROM_COLUMN, (EveryToken(Not(c)) for c in columns), one_of(len(columns)) + 3
    )
    yield Proposal(Kind.STRAIGHT_UP, (StraightUp(),), 0.0)
    for row in rows:
        yield Proposal(Kind.ROW_UP, (EveryToken(row), StraightUp()))
    yield Proposal(Kind.STRAIGHT_UP, (StraightUp(mirrored=True),), 1.0)
    yield from _timed(
        shown,
        Kind.ROWS_IN_TURN,
        lambda line: (Pattern(two, repeat=True, line=line) for two in permutations(rows, 2)),
    )
    for extreme in Extreme:
        yield Proposal(Kind.TAKE_FIRST, (TakeExtreme(ORIGIN_COLUMN, extreme),), 1.0)
    for attribute, direction, strict in product(
        (ORIGIN_COLUMN, ORIGIN_ROW), Direction, (False, True)
    ):
        cost = 1.0 + (attribute == ORIGIN_ROW) + 1.5 * strict
        for line in shown.lines:
            rule = Ordered(attribute, direction, strict, line)
            yield Proposal(
                Kind.ORIGIN_ORDER, (rule,), cost + (line is Line.TIME) * ALONG_TIME_BITS
            )
    for attribute, relation, which in product(
        (ORIGIN_COLUMN, ORIGIN_ROW), (different, same), (Pairs.ALL, Pairs.NEIGHBOURS)
    ):
        seldom = 1.0 + (which is Pairs.NEIGHBOURS) * 2.0
        rule = EachPair(which, relation(attribute))
        yield Proposal(Kind.ORIGIN_PAIRS, (rule,), seldom)


def timings(shown: Shown) -> Iterator[Proposal]:
    """One kind before another; after one kind another; always the least that is left."""
    yield from _timed(
        shown, Kind.BEFORE, lambda line: (Before(a, b, line) for a, b in shown.contrasts)
    )
    for now in (True, False):
        yield from _timed(
            shown,
            Kind.FOLLOWS,
            lambda line, now=now: (
                Follows(a, b, immediately=now, line=line) for a, b in shown.contrasts
            ),
        )
    cost = one_of(2 * len(shown.ordinal)) + (0.0 if shown.timed else ALONG_TIME_BITS)
    takes = (TakeExtreme(a, extreme) for a in shown.ordinal for extreme in Extreme)
    yield from _each(Kind.TAKE_EXTREME, takes, cost)
    for attribute in shown.names:
        yield from _chains(shown, attribute)


def _chains(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """Named tokens one before the other, as they are in the first play."""
    named = {value for value in shown.setting.values(attribute) if value is not None}
    for line in shown.lines:
        row = [t for t in shown.plays[0].slots(line) if t is not None]
        values = [shown.setting.values(attribute)[t] for t in row]
        tests = [has(f"is-{value}", attribute) for value in values]
        for count in (2, CHAIN):
            for chain in combinations(tests, count):
                rules = tuple(Before(a, b, line) for a, b in zip(chain, chain[1:], strict=False))
                cost = one_of(perm(len(named), count)) + (count == 2)
                yield Proposal(Kind.CHAIN, rules, cost)


def contexts(shown: Shown) -> Iterator[Proposal]:
    """Rows and single tokens of the start that stay and are followed."""
    plain: list[Relation] = [same(attribute) for attribute in shown.named_attributes]
    plain += [Named(name) for name in shown.setting.deck.relations]
    other: list[Relation] = [
        Compare(one, Comparison.EQUAL, two)
        for one, two in permutations(shown.setting.deck.scales, 2)
        if set(shown.setting.values(one)) & set(shown.setting.values(two)) - {None}
    ]
    steps = [Step(attribute, n) for attribute in shown.ordinal for n in (1, -1)]
    played = sum(1 << token for token in shown.plays[0].tokens)
    for number in range(1, shown.setting.start.board.rows):
        here = passing(shown.setting, has(f"is-{number}", ORIGIN_ROW))
        if here and not here & played:
            # A model is a whole row; one with holes is seldom meant for one.
            holes = HOLE_BITS * (shown.setting.length - here.bit_count())
            choices = holes + one_of(3 * (shown.setting.start.board.rows - 1))
            for reading in Reading:
                for relation in [*plain, *other]:
                    cost = choices + one_of(len([*plain, *other]))
                    yield Proposal(Kind.MODEL_ROW, (ModelRow(number, reading, relation),), cost)
                for relation in steps:
                    cost = choices + one_of(len(steps)) + 3.0
                    yield Proposal(Kind.MODEL_ROW, (ModelRow(number, reading, relation),), cost)
    columns = shown.setting.values(ORIGIN_COLUMN)
    storage = shown.setting.values(ORIGIN_ROW)
    for token in bits(shown.plays[0].left):
        place = int(str(storage[token])), int(str(columns[token]))
        for relation in [*plain, *other]:
            yield Proposal(Kind.CUE, (Cue(*place, relation),))


def words(shown: Shown) -> Iterator[Proposal]:
    """Any word of the lexicon."""
    deck = shown.setting.deck
    if deck.lexicon:
        yield Proposal(Kind.WORD, (Word(),), 0.0)
        yield from _each(
            Kind.WORD_OF,
            (
                Word(relation=name, value=value)
                for name, related in deck.relations.items()
                for value in sorted({value for _, value in related})
            ),
        )


GENERATORS: Final[tuple[Generator, ...]] = (
    words,
    selections,
    orders,
    groupings,
    arithmetic,
    patterns,
    counts,
    places,
    sources,
    timings,
    contexts,
)
"""In the order in which equal rules are kept: the first is said."""


@dataclass(frozen=True, slots=True)
class Survivor:
    """A proposal that holds of all plays but perhaps one."""

    rules: tuple[Rule, ...]
    broken: int
    """The plays it does not hold of, as a bit set."""
    bits: float
    """What it costs alone."""
    added: float
    """What it costs more to be added to another."""


def surviving(plays: Sequence[Play], *, timed: bool, slips: int) -> list[Survivor]:
    """The proposals that hold of all plays but at most `slips` of them."""
    shown = Shown(tuple(plays), timed)
    # Where it does not matter where tokens lay, what one start remembers serves all plays.
    first = plays[0].setting
    alike = same_tokens([play.setting for play in plays])
    moved = [replace(play, setting=first) for play in plays] if alike else plays
    broken: dict[Rule, int] = {}

    def breaches(rule: Rule) -> int:
        if rule not in broken:
            where = plays if looks_at_start(rule) else moved
            broken[rule] = sum(1 << k for k, play in enumerate(where) if not rule.holds(play))
        return broken[rule]

    proposed = {
        proposal.rules: proposal for generator in GENERATORS for proposal in generator(shown)
    }
    of_kind = Counter(one.kind for one in proposed.values() if one.bits is None)
    found: list[Survivor] = []
    for one in proposed.values():
        wrong = 0
        for rule in one.rules:
            wrong |= breaches(rule)
        if wrong.bit_count() <= slips:
            parameters = one_of(of_kind[one.kind]) if one.bits is None else one.bits
            cost = FAMILY_BITS + KIND_BITS[one.kind] + parameters + one.seldom
            added = USUALLY_ADDED.get(one.kind, UNUSUAL_BITS)
            found.append(Survivor(one.rules, wrong, cost, added))
    return found


__all__ = ["GENERATORS", "Among", "Proposal", "Survivor", "Value", "surviving"]

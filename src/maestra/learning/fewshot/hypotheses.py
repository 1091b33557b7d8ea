"""The rules worth considering: one generator for each kind of rule, fed by what was shown.

Nothing here is a list of exercises: attributes, values, places and amounts are those of the
decks and plays. A generator may propose anything; `surviving` keeps what holds of the plays.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from itertools import combinations, permutations, product
from typing import Final, TypeAlias

from maestra.core.tokens import Scale, Value
from maestra.learning.fewshot.prior import kind_of, rule_bits
from maestra.learning.fewshot.space import looks_at_start, same_tokens
from maestra.learning.fewshot.token_tests import (
    naming,
    scales_of,
    selecting,
    simple,
    thresholds,
)
from maestra.rules.fields import Number
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Operation, Total
from maestra.rules.forms.length import FullRow, UntilTotal
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
from maestra.rules.setting import (
    ORIGIN_COLUMN,
    ORIGIN_ROW,
    Line,
    Play,
    Rank,
    Setting,
    bits,
)
from maestra.rules.token_tests import Among, Comparison, Extreme, TokenTest, has, passing

MAX_KINDS: Final = 6
"""Values an attribute may have for its pairs of values to be looked at."""
ORIGINS: Final = (ORIGIN_ROW, ORIGIN_COLUMN)


@dataclass(frozen=True)
class Shown:
    """What was shown, as the generators look at it."""

    plays: tuple[Play, ...]
    timed: bool
    """Whether rules about the order in time are worth a thought."""

    @property
    def setting(self) -> Setting:
        """That of the first play; the others' decks show the same attributes."""
        return self.plays[0].setting

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The lines to look along."""
        return (Line.ROW, Line.TIME) if self.timed else (Line.ROW,)

    @cached_property
    def scales(self) -> dict[str, Scale]:
        """Every attribute with its scale."""
        return scales_of(self.setting)

    @cached_property
    def ordinal(self) -> tuple[str, ...]:
        """The attributes of the tokens that have an order."""
        return tuple(k for k, s in self.setting.deck.scales.items() if s is not Scale.NOMINAL)

    @cached_property
    def numeric(self) -> tuple[str, ...]:
        """The attributes of the tokens that are numbers."""
        return tuple(k for k, s in self.setting.deck.scales.items() if s is Scale.NUMBER)

    @cached_property
    def basic(self) -> list[TokenTest]:
        """Simple tests that some token in storage passes and some other does not."""
        setting = self.setting
        everything = setting.movable
        seen: set[int] = set()
        kept: list[TokenTest] = []
        for test in simple(setting):
            mask = passing(setting, test) & everything
            if mask not in (0, everything) and mask not in seen:
                seen.add(mask)
                kept.append(test)
        return kept

    @cached_property
    def kinds(self) -> dict[str, list[TokenTest]]:
        """For each attribute with few shared values, the tests that name them."""
        named = {k: naming(self.setting, k) for k in self.scales}
        return {k: tests for k, tests in named.items() if 1 < len(tests) <= MAX_KINDS}

    @cached_property
    def contrasts(self) -> list[tuple[TokenTest, TokenTest]]:
        """Two tests of one attribute that no token passes both: red and blue, odd and even."""
        found: list[tuple[TokenTest, TokenTest]] = []
        for tests in self.kinds.values():
            found += permutations(tests, 2)
        for scale, one, two in (
            (Scale.NUMBER, "odd", "even"),
            (Scale.LETTER, "vowel", "consonant"),
        ):
            for attribute, its in self.setting.deck.scales.items():
                if its is scale:
                    found.append((has(one, attribute), has(two, attribute)))
                    found.append((has(two, attribute), has(one, attribute)))
        return found

    def amounts(self, attribute: str, of: Callable[[Rank, Rank], Rank | None]) -> list[Number]:
        """What `of` gives for the first pairs of neighbours of the plays; without repetition."""
        found: dict[Number, None] = {}
        for play in self.plays:
            ranks = play.setting.ranks(attribute)
            shown = [rank for t in play.tokens[:2] if (rank := ranks[t]) is not None]
            amount = of(shown[0], shown[1]) if len(shown) > 1 else None
            if amount is not None and (number := as_number(amount)) is not None:
                found[number] = None
        return list(found)


def as_number(rank: Rank) -> Number | None:
    """A number that can be written; None for a third."""
    fraction = Fraction(rank)
    if fraction.denominator == 1:
        return int(fraction)
    shown = Decimal(fraction.numerator) / Decimal(fraction.denominator)
    return shown if Fraction(shown) == fraction else None


Generator: TypeAlias = Callable[[Shown], Iterator[Rule]]


def selections(shown: Shown) -> Iterator[Rule]:
    """Only these tokens."""
    for test in selecting(shown.setting, shown.basic):
        masks = [passing(play.setting, test) for play in shown.plays]
        trivial = all(not p.setting.movable & ~m for p, m in zip(shown.plays, masks, strict=True))
        if not trivial:
            yield EveryToken(test)


def exhaustive(shown: Shown) -> Iterator[Rule]:
    """All of these tokens, none left behind."""
    for test in (*shown.basic, *thresholds(shown.setting)):
        yield AllOfThem(test)


def orders(shown: Shown) -> Iterator[Rule]:
    """Order and shape."""
    for line in shown.lines:
        for attribute in (*shown.ordinal, *ORIGINS):
            for direction in Direction:
                yield Ordered(attribute, direction, line=line)
                yield Ordered(attribute, direction, strict=False, line=line)
                if attribute not in ORIGINS:
                    yield RiseAndFall(attribute, direction, line)
                if shown.scales[attribute] is Scale.CYCLE:
                    yield CyclicOrdered(attribute, direction, line)
            yield Zigzag(attribute, line)
            if attribute not in ORIGINS:
                yield EqualSteps(attribute, line=line)
            if attribute in shown.numeric:
                yield EqualSteps(attribute, ratio=True, line=line)
    for attribute, extreme in product(shown.ordinal, Extreme):
        for place in (MIDDLE, *range(1, shown.setting.length + 1)):
            yield ExtremeAt(attribute, extreme, Position(place))


def _quotient(a: Rank, b: Rank) -> Rank | None:
    return Fraction(b) / a if a else None


def _difference(a: Rank, b: Rank) -> Rank:
    return Fraction(b) - a


def _distance(a: Rank, b: Rank) -> Rank:
    return abs(Fraction(b) - a)


def _sum(a: Rank, b: Rank) -> Rank:
    return Fraction(a) + b


def relations_of(shown: Shown) -> Iterator[Relation]:
    """Relations that a pair of neighbours suggests."""
    for attribute in shown.scales:
        yield from (same(attribute), different(attribute))
    for attribute in (*shown.ordinal, *ORIGINS):
        yield from (Step(attribute, n) for n in shown.amounts(attribute, _difference))
        yield from (Apart(attribute, n) for n in shown.amounts(attribute, _distance))
    for attribute in shown.numeric:
        quotients = shown.amounts(attribute, _quotient)
        yield from (Times(attribute, n) for n in quotients)
        yield from (AddUp(attribute, n) for n in shown.amounts(attribute, _sum))
    yield from (Named(name) for name in shown.setting.deck.relations)


def pairs(shown: Shown) -> Iterator[Rule]:
    """Neighbours, partners, mirrored, all pairs; two given places."""
    relations = list(relations_of(shown))
    for line, relation, which in product(shown.lines, relations, Pairs):
        if line is Line.ROW or which is not Pairs.MIRRORED:
            yield EachPair(which, relation, line)
    places = [*range(1, shown.setting.length), LAST]
    attributes = tuple(shown.setting.deck.scales)
    plain: list[Relation] = [r(a) for a in attributes for r in (same, different)]
    plain += [
        Compare(a, order) for a in shown.ordinal for order in (Comparison.LESS, Comparison.MORE)
    ]
    plain += [Named(name) for name in shown.setting.deck.relations]
    for (one, two), relation in product(combinations(places, 2), plain):
        yield TwoPlaces(Position(one), Position(two), relation)


def patterns(shown: Shown) -> Iterator[Rule]:
    """Rows and templates that repeat, blocks, and the same row every time."""
    for line in shown.lines:
        for one, two in shown.contrasts:
            yield Pattern((one, two), repeat=True, line=line)
        for tests in shown.kinds.values():
            yield from (Pattern(three, repeat=True, line=line) for three in permutations(tests, 3))
        for attribute in shown.kinds:
            yield Blocks(attribute, line)
            yield from (
                Template(attribute, letters, repeat=True, line=line) for letters in REPEATED
            )
            if letters := template_of(shown, attribute, line):
                yield Template(attribute, letters, line=line)
    for attribute in shown.setting.deck.scales:
        for play in shown.plays:
            values = play.setting.values(attribute)
            row = tuple(None if t is None else values[t] for t in play.row)
            if None not in row:
                yield given_row(attribute, row)


REPEATED: Final = ("AB", "ABC", "AAB", "ABB", "AABB")


def template_of(shown: Shown, attribute: str, line: Line) -> str:
    """The pattern of equal and different values of the first play; nothing if it has gaps."""
    play = shown.plays[0]
    values = [None if t is None else play.setting.values(attribute)[t] for t in play.slots(line)]
    letters: dict[Value | None, str] = {}
    for value in values:
        letters.setdefault(value, chr(ord("A") + len(letters)))
    wanted = 1 < len(letters) < len(values) and None not in letters
    return "".join(letters[value] for value in values) if wanted else ""


def counts(shown: Shown) -> Iterator[Rule]:
    """So many of a kind, so many kinds, more of one than of another."""
    for test in shown.basic:
        found = sorted(play.count(passing(play.setting, test)) for play in shown.plays)
        for number in {found[0], found[-1]}:
            if 0 < number < shown.setting.length:
                yield Count(test, Comparison.EQUAL, number)
                yield Count(test, Comparison.AT_LEAST, number)
                yield Count(test, Comparison.AT_MOST, number)
    for one, two in shown.contrasts:
        yield CompareCounts(one, Comparison.MORE, two)
        yield CompareCounts(one, Comparison.AT_LEAST, two)
        yield CompareCounts(one, Comparison.EQUAL, two)
    for attribute in shown.kinds:
        found = sorted(Kinds(attribute, Comparison.EQUAL, 0).amount(p) for p in shown.plays)
        for number in {found[0], found[-1]} - {0}:
            orders_ = (Comparison.EQUAL, Comparison.AT_LEAST, Comparison.AT_MOST)
            yield from (Kinds(attribute, order, number) for order in orders_)


def sums(shown: Shown) -> Iterator[Rule]:
    """What the row adds up to, and equations over places."""
    for attribute in shown.numeric:
        for play in shown.plays:
            ranks = play.setting.ranks(attribute)
            found = [rank for t in play.tokens if (rank := ranks[t]) is not None]
            total = as_number(Fraction(sum(found)))
            exact = [] if total is None else [total]
            yield from (Total(attribute, Comparison.EQUAL, number) for number in exact)
            for number in {10 * (int(sum(found)) // 10), 10 * -(-int(sum(found)) // 10)}:
                yield Total(attribute, Comparison.AT_LEAST, number)
                yield Total(attribute, Comparison.AT_MOST, number)
                yield UntilTotal(attribute, number)
        places = [Position(k) for k in range(1, shown.setting.length + 1)]
        for result, operation in product(places, Operation):
            others = [place for place in places if place != result]
            for one, two in combinations(others, 2):
                constant = 0 if operation is Operation.SUM else 1
                yield Equation(attribute, (one, two), (result,), constant, operation)


def places(shown: Shown) -> Iterator[Rule]:
    """What is asked of one place, and conditions on the ends."""
    tests: list[TokenTest] = list(shown.basic)
    for attribute, extreme in product(shown.ordinal, Extreme):
        tests.append(Among(attribute, extreme, 1))
    spots = [*range(1, shown.setting.length), LAST, MIDDLE]
    for place, test in product(spots, tests):
        yield At(Position(place), test)
    if shown.timed:
        yield from (At(place, test, Line.TIME) for place in (FIRST, LAST) for test in tests)
    for one, two in shown.contrasts:
        yield IfThen(At(FIRST, one), At(LAST, two))
        yield IfThen(At(FIRST, one), At(LAST, one))


def sources(shown: Shown) -> Iterator[Rule]:
    """Where tokens come from; a selection by row or column is among `selections`."""
    yield from (StraightUp(), StraightUp(mirrored=True))
    for attribute, extreme in product((*shown.ordinal, ORIGIN_COLUMN), Extreme):
        yield TakeExtreme(attribute, extreme)


def timings(shown: Shown) -> Iterator[Rule]:
    """One kind before another; after one kind another."""
    for line in shown.lines:
        for one, two in shown.contrasts:
            yield Before(one, two, line)
            yield Follows(one, two, line=line)
            yield Follows(one, two, immediately=False, line=line)


def contexts(shown: Shown) -> Iterator[Rule]:
    """Rows and single tokens of the start that stay and are followed."""
    plain: list[Relation] = [same(attribute) for attribute in shown.setting.deck.scales]
    plain += [Named(name) for name in shown.setting.deck.relations]
    plain += [
        Compare(one, Comparison.EQUAL, two)
        for one, two in permutations(shown.setting.deck.scales, 2)
        if set(shown.setting.values(one)) & set(shown.setting.values(two)) - {None}
    ]
    rows = shown.setting.start.board.rows - 1
    for row in range(1, rows + 1):
        here = passing(shown.setting, has(f"is-{row}", ORIGIN_ROW))
        if not here or any(here & sum(1 << t for t in p.tokens) for p in shown.plays[:1]):
            here = 0
        if here:
            for reading, relation in product(Reading, plain):
                yield ModelRow(row, reading, relation)
    stays = shown.plays[0].left
    columns = shown.setting.values(ORIGIN_COLUMN)
    storage = shown.setting.values(ORIGIN_ROW)
    cells = [(storage[token], columns[token]) for token in bits(stays)]
    for (line, column), relation in product(cells, plain):
        yield Cue(int(str(line)), int(str(column)), relation)


def lengths(shown: Shown) -> Iterator[Rule]:
    """When the play is over, and words."""
    yield FullRow()
    if shown.setting.deck.lexicon:
        yield Word()
        for name, related in shown.setting.deck.relations.items():
            yield from (Word(relation=name, value=v) for v in sorted({v for _, v in related}))


GENERATORS: Final[tuple[Generator, ...]] = (
    lengths,
    selections,
    exhaustive,
    orders,
    pairs,
    patterns,
    counts,
    sums,
    places,
    sources,
    timings,
    contexts,
)
"""In the order in which equal rules are kept: the first is said."""


@dataclass(frozen=True, slots=True)
class Survivor:
    """A rule that holds of all plays but perhaps one."""

    rule: Rule
    broken: int
    """The plays it does not hold of, as a bit set."""
    bits: float
    """What it costs as part of a hypothesis."""


def surviving(plays: Sequence[Play], *, timed: bool) -> list[Survivor]:
    """The rules that hold of all plays, or of all but one if there are three or more."""
    enough = 3
    shown = Shown(tuple(plays), timed)
    allowed = 1 if len(plays) >= enough else 0
    # Where it does not matter where tokens lay, what one start remembers serves all plays.
    first = plays[0].setting
    alike = same_tokens([play.setting for play in plays])
    moved = [replace(play, setting=first) for play in plays] if alike else plays
    found: dict[Rule, int] = {}
    thought_of: Counter[tuple[object, ...]] = Counter()
    for generator in GENERATORS:
        for rule in generator(shown):
            if rule not in found:
                where = plays if looks_at_start(rule) else moved
                found[rule] = sum(1 << k for k, play in enumerate(where) if not rule.holds(play))
                thought_of[kind_of(rule)] += 1
    return [
        Survivor(rule, broken, rule_bits(rule, first, thought_of[kind_of(rule)]))
        for rule, broken in found.items()
        if broken.bit_count() <= allowed
    ]

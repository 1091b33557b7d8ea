"""The order of the tokens along the row or in time, and the shape of what they show."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations, pairwise, permutations, product
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from maestra.rules.fields import Flag, Name, Place
from maestra.rules.forms.base import (
    Direction,
    Form,
    Link,
    Pairwise,
    can_clash,
    place_of,
)
from maestra.rules.forms.ranks import (
    NO_LIMIT,
    PAIR,
    SIGN,
    all_ranked,
    dense_ranks,
    few_of_each,
    rank_table,
    ranks_along,
)
from maestra.rules.pairs import Compare, Related, related
from maestra.rules.plays import NOBODY, Plays, Truth, as_matrix
from maestra.rules.setting import Index, Line, Play, Rank, Setting, bits
from maestra.rules.token_tests import Comparison, Extreme

_ORDERS = {
    (Direction.RISING, True): Comparison.LESS,
    (Direction.RISING, False): Comparison.AT_MOST,
    (Direction.FALLING, True): Comparison.MORE,
    (Direction.FALLING, False): Comparison.AT_LEAST,
}


def order_of(direction: Direction, *, strict: bool) -> Comparison:
    """How one token compares to a later one."""
    return _ORDERS[direction, strict]


@dataclass(frozen=True, slots=True)
class Ordered(Pairwise):
    """Of two tokens the one further on the line shows more (rising) or less (falling).

    Not strict: or as much. Gaps do not matter. A token without a rank is never in order with
    another.
    """

    attribute: Name
    direction: Direction = Direction.RISING
    strict: Flag = True
    line: Line = Line.ROW
    form: Literal["ordered"] = field(default="ordered", kw_only=True, repr=False)

    def along(self) -> Line:
        """The line of the rule."""
        return self.line

    def links(self, setting: Setting) -> Iterator[Link]:
        """Every pair."""
        comparison = order_of(self.direction, strict=self.strict)
        masks = related(setting, Compare(self.attribute, comparison))
        for i, j in combinations(range(setting.length), 2):
            yield i, j, masks


@dataclass(frozen=True, slots=True)
class CyclicOrdered(Form):
    """Strictly in order once round: from the last on to the first again, one step back at most.

    Friday, Sunday, Monday, Wednesday. Gaps do not matter; every token has a rank.
    """

    attribute: Name
    direction: Direction = Direction.RISING
    line: Line = Line.ROW
    form: Literal["cyclic-ordered"] = field(default="cyclic-ordered", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """Some rotation of the line is strictly in order."""
        ranks = ranks_along(play, self.line, self.attribute, self.direction)
        if ranks is None:
            return False
        turned = [ranks[k:] + ranks[:k] for k in range(len(ranks) or 1)]
        return any(all(a < b for a, b in pairwise(one)) for one in turned)

    def possible(self, play: Play) -> bool:
        """A part of a line in order is in order."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no token that is left can come to disturb the order.

        Two new ones and any other token can always be placed the wrong way round.
        """
        if not self.holds(play):
            return False
        ranks = [play.setting.ranks(self.attribute)[token] for token in bits(play.left)]
        seen = sum(token is not None for token in play.slots(self.line))
        if not play.room or (not seen and play.room == 1):
            return not play.room or None not in ranks
        if play.room == 1:
            return all(self.holds(longer) for longer in play.extensions())
        return (
            None not in ranks and not seen and play.room == PAIR and len(set(ranks)) == len(ranks)
        )

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: counted once round, at most one token does not show more than the last."""
        ranks, present = dense_ranks(plays, self.line, self.attribute, self.direction)
        length = present.sum(axis=1)
        following = np.roll(ranks, -1, axis=1)
        ends = np.maximum(length - 1, 0)
        following[np.arange(len(plays)), ends] = ranks[:, 0]
        falls = (following <= ranks) & present
        one_fall = np.asarray(falls.sum(axis=1) <= 1)
        return one_fall & all_ranked(plays, self.line, self.attribute)


@dataclass(frozen=True, slots=True)
class RiseAndFall(Form):
    """Up, then down (rising), or down, then up (falling): nothing lies between two as extreme.

    One of the two parts may be missing; `ExtremeAt` says where the turn is or is not. Gaps do
    not matter; every token has a rank.
    """

    attribute: Name
    direction: Direction = Direction.RISING
    line: Line = Line.ROW
    form: Literal["rise-and-fall"] = field(default="rise-and-fall", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """No token has on both sides one that is at least as far."""
        ranks = ranks_along(play, self.line, self.attribute, self.direction)
        return ranks is not None and not any(
            two <= one and two <= three for one, two, three in combinations(ranks, 3)
        )

    def possible(self, play: Play) -> bool:
        """A part of such a line is such a line."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no token that is left can come between, or on a side."""
        if not self.holds(play):
            return False
        sign = SIGN[self.direction]
        ranks = [None if r is None else sign * r for r in play.setting.ranks(self.attribute)]
        left = sorted(r for token in bits(play.left) if (r := ranks[token]) is not None)
        if not play.room:
            return True
        if len(left) < play.left.bit_count():
            return False
        slots = [None if token is None else ranks[token] for token in play.slots(self.line)]
        return not any(_can_dip(slots, k, left, play.room) for k in range(1, len(slots) - 1))

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: against the farthest before and the farthest after."""
        ranks, present = dense_ranks(plays, self.line, self.attribute, self.direction)
        high = np.where(present, ranks, -1)
        before = np.maximum.accumulate(high, axis=1)[:, :-2]
        after = np.maximum.accumulate(high[:, ::-1], axis=1)[:, ::-1][:, 2:]
        middle = high[:, 1:-1]
        dips = present[:, 1:-1] & (middle <= before) & (middle <= after)
        return ~dips.any(axis=1) & all_ranked(plays, self.line, self.attribute)


def _can_dip(slots: list[Rank | None], k: int, left: list[Rank], room: int) -> bool:
    """Whether slot k can come to be no farther than a slot on each side; `left` is sorted."""
    middle = slots[k]
    spare = left
    if middle is None:
        middle, spare, room = left[0], left[1:], room - 1
    high = [rank for rank in spare if rank >= middle]
    needed = 0
    for side in (slots[:k], slots[k + 1 :]):
        if any(rank is not None and rank >= middle for rank in side):
            continue
        if None not in side:
            return False
        needed += 1
    return needed <= min(room, len(high))


@dataclass(frozen=True, slots=True)
class Zigzag(Form):
    """Up and down by turns: neighbours differ, and one between two is above or below both."""

    attribute: Name
    line: Line = Line.ROW
    form: Literal["zigzag"] = field(default="zigzag", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says, of slots that are all filled."""
        ranks = play.setting.ranks(self.attribute)
        slots = play.slots(self.line)
        for one, two in pairwise(slots):
            if one is not None and two is not None:
                a, b = ranks[one], ranks[two]
                if a is None or b is None or a == b:
                    return False
        return not any(
            None not in three and _monotone([ranks[k] for k in three if k is not None])
            for three in zip(slots, slots[1:], slots[2:], strict=False)
        )

    def possible(self, play: Play) -> bool:
        """What lies wrong stays wrong, and ending adds nothing wrong."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no neighbours can come to be equal, and no three to go one way."""
        if not self.holds(play):
            return False
        slots = play.slots(self.line)
        less, more = self._masks(play.setting)
        unequal = tuple(one | other for one, other in zip(less, more, strict=True))
        if play.room and any(can_clash(play, a, b, unequal) for a, b in pairwise(slots)):
            return False
        return not any(
            0 < three.count(None) <= play.room and self._can_go_one_way(play, three)
            for three in zip(slots, slots[1:], slots[2:], strict=False)
        )

    def _masks(self, setting: Setting) -> tuple[Related, Related]:
        orders = (Comparison.LESS, Comparison.MORE)
        less, more = (related(setting, Compare(self.attribute, order)) for order in orders)
        return less, more

    def _can_go_one_way(self, play: Play, three: tuple[Index | None, ...]) -> bool:
        first, middle, last = (play.left if token is None else 1 << token for token in three)
        less, more = self._masks(play.setting)
        return any(
            (first & less[k] and last & more[k]) or (first & more[k] and last & less[k])
            for k in bits(middle)
        )

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        tokens = plays.line(self.line)
        less, more = (as_matrix(plays.setting, one) for one in self._masks(plays.setting))
        up, down = (one[tokens[:, :-1], tokens[:, 1:]] for one in (less, more))
        present = (tokens[:, :-1] != NOBODY) & (tokens[:, 1:] != NOBODY)
        up, down = up & present, down & present
        one_way = (up[:, :-1] & up[:, 1:]) | (down[:, :-1] & down[:, 1:])
        right: Truth = (up | down | ~present).all(axis=1) & ~one_way.any(axis=1)
        return right


def _monotone(ranks: Sequence[Rank | None]) -> bool:
    return all(a is not None and b is not None and a < b for a, b in pairwise(ranks)) or all(
        a is not None and b is not None and a > b for a, b in pairwise(ranks)
    )


@dataclass(frozen=True, slots=True)
class EqualSteps(Form):
    """From neighbour to neighbour always the same difference, or the same ratio, whichever it is.

    Round the cycle, if it is one. A fixed difference or ratio is an `EachPair` of neighbours.
    """

    attribute: Name
    ratio: Flag = False
    line: Line = Line.ROW
    form: Literal["equal-steps"] = field(default="equal-steps", kw_only=True, repr=False)

    def step(self, setting: Setting, one: Index, two: Index) -> Rank | None:
        """The difference or ratio from one token to another; None if there is none."""
        ranks = setting.ranks(self.attribute)
        a, b = ranks[one], ranks[two]
        if a is None or b is None:
            return None
        if self.ratio:
            return Fraction(b) / a if a else None
        cycle = len(setting.deck.cycles.get(self.attribute, ()))
        return (b - a) % cycle if cycle else b - a

    def _steps(self, play: Play) -> set[Rank | None]:
        return {
            self.step(play.setting, one, two)
            for one, two in pairwise(play.slots(self.line))
            if one is not None and two is not None
        }

    def holds(self, play: Play) -> bool:
        """One step at most between neighbours, and no pair without one."""
        steps = self._steps(play)
        return None not in steps and len(steps) <= 1

    def possible(self, play: Play) -> bool:
        """What lies wrong stays wrong, and ending adds nothing wrong."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no neighbours can come to have another step."""
        steps = self._steps(play)
        if None in steps or len(steps) > 1:
            return False
        if not play.room:
            return True
        slots = play.slots(self.line)
        masks = self._defined(play.setting) if not steps else self._with(play.setting, *steps)
        if any(can_clash(play, one, two, masks) for one, two in pairwise(slots)):
            return False
        return bool(steps) or not self._can_differ(play, slots)

    def _defined(self, setting: Setting) -> Related:
        return setting.remember(
            (self, "defined"),
            lambda: setting.masks(lambda a, b: self.step(setting, a, b) is not None),
        )

    def _with(self, setting: Setting, step: Rank | None) -> Related:
        return setting.remember(
            (self, "with", step),
            lambda: setting.masks(lambda a, b: self.step(setting, a, b) == step),
        )

    def _can_differ(self, play: Play, slots: tuple[Index | None, ...]) -> bool:
        """Whether two pairs of neighbours, none of them filled yet, can get different steps."""
        ranks = play.setting.ranks(self.attribute)
        left = few_of_each(bits(play.left), lambda token: ranks[token], 4)
        for i, j in combinations(range(len(slots) - 1), 2):
            places = sorted({i, i + 1, j, j + 1})
            new = [place for place in places if slots[place] is None]
            if len(new) > play.room:
                continue
            for tokens in permutations(left, len(new)):
                filled = dict(zip(new, tokens, strict=True))
                a, b, c, d = (
                    token if (token := slots[k]) is not None else filled[k]
                    for k in (i, i + 1, j, j + 1)
                )
                if self.step(play.setting, a, b) != self.step(play.setting, c, d):
                    return True
        return False

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: each pair of tokens has the number of its step."""
        tokens = plays.line(self.line)
        table = plays.setting.remember((self, "steps"), lambda: self._numbered(plays.setting))
        steps = table[tokens[:, :-1], tokens[:, 1:]]
        present = (tokens[:, :-1] != NOBODY) & (tokens[:, 1:] != NOBODY)
        largest = np.where(present, steps, 0).max(axis=1, initial=0)
        least = np.where(present, steps, largest[:, None]).min(axis=1, initial=NO_LIMIT)
        undefined = (present & (steps < 0)).any(axis=1)
        right: Truth = (~present.any(axis=1) | (least == largest)) & ~undefined
        return right

    def _numbered(self, setting: Setting) -> NDArray[np.int64]:
        count = len(setting.deck.tokens)
        numbers: dict[Rank, int] = {}
        table = np.full((count + 1, count + 1), -1, np.int64)
        for a, b in product(range(count), repeat=2):
            if (step := self.step(setting, a, b)) is not None:
                table[a, b] = numbers.setdefault(step, len(numbers))
        return table


@dataclass(frozen=True, slots=True)
class ExtremeAt(Form):
    """The token at `position` of the row shows the least or the most of the row, ties allowed.

    It is there, and every token of the row has a rank. `negated`: that is not so.
    """

    attribute: Name
    extreme: Extreme
    position: Place
    negated: Flag = False
    form: Literal["extreme-at"] = field(default="extreme-at", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        place = place_of(self.position, play.setting.length)
        token = None if place is None else play.row[place]
        ranks = self._ranks(play.setting)
        mine = None if token is None else ranks[token]
        is_so = mine is not None and all(
            (rank := ranks[other]) is not None and rank <= mine for other in play.tokens
        )
        return is_so is not self.negated

    def possible(self, play: Play) -> bool:
        """As the base says."""
        return not self._must(play) if self.negated else self._may(play)

    def certain(self, play: Play) -> bool:
        """As the base says."""
        return not self._may(play) if self.negated else self._must(play)

    def _ranks(self, setting: Setting) -> tuple[Rank | None, ...]:
        sign = 1 if self.extreme is Extreme.HIGHEST else -1
        return tuple(None if r is None else sign * r for r in setting.ranks(self.attribute))

    def _may(self, play: Play) -> bool:
        """Whether the token there can come to be, or stay, the extreme one."""
        place = place_of(self.position, play.setting.length)
        if place is None:
            return False
        ranks = self._ranks(play.setting)
        others = [ranks[token] for token in play.tokens]
        lies = play.row[place]
        candidates = bits(play.left) if lies is None else (lies,)
        return None not in others and any(
            (rank := ranks[token]) is not None
            and all(other is None or other <= rank for other in others)
            for token in candidates
        )

    def _must(self, play: Play) -> bool:
        """Whether it is the extreme one, and no token that is left can change that."""
        place = place_of(self.position, play.setting.length)
        token = None if place is None else play.row[place]
        ranks = self._ranks(play.setting)
        mine = None if token is None else ranks[token]
        others = [*play.tokens, *(bits(play.left) if play.room else ())]
        return mine is not None and all(
            (rank := ranks[other]) is not None and rank <= mine for other in others
        )

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        place = place_of(self.position, plays.setting.length)
        if place is None:
            return np.full(len(plays), self.negated)
        way = Direction.RISING if self.extreme is Extreme.HIGHEST else Direction.FALLING
        table = rank_table(plays.setting, self.attribute, way)
        ranks = table[plays.row]
        there = plays.row[:, place] != NOBODY
        is_so = there & (ranks[:, place] >= ranks.max(axis=1))
        is_so &= all_ranked(plays, Line.ROW, self.attribute)
        right: Truth = is_so != self.negated
        return right

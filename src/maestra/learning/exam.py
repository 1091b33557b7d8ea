"""The exam: the robot plays its own rules, right plays and near misses, and a person judges.

Plays are chosen to be as different as possible, from one another and from what was shown; a near
miss is a right play with one change, refused at just one place where there is such a one. What
the caregiver's judgement of `n` right plays says about all of them is the bound of Clopper and
Pearson [1]: with `k` called wrong, the share of wrong ones is below the p for which at most `k`
of `n` would be called wrong in 5 % of the cases. It holds for plays drawn at random; ours are
drawn to be more different than that, so that rare mistakes show sooner.

[1] C. J. Clopper, E. S. Pearson, The use of confidence or fiducial limits illustrated in the case
of the binomial, Biometrika 26, 1934.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from math import comb
from typing import Final

from maestra.core.state import State
from maestra.learning.chance import shuffled
from maestra.learning.drawn_plays import Drawer, distance, starts
from maestra.rules.answers import Answer, Reply, RowQuestion
from maestra.rules.exercise import Exam, RuledExercise
from maestra.rules.setting import Index, Play, Setting, play_of

STARTS_TRIED: Final = 3
"""Arrangements looked at for each one that plays begin from: some allow no right play."""
DRAWN: Final = 4
"""Plays drawn for each one wanted, to choose from."""
CHANGED: Final = 60
"""Near misses of one right play to choose from."""
WEIGHED: Final = 150
"""Near misses of which it is found out at how many places they are refused, for each wanted."""
CONFIDENCE: Final = 0.95
_STEPS: Final = 60
"""Of halving an interval: until a double can hold no more."""


@dataclass(frozen=True, slots=True)
class ExamPlay:
    """A play to be judged, and what the exercise says of it."""

    play: Play
    is_right: bool


@dataclass(frozen=True, slots=True)
class _Drawn:
    """A play with who can judge it."""

    play: Play
    drawer: Drawer


def exam_plays(exercise: RuledExercise, plays: int, seed: int) -> tuple[ExamPlay, ...]:
    """Right plays and near misses in a mixed order, at most `plays` of each.

    There are fewer where the rules allow so few, and no near misses where they allow everything.

    Args:
        exercise: what is examined.
        plays: how many of each.
        seed: any number; the same one draws the same plays.
    """
    shown = [play_of(one) for one in exercise.evidence.demonstrations]
    drawers = _drawers(exercise, plays, seed)
    right = _farthest(_right_plays(drawers, plays * DRAWN, seed), shown, plays)
    wrong = _near_misses(right, plays)
    mixed = [ExamPlay(one.play, is_right=True) for one in right]
    mixed += [ExamPlay(one.play, is_right=False) for one in wrong]
    return tuple(shuffled(mixed, seed))


def result(judged: Sequence[tuple[ExamPlay, Reply]], date: str) -> Exam:
    """How often the caregiver agreed; plays that the caregiver was unsure of count for nothing."""
    right = [reply for one, reply in judged if one.is_right and reply is not Reply.UNSURE]
    wrong = [reply for one, reply in judged if not one.is_right and reply is not Reply.UNSURE]
    return Exam(date, len(right), right.count(Reply.YES), len(wrong), wrong.count(Reply.NO))


def objections(judged: Sequence[tuple[ExamPlay, Reply]]) -> tuple[Answer, ...]:
    """What goes back to learning: the plays that the caregiver judged otherwise."""
    return tuple(
        Answer(RowQuestion(one.play), reply)
        for one, reply in judged
        if reply is (Reply.NO if one.is_right else Reply.YES)
    )


def most_wrong(plays: int, agreed: int, confidence: float = CONFIDENCE) -> float:
    """The share of plays that may be wrong at most, with this confidence, one-sided.

    Args:
        plays: how many were judged.
        agreed: how many of them were called right.
        confidence: that the true share is below what is returned.
    """
    wrong = plays - agreed
    if wrong >= plays:
        return 1.0
    low, high = wrong / plays, 1.0
    for _ in range(_STEPS):
        share = (low + high) / 2
        if _at_most(wrong, plays, share) > 1 - confidence:
            low = share
        else:
            high = share
    return high


def _at_most(wrong: int, plays: int, share: float) -> float:
    """How likely at most `wrong` of `plays` are wrong, if each is with this share."""
    return sum(comb(plays, k) * share**k * (1 - share) ** (plays - k) for k in range(wrong + 1))


def _drawers(exercise: RuledExercise, number: int, seed: int) -> list[Drawer]:
    """Who draws plays, each from an arrangement that right plays can begin from."""
    shown = list(dict.fromkeys(one.start for one in exercise.evidence.demonstrations))
    whole = [start for start in shown if start.cells.keys() == exercise.deck.by_id.keys()]
    found: list[Drawer] = []
    for setting in islice(_settings(exercise, whole, seed), number * STARTS_TRIED):
        drawer = Drawer(exercise.conjunction, setting)
        if drawer.right(seed) is not None:
            found.append(drawer)
        if len(found) == number:
            break
    return found


def _settings(exercise: RuledExercise, shown: Sequence[State], seed: int) -> Iterator[Setting]:
    yield from (Setting(exercise.deck, start) for start in shown)
    yield from starts(exercise.deck, exercise.board, shown, seed)


def _right_plays(drawers: Sequence[Drawer], number: int, seed: int) -> list[_Drawn]:
    """Different right plays, by turns from each arrangement."""
    found: dict[Play, _Drawn] = {}
    for turn in range(number):
        drawn = [(drawer.right(seed + turn), drawer) for drawer in drawers]
        found |= {
            play: _Drawn(play, drawer)
            for play, drawer in drawn
            if play is not None and play not in found
        }
        if len(found) >= number:
            break
    return list(found.values())


def _near_misses(right: Sequence[_Drawn], number: int) -> list[_Drawn]:
    """Near misses of right plays that break each rule about equally often, far from one another.

    Those that break one rule alone are preferred, and those that are refused at one place.
    """
    pool = {
        play: _Drawn(play, one.drawer)
        for one in right
        for play in islice(one.drawer.near_misses(one.play, number), CHANGED)
    }
    broken = {play: one.drawer.broken(play) for play, one in pool.items()}
    of_one_rule = [one for play, one in pool.items() if len(broken[play]) == 1]
    left = shuffled(of_one_rule or list(pool.values()), number)
    refusals: dict[Play, int] = {}

    def at_places(one: _Drawn) -> int:
        if one.play not in refusals:
            refusals[one.play] = one.drawer.refusals(one.play)
        return refusals[one.play]

    chosen: list[Play] = []
    found: list[_Drawn] = []
    while left and len(found) < number:
        met = Counter(broken[play] for play in chosen)
        rarest = min(met[broken[one.play]] for one in left)
        fit = [one for one in left if met[broken[one.play]] == rarest]
        far = sorted(fit, key=lambda one: -_nearest(one.play, chosen))
        weighed = far[:WEIGHED]
        single = (one for one in weighed if at_places(one) == 1)
        best = next(single, None) or min(weighed, key=at_places)
        found.append(best)
        chosen.append(best.play)
        left.remove(best)
    return found


def _farthest(drawn: Sequence[_Drawn], shown: Sequence[Play], number: int) -> list[_Drawn]:
    """Those farthest from one another and from what was shown, one after another."""
    left: dict[Index, float] = {k: _nearest(one.play, shown) for k, one in enumerate(drawn)}
    chosen: list[Index] = []
    while left and len(chosen) < number:
        best = max(left, key=lambda k: left[k])
        chosen.append(best)
        del left[best]
        for k, near in left.items():
            left[k] = min(near, distance(drawn[k].play, drawn[best].play))
    return [drawn[k] for k in chosen]


def _nearest(play: Play, others: Sequence[Play]) -> float:
    return min((distance(play, other) for other in others), default=1.0)

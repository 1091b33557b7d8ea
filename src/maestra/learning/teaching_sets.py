"""A smallest set of demonstrations from which the grounded learner learns all there is to learn.

This is set covering: each right play settles some literals of the actions it shows, and all that
some right play settles must be. There are billions of plays, so it is done in steps:

1. *A lower bound by counting.* Each action must be shown, and shown again if no single play
   settles all of its literals. A play shows each action once; so with any weights on actions
   that sum to at most one over each right sequence, the weighted number of showings is a bound.
   With equal weights it is showings divided by the moves of a play: for the paper's ascending
   exercise 30 actions, twice each, five a play: 12.
2. If there are few plays, an exact search: iterative deepening on the number of plays, branching
   on the open literal that the fewest plays settle.
3. Else a search for as many sequences as the bound says that show each action as often as it
   must be, then the best start for each in turn (`telling`). A set of that size is smallest.
4. Else greedy: the most telling play again and again, then without those that the others make
   needless. The bound says how far from the smallest it can be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from maestra.core.demonstration import Demonstration
from maestra.learning.covering import smallest_cover, union, without_needless
from maestra.learning.grounded import GroundedLearner
from maestra.learning.showings import Showings, count_showings
from maestra.learning.telling import MostTelling, Open, never_seen
from maestra.rules.ground_truth import ground_truth
from maestra.rules.right_plays import RightPlays
from maestra.rules.strips.vocabulary import Vocabulary

MAX_LISTED: Final = 1_000
"""Plays that the exact search lists at most."""
MAX_NODES: Final = 20_000
"""Steps of a search after which it gives up: seconds."""
MAX_ROWS: Final = 10_000_000
"""Sequences that the search for a set of the bound's size looks at: a few seconds."""
MAX_TRIES: Final = 20
"""Sets of sequences of the bound's size that are tried with starts."""


@dataclass(frozen=True, slots=True)
class TeachingSet:
    """Demonstrations that teach an exercise exactly, and how few could."""

    demonstrations: tuple[Demonstration, ...]
    lower_bound: int
    """No fewer demonstrations teach it exactly."""

    @property
    def is_smallest(self) -> bool:
        """Whether it is proven that fewer do not suffice."""
        return len(self.demonstrations) == self.lower_bound


def teaching_set(plays: RightPlays, vocabulary: Vocabulary) -> TeachingSet:
    """Demonstrations from which the grounded learner learns the ground truth, and a lower bound.

    Raises:
        InvalidError: the vocabulary is not about these plays.
        TooManyPlaysError: the right sequences cannot be enumerated.
    """
    needed = open_literals(plays, vocabulary)
    showings = count_showings(plays, vocabulary, needed)
    if plays.count <= MAX_LISTED:
        return _listed(plays, vocabulary, needed, showings.lower_bound)
    exact = _of_size_of_the_bound(plays, vocabulary, needed, showings)
    if exact is not None:
        return TeachingSet(exact, showings.lower_bound)
    return TeachingSet(_greedy(plays, vocabulary, needed), showings.lower_bound)


def open_literals(plays: RightPlays, vocabulary: Vocabulary) -> Open:
    """What a learner that has seen nothing has yet to delete, and to see (`never_seen`)."""
    index = vocabulary.index_of_shown
    return {
        (index[action.shown], action.step): (vocabulary.everything & ~bits)
        | never_seen(vocabulary)
        for action, bits in ground_truth(plays, vocabulary).preconditions.items()
    }


def _of_size_of_the_bound(
    plays: RightPlays, vocabulary: Vocabulary, needed: Open, showings: Showings
) -> tuple[Demonstration, ...] | None:
    """A set as small as the lower bound; None if none was found."""
    for tried, chosen in enumerate(showings.covers(MAX_ROWS)):
        if tried >= MAX_TRIES:
            return None
        search = MostTelling(plays, vocabulary, needed)
        shown: list[Demonstration] = []
        for group, row in chosen:
            telling = search.arrange(plays.groups[group], row)
            search.settle(telling.demonstration)
            shown.append(telling.demonstration)
        if not search.open_literals:
            return tuple(shown)
    return None


def _greedy(plays: RightPlays, vocabulary: Vocabulary, needed: Open) -> tuple[Demonstration, ...]:
    search = MostTelling(plays, vocabulary, needed)
    shown: list[Demonstration] = []
    while telling := search.most_telling():
        search.settle(telling.demonstration)
        shown.append(telling.demonstration)
    masks = _settled_masks(shown, vocabulary, needed)
    return tuple(shown[index] for index in without_needless(masks))


def _listed(plays: RightPlays, vocabulary: Vocabulary, needed: Open, bound: int) -> TeachingSet:
    """The exact search over all plays; greedy with the best bound if it takes too long."""
    listed = [plays.play(number) for number in range(plays.count)]
    greedy = _greedy(plays, vocabulary, needed)
    masks = _settled_masks(listed, vocabulary, needed)
    cover = smallest_cover(masks, MAX_NODES, at_least=bound, below=len(greedy))
    if cover.chosen is None:
        return TeachingSet(greedy, cover.lower_bound)
    return TeachingSet(tuple(listed[index] for index in cover.chosen), cover.lower_bound)


def _settled_masks(
    plays: Sequence[Demonstration], vocabulary: Vocabulary, needed: Open
) -> list[int]:
    """For each play one bit set of all that it settles, over all actions."""
    learner = GroundedLearner(vocabulary)
    width = never_seen(vocabulary).bit_length()
    place = {key: width * index for index, key in enumerate(needed)}
    return [
        union(
            (needed[key] & ~seen.holding) << place[key]
            for seen in learner.observe(play)
            for key in [(seen.moved, seen.step)]
        )
        for play in plays
    ]

"""Which conjunctions of proposals explain what was shown.

The score of a hypothesis is in bits, the fewer the better: what it takes to say its proposals
and, for each layout shown, the logarithm of how many layouts it allows (the size principle).
Every proposal and every pair of them is scored on an even sample of the rows; whatever may be
among the best is then scored exactly, and the best are made longer. Hypotheses that take one
demonstration for a slip are searched for in the same way, once for each demonstration.

Cost: O(proposals^2 x sample / 64 + candidates x rows / 64) words.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, log2
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from maestra.learning.fewshot.prior import CROWD_BITS, FREE_BITS, SLIP, TRUST, and_bits
from maestra.learning.fewshot.space import Rows, Words, shared
from maestra.learning.fewshot.truths import SAMPLE, Truths

PAIRED: Final = 160
"""Proposals that are paired with each other, those first that explain most alone."""
CANDIDATES: Final = 140
"""Hypotheses of one and two proposals that are scored exactly."""
BEAM: Final = 24
"""Conjunctions that are made longer."""
KEPT: Final = 150
"""Hypotheses that are looked at closely."""
LENGTH: Final = 4
"""Proposals of a hypothesis at most."""
WITHIN: Final = 12.0
"""Bits from the best beyond which a hypothesis is forgotten: one in 4,000."""
Numbers: TypeAlias = NDArray[np.float64]
Parts: TypeAlias = tuple[int, ...]
"""The proposals of a hypothesis by their numbers, in order."""


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """A layout that was shown: in which context, and which of its rows."""

    context: int
    rows: Words
    near: Words
    """The rows from which one mistake leads to a layout shown."""
    mistakes: float
    """How many such rows there are: the likelihood of a slip is shared among them."""


@dataclass(frozen=True, slots=True, eq=False)
class Answered:
    """What a caregiver said of rows: whether one of them is right."""

    context: int
    rows: Words
    """The row, or all rows that a move leaves open."""
    yes: bool
    out_of_order: float = 0.0
    """How likely it was a "no" to the order in which the tokens were placed."""
    mended: tuple[Words, ...] = ()
    """For each goal cell, the rows that differ from the one asked about by a mistake there."""
    wrong: int | None = None
    """The goal cell that the caregiver says is wrong."""


@dataclass(frozen=True, slots=True)
class Found:
    """A conjunction by the numbers of its proposals, what it costs, and which layout is a slip."""

    parts: Parts
    bits: float
    slip: int | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Frontier:
    """Conjunctions, the rows each allows in every context, and their scores."""

    parts: list[Parts]
    words: list[Words]
    """For each context that is needed: conjunctions x words."""
    bits: Numbers

    def best(self, number: int) -> Frontier:
        """So many of the best."""
        order = np.argsort(self.bits, kind="stable")[:number]
        order = order[self.bits[order] < inf]
        return Frontier(
            [self.parts[k] for k in order], [w[order] for w in self.words], self.bits[order]
        )


@dataclass(frozen=True, eq=False)
class Search:
    """A search for the conjunctions that explain layouts and answers best."""

    truths: Truths
    layouts: tuple[Layout, ...]
    """The different layouts that were shown."""
    answers: tuple[Answered, ...] = ()

    @cached_property
    def needed(self) -> tuple[int, ...]:
        """The contexts that layouts and answers are in."""
        seen = [e.context for e in self.layouts] + [a.context for a in self.answers]
        return tuple(dict.fromkeys(seen))

    @cached_property
    def _times(self) -> dict[int, int]:
        """How many layouts were shown in each context."""
        times = dict.fromkeys(self.needed, 0)
        for layout in self.layouts:
            times[layout.context] += 1
        return times

    def best(self) -> list[Found]:
        """The best conjunctions, best first, none worse than `WITHIN` bits than the best."""
        found = self.explaining(None, inf)
        for slip in self._suspects:
            found += self.explaining(slip, min(one.bits for one in found))
        found.sort(key=lambda one: one.bits)
        return [one for one in found[:KEPT] if one.bits <= found[0].bits + WITHIN]

    @cached_property
    def _suspects(self) -> tuple[int, ...]:
        """The layouts that some proposal breaks alone, if there are others."""
        broken = {one.broken for one in self.truths.survivors}
        few = 2
        if len(self.layouts) < few:
            return ()
        return tuple(k for k in range(len(self.layouts)) if 1 << k in broken)

    def explaining(self, slip: int | None, known: float) -> list[Found]:
        """The conjunctions of which just layout `slip` is no case; better ones are `known`."""
        allowed = 0 if slip is None else 1 << slip
        survivors = self.truths.survivors
        usable = [k for k, one in enumerate(survivors) if not one.broken & ~allowed]
        candidates = self._candidates(usable, slip, known)
        if not candidates:
            return []
        involved = sorted({part for parts in candidates for part in parts})
        truths = [
            np.array([self.truths.of(p, c) for p in involved], np.uint64).reshape(
                len(involved), self.truths.contexts[c].rows.everything.size
            )
            for c in self.needed
        ]
        words = [
            np.array([self.truths.of_all(parts, c) for parts in candidates]) for c in self.needed
        ]
        frontier = self._scored(candidates, words, slip)
        found = dict(zip(frontier.parts, frontier.bits.tolist(), strict=True))
        for _ in range(LENGTH - 2):
            frontier = self._longer(frontier.best(BEAM), involved, truths, slip, found)
            if not frontier.parts:
                break
            found.update(zip(frontier.parts, frontier.bits.tolist(), strict=True))
        return [
            Found(parts, bits, slip)
            for parts, bits in found.items()
            if bits < inf and (slip is None or any(survivors[p].broken for p in parts))
        ]

    def _longer(
        self,
        frontier: Frontier,
        involved: Sequence[int],
        truths: Sequence[Words],
        slip: int | None,
        found: dict[Parts, float],
    ) -> Frontier:
        """The conjunctions of the frontier with one more proposal each that says more."""
        limit = min(found.values()) + WITHIN
        survivors = self.truths.survivors
        own = np.array([survivors[p].bits for p in involved])
        kinds, kind = np.unique([survivors[p].added for p in involved], return_inverse=True)
        keys: list[Parts] = []
        words: list[list[Words]] = [[] for _ in self.needed]
        for k, parts in enumerate(frontier.parts):
            mine = [w[k] for w in frontier.words]
            # What costs too much alone need not be looked at.
            before = [survivors[p].added for p in parts]
            joined = np.array([and_bits([*before, one]) for one in kinds])[kind]
            some = np.flatnonzero(own + sum(survivors[p].bits for p in parts) + joined < limit)
            both = [w & t[some] for w, t in zip(mine, truths, strict=True)]
            less = np.zeros(len(some), np.bool_)
            for w, longer in zip(mine, both, strict=True):
                less |= (longer != w).any(axis=1)
            for place in np.flatnonzero(less):
                key = tuple(sorted((*parts, involved[int(some[place])])))
                if key not in found:
                    found[key] = inf
                    keys.append(key)
                    for w, longer in zip(words, both, strict=True):
                        w.append(longer[place])
        return self._scored(keys, [np.array(w, np.uint64) for w in words], slip)

    def _candidates(self, usable: Sequence[int], slip: int | None, known: float) -> list[Parts]:
        """Nothing, single proposals and pairs that may be among the best, by the sample."""
        nothing: list[Parts] = [()] if slip is None else []
        if not usable:
            return nothing
        survivors = self.truths.survivors
        own = np.array([survivors[p].bits for p in usable])
        coarse = [
            np.array([self.truths.coarse(p, c) for p in usable], np.uint64) for c in self.needed
        ]
        everything = [self._some(c).everything[None] for c in self.needed]
        single = own + CROWD_BITS[1] + self._coarse_bits(everything, coarse)[0]
        order = np.argsort(single - 0.5 * own, kind="stable")[:PAIRED]
        few = [usable[int(k)] for k in order]
        ones, twos = np.triu_indices(len(few), 1)
        pair = self._pair_bits(few, [words[order] for words in coarse])[ones, twos]
        bits = np.concatenate([single, pair])
        if slip is not None:
            bits -= log2(SLIP)
        limit = min(known, float(bits.min())) + WITHIN
        best = np.argsort(bits, kind="stable")[:CANDIDATES]
        best = best[bits[best] <= limit]
        return [*nothing, *(self._parts_at(int(k), usable, few, ones, twos) for k in best)]

    @staticmethod
    def _parts_at(
        place: int,
        usable: Sequence[int],
        few: Sequence[int],
        ones: NDArray[np.intp],
        twos: NDArray[np.intp],
    ) -> Parts:
        """What stands at a place of the singles and the pairs behind them."""
        if place < len(usable):
            return (usable[place],)
        one = few[int(ones[place - len(usable)])]
        two = few[int(twos[place - len(usable)])]
        return (min(one, two), max(one, two))

    def _pair_bits(self, few: Sequence[int], coarse: list[Words]) -> Numbers:
        """The score by the sample of each two of a few proposals; infinite for no real pair."""
        own = np.array([self.truths.survivors[p].bits for p in few])
        added = np.array([self.truths.survivors[p].added for p in few])
        together = self._coarse_bits(coarse, coarse)
        # As `and_bits` says, for all pairs at once.
        joined = added[:, None] + added - np.maximum(np.maximum(added[:, None], added), 0.0)
        bits = own[:, None] + own + CROWD_BITS[2] + together + joined
        # A pair in which one of the two says nothing more is none.
        alone = np.diagonal(together)
        idle = together >= np.minimum(alone[:, None], alone) - 1e-9
        return np.asarray(np.where(idle, inf, bits), np.float64)

    def _some(self, context: int) -> Rows:
        return self.truths.contexts[context].some(SAMPLE).rows

    def _coarse_bits(self, ones: list[Words], others: list[Words]) -> Numbers:
        """Bits to name each layout among those that two proposals both allow, by the sample."""
        total = np.zeros((len(ones[0]), len(others[0])))
        for c, one, other in zip(self.needed, ones, others, strict=True):
            some = self._some(c)
            counts = np.array([shared(words, other, some.word_weight) for words in one])
            scale = self.truths.contexts[c].rows.size / some.size
            # What no row of the sample shows may still be a third of one.
            total += self._times[c] * np.log2(np.maximum(counts * scale, max(0.3 * scale, 1.0)))
        return total

    def _prior(self, parts: Sequence[int]) -> float:
        if not parts:
            return FREE_BITS
        mine = [self.truths.survivors[p] for p in parts]
        return sum(one.bits for one in mine) + and_bits([one.added for one in mine])

    def _scored(self, parts: list[Parts], words: list[Words], slip: int | None) -> Frontier:
        """The conjunctions with their scores, given the rows they allow in each context."""
        if not parts:
            return Frontier([], words, np.zeros(0))
        rows = [self.truths.contexts[c].rows for c in self.needed]
        weights = [one.word_weight for one in rows]
        everything = [one.everything for one in rows]
        bits_ = np.array([self._prior(one) for one in parts])
        sizes = [
            np.log2(np.maximum(shared(all_, w, weight), 1e-9))
            for w, all_, weight in zip(words, everything, weights, strict=True)
        ]
        for k, layout in enumerate(self.layouts):
            at = self.needed.index(layout.context)
            bits_ += np.where(sizes[at] < 0, inf, sizes[at])
            if k == slip:
                near = shared(layout.near, words[at], weights[at])
                likely = np.log2(np.maximum(near, 1e-9)) + log2(SLIP / layout.mistakes)
                bits_ += np.where(near < 1, inf, -likely)
        for answer in self.answers:
            at = self.needed.index(answer.context)
            says = (words[at] & answer.rows).any(axis=1)
            agreed = TRUST + answer.out_of_order * (1 - 2 * TRUST)
            yes = np.where(says, agreed, 1 - TRUST)
            bits_ -= np.log2(yes if answer.yes else 1 - yes)
            if answer.wrong is not None:
                bits_ -= np.log2(_pointed_at(answer, answer.wrong, words[at]))
        return Frontier(parts, words, bits_)


def _pointed_at(answer: Answered, wrong: int, words: Words) -> Numbers:
    """How likely the goal cell that is said to be wrong is, if each set of rows is what is right.

    It is one where a change makes the row right; any, if none does.
    """
    mends = np.array([(words & near).any(axis=1) for near in answer.mended])
    places = mends.sum(axis=0)
    anywhere = 1 / len(answer.mended)
    meant = np.where(places > 0, mends[wrong] / np.maximum(places, 1), anywhere)
    return np.asarray(TRUST * meant + (1 - TRUST) * anywhere, np.float64)

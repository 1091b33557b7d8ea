"""How likely each hypothesis is, with people's habits and the answers about rules weighed in.

The search takes all plays that a hypothesis allows for equally likely. But people take what is
near, and some show the same row again and again: that alone must not become a rule.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from math import log2

import numpy as np

from maestra.learning.fewshot.evidence import Evidence
from maestra.learning.fewshot.lesson import Belief, Class
from maestra.learning.fewshot.posterior import Found, Numbers, Search
from maestra.learning.fewshot.prior import (
    ALONE,
    FREE_BITS,
    LAZY,
    NEAREST,
    OUTSIDE_BITS,
    OUTSIDE_YES,
    REPEATS,
    TRUST,
)
from maestra.learning.fewshot.space import Words, follows, size_of, unpack
from maestra.learning.fewshot.truths import Truths


def belief_from(evidence: Evidence) -> Belief:
    """What is believed after all that was shown and said."""
    return _Weighing(evidence).belief()


@dataclass(frozen=True)
class _Weighing:
    """One run of it; keeps what its steps share."""

    evidence: Evidence

    @cached_property
    def truths(self) -> Truths:
        return Truths(self.evidence.survivors, self.evidence.contexts)

    def belief(self) -> Belief:
        evidence = self.evidence
        search = Search(self.truths, evidence.layouts, evidence.answered)
        classes, nothing = self._with_orders(
            [
                replace(one, bits=one.bits + self._habits(one.words) + self._meaning(one.words))
                for one in self._merged(search.best())
            ]
        )
        bits = np.array([*(one.bits for one in classes), nothing])
        weights = np.exp2(-(bits - bits.min()))
        weights /= weights.sum()
        order = np.argsort(-weights[:-1], kind="stable")
        return Belief(
            evidence.plays,
            evidence.contexts,
            self.truths,
            tuple(classes[int(k)] for k in order),
            tuple(map(float, weights[order])),
            evidence.fillings,
            float(weights[-1]),
            evidence.full,
        )

    def _with_orders(self, classes: Sequence[Class]) -> tuple[list[Class], float]:
        """The classes with an order of placement or without; the bits of what cannot be said.

        Any row in a certain order is an exercise. Any row in any order is none: then it is about
        something that cannot be said.
        """
        shares = dict(self.evidence.fillings)
        none = shares.pop(None)
        some = sum(shares.values())
        with_rules, alone = log2(none + (1 - ALONE) * some), log2(ALONE * some) + FREE_BITS
        weighed = [
            replace(one, bits=one.bits - (with_rules if one.parts else alone)) for one in classes
        ]
        free = [log2(none) - one.bits for one in classes if not one.parts]
        return weighed, -float(np.logaddexp2.reduce([-self._of_nothing(), *free]))

    def _merged(self, found: Iterable[Found]) -> Iterable[Class]:
        """Hypotheses that allow the same rows everywhere are one; the best of them says it."""
        merged: dict[tuple[bytes, int | None], Class] = {}
        for one in found:
            words = tuple(
                self.truths.of_all(one.parts, c) for c in range(len(self.truths.contexts))
            )
            key = (b"".join(w.tobytes() for w in words), one.slip)
            if key in merged:
                both = -float(np.logaddexp2(-merged[key].bits, -one.bits))
                merged[key] = replace(merged[key], bits=both)
            else:
                merged[key] = Class(one.parts, one.bits, one.slip, words)
        return merged.values()

    def _habits(self, words: tuple[Words, ...]) -> float:
        """Bits more than if all allowed plays were equally likely."""
        contexts = self.truths.contexts
        sizes = [
            log2(max(size_of(words[one.context], contexts[one.context].rows), 1.0))
            for one in self.evidence.layouts
        ]
        plain = sum(sizes)
        ways = [
            log2(share) - (self._near_bits(words, strength) if strength else plain)
            for strength, share in NEAREST.items()
        ]
        habit = -float(np.logaddexp2.reduce(ways)) - plain
        repeated = len(self.evidence.plays) - len(sizes)
        if not repeated:
            return habit
        usual = log2(LAZY) + repeated * log2(REPEATS)
        chance = log2(1 - LAZY) - repeated * plain / len(sizes)
        return habit - float(np.logaddexp2(usual, chance))

    def _near_bits(self, words: tuple[Words, ...], strength: float) -> float:
        """Bits to name the layouts, if near tokens are taken so much."""
        bits = 0.0
        for context, likely, shown in self._nearness[strength]:
            inside = unpack(words[context], len(likely))
            mass = log2(max(float(likely[inside].sum()), 1e-300))
            bits += sum(mass + one for one in shown)
        return bits

    @cached_property
    def _nearness(self) -> dict[float, list[tuple[int, Numbers, list[float]]]]:
        """By strength: contexts, how likely each row is laid there, the bits of those shown."""
        layouts = self.evidence.layouts
        found: dict[float, list[tuple[int, Numbers, list[float]]]] = {}
        for strength, c in product(
            filter(None, NEAREST), dict.fromkeys(x.context for x in layouts)
        ):
            likely = self.truths.contexts[c].nearness(strength)
            rows = (unpack(x.rows, len(likely)).argmax() for x in layouts if x.context == c)
            shown = [-log2(float(likely[row])) for row in rows]
            found.setdefault(strength, []).append((c, likely, shown))
        return found

    def _meaning(self, words: tuple[Words, ...]) -> float:
        """Bits for the answers about rules: a rule is meant when it is one, or follows."""
        total = 0.0
        for rule, yes in self.evidence.meant:
            so = follows(words, self.truths.everywhere(rule))
            total -= log2(TRUST if so == yes else 1 - TRUST)
        return total

    def _of_nothing(self) -> float:
        """Bits if the exercise is about something that cannot be said."""
        evidence, contexts = self.evidence, self.truths.contexts
        plain = sum(log2(contexts[one.context].rows.size) for one in evidence.layouts)
        habit = self._habits(tuple(context.rows.everything for context in contexts))
        said = [one.yes for one in evidence.answered] + [yes for _, yes in evidence.meant]
        heard = sum(log2(OUTSIDE_YES if yes else 1 - OUTSIDE_YES) for yes in said)
        return plain + habit + OUTSIDE_BITS - heard

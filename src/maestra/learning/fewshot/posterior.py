"""Which conjunctions of rules explain what was shown: a beam search over all that hold.

The score of a hypothesis is in bits, the fewer the better: what it takes to say its rules and,
for each layout shown, the logarithm of how many it allows. Rules with the same truth everywhere
are one; a rule that follows from the others never joins them. Hypotheses that take one
demonstration for a slip are searched for as well, once for each demonstration.

Cost: O(levels x beam x rules x rows / 64) after each rule was evaluated once on the rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf, log2
from typing import Final

import numpy as np
from numpy.typing import NDArray

from maestra.learning.fewshot.hypotheses import Survivor
from maestra.learning.fewshot.prior import SLIP, TRUST
from maestra.learning.fewshot.space import Context, Words, looks_at_start, pack, shared, size_of
from maestra.rules.looks import lines_of
from maestra.rules.rule import Rule
from maestra.rules.setting import Line

BEAM: Final = 40
"""Conjunctions that are made longer at each length."""
LENGTH: Final = 4
"""Rules of a conjunction at most."""
LOOKED_AT: Final = 800
"""Of the conjunctions of one length, best first."""
KEPT: Final = 150
"""Hypotheses that are looked at closely."""
WITHIN: Final = 14.0
"""Bits from the best beyond which a hypothesis is forgotten: one in 16,000."""
HOPELESS: Final = 8.0
"""Bits that a rule may cost more than it saves: even with others it will not be believed."""
EDITS: Final = 35
"""Ways to make one mistake in a row of five: the likelihood of a slip is shared among them."""

SAMPLE: Final = 400
"""Rows on which a rule is looked at first."""

Numbers = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """A layout shown or asked about: in which context, and which of its rows."""

    context: int
    rows: Words
    """The row, or all rows that a move leaves open."""


@dataclass(frozen=True, slots=True, eq=False)
class Answered:
    """What a caregiver said of rows: whether one of them is right."""

    about: Evidence
    yes: bool


@dataclass(frozen=True, slots=True)
class Found:
    """A conjunction by the numbers of its rules, what it costs, and which layout is a slip."""

    atoms: tuple[int, ...]
    bits: float
    slip: int | None = None


@dataclass(frozen=True, eq=False)
class Atoms:
    """Rules with their truth in each context; rules of equal truth and breaches are one."""

    rules: tuple[Rule, ...]
    bits: Numbers
    broken: NDArray[np.int64]
    truth: tuple[Words, ...]
    """For each context: rules x words."""
    said: dict[Rule, int] = field(default_factory=dict[Rule, int])
    """For each rule, also one that was merged into another, its number."""


def evaluate(survivors: Sequence[Survivor], contexts: Sequence[Context], shown: int) -> Atoms:
    """The rules that say anything, each once, the shortest first, with their truth.

    Args:
        survivors: rules that hold of what was shown.
        contexts: where their truth is worked out.
        shown: how many layouts were shown. A rule that would cost much more than it could save
            on so many is left out; a sample of the rows is enough to see that.
    """
    few = [context.some(SAMPLE) for context in contexts]
    priced = sorted((one.bits, k) for k, one in enumerate(survivors))
    kept: list[int] = []
    number: dict[bytes, int] = {}
    said: dict[Rule, int] = {}
    truths: list[list[Words]] = [[] for _ in contexts]
    bits_: list[float] = []
    for cost, k in priced:
        rule, broken = survivors[k].rule, survivors[k].broken
        saved = (shown - bool(broken)) * _saving(_everywhere(rule, few), few)
        if cost + (log2(EDITS) - log2(SLIP) if broken else 0.0) - saved > HOPELESS:
            continue
        truth = _everywhere(rule, contexts)
        if all(_is_full(t, c) for t, c in zip(truth, contexts, strict=True)):
            continue
        key = broken.to_bytes(8, "little") + b"".join(t.tobytes() for t in truth)
        if key not in number:
            number[key] = len(kept)
            kept.append(k)
            bits_.append(cost)
            for one, words in zip(truths, truth, strict=True):
                one.append(words)
        else:
            # Several ways to say the same make it likelier.
            at = number[key]
            bits_[at] = -float(np.logaddexp2(-bits_[at], -cost))
        said[rule] = number[key]
    return Atoms(
        tuple(survivors[k].rule for k in kept),
        np.array(bits_),
        np.array([survivors[k].broken for k in kept], np.int64),
        tuple(
            np.array(one, np.uint64).reshape(len(kept), len(c.rows.everything))
            for one, c in zip(truths, contexts, strict=True)
        ),
        said,
    )


def _saving(truth: Sequence[Words], contexts: Sequence[Context]) -> float:
    """Bits that a rule saves on a layout, in the context where it saves most."""
    allowed = min(size_of(t, c.rows) / c.rows.size for t, c in zip(truth, contexts, strict=True))
    return -log2(max(allowed, 1 / SAMPLE))


def _is_full(words: Words, context: Context) -> bool:
    return bool((words == context.rows.everything).all())


def _everywhere(rule: Rule, contexts: Sequence[Context]) -> list[Words]:
    """The truth in each context; worked out once for those that cannot differ."""
    timed = Line.TIME in lines_of(rule)
    started = looks_at_start(rule)
    known: dict[tuple[object, ...], Words] = {}
    found: list[Words] = []
    for context in contexts:
        key = (
            id(context.rows),
            context.order if timed else None,
            id(context.setting) if started else id(context.setting.deck),
        )
        if key not in known:
            known[key] = pack(context.truth(rule))
        found.append(known[key])
    return found


@dataclass(frozen=True, eq=False)
class Search:
    """A search for the conjunctions that explain layouts and answers best."""

    atoms: Atoms
    contexts: tuple[Context, ...]
    layouts: tuple[Evidence, ...]
    """The different layouts that were shown."""
    answers: tuple[Answered, ...] = ()
    meant: tuple[tuple[int, bool], ...] = ()
    """Rules by number that the caregiver said are meant, or are not."""

    def best(self) -> list[Found]:
        """The best conjunctions, best first, none worse than `WITHIN` bits than the best."""
        found: dict[tuple[tuple[int, ...], int | None], float] = {}
        for slip in (None, *self._suspects):
            for atoms, bits_ in self._beam(slip):
                found[atoms, slip] = bits_
        ranked = sorted((bits_, atoms, slip) for (atoms, slip), bits_ in _keyed(found))
        limit = ranked[0][0] + WITHIN if ranked else inf
        return [
            Found(atoms, bits_, None if slip < 0 else slip)
            for bits_, atoms, slip in ranked[:KEPT]
            if bits_ <= limit
        ]

    @cached_property
    def _suspects(self) -> tuple[int, ...]:
        """The layouts that some rule breaks alone, if there are enough others."""
        few = 3
        if len(self.layouts) < few:
            return ()
        return tuple(k for k in range(len(self.layouts)) if (self.atoms.broken == 1 << k).any())

    def _beam(self, slip: int | None) -> list[tuple[tuple[int, ...], float]]:
        broken = 0 if slip is None else 1 << slip
        usable = np.flatnonzero((self.atoms.broken & ~broken) == 0)
        if not len(usable):
            return []
        found: dict[tuple[int, ...], float] = {}
        contexts = self._needed
        frontier: list[tuple[tuple[int, ...], list[Words], Numbers]] = [
            (
                (),
                [self.contexts[c].rows.everything for c in contexts],
                np.array([self.contexts[c].rows.size for c in contexts]),
            )
        ]
        truths = [self.atoms.truth[c][usable] for c in contexts]
        for _ in range(LENGTH):
            frontier = self._longer(slip, usable, truths, frontier, found)
            if not frontier:
                break
        if slip is not None:
            return [
                (atoms, bits_)
                for atoms, bits_ in found.items()
                if any(self.atoms.broken[a] for a in atoms)
            ]
        return list(found.items())

    @cached_property
    def _needed(self) -> tuple[int, ...]:
        """The contexts that layouts and answers are in."""
        seen = [e.context for e in self.layouts] + [a.about.context for a in self.answers]
        return tuple(dict.fromkeys(seen))

    def _longer(
        self,
        slip: int | None,
        usable: NDArray[np.intp],
        truths: list[Words],
        frontier: list[tuple[tuple[int, ...], list[Words], Numbers]],
        found: dict[tuple[int, ...], float],
    ) -> list[tuple[tuple[int, ...], list[Words], Numbers]]:
        sizes_of: list[list[Numbers]] = []
        scores = np.full((len(frontier), len(usable)), inf)
        for f, (atoms, words, sizes) in enumerate(frontier):
            counts = [
                shared(one, truth, self.contexts[c].rows.word_weight)
                for one, truth, c in zip(words, truths, self._needed, strict=True)
            ]
            sizes_of.append(counts)
            smaller = np.zeros(len(usable), np.bool_)
            for count, size in zip(counts, sizes, strict=True):
                smaller |= count < size * (1 - 1e-9)
            score = sum(self.atoms.bits[a] for a in atoms) + self.atoms.bits[usable]
            score = score + self._explaining(slip, counts) + self._agreeing(words, truths)
            scores[f] = np.where(smaller, score, inf)
        longer: list[tuple[tuple[int, ...], list[Words], Numbers]] = []
        best = min([*found.values(), scores.min()])
        seen: set[tuple[int, ...]] = set()
        for flat in np.argsort(scores, axis=None)[:LOOKED_AT]:
            f, u = divmod(int(flat), len(usable))
            if scores[f, u] == inf or (len(longer) >= BEAM and scores[f, u] > best + WITHIN):
                break
            key = tuple(sorted((*frontier[f][0], int(usable[u]))))
            if key in seen:
                continue
            seen.add(key)
            if scores[f, u] <= best + WITHIN:
                found[key] = float(scores[f, u])
            if len(longer) < BEAM:
                words = [one & t[u] for one, t in zip(frontier[f][1], truths, strict=True)]
                sizes = np.array([counts[u] for counts in sizes_of[f]])
                longer.append((key, words, sizes))
        return longer

    def _explaining(self, slip: int | None, counts: list[Numbers]) -> Numbers:
        """Bits to name each layout among those allowed."""
        logs = [np.where(n > 0, np.log2(np.maximum(n, 1)), inf) for n in counts]
        total = np.zeros_like(logs[0])
        for k, layout in enumerate(self.layouts):
            total += logs[self._needed.index(layout.context)]
            if k == slip:
                total += log2(EDITS) - log2(SLIP)
        return total

    def _agreeing(self, words: list[Words], truths: list[Words]) -> Numbers:
        """Bits for the answers: few where they are as the hypothesis says."""
        total = np.zeros(len(truths[0]))
        for answer in self.answers:
            c = self._needed.index(answer.about.context)
            some = np.flatnonzero(answer.about.rows)
            mine = words[c][some] & answer.about.rows[some]
            says = (truths[c][:, some] & mine).any(axis=1)
            total += np.where(says == answer.yes, -log2(TRUST), -log2(1 - TRUST))
        return total


def _keyed(
    found: dict[tuple[tuple[int, ...], int | None], float],
) -> list[tuple[tuple[tuple[int, ...], int], float]]:
    return [((atoms, -1 if slip is None else slip), v) for (atoms, slip), v in found.items()]

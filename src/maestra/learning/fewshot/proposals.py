"""The proposals of all families, and which of them hold of what was shown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from maestra.learning.fewshot.families.arithmetic import arithmetic
from maestra.learning.fewshot.families.base import Generator, Proposal
from maestra.learning.fewshot.families.choice import counts, selections
from maestra.learning.fewshot.families.grouping import groupings, patterns
from maestra.learning.fewshot.families.order import orders
from maestra.learning.fewshot.families.places import places, words
from maestra.learning.fewshot.families.start import contexts, sources
from maestra.learning.fewshot.families.timing import timings
from maestra.learning.fewshot.prior import (
    FAMILY_BITS,
    KIND_BITS,
    UNUSUAL_BITS,
    USUALLY_ADDED,
    one_of,
)
from maestra.learning.fewshot.shown import Shown
from maestra.learning.fewshot.space import looks_at_start, same_tokens
from maestra.rules.rule import Rule
from maestra.rules.setting import Play

__all__ = ["GENERATORS", "Proposal", "Survivor", "proposed", "surviving"]

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
"""Rules that say the same are told by the first of them. What two generators propose alike costs
what the later one says."""


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


def proposed(plays: Sequence[Play], *, timed: bool) -> list[tuple[Proposal, float]]:
    """All proposals, each with what it costs alone, in bits.

    Args:
        plays: at least one; their decks show the same attributes.
        timed: whether rules about the order in time are worth a thought.
    """
    shown = Shown(tuple(plays), timed)
    different = {one.rules: one for generator in GENERATORS for one in generator(shown)}
    of_kind = Counter(one.kind for one in different.values() if one.bits is None)
    found: list[tuple[Proposal, float]] = []
    for one in different.values():
        parameters = one_of(of_kind[one.kind]) if one.bits is None else one.bits
        bits = FAMILY_BITS + KIND_BITS[one.kind] + parameters + one.seldom
        found.append((one, bits))
    return found


def surviving(plays: Sequence[Play], *, timed: bool, slips: int) -> list[Survivor]:
    """The proposals that hold of all plays but at most `slips` of them; as `proposed`."""
    # Where it does not matter where tokens lay, what one start remembers serves all plays.
    first = plays[0].setting
    alike = same_tokens([play.setting for play in plays])
    moved = [replace(play, setting=first) for play in plays] if alike else plays
    broken: dict[Rule, int] = {}

    def breaches(rule: Rule) -> int:
        """The plays it does not hold of; once they are too many the others do not matter."""
        if rule not in broken:
            wrong = 0
            for k, play in enumerate(plays if looks_at_start(rule) else moved):
                if not rule.holds(play):
                    wrong |= 1 << k
                    if wrong.bit_count() > slips:
                        break
            broken[rule] = wrong
        return broken[rule]

    found: list[Survivor] = []
    for one, bits in proposed(plays, timed=timed):
        wrong = 0
        for rule in one.rules:
            wrong |= breaches(rule)
            if wrong.bit_count() > slips:
                break
        else:
            added = USUALLY_ADDED.get(one.kind, UNUSUAL_BITS)
            found.append(Survivor(one.rules, wrong, bits, added))
    return found

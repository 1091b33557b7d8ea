"""Which rows each proposal allows, worked out when it is asked for and only once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final

import numpy as np

from maestra.learning.fewshot.proposals import Survivor
from maestra.learning.fewshot.space import Context, Words, looks_at_start, pack
from maestra.rules.looks import lines_of
from maestra.rules.rule import Rule
from maestra.rules.setting import Line

SAMPLE: Final = 2048
"""Rows on which all proposals and pairs are looked at first."""


@dataclass(frozen=True, eq=False)
class Truths:
    """Proposals with their truth in each context, worked out when it is asked for."""

    survivors: tuple[Survivor, ...]
    contexts: tuple[Context, ...]
    _known: dict[tuple[object, ...], Words] = field(
        default_factory=dict[tuple[object, ...], Words]
    )

    def of(self, part: int, context: int) -> Words:
        """The rows of a context that a proposal allows."""
        return self._of(part, context, coarse=False)

    def coarse(self, part: int, context: int) -> Words:
        """The same of some rows only."""
        return self._of(part, context, coarse=True)

    def of_rule(self, rule: Rule, context: int) -> Words:
        """The rows of a context that a rule allows."""
        return self._rule(rule, self.contexts[context])

    def everywhere(self, rule: Rule) -> list[Words]:
        """The rows that a rule allows, for each context."""
        return [self._rule(rule, context) for context in self.contexts]

    def of_all(self, parts: Sequence[int], context: int) -> Words:
        """The rows of a context that all of these proposals allow."""
        everything = self.contexts[context].rows.everything
        words = everything.copy()
        for part in parts:
            words &= self.of(part, context)
        return words

    def _of(self, part: int, context: int, *, coarse: bool) -> Words:
        """Worked out once for the contexts that cannot differ."""
        key = (part, coarse, self._same[self._looks[part]][context])
        if key not in self._known:
            where = self.contexts[context]
            where = where.some(SAMPLE) if coarse else where
            rules = self.survivors[part].rules
            self._known[key] = np.bitwise_and.reduce([self._rule(rule, where) for rule in rules])
        return self._known[key]

    def _rule(self, rule: Rule, context: Context) -> Words:
        key = (rule, id(context.rows), context.order, id(context.setting))
        if key not in self._known:
            self._known[key] = pack(context.truth(rule))
        return self._known[key]

    @cached_property
    def _looks(self) -> list[tuple[bool, bool]]:
        """Of each proposal, whether it looks at the order in time, and at the start."""
        return [
            (
                any(Line.TIME in lines_of(rule) for rule in one.rules),
                any(looks_at_start(rule) for rule in one.rules),
            )
            for one in self.survivors
        ]

    @cached_property
    def _same(self) -> dict[tuple[bool, bool], list[int]]:
        """For each way to look, to each context the first one that is the same to it."""
        same: dict[tuple[bool, bool], list[int]] = {}
        for timed in (False, True):
            for started in (False, True):
                keys = [
                    (
                        id(c.rows),
                        c.order if timed else None,
                        id(c.setting) if started else id(c.setting.deck),
                    )
                    for c in self.contexts
                ]
                same[timed, started] = [keys.index(key) for key in keys]
        return same

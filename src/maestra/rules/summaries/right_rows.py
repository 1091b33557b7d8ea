"""Which tokens can lie where, and which together, in the rows that some simple rules allow.

A row has a place for each token, a set of tokens that may lie there, and perhaps a relation that
neighbours must stand in. Three cases are exact without listing the rows: no relation and the same
set everywhere; and a relation that never leads back to the same token, such as any strict order,
because then no path repeats a token and reachability says it all: O(places² x tokens) unions of
bit sets. Any other case is searched row by row, and given up when there are too many.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final

from maestra.rules.setting import Index, Mask, bits

MAX_WORK: Final = 1_000_000
"""Places filled and pairs noted by the search before it gives up: some tenths of a second."""


class UndecidedError(Exception):
    """Reachability does not tell, and there is too much to list."""


@dataclass(frozen=True)
class RightRows:
    """All rows of different tokens with one of `domains` on each place, neighbours related."""

    domains: tuple[Mask, ...]
    """For each place, from left to right, the tokens that may lie there."""
    before: tuple[Mask, ...] | None = None
    """For each token, those that may lie on the place before it; None: any."""

    def possible(self, place: Index) -> Mask:
        """The tokens that lie on `place` in some row.

        Raises:
            UndecidedError: cannot be found out.
        """
        if self.before is None and self._uniform:
            return self.domains[0] if self._room else 0
        if self._acyclic:
            return self._reached[place] & self._continued[place]
        return self._listed_places[place]

    def together(self, place: Index, token: Index, other: Index) -> Mask:
        """The tokens that lie on `other` in some row with `token` on `place`.

        Raises:
            UndecidedError: cannot be found out.
        """
        if not self.possible(place) >> token & 1:
            return 0
        if self.before is None and self._uniform:
            return self.domains[0] & ~(1 << token)
        if not self._acyclic:
            return self._listed[place, token][other]
        mask = 1 << token
        for step in range(place - 1, other - 1, -1):
            mask = self._earlier(mask) & self._reached[step]
        for step in range(place + 1, other + 1):
            mask = self._later(mask) & self._continued[step]
        return mask

    @cached_property
    def _uniform(self) -> bool:
        return len(set(self.domains)) == 1

    @cached_property
    def _room(self) -> bool:
        return self.domains[0].bit_count() >= len(self.domains)

    @cached_property
    def _before(self) -> tuple[Mask, ...]:
        return self.before or ()

    @cached_property
    def _after(self) -> tuple[Mask, ...]:
        after = [0] * len(self._before)
        for token, mask in enumerate(self._before):
            for earlier in bits(mask):
                after[earlier] |= 1 << token
        return tuple(after)

    @cached_property
    def _acyclic(self) -> bool:
        """Whether the relation never leads back: what has no successor is taken away."""
        if self.before is None:
            return False
        left, last = (1 << len(self.before)) - 1, 0
        while left != last:
            last = left
            left = sum(1 << token for token in bits(left) if self._after[token] & left)
        return not left

    @cached_property
    def _known_earlier(self) -> dict[Mask, Mask]:
        return {}

    @cached_property
    def _known_later(self) -> dict[Mask, Mask]:
        return {}

    def _earlier(self, tokens: Mask) -> Mask:
        """What may lie right before one of `tokens`."""
        if tokens not in self._known_earlier:
            self._known_earlier[tokens] = _union(self._before, tokens)
        return self._known_earlier[tokens]

    def _later(self, tokens: Mask) -> Mask:
        """What may lie right after one of `tokens`."""
        if tokens not in self._known_later:
            self._known_later[tokens] = _union(self._after, tokens)
        return self._known_later[tokens]

    @cached_property
    def _reached(self) -> tuple[Mask, ...]:
        """For each place the tokens to which some beginning leads."""
        reached = [self.domains[0]]
        for domain in self.domains[1:]:
            reached.append(domain & self._later(reached[-1]))
        return tuple(reached)

    @cached_property
    def _continued(self) -> tuple[Mask, ...]:
        """For each place the tokens from which some row goes on to the end."""
        continued = [self.domains[-1]]
        for domain in self.domains[-2::-1]:
            continued.append(domain & self._earlier(continued[-1]))
        return tuple(reversed(continued))

    @cached_property
    def _listed(self) -> dict[tuple[Index, Index], list[Mask]]:
        """For each place and token what lies on each place, over all rows, one by one."""
        listed: dict[tuple[Index, Index], list[Mask]] = {}
        for row in self._rows():
            for place, token in enumerate(row):
                masks = listed.setdefault((place, token), [0] * len(row))
                for other, lying in enumerate(row):
                    masks[other] |= 1 << lying
        return listed

    @cached_property
    def _listed_places(self) -> list[Mask]:
        places = [0] * len(self.domains)
        for place, token in self._listed:
            places[place] |= 1 << token
        return places

    def _rows(self) -> Iterator[tuple[Index, ...]]:
        """Every row.

        Raises:
            UndecidedError: it would take more than `MAX_WORK`.
        """
        work = 0
        stack: list[tuple[Index, ...]] = [()]
        while stack:
            row = stack.pop()
            work += len(row) ** 2 if len(row) == len(self.domains) else 1
            if work > MAX_WORK:
                raise UndecidedError
            if len(row) == len(self.domains):
                yield row
                continue
            free = self.domains[len(row)]
            for token in row:
                free &= ~(1 << token)
            stack += [
                (*row, token)
                for token in bits(free)
                if not row or self.before is None or self.before[token] >> row[-1] & 1
            ]


def _union(relation: tuple[Mask, ...], tokens: Mask) -> Mask:
    found = 0
    for token in bits(tokens):
        found |= relation[token]
    return found

"""Which tokens can still come to each slot of a line, by the rules about single slots and pairs.

Sets of tokens are bit masks. Filled slots narrow the open ones at once (forward checking [1]);
narrowing those that must be filled against each other until nothing changes makes them arc
consistent [2], which alone refutes every dead end of an order; and no set of slots may have
fewer tokens than slots (a matching must exist).

[1] Haralick, Elliott, Increasing tree search efficiency for constraint satisfaction problems,
Artificial Intelligence 14, 1980.
[2] Mackworth, Consistency in networks of relations, Artificial Intelligence 8, 1977.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from maestra.rules.forms.base import EachSlot, Pairwise
from maestra.rules.forms.order import Ordered
from maestra.rules.pairs import Related, converse
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Line, Mask, Setting, bits
from maestra.rules.token_tests import Anything, passing

Domains: TypeAlias = dict[Index, Mask]
"""For each open slot the tokens that can still come there."""


@dataclass(frozen=True, slots=True)
class View:
    """The slots of a line, or of both where each cell has its time, and what rules say of them."""

    allowed: tuple[Mask, ...]
    """For each slot the tokens that may be there."""
    links: tuple[tuple[tuple[Index, Related], ...], ...]
    """For each slot the slots it is linked to, and what a token here allows there."""
    essential: tuple[tuple[tuple[Index, Related], ...], ...]
    """The same without links that follow from others when all slots are filled."""

    def domains(self, slots: Sequence[Index | None], left: Mask) -> Domains:
        """What can come to each open slot as far as the filled ones say."""
        domains = {k: self.allowed[k] & left for k, token in enumerate(slots) if token is None}
        for k, token in enumerate(slots):
            if token is not None:
                for other, masks in self.links[k]:
                    if other in domains:
                        domains[other] &= masks[token]
        return domains

    def narrow(self, domains: Domains, required: Iterable[Index]) -> bool:
        """Make `required` slots arc consistent in place; false if one has nothing left."""
        todo = set(required)
        among = frozenset(todo)
        while todo:
            slot = todo.pop()
            for other, masks in self.essential[slot]:
                if other in among:
                    supported = 0
                    for token in bits(domains[slot]):
                        supported |= masks[token]
                    if domains[other] & ~supported:
                        domains[other] &= supported
                        todo.add(other)
        return all(domains[slot] for slot in among)


def can_match(domains: Mapping[Index, Mask], required: Iterable[Index]) -> bool:
    """Whether each required slot can have a token of its own (Kuhn's augmenting paths)."""
    taken: dict[Index, Index] = {}

    def place(slot: Index, tried: set[Index]) -> bool:
        for token in bits(domains[slot]):
            if token not in tried:
                tried.add(token)
                if token not in taken or place(taken[token], tried):
                    taken[token] = slot
                    return True
        return False

    return all(place(slot, set()) for slot in required)


def view_of(
    rules: Sequence[Rule], setting: Setting, places: Mapping[Line, Sequence[Index]]
) -> View:
    """What `rules` say of slots.

    Args:
        rules: those about lines that are not in `places` are passed over.
        setting: the start.
        places: for a line, which slot of the view each of its own slots is.
    """
    everything = passing(setting, Anything())
    allowed = [everything] * setting.length
    links: list[list[tuple[Index, Related]]] = [[] for _ in allowed]
    essential: list[list[tuple[Index, Related]]] = [[] for _ in allowed]
    for rule in rules:
        if isinstance(rule, EachSlot) and rule.along() in places:
            for slot, mask in zip(places[rule.along()], rule.allowed(setting), strict=False):
                allowed[slot] &= mask
        if isinstance(rule, Pairwise) and rule.along() in places:
            place = places[rule.along()]
            for i, j, masks in rule.links(setting):
                if j < len(place):
                    there, back = (place[j], masks), (place[i], converse(setting, masks))
                    links[place[i]].append(there)
                    links[place[j]].append(back)
                    # Of an order only neighbours matter once every slot has a token.
                    if j == i + 1 or not isinstance(rule, Ordered):
                        essential[place[i]].append(there)
                        essential[place[j]].append(back)
    return View(tuple(allowed), tuple(map(tuple, links)), tuple(map(tuple, essential)))

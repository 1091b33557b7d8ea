"""One deck out of the decks of several plays."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from maestra.core.faults import Fault, refuse

if TYPE_CHECKING:
    from collections.abc import Sequence

    from maestra.core.tokens import Deck


def merge_decks(decks: Sequence[Deck]) -> Deck:
    """The first deck, and from each further one the tokens that show something new.

    Raises:
        InvalidError: a token shows one thing here and another there, or an attribute's order, a
            relation or the lexicon is declared differently.
    """
    merged = decks[0]
    for number, deck in enumerate(decks[1:], start=2):
        if deck is not merged and deck != merged:
            merged = _merge(merged, deck, f"demonstration {number}")
    return merged


def _merge(merged: Deck, deck: Deck, place: str) -> Deck:
    faults = [
        Fault(f"{place}: tokens.{token.id}", "shows something else", "what it showed before")
        for token in deck.tokens
        if token.id in merged.by_id and merged.by_id[token.id] != token
    ]
    for kind, before, now in (
        ("orders", merged.orders, deck.orders),
        ("cycles", merged.cycles, deck.cycles),
        ("relations", merged.relations, deck.relations),
    ):
        faults.extend(
            Fault(f"{place}: {kind}.{name}", "declared differently", "as it was before")
            for name in before.keys() & now.keys()
            if before[name] != now[name]
        )
    if merged.lexicon and deck.lexicon and merged.lexicon != deck.lexicon:
        faults.append(Fault(f"{place}: lexicon", "declared differently", "as it was before"))
    refuse(faults)
    known = {token.attributes for token in merged.tokens}
    return replace(
        merged,
        tokens=(*merged.tokens, *(t for t in deck.tokens if t.attributes not in known)),
        orders={**merged.orders, **deck.orders},
        cycles={**merged.cycles, **deck.cycles},
        relations={**merged.relations, **deck.relations},
        lexicon=merged.lexicon or deck.lexicon,
    )

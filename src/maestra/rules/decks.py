"""One deck out of the decks of several plays."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from maestra.core.faults import Fault, refuse
from maestra.core.tokens import Deck, Token

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from maestra.core.tokens import Attributes

_Name = TypeVar("_Name", bound=str)
_Declared = TypeVar("_Declared")


def merge_decks(decks: Sequence[Deck]) -> Deck:
    """The first deck (of at least one), and from each further one the tokens that show new things.

    Raises:
        InvalidError: a token shows one thing here and another there; an order, a cycle, a
            relation or the lexicon is declared differently; what one deck declares does not fit
            the tokens of another.
    """
    different = _different(decks)
    if len(different) == 1:
        return decks[0]
    faults: list[Fault] = []
    _unite("tokens", [(n, deck.by_id) for n, deck in different], faults)
    orders = _unite("orders", [(n, deck.orders) for n, deck in different], faults)
    cycles = _unite("cycles", [(n, deck.cycles) for n, deck in different], faults)
    relations = _unite("relations", [(n, deck.relations) for n, deck in different], faults)
    lexicons = [(n, {"words": deck.lexicon}) for n, deck in different if deck.lexicon]
    lexicon = _unite("lexicon", lexicons, faults).get("words", ())
    refuse(faults)
    tokens = _tokens_that_show_something_new(deck for _, deck in different)
    return Deck(tokens, orders, cycles, relations, lexicon)


def _different(decks: Sequence[Deck]) -> list[tuple[int, Deck]]:
    """The decks that are not equal to an earlier one, with their numbers from 1."""
    # Plays of one file share a deck, and to look at an object's identity takes no time.
    objects = {id(deck): number for number, deck in reversed([*enumerate(decks, start=1)])}
    numbers: dict[Deck, int] = {}
    for number in sorted(objects.values()):
        numbers.setdefault(decks[number - 1], number)
    return [(number, deck) for deck, number in numbers.items()]


def _unite(
    kind: str, declared: Iterable[tuple[int, Mapping[_Name, _Declared]]], faults: list[Fault]
) -> dict[_Name, _Declared]:
    """Everything that is declared under some name; what is declared twice must be the same."""
    united: dict[_Name, _Declared] = {}
    for number, mapping in declared:
        for name, value in mapping.items():
            if united.setdefault(name, value) != value:
                place = f"demonstration {number}: {kind}.{name}"
                faults.append(Fault(place, "something else than before", "the same everywhere"))
    return united


def _tokens_that_show_something_new(decks: Iterable[Deck]) -> tuple[Token, ...]:
    tokens: list[Token] = []
    shown: set[Attributes] = set()
    for deck in decks:
        tokens += [token for token in deck.tokens if token.attributes not in shown]
        shown.update(token.attributes for token in deck.tokens)
    return tuple(tokens)

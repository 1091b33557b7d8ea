"""`maestra features`: what `learn --features` takes, in words."""

from collections.abc import Sequence

from maestra.cli.shown_file import shown_in
from maestra.cli.streams import print_json, print_lines
from maestra.core.tokens import Deck, Scale
from maestra.language import Language
from maestra.language.terminal import TerminalKey, feature_words, terminal_sentence
from maestra.rules.features import CELLS
from maestra.rules.registry import (
    CELL_FEATURES,
    CONVERSES,
    PAIR_FEATURES,
    PARAMETER_FEATURES,
    TOKEN_FEATURES,
)


def features(demonstrations_file: str | None, language: str, *, as_json: bool) -> None:
    """Print every feature, or those that apply to what is shown in a file."""
    tongue = Language(language)
    if demonstrations_file is None:
        kinds = names_by_kind(None)
    else:
        with shown_in(demonstrations_file) as shown:
            kinds = names_by_kind(shown.deck)
    if as_json:
        for kind, names in kinds.items():
            for name in names:
                words = feature_words(name, tongue)
                print_json({"name": name, "about": kind.value.removeprefix("of-"), "text": words})
        return
    width = max(len(name) for names in kinds.values() for name in names)
    for kind, names in kinds.items():
        if names:
            lines = (f"  {name:<{width}}  {feature_words(name, tongue)}" for name in names)
            print_lines([terminal_sentence(kind, tongue), *lines])


def names_by_kind(deck: Deck | None) -> dict[TerminalKey, Sequence[str]]:
    """The names of features by what they look at; only those that apply to `deck`, if given."""
    families = {f"{name}-K": definition.scales for name, definition in PARAMETER_FEATURES.items()}
    of_tokens = {name: definition.scales for name, definition in TOKEN_FEATURES.items()} | families
    of_pairs = {name: definition.scales for name, definition in PAIR_FEATURES.items()}
    of_pairs |= {name: of_pairs[converse] for name, converse in CONVERSES.items()}
    scales = frozenset(Scale if deck is None else deck.scales.values())
    relations = () if deck is None else tuple(deck.relations)
    return {
        TerminalKey.OF_CELLS: (CELLS, *CELL_FEATURES),
        TerminalKey.OF_TOKENS: [name for name, over in of_tokens.items() if over & scales],
        TerminalKey.OF_PAIRS: [
            *(name for name in of_pairs if of_pairs[name] & scales),
            *relations,
        ],
    }

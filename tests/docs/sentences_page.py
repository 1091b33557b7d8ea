"""The page of all forms of rules with a sentence in each language."""

from typing import Final

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.language.understanding import listener_for, rules_like
from maestra.rules.rule import Rule

_HEAD: Final = (
    "# What can be said\n\n"
    "Each form of rule that Maestra knows, with a sentence in each language. The sentences are "
    "said about tokens with a number, a letter, a colour and a day, and all are understood by "
    "`maestra tell`; a test makes this page and reads every sentence on it back. [Say a "
    "rule](../how-to/say-a-rule.md) tells what else is understood.\n\n"
)
_COLOURS: Final = ("red", "blue")
_DAYS: Final = ("Monday", "Tuesday", "Wednesday")

DECK: Final = Deck(
    tuple(
        Token(
            TokenId(f"t{k}"),
            (
                ("value", 10 + k),
                ("letter", "abcdef"[k]),
                ("colour", _COLOURS[k % 2]),
                ("day", _DAYS[k % 3]),
                ("name", ("cup", "saucer")[k % 2]),
            ),
        )
        for k in range(6)
    ),
    cycles={"day": _DAYS},
    relations={"partner": frozenset({("cup", "saucer")})},
    lexicon=("bed",),
)


def forms() -> dict[str, list[Rule]]:
    """Some rules of each form, by its name."""
    found: dict[str, list[Rule]] = {}
    for rule in rules_like(DECK, Board()):
        found.setdefault(rule.form, []).append(rule)
    return found


def page() -> str:
    """The page."""
    lines = [_HEAD]
    names = {Language.EN: "English", Language.ES: "Spanish", Language.CA: "Catalan"}
    for form, rules in sorted(forms().items()):
        lines.append(f"## {form}\n\n")
        for language, name in names.items():
            said = listener_for(language, Board(), DECK).says(rules[0])
            lines.append(f"- {name}: {said}\n")
        lines.append("\n")
    return "".join(lines).rstrip("\n") + "\n"

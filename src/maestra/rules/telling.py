"""Exercises from rules that were told, and whether their rules can be kept together."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.core.board import Board
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.rules.completability import Conjunction, DeadEnd
from maestra.rules.exercise import Evidence, LearnStatus, RuledExercise, meant_rules
from maestra.rules.forms.counting import Count
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.selection import AllOfThem
from maestra.rules.forms.words import Word
from maestra.rules.rule import Rule
from maestra.rules.setting import Play, Setting
from maestra.rules.token_tests import Anything


def told_exercise(
    rules: Sequence[Rule], board: Board, deck: Deck, evidence: Evidence | None = None
) -> RuledExercise:
    """The exercise of just these rules, each once; there was nothing to find out.

    Raises:
        InvalidError: the deck lacks what a rule asks for.
    """
    kept = tuple(dict.fromkeys(rules))
    return RuledExercise(
        board,
        deck,
        meant_rules(kept, [1.0] * len(kept)),
        1.0,
        LearnStatus.TOLD,
        kept,
        evidence=evidence or Evidence(),
    )


def with_length(rules: Sequence[Rule]) -> tuple[Rule, ...]:
    """The rules, and that the row is full unless they say themselves how long it is."""
    said = any(map(_says_length, rules))
    return tuple(rules) if said else (*rules, FullRow())


def _says_length(rule: Rule) -> bool:
    match rule:
        case FullRow() | UntilTotal() | AllOfThem() | Word() | Count(Anything()):
            return True
        case _:
            return False


def clash(rules: Sequence[Rule], setting: Setting) -> tuple[Rule, ...]:
    """Rules that no play from this start keeps together: none can be left out of them.

    None if all can be kept, or if a search with a bound could not tell.
    """
    if not _is_hopeless(rules, setting):
        return ()
    core = list(rules)
    for rule in rules:
        rest = [other for other in core if other is not rule]
        if _is_hopeless(rest, setting):
            core = rest
    return tuple(core)


def _is_hopeless(rules: Sequence[Rule], setting: Setting) -> bool:
    outlook = Conjunction(tuple(rules), setting).outlook(Play.begin(setting))
    return isinstance(outlook, DeadEnd)


def dealt(deck: Deck, board: Board) -> State:
    """The tokens in storage, row by row.

    Raises:
        InvalidError: there are more tokens than storage cells.
    """
    cells = board.storage_cells
    if len(deck.tokens) > len(cells):
        found = f"{len(deck.tokens)} tokens for {len(cells)} storage cells"
        raise InvalidError([Fault("board", found, "a cell for each token")])
    return State(board, dict(zip((token.id for token in deck.tokens), cells, strict=False)))

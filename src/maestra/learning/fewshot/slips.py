"""Which move of a demonstration is the mistake, if one is."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play, Setting


def wrong_move(rules: Sequence[Rule], play: Play) -> int:
    """The move without which, changed, the play would be right; else the first that breaks a rule.

    A token that was not used may have been meant, or two tokens have changed places.
    """
    cells = [cell for _, cell in play.placed]
    tokens = [token for token, _ in play.placed]
    left = [t for t in range(len(play.setting.deck.tokens)) if play.left >> t & 1]
    for move in range(len(tokens)):
        for other in left:
            tried = [*tokens[:move], other, *tokens[move + 1 :]]
            if _right(rules, play.setting, tried, cells):
                return move
    for later in range(len(tokens)):
        for move in range(later):
            tried = list(tokens)
            tried[move], tried[later] = tried[later], tried[move]
            if _right(rules, play.setting, tried, cells):
                return later
    position = Play.begin(play.setting)
    for move, (token, cell) in enumerate(play.placed):
        position = position.after(token, cell)
        if not all(rule.possible(position) for rule in rules):
            return move
    return len(tokens) - 1


def _right(
    rules: Sequence[Rule], setting: Setting, tokens: Sequence[Index], cells: Sequence[Index]
) -> bool:
    play = Play.begin(setting)
    for token, cell in zip(tokens, cells, strict=True):
        play = play.after(token, cell)
    return all(rule.holds(play) for rule in rules)

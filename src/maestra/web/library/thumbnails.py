"""Drawings of exercises and of their rules, as pictures that a browser keeps."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Final

from maestra.core.faults import InvalidError
from maestra.language import Language
from maestra.rules.account import account_of
from maestra.rules.exercise import Exercise, RuledExercise
from maestra.rules.fitting import misfits
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.telling import dealt
from maestra.web.library.collection import exercise_in
from maestra.web.rule_drawing import draw_exercise, draw_rule

KEPT_DRAWINGS: Final = 500
"""Kept in memory, some 10 kB each."""


@lru_cache(maxsize=KEPT_DRAWINGS)
def thumbnail(text: str, language: Language) -> str:
    """The exercise that is written so: its board, with the rule that says most about it.

    Raises:
        KeyError: there is nothing to be drawn.
    """
    rules, setting = _drawn(text)
    return str(draw_exercise(rules, setting, language=language))


@lru_cache(maxsize=KEPT_DRAWINGS)
def rule_picture(text: str, name: str, language: Language) -> str:
    """One of its rules, by its id.

    Raises:
        KeyError: it has no such rule, or nothing can be drawn.
    """
    rules, setting = _drawn(text)
    named = dict(zip(rule_names(text), rules, strict=True))
    return str(draw_rule(named[name], setting, language=language))


@lru_cache(maxsize=KEPT_DRAWINGS)
def rule_names(text: str) -> tuple[str, ...]:
    """The ids of the rules that can be drawn: of what is said, some may have no drawing."""
    exercise = exercise_in(text)
    if exercise is None:
        return ()
    account = account_of(exercise)
    if isinstance(account, RuledExercise):
        return tuple(one.id for one in account.rules)
    return account.rule_names


def _drawn(text: str) -> tuple[tuple[Rule, ...], Setting]:
    exercise = exercise_in(text)
    if exercise is None:
        raise KeyError("unreadable")
    account = account_of(exercise)
    if isinstance(account, RuledExercise):
        return account.conjunction, _setting(exercise, account.conjunction)
    return account.rules, _setting(exercise, account.rules)


def _setting(exercise: Exercise, rules: Sequence[Rule]) -> Setting:
    """As it was first shown, else the tokens row by row.

    Raises:
        KeyError: there are more tokens than storage cells.
    """
    if isinstance(exercise, RuledExercise):
        for shown in exercise.evidence.demonstrations:
            # A file may have been written by hand.
            if not misfits(rules, shown.deck):
                return Setting(shown.deck, shown.start)
    try:
        return Setting(exercise.deck, dealt(exercise.deck, exercise.board))
    except InvalidError:
        raise KeyError("too many tokens") from None

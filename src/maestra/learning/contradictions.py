"""What was shown and answered that cannot both be: two moments, side by side.

Two kinds are found. Two moments clash by what they say alone: no exercise, however odd, agrees
with both. And an answer may be overruled: the rules that explain all the rest say otherwise.
Nothing is settled here; the caregiver says which moment counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Final, TypeAlias, assert_never

from maestra.learning.drawn_plays import Drawer, starts
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.completability import Conjunction, MoveAllowed, MoveRefused
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play

LOOKED_AT: Final = 12
"""Right plays among which one is looked for that breaks a rule said to be meant."""


@dataclass(frozen=True, slots=True)
class Shown:
    """A demonstration, by its number from 0."""

    demonstration: Index


@dataclass(frozen=True, slots=True)
class Said:
    """An answer, by its number from 0."""

    answer: Index


@dataclass(frozen=True, slots=True)
class Understood:
    """What all the rest comes to: the rules learned from it."""


Moment: TypeAlias = Shown | Said | Understood


@dataclass(frozen=True, slots=True)
class Contradiction:
    """Two moments that disagree; the later one is always an answer."""

    earlier: Moment
    later: Said


@dataclass(frozen=True, slots=True)
class _Right:
    """A play that is right: all of it, or as a beginning."""

    play: Play
    whole: bool


@dataclass(frozen=True, slots=True)
class _Wrong:
    """A play that is not right if it ends here, or however it goes on."""

    play: Play
    whole: bool


@dataclass(frozen=True, slots=True)
class _Meant:
    """A rule that is meant or is not."""

    rule: Rule
    is_meant: bool


_Claim: TypeAlias = _Right | _Wrong | _Meant


def clashes(shown: Mapping[Index, Play], answers: Sequence[Answer]) -> tuple[Contradiction, ...]:
    """The pairs of moments of which one says what the other denies, in the order of the later.

    Args:
        shown: the demonstrations that count, by number.
        answers: all answers; those that are unsure claim nothing.
    """
    claims: list[tuple[Moment, _Claim]] = [
        (Shown(number), _Right(play, whole=True)) for number, play in shown.items()
    ]
    for number, answer in enumerate(answers):
        claims += [(Said(number), claim) for claim in _claims(answer)]
    found = [
        Contradiction(earlier, later)
        for (earlier, one), (later, other) in combinations(claims, 2)
        if isinstance(later, Said) and (_denies(one, other) or _denies(other, one))
    ]
    return tuple(sorted(found, key=lambda one: one.later.answer))


def overruled(
    rules: Sequence[Rule], answers: Sequence[Answer], shown: Sequence[Play], seed: int
) -> tuple[Contradiction, ...]:
    """The answers that `rules`, which were learned, do not agree with.

    That a rule which is meant follows from `rules` is looked for in plays drawn from `seed`; one
    that breaks it is proof.
    """
    return tuple(
        Contradiction(Understood(), Said(number))
        for number, answer in enumerate(answers)
        if _is_overruled(tuple(rules), answer, shown, seed)
    )


def _claims(answer: Answer) -> Iterator[_Claim]:
    if answer.reply is Reply.UNSURE:
        return
    yes = answer.reply is Reply.YES
    match answer.question:
        case RowQuestion(play):
            yield _Right(play, whole=True) if yes else _Wrong(play, whole=True)
        case MoveQuestion(position, token, cell):
            after = position.after(token, cell)
            yield _Right(after, whole=False) if yes else _Wrong(after, whole=False)
        case RuleQuestion(rule):
            yield _Meant(rule, yes)
        case _:
            assert_never(answer.question)


def _denies(right: _Claim, other: _Claim) -> bool:
    """Whether what is said to be right, or meant, cannot be so if `other` is."""
    match right, other:
        case _Right(play), _Wrong(wrong, whole=False):
            beginning = play.placed[: len(wrong.placed)]
            return play.setting == wrong.setting and beginning == wrong.placed
        case _Right(play, whole), _Wrong(wrong):
            same = play.setting == wrong.setting and play.placed == wrong.placed
            return same and (whole or not play.room)
        case _Right(play, whole), _Meant(rule, True):
            return not (rule.holds(play) if whole else rule.possible(play))
        case _Meant(rule, True), _Meant(denied, False):
            return rule == denied
        case _:
            return False


def _is_overruled(
    rules: tuple[Rule, ...], answer: Answer, shown: Sequence[Play], seed: int
) -> bool:
    if answer.reply is Reply.UNSURE:
        return False
    yes = answer.reply is Reply.YES
    match answer.question:
        case RowQuestion(play):
            return yes is not all(rule.holds(play) for rule in rules)
        case MoveQuestion(position, token, cell):
            verdict = Conjunction(rules, position.setting).judge(position, token, cell)
            return isinstance(verdict, MoveRefused if yes else MoveAllowed)
        case RuleQuestion(rule):
            if rule in rules:
                return not yes
            return yes and _may_be_broken(rule, rules, shown, seed)
        case _:
            assert_never(answer.question)


def _may_be_broken(rule: Rule, rules: tuple[Rule, ...], shown: Sequence[Play], seed: int) -> bool:
    """Whether a play that `rules` allow breaks `rule`."""
    setting = shown[0].setting
    drawers = [Drawer(rules, setting)]
    elsewhere = starts(setting.deck, setting.start.board, [setting.start], seed)
    drawers.append(Drawer(rules, next(elsewhere)))
    drawn = (drawer.right(seed + number) for number in range(LOOKED_AT // 2) for drawer in drawers)
    return any(play is not None and not rule.holds(play) for play in drawn)

"""What is said of a summary: its rules, its single steps, and what is still too narrow."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, assert_never

from maestra.core.board import Cell
from maestra.core.tokens import Attributes
from maestra.language.keys import Key
from maestra.language.of_literals import Conditions, needed
from maestra.language.of_rules import Rules
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import Joint, Listing, Named, Nth, Phrase, Place, Say, say
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.strips.literals import Placed
from maestra.rules.summaries.summary import Check, Narrow, Step, Summary, Unseen

MAX_CONDITIONS: Final = 3
"""A sentence with more conditions is not understood."""
MAX_MISSING: Final = 2
"""So few tokens that were not seen are named, instead of the many that were."""


@dataclass(frozen=True, slots=True)
class Identified:
    """What is to be said, with the stable id of what it is about."""

    id: str
    phrase: Phrase


def rules_of(summary: Summary) -> Iterator[Identified]:
    """A sentence for each rule, and for each step that no rule speaks of.

    That the goal row is to be filled is said where the tokens are placed.
    """
    rules = Rules(Tokens(summary.board, summary.deck))
    if summary.places:
        yield Identified(summary.placing_name, _placing(rules, summary))
    for rule, name in zip(summary.rules, summary.rule_names, strict=True):
        if not isinstance(rule, FillOrder | FullRow):
            yield Identified(name, rules.says(rule))
    for step in summary.steps:
        yield Identified(step.name, _step(step))


def gaps_of(summary: Summary) -> Iterator[Identified]:
    """A sentence for each gap."""
    tokens = Tokens(summary.board, summary.deck)
    for gap, name in zip(summary.gaps, summary.gap_names, strict=True):
        match gap:
            case Unseen():
                yield Identified(name, _unseen(gap))
            case Narrow():
                yield Identified(name, _narrow(tokens, gap))
            case _:
                assert_never(gap)


def check_of(summary: Summary) -> Say | None:
    """What is said of the comparison; where there are gaps, they say it."""
    match summary.check:
        case Check.SAME:
            return say(Key.EXACT)
        case Check.WIDER:
            return None
        case Check.NOT_COMPARED:
            return say(Key.NOT_COMPARED)
        case _:
            assert_never(summary.check)


def either(shown: tuple[Attributes, ...]) -> Listing:
    """One of these tokens."""
    return Listing(tuple(Named(each) for each in shown), Joint.OR)


def _placing(rules: Rules, summary: Summary) -> Say:
    filling = next((rule.filling for rule in summary.rules if isinstance(rule, FillOrder)), None)
    full = any(isinstance(rule, FullRow) for rule in summary.rules)
    counts = None if full else tuple(sorted(summary.lengths))
    if filling is None and any(step.cell is not None for step in summary.steps):
        return rules.placing_in(say(Key.IN_THIS_ORDER), counts)
    return rules.placing(filling, counts)


def _step(step: Step) -> Say:
    nth = Nth(step.step)
    if step.cell is None:
        return say(Key.NTH_IS, nth=nth, tokens=either(step.shown))
    place = Place(step.cell)
    if not step.shown:
        return say(Key.NTH_THERE, nth=nth, place=place)
    return say(Key.NTH_IS_THERE, nth=nth, tokens=either(step.shown), place=place)


def _unseen(gap: Unseen) -> Say:
    few = len(gap.missing) <= MAX_MISSING and len(gap.missing) < len(gap.seen)
    if few or not gap.seen:
        return say(Key.NOT_SHOWN, tokens=either(gap.missing), nth=Nth(gap.step))
    return say(Key.SEEN_GO, tokens=either(gap.seen), nth=Nth(gap.step))


def _narrow(tokens: Tokens, gap: Narrow) -> Say:
    who, nth = either(gap.shown), Nth(gap.step)
    literals = needed(gap.literals)
    if len(literals) > MAX_CONDITIONS:
        return say(Key.SEEN_TOO_SELDOM, tokens=who, nth=nth)
    if len(literals) == 1:
        (literal,) = literals
        if isinstance(literal, Placed) and isinstance(literal.value, Cell):
            key = Key.SEEN_COME if literal.feature.name == "origin" else Key.SEEN_GO_TO
            return say(key, tokens=who, nth=nth, place=Place(literal.value))
    conditions = Conditions(tokens, gap.shown[0]).listed(literals)
    return say(Key.SEEN_ONLY_IF, tokens=who, nth=nth, conditions=conditions)

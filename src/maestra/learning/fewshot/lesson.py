"""What was learned: rules with confidence, alternatives, slips, and how sure all of it is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.learning.fewshot.prior import ALONE
from maestra.learning.fewshot.space import Context, Words
from maestra.learning.fewshot.truths import Truths
from maestra.rules.answers import Answer
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.timing import Filling
from maestra.rules.rule import Rule
from maestra.rules.setting import Play


@dataclass(frozen=True, slots=True)
class Slip:
    """A likely mistake in a demonstration."""

    demonstration: int
    """From 0."""
    move: int
    """From 0."""
    confidence: float


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """A conjunction of rules and how likely it is that just it is meant."""

    rules: tuple[Rule, ...]
    weight: float


@dataclass(frozen=True, slots=True)
class Lesson:
    """What was learned from demonstrations and answers."""

    status: LearnStatus
    rules: tuple[Rule, ...]
    """The likeliest conjunction; of `OUTSIDE` too, where it is only a guess."""
    confidences: tuple[float, ...]
    """For each of the rules, how likely it is meant or follows."""
    confidence: float
    """In the rules as a whole."""
    alternatives: tuple[Hypothesis, ...]
    """Other exercises, likeliest first."""
    slips: tuple[Slip, ...]
    safe: tuple[Rule, ...]
    """The safe bound: all plausible rules at once; what they accept is right for certain."""
    demonstrations: tuple[Demonstration, ...]
    answers: tuple[Answer, ...]
    belief: Belief


@dataclass(frozen=True, slots=True, eq=False)
class Class:
    """Hypotheses that allow the same rows everywhere we look."""

    parts: tuple[int, ...]
    """The proposals of the best of them."""
    bits: float
    """Minus the logarithm of how likely it is, but for a constant."""
    slip: int | None
    """The distinct layout that is taken for a mistake."""
    words: tuple[Words, ...]
    """The rows allowed, for each context."""

    def allows_the_same(self, other: Class) -> bool:
        """Whether the two differ at most in what they take for a mistake."""
        return all(map(np.array_equal, self.words, other.words))


@dataclass(frozen=True)
class Belief:
    """Everything the posterior rests on; for asking on."""

    plays: tuple[Play, ...]
    contexts: tuple[Context, ...]
    truths: Truths
    classes: tuple[Class, ...]
    """Likeliest first."""
    weights: tuple[float, ...]
    """Of the classes; what is missing to one is `outside`."""
    filling: tuple[tuple[Filling | None, float], ...]
    """Orders of placement, likeliest first, whatever the row must be."""
    outside: float
    """How likely it is that the exercise is about something that cannot be said."""
    full: bool
    """Whether every goal cell was filled each time."""

    @cached_property
    def weighted(self) -> tuple[tuple[Class, float], ...]:
        """The classes with their weights."""
        return tuple(zip(self.classes, self.weights, strict=True))

    def rules_of(self, one: Class) -> tuple[Rule, ...]:
        """The rules of a class, without the length and the order of placement."""
        rules = (rule for p in one.parts for rule in self.truths.survivors[p].rules)
        return tuple(dict.fromkeys(rules))

    def orders_of(self, one: Class) -> dict[Filling | None, float]:
        """How likely each order of placement is asked for, if that class is right.

        An exercise asks for something: where any row will do, for an order.
        """
        none, some = (1.0, 1 - ALONE) if one.parts else (0.0, 1.0)
        shares = {
            order: share * (none if order is None else some) for order, share in self.filling
        }
        total = sum(shares.values())
        return {order: share / total for order, share in shares.items()}

    @cached_property
    def orders(self) -> dict[Filling | None, float]:
        """How likely each order of placement is asked for."""
        found = {filling: share * self.outside for filling, share in self.filling}
        for one, weight in self.weighted:
            for filling, share in self.orders_of(one).items():
                found[filling] += weight * share
        return found

    @property
    def asked_in(self) -> tuple[int, ...]:
        """The contexts that rows may be asked in: the shown start and another one."""
        return (0, len(self.contexts) - 1)

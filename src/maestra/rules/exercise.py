"""What has been learned and can be played: an exercise, made of actions or of rules."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Final, TypeAlias

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, refuse, shorten
from maestra.core.text import faults_of_name
from maestra.core.tokens import Deck
from maestra.rules.answers import Answer
from maestra.rules.fitting import misfits
from maestra.rules.rule import MAX_RULES, Rule
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.summaries.rule_ids import rule_ids

MAX_SAFE_RULES: Final = 1_000
"""In the most specific hypothesis, which only a program reads."""
MAX_ALTERNATIVES: Final = 1_000
"""Other exercises that may be meant: a learner names ten, none needs a thousand."""


@dataclass(frozen=True, slots=True)
class Deletion:
    """Literals that one demonstration showed not to be needed."""

    demonstration: int
    """From 1, in the order they were shown."""
    literals: int
    """A bit set over the vocabulary."""


@dataclass(frozen=True, slots=True)
class Provenance:
    """Where an action's precondition comes from."""

    seen: int
    """In how many demonstrations it was shown: each literal that is left held in all of them."""
    deletions: tuple[Deletion, ...]


@dataclass(frozen=True, slots=True)
class GroundedExercise:
    """An exercise as the paper learns it: an action for each token and step."""

    model: ActionModel
    provenance: Mapping[Action, Provenance]
    """For each action of the model."""
    lengths: frozenset[int]
    """After how many moves a play may end: after as many as some demonstration had."""
    demonstrations: int
    """How many were shown."""

    @property
    def board(self) -> Board:
        """The board it is played on."""
        return self.model.vocabulary.board

    @property
    def deck(self) -> Deck:
        """The tokens it was learned with."""
        return self.model.vocabulary.deck


class LearnStatus(Enum):
    """What learning came to."""

    LEARNED = "learned"
    AMBIGUOUS = "ambiguous"
    """Several exercises explain what was shown; questions would tell them apart."""
    OUTSIDE = "outside"
    """No simple rule explains what was shown better than listing it."""
    CONTRADICTORY = "contradictory"
    """No exercise agrees with all that was shown and answered."""
    TOLD = "told"
    """The rules were said in words: there was nothing to find out."""


@dataclass(frozen=True, slots=True)
class MeantRule:
    """One of an exercise's rules.

    Raises:
        InvalidError: an id that is no plain text, a confidence that is none.
    """

    id: str
    """A stable name, for programs; unique in its exercise."""
    rule: Rule
    confidence: float
    """How likely it is that the rule is meant, or follows from what is."""

    def __post_init__(self) -> None:
        """Refuse what is no rule of an exercise, naming every fault."""
        refuse([*faults_of_name("id", self.id), *_faults_of_share("confidence", self.confidence)])


@dataclass(frozen=True, slots=True)
class Alternative:
    """Other rules that may be meant instead.

    Raises:
        InvalidError: a weight that is none.
    """

    rules: tuple[Rule, ...]
    weight: float
    """How likely it is that just these are meant."""

    def __post_init__(self) -> None:
        """Refuse a weight that is none."""
        refuse(_faults_of_share("weight", self.weight))


@dataclass(frozen=True, slots=True)
class Exam:
    """What came of letting a caregiver judge plays that the exercise allows, and near misses.

    Raises:
        InvalidError: more that was agreed to than was shown, or less than nothing.
    """

    date: str
    """When, as it was given: ``2026-11-22``."""
    plays: int
    """Plays shown that the exercise holds for right."""
    agreed: int
    """How many of these the caregiver called right too."""
    near_misses: int = 0
    """Plays shown that the exercise holds for wrong."""
    near_misses_agreed: int = 0
    """How many of these the caregiver called wrong too."""

    def __post_init__(self) -> None:
        """Refuse numbers that cannot be, naming every fault."""
        faults = list(faults_of_name("date", self.date))
        counts = (
            ("agreed", self.agreed, self.plays),
            ("near_misses_agreed", self.near_misses_agreed, self.near_misses),
        )
        for name, agreed, shown in counts:
            if not 0 <= agreed <= shown:
                faults.append(Fault(name, str(agreed), f"0 to {shown}, how many were shown"))
        refuse(faults)


@dataclass(frozen=True, slots=True)
class Evidence:
    """What an exercise rests on: kept, so that teaching can go on later."""

    demonstrations: tuple[Demonstration, ...] = ()
    answers: tuple[Answer, ...] = ()
    exams: tuple[Exam, ...] = ()


@dataclass(frozen=True, slots=True)
class RuledExercise:
    """An exercise made of rules, all of which a right play keeps.

    How long a play is and in which order the cells are filled are rules too. It can be played
    with any deck that has the attributes its rules ask for.

    Raises:
        InvalidError: an id twice, more rules than `MAX_RULES`, rules that ask for what the deck
            does not have, a confidence that is none.
    """

    board: Board
    """The board it was taught on."""
    deck: Deck
    """The tokens it was taught with."""
    rules: tuple[MeantRule, ...]
    """Of `OUTSIDE` too, where they are only a guess."""
    confidence: float
    """How likely it is that just these rules are meant."""
    status: LearnStatus
    safe: tuple[Rule, ...]
    """The most specific hypothesis: what it accepts is right, if any exercise of the language is
    meant."""
    alternatives: tuple[Alternative, ...] = ()
    """Other exercises that may be meant, likeliest first."""
    evidence: Evidence = Evidence()

    def __post_init__(self) -> None:
        """Refuse an exercise that nobody could play, naming every fault."""
        faults = _faults_of_share("confidence", self.confidence)
        faults += _faults_of_ids([one.id for one in self.rules])
        if len(self.alternatives) > MAX_ALTERNATIVES:
            found = f"{len(self.alternatives)} alternatives"
            faults.append(Fault("alternatives", found, f"at most {MAX_ALTERNATIVES}"))
        faults += self._faults_of_rules("rules", self.conjunction, MAX_RULES, ".rule")
        faults += self._faults_of_rules("safe", self.safe, MAX_SAFE_RULES)
        for index, other in enumerate(self.alternatives):
            where = f"alternatives[{index}].rules"
            faults += self._faults_of_rules(where, other.rules, MAX_RULES)
        refuse(faults)

    @property
    def conjunction(self) -> tuple[Rule, ...]:
        """The rules without what is known about them."""
        return tuple(one.rule for one in self.rules)

    def _faults_of_rules(
        self, where: str, rules: Sequence[Rule], most: int, inner: str = ""
    ) -> list[Fault]:
        if len(rules) > most:
            return [Fault(where, f"{len(rules)} rules", f"at most {most}")]
        return [
            fault.under(f"{where}[{index}]{inner}")
            for index, rule in enumerate(rules)
            for fault in misfits([rule], self.deck)
        ]


Exercise: TypeAlias = GroundedExercise | RuledExercise


def meant_rules(rules: Sequence[Rule], confidences: Sequence[float]) -> tuple[MeantRule, ...]:
    """The rules, each with its confidence and an id made of what it says."""
    ids = rule_ids(rules)
    return tuple(MeantRule(*one) for one in zip(ids, rules, confidences, strict=True))


def _faults_of_ids(ids: Sequence[str]) -> list[Fault]:
    return [
        Fault("rules", f"the id {shorten(name)} {times} times", "each id once")
        for name, times in Counter(ids).items()
        if times > 1
    ]


def _faults_of_share(where: str, share: float) -> list[Fault]:
    return [] if 0 <= share <= 1 else [Fault(where, str(share), "a number from 0 to 1")]

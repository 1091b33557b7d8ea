"""The few rules that say what an exercise's many preconditions say, and where they say more.

A rule is chosen only if every play that the preconditions accept keeps it; so what the rules
refuse, the preconditions refuse. The converse is checked, exactly and without listing plays: the
preconditions accept all that the rules accept if, and only if, every action that occurs in a
right play is known and no right play makes a literal of its precondition false. Each literal
speaks of the move's own cells or of what lies on one cell, so it is enough to know which tokens
can lie where, and which two together (`right_rows`). What fails this check is a gap: the rules
are wider there than what has been learned.

Where the rows cannot be told apart like that and are too many to list, the outcome says so.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.tokens import Attributes, Deck
from maestra.rules.exercise import GroundedExercise
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import Mask
from maestra.rules.strips.literals import Literal
from maestra.rules.summaries.candidates import Candidates, Chosen, GivenRow
from maestra.rules.summaries.comparison import Wider, compare
from maestra.rules.summaries.evidence import Bits, Evidence
from maestra.rules.summaries.outline import Outline
from maestra.rules.summaries.right_rows import UndecidedError
from maestra.rules.summaries.rule_ids import number_equal_ones, rule_ids


class Check(Enum):
    """What the comparison of the rules with the preconditions came to."""

    SAME = "same"
    """They accept the same plays of the exercise's board."""
    WIDER = "wider"
    """The rules accept more: the gaps say what."""
    NOT_COMPARED = "not-compared"
    """Too many plays to tell, or moves of a kind that rules do not speak of."""


@dataclass(frozen=True, slots=True)
class Unseen:
    """Tokens that the rules would accept as this move, but that were never shown as it."""

    step: int
    seen: tuple[Attributes, ...]
    """What was shown as this move instead; empty if no play came so far."""
    missing: tuple[Attributes, ...]


@dataclass(frozen=True, slots=True)
class Narrow:
    """Actions whose precondition demands what the rules do not."""

    step: int
    shown: tuple[Attributes, ...]
    """What these actions move."""
    literals: tuple[Literal, ...]
    """What they demand beyond the rules."""


Gap: TypeAlias = Unseen | Narrow


@dataclass(frozen=True, slots=True)
class Step:
    """What may come as one move, where no rule says it."""

    step: int
    shown: tuple[Attributes, ...]
    cell: Cell | None
    """Where it goes, if no rule says so and it is always the same."""

    @property
    def name(self) -> str:
        """Its id."""
        return f"step-{self.step}"


@dataclass(frozen=True, slots=True)
class Summary:
    """What an exercise asks for, in few rules."""

    board: Board
    deck: Deck
    places: bool
    """Whether every move takes a token from storage to the goal row; rules speak of no other."""
    rules: tuple[Rule, ...]
    """In the order in which a person would say them."""
    steps: tuple[Step, ...]
    """Empty when the rules say what may come when."""
    lengths: frozenset[int]
    """After how many moves a play may end."""
    gaps: tuple[Gap, ...]
    check: Check

    @property
    def rule_names(self) -> tuple[str, ...]:
        """An id for each rule, unique here."""
        return rule_ids(self.rules)

    @property
    def placing_name(self) -> str:
        """The id of what says where tokens go: the order in which the cells are filled, if any."""
        named = zip(self.rules, self.rule_names, strict=True)
        return next((name for rule, name in named if isinstance(rule, FillOrder)), "placing")

    @property
    def gap_names(self) -> tuple[str, ...]:
        """An id for each gap, unique here."""
        names = ["unseen" if isinstance(gap, Unseen) else "narrow" for gap in self.gaps]
        steps = [f"{name}-{gap.step}" for name, gap in zip(names, self.gaps, strict=True)]
        return number_equal_ones(steps)


def summarise(exercise: GroundedExercise) -> Summary:
    """The rules that every play of `exercise` keeps, as few and as tight as possible.

    The cost grows with tokens² x goal cells², not with the number of plays.
    """
    evidence = Evidence(exercise)
    if not evidence.only_places:
        return _Draft(evidence, Candidates(evidence), placing=False).summary()
    draft = _Draft(evidence, Candidates(evidence))
    given = draft.candidates.given_row()
    if given is not None and draft.is_poor and draft.may_be_given:
        return _Draft(evidence, draft.candidates, given=given).summary()
    return draft.summary()


@dataclass(frozen=True)
class _Draft:
    """One way to put the evidence into rules."""

    evidence: Evidence
    candidates: Candidates
    given: GivenRow | None = None
    placing: bool = True
    """Whether the exercise only places tokens; rules speak of no other."""

    @property
    def may_be_given(self) -> bool:
        """Whether a row that is always the same is meant: not if an order or source explains it.

        A source explains it no longer when the same row was shown again.
        """
        provenance = self.evidence.exercise.provenance
        again = all(provenance[action].seen > 1 for action in provenance)
        return not self.neighbours and (again or not self.sources)

    @property
    def is_poor(self) -> bool:
        """Whether the rules are known not to say it all."""
        return bool(self._wider) or self._step_by_step

    @cached_property
    def sources(self) -> tuple[Rule, ...]:
        """Where tokens come from."""
        return tuple(self.candidates.sources())

    @cached_property
    def selections(self) -> list[Chosen]:
        """Which tokens are used."""
        return [] if self.given else self.candidates.selections()

    @cached_property
    def neighbours(self) -> list[Chosen]:
        """How neighbours compare."""
        return [] if self.given else self.candidates.neighbours()

    def summary(self) -> Summary:
        """The rules, what they leave open, and how they compare."""
        exercise = self.evidence.exercise
        return Summary(
            exercise.board,
            exercise.deck,
            self.placing,
            tuple(self._rules()) if self.placing else (),
            tuple(self._steps()),
            exercise.lengths,
            tuple(self._gaps()),
            self._check(),
        )

    def _rules(self) -> Iterator[Rule]:
        if self.candidates.filling is not None:
            yield self.candidates.filling
        if self.evidence.exercise.lengths == frozenset({self.evidence.exercise.board.columns}):
            yield FullRow()
        yield from self.sources
        if self.given is not None:
            yield self.given.rule
        yield from (chosen.rule for chosen in (*self.selections, *self.neighbours))

    @cached_property
    def _step_by_step(self) -> bool:
        """Whether only the single steps say which tokens come when."""
        if not self.placing:
            return True
        everything = sum(self.evidence.of_shown)
        restricted = any(tokens != everything for tokens in self.evidence.tokens.values())
        explained = self.given or self.sources or self.selections or self.neighbours
        return restricted and not explained

    def _steps(self) -> Iterator[Step]:
        """What comes when, and where, if no rule says it."""
        fixed = self.candidates.fixed_order if self.placing else None
        says_where = self.placing and self.candidates.filling is None and fixed is not None
        if not self._step_by_step and not says_where:
            return
        goal_cells = self.evidence.exercise.board.goal_cells
        shown = self.evidence.vocabulary.shown
        for step, actions in sorted(self.evidence.actions.items()):
            known = tuple(shown[index] for index in sorted(actions)) if self._step_by_step else ()
            where = fixed is not None and says_where and step <= len(fixed)
            yield Step(step, known, goal_cells[fixed[step - 1]] if where and fixed else None)

    @cached_property
    def _outline(self) -> Outline:
        exercise = self.evidence.exercise
        return Outline(
            exercise.board,
            self.candidates.levels,
            exercise.lengths,
            self._domains(),
            self.evidence.tokens if self._step_by_step else None,
            self._before(),
            self.candidates.storage_row,
            self.candidates.same_column,
        )

    def _domains(self) -> tuple[Mask, ...]:
        columns = self.evidence.exercise.board.columns
        domain = sum(self.evidence.of_shown)
        for chosen in self.selections:
            domain &= chosen.mask
        if self.given is None:
            return (domain,) * columns
        masks = self.given.masks
        return (*masks, *(domain,) * (columns - len(masks)))

    def _before(self) -> tuple[Mask, ...] | None:
        related = [chosen.before for chosen in self.neighbours if chosen.before is not None]
        if not related:
            return None
        before, *others = related
        for other in others:
            before = tuple(one & two for one, two in zip(before, other, strict=True))
        return before

    @cached_property
    def _wider(self) -> Wider | None:
        """Where the rules are wider; None if that cannot be found out."""
        if not self.placing:
            return None
        try:
            return compare(self.evidence, self._outline)
        except UndecidedError:
            return None

    def _check(self) -> Check:
        if self._wider is None:
            return Check.NOT_COMPARED
        return Check.WIDER if self._wider else Check.SAME

    def _gaps(self) -> Iterator[Gap]:
        if self._wider is None:
            return
        vocabulary = self.evidence.vocabulary
        shown = vocabulary.shown
        for step, missing in sorted(self._wider.unseen.items()):
            seen = self.evidence.actions.get(step, {})
            yield Unseen(step, _named(shown, seen), _named(shown, missing))
        alike: dict[tuple[int, Bits], list[int]] = {}
        for (step, moved), literals in sorted(self._wider.falsified.items()):
            alike.setdefault((step, literals), []).append(moved)
        for (step, literals), moved_by in alike.items():
            yield Narrow(step, _named(shown, moved_by), vocabulary.select(literals))


def _named(shown: tuple[Attributes, ...], indices: Iterable[int]) -> tuple[Attributes, ...]:
    """What is shown at these indices, in the order of the deck."""
    return tuple(shown[index] for index in sorted(indices))

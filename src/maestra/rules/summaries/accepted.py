"""The plays that a summary accepts, listed: what to show next is chosen from them.

Depth first, move by move, as long as every rule is still possible. Where tokens come from is a
matter apart, as in `right_plays`: which cells the source rules allow is asked token by token.
Cost: the beginnings that are right times tokens times the goal cells that come next.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from maestra.core.state import State
from maestra.rules.features import TokenFeature
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import FillOrder
from maestra.rules.right_plays import Placement, RightPlays
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Play, Setting, bits
from maestra.rules.token_tests import Has, Not

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from maestra.core.board import Board, Cell
    from maestra.core.tokens import Deck, TokenId
    from maestra.rules.right_plays import Placements
    from maestra.rules.rule import Rule
    from maestra.rules.setting import Index
    from maestra.rules.summaries.summary import Step, Summary

MAX_TRIED: Final = 20_000
"""Placements looked at before it is given up: some tenths of a second."""


class _GivenUpError(Exception):
    """More than `MAX_TRIED`."""


def accepted_plays(summary: Summary, max_tried: int = MAX_TRIED) -> RightPlays | None:
    """All plays that the rules and steps of `summary` accept, on its board with its deck.

    None if it accepts moves that are no placements, the storage rows have no room for all
    tokens, or there are too many to be listed.
    """
    if not summary.places or len(summary.deck.tokens) > len(summary.board.storage_cells):
        return None
    return plays_keeping(
        summary.rules, summary.board, summary.deck, summary.lengths, summary.steps, max_tried
    )


def plays_keeping(
    rules: Sequence[Rule],
    board: Board,
    deck: Deck,
    lengths: frozenset[int],
    steps: Sequence[Step] = (),
    max_tried: int = MAX_TRIED,
) -> RightPlays | None:
    """All plays of one of `lengths` that keep `rules` and `steps`, with all tokens in storage.

    Of the rules only those that `is_about_sources` may look at where tokens come from. None if
    there are too many to be listed.

    Raises:
        InvalidError: the storage rows have no room for all tokens.
    """
    search = _Search(tuple(rules), board, deck, lengths, tuple(steps), max_tried)
    try:
        known = tuple(search.sequences())
    except _GivenUpError:
        return None
    return RightPlays(board, deck, origins=search.origins, lengths=lengths, known=known)


@dataclass
class _Search:
    """Lists what rules and steps accept."""

    rules: tuple[Rule, ...]
    board: Board
    deck: Deck
    lengths: frozenset[int]
    steps: tuple[Step, ...]
    left: int
    """How many more placements may be looked at."""
    known_origins: dict[tuple[TokenId, Cell], frozenset[Cell]] = field(
        default_factory=dict["tuple[TokenId, Cell]", "frozenset[Cell]"]
    )

    def __post_init__(self) -> None:
        """Part the rules about sources from the others, which need no certain start."""
        rules = self.rules
        self.sources = tuple(rule for rule in rules if is_about_sources(rule))
        self.others = tuple(rule for rule in rules if rule not in self.sources)
        self.fill_order = next((rule for rule in rules if isinstance(rule, FillOrder)), None)
        ids = [token.id for token in self.deck.tokens]
        cells = dict(zip(ids, self.board.storage_cells, strict=False))
        self.setting = Setting(self.deck, State(self.board, cells))

    def sequences(self) -> Iterator[Placements]:
        """Every accepted sequence of placements.

        Raises:
            _GivenUpError: they are too many.
        """
        yield from self._from(Play.begin(self.setting))

    def origins(self, _step: int, placement: Placement) -> frozenset[Cell] | None:
        """The storage cells from which the token of a placement may come; None: any."""
        if not self.sources:
            return None
        key = (placement.token, placement.destination)
        if key not in self.known_origins:
            storage = self.board.storage_cells
            fitting = (cell for cell in storage if self._may_come_from(cell, placement))
            self.known_origins[key] = frozenset(fitting)
        return self.known_origins[key]

    def _from(self, play: Play) -> Iterator[Placements]:
        made = len(play.placed)
        if made in self.lengths and all(rule.holds(play) for rule in self.others):
            yield self._placements(play)
        if made < max(self.lengths):
            for longer in self._longer(play):
                yield from self._from(longer)

    def _longer(self, play: Play) -> Iterator[Play]:
        """The plays with one more placement, as long as nothing speaks against them."""
        cells = play.free if self.fill_order is None else self.fill_order.next_cells(play)
        for cell in cells:
            for token in bits(play.left):
                if self.left <= 0:
                    raise _GivenUpError
                self.left -= 1
                longer = play.after(token, cell)
                if self._may_come(len(longer.placed), token, cell) and all(
                    rule.possible(longer) for rule in self.others
                ):
                    yield longer

    def _may_come(self, step: int, token: Index, cell: Index) -> bool:
        """Whether the steps allow it, where no rule says what comes when."""
        shown = self.deck.tokens[token].attributes
        goal = self.board.goal_cells[cell]
        return all(
            shown in one.shown and one.cell in {None, goal}
            for one in self.steps
            if one.step == step
        )

    def _placements(self, play: Play) -> Placements:
        tokens, goals = self.deck.tokens, self.board.goal_cells
        return tuple(Placement(tokens[token].id, goals[cell]) for token, cell in play.placed)

    def _may_come_from(self, cell: Cell, placement: Placement) -> bool:
        """Whether the token may come from `cell`; what lies there trades places with it."""
        cells = dict(self.setting.start.cells)
        other = self.setting.start.tokens.get(cell)
        if other is not None:
            cells[other] = cells[placement.token]
        cells[placement.token] = cell
        setting = Setting(self.deck, State(self.board, cells))
        token = setting.number_of[placement.token]
        play = Play.begin(setting).after(token, placement.destination.column - 1)
        return all(rule.possible(play) for rule in self.sources)


def is_about_sources(rule: Rule) -> bool:
    """Whether a rule says for each token apart which cells it may come from."""
    match rule:
        case StraightUp():
            return True
        case EveryToken(Has(TokenFeature(_, attribute)) | Not(Has(TokenFeature(_, attribute)))):
            return attribute in {ORIGIN_ROW, ORIGIN_COLUMN}
        case _:
            return False

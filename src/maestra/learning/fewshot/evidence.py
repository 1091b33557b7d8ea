"""What demonstrations and answers say of rows of tokens.

The plays fix the contexts: from which start, placed in which order. In each of them what was
shown and answered is a set of rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias, assert_never

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.core.state import State
from maestra.core.tokens import TokenId
from maestra.learning.fewshot.filling import Fillings, another_order, fillings, out_of_order
from maestra.learning.fewshot.posterior import Answered, Layout
from maestra.learning.fewshot.proposals import Survivor, surviving
from maestra.learning.fewshot.sampled import sampled
from maestra.learning.fewshot.space import (
    MAX_ROWS,
    Context,
    Order,
    Rows,
    Words,
    how_many,
    pack,
    row_number,
    rows_of,
)
from maestra.rules.answers import (
    Answer,
    MoveQuestion,
    Question,
    Reply,
    RowQuestion,
    RuleQuestion,
)
from maestra.rules.forms.timing import FillOrder
from maestra.rules.plays import NOBODY, Tokens, Truth
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play, Setting, play_of

_TokenRow: TypeAlias = tuple[TokenId | None, ...]
"""What lies on each goal cell, whatever the start."""

Place: TypeAlias = tuple[Setting, Order]
"""What tells contexts apart."""


@dataclass(frozen=True)
class Evidence:
    """Demonstrations and answers as the search looks at them; works out what is asked for."""

    demonstrations: tuple[Demonstration, ...]
    """At least one."""
    answers: tuple[Answer, ...]
    seed: int
    """Of the sample that stands for the rows where they are too many to list."""

    @cached_property
    def plays(self) -> tuple[Play, ...]:
        """The demonstrations as plays; those from the same start share its setting."""
        settings = [self._known(Setting(one.deck, one.start)) for one in self.demonstrations]
        return tuple(map(play_of, self.demonstrations, settings))

    @cached_property
    def _showings(self) -> dict[_TokenRow, Index]:
        """Each row that was shown, with the first play that shows it."""
        found: dict[_TokenRow, Index] = {}
        for k, play in enumerate(self.plays):
            found.setdefault(_token_row(play), k)
        return found

    @cached_property
    def distinct(self) -> tuple[Index, ...]:
        """The plays that show a row for the first time: equal rows count once."""
        return tuple(self._showings.values())

    @cached_property
    def full(self) -> bool:
        """Whether every goal cell was filled each time."""
        return all(not play.free for play in self.plays)

    @cached_property
    def timed(self) -> bool:
        """Whether somebody did not simply fill from the left: else time tells nothing new."""
        return any(_order(play) != _from_the_left(play) for play in self.plays)

    @cached_property
    def survivors(self) -> tuple[Survivor, ...]:
        """The proposals that hold of all plays, or break a distinct one that may be a slip."""
        first = [self.plays[k] for k in self.distinct]
        again = [play for k, play in enumerate(self.plays) if k not in self.distinct]
        found = surviving([*first, *again], timed=self.timed, slips=int(len(first) > 1))
        # A row that is shown again, from another start, is no slip; nor is one said to be right.
        said = {
            _token_row(answer.question.play)
            for answer in self.answers
            if isinstance(answer.question, RowQuestion) and answer.reply is Reply.YES
        }
        sure = {1 << k for k, row in enumerate(self._showings) if row in said}
        return tuple(
            one for one in found if one.broken < 1 << len(first) and one.broken not in sure
        )

    @cached_property
    def contexts(self) -> tuple[Context, ...]:
        """Those of what was shown and answered; at last one that starts elsewhere."""
        seen = [Context(*place, self._rows(*place)) for place in self._places]
        first, other = seen[0], elsewhere(self.plays[0].setting)
        order = another_order(first.order, self.fillings)
        if order == first.order:
            # The row from the other side, so that what is meant in time differs from it.
            back = order[::-1]
            seen.append(Context(first.setting, back, self._rows(first.setting, back)))
        return (*seen, Context(other, order, self._rows(other, order)))

    @cached_property
    def fillings(self) -> Fillings:
        """How likely each order of placement is asked for."""
        return fillings(self.plays, self.answers)

    @cached_property
    def layouts(self) -> tuple[Layout, ...]:
        """What was shown; one for each of `distinct`."""
        return tuple(self._layout(self.plays[k]) for k in self.distinct)

    @cached_property
    def answered(self) -> tuple[Answered, ...]:
        """What was said of rows and moves."""
        return tuple(self._answered(answer, position) for answer, position in self._said)

    @cached_property
    def meant(self) -> tuple[tuple[Rule, bool], ...]:
        """What was said of rules, but for the order of placement: whether each is meant."""
        return tuple(
            (answer.question.rule, answer.reply is Reply.YES)
            for answer in self.answers
            if isinstance(answer.question, RuleQuestion)
            and not isinstance(answer.question.rule, FillOrder)
            and answer.reply is not Reply.UNSURE
        )

    @cached_property
    def _settings(self) -> dict[Setting, Setting]:
        return {}

    def _known(self, setting: Setting) -> Setting:
        """The first setting like this one, which remembers what was worked out."""
        return self._settings.setdefault(setting, setting)

    @cached_property
    def _asked(self) -> tuple[tuple[Answer, Play], ...]:
        """The answers about rows and moves, with the position each is about."""
        return tuple(
            (answer, position)
            for answer in self.answers
            if (position := _position(answer.question)) is not None
        )

    @cached_property
    def _said(self) -> tuple[tuple[Answer, Play], ...]:
        """Those that tell something."""
        return tuple(one for one in self._asked if one[0].reply is not Reply.UNSURE)

    @cached_property
    def _places(self) -> dict[Place, int]:
        """The numbers of the contexts of what was shown and answered."""
        positions = [*(self.plays[k] for k in self.distinct), *(play for _, play in self._said)]
        different = dict.fromkeys(map(self._place, positions))
        return {place: number for number, place in enumerate(different)}

    def _place(self, play: Play) -> Place:
        # With gaps the order of placement says which cells stay free.
        matters = self.timed or not self.full
        return self._known(play.setting), _order(play) if matters else _from_the_left(play)

    def _layout(self, play: Play) -> Layout:
        context = self._places[self._place(play)]
        rows = self.contexts[context].rows
        own = np.zeros(len(rows.row), np.bool_)
        own[row_number(rows, play)] = True
        near = _near(rows, play)
        return Layout(context, pack(own), pack(near), max(1.0, float(near.sum())))

    def _answered(self, answer: Answer, position: Play) -> Answered:
        context = self._places[self._place(position)]
        rows = self.contexts[context].rows
        asked = _matching(rows, position, whole=isinstance(answer.question, RowQuestion))
        yes = answer.reply is Reply.YES
        late = out_of_order(position, self.fillings)
        if answer.wrong is None:
            return Answered(context, asked, yes, late)
        return Answered(context, asked, yes, late, _mended(rows, position), answer.wrong)

    @cached_property
    def _sampled(self) -> dict[Setting, Rows]:
        return {}

    def _rows(self, setting: Setting, order: Order) -> Rows:
        """All rows from a start, or some that stand for all."""
        if how_many(setting, full=self.full) <= MAX_ROWS:
            return rows_of(setting, order, full=self.full)
        if setting not in self._sampled:
            positions = [*self.plays, *(play for _, play in self._asked if not play.free)]
            shown = [as_array(play) for play in positions if play.setting == setting]
            self._sampled[setting] = sampled(
                setting,
                self._likely,
                shown or [as_array(self.plays[0])],
                full=self.full,
                seed=self.seed,
            )
        return self._sampled[setting]

    @cached_property
    def _likely(self) -> list[Rule]:
        """The rules that hold of all plays, the shortest first."""
        whole = [one for one in self.survivors if not one.broken]
        return [rule for one in sorted(whole, key=lambda one: one.bits) for rule in one.rules]


def _token_row(play: Play) -> _TokenRow:
    ids = [token.id for token in play.setting.deck.tokens]
    return tuple(None if token is None else ids[token] for token in play.row)


def elsewhere(setting: Setting) -> Setting:
    """Another start of the same deck: the tokens in storage have changed places."""
    start = setting.start
    stored = [t.id for k, t in enumerate(setting.deck.tokens) if setting.movable >> k & 1]
    cells = sorted(start.cells[token] for token in stored)
    # Steps of a number that shares no factor with any likely count leave no row together.
    count = len(cells)
    moved = {token: cells[(7 * k + 3) % count] for k, token in enumerate(stored)}
    if len(set(moved.values())) < count:
        moved = {token: cells[-1 - k] for k, token in enumerate(stored)}
    return Setting(setting.deck, State(start.board, {**start.cells, **moved}))


def as_array(play: Play) -> Tokens:
    """The row of a play."""
    return np.array([NOBODY if token is None else token for token in play.row], np.intp)


def _from_the_left(play: Play) -> Order:
    return tuple(range(play.setting.length))


def _order(play: Play) -> Order:
    """The goal cells in the order they were filled, the free ones after them."""
    placed = [cell for _, cell in play.placed]
    return (*placed, *(k for k in range(play.setting.length) if k not in placed))


def _near(rows: Rows, play: Play) -> Truth:
    """The rows with one token in another's stead, or two in each other's place."""
    row = as_array(play)
    same = (rows.row == row).sum(axis=1)
    length = len(row)
    swapped = (same == length - 2) & np.isin(rows.row, row).all(axis=1)
    return np.asarray(((same == length - 1) | swapped) & rows.real)


def _mended(rows: Rows, play: Play) -> tuple[Words, ...]:
    """For each goal cell the rows of `_near` that differ there."""
    near = _near(rows, play)
    return tuple(
        pack(near & (rows.row[:, cell] != token)) for cell, token in enumerate(as_array(play))
    )


def _matching(rows: Rows, position: Play, *, whole: bool) -> Words:
    """The rows that have every token of the position in its place; only its own if `whole`."""
    truth = rows.real.copy()
    for cell, token in enumerate(as_array(position)):
        if whole or token != NOBODY:
            truth &= rows.row[:, cell] == token
    return pack(truth)


def _position(question: Question) -> Play | None:
    """The row asked about, or what the move would make."""
    match question:
        case RowQuestion(play):
            return play
        case MoveQuestion(position, token, cell):
            return position.after(token, cell)
        case RuleQuestion():
            return None
        case _:
            assert_never(question)

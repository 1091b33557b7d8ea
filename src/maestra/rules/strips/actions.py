"""STRIPS actions move-v-t(from, to): what must hold before, what changes, what is applicable.

The effects are those of any pick-and-place and never learned; a model is its preconditions [1].

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019,
sections 3.2 and 3.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from maestra.rules.strips.literals import formula, symbol

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from maestra.core.board import Cell
    from maestra.core.tokens import Attributes
    from maestra.rules.strips.literals import Literal
    from maestra.rules.strips.vocabulary import Vocabulary


@dataclass(frozen=True, slots=True)
class Action:
    """Moving a token that shows `shown` as the `step`-th move, from 1."""

    shown: Attributes
    step: int

    @property
    def name(self) -> str:
        """The paper's name, ``move-v19-t1``."""
        return f"move-{symbol(self.shown)}-t{self.step}"


ADDED: Final = ("contains(to, {v})", "empty(from)")
"""What every action makes true."""
REMOVED: Final = ("contains(from, {v})", "empty(to)")
"""What every action needs and makes false."""


@dataclass(frozen=True)
class ActionModel:
    """Actions and their preconditions.

    An action that is not there is never applicable. A precondition is a bit set over the
    vocabulary's literals; that the token lies on `from` and that `to` is empty goes without
    saying, because no board could make another move.
    """

    vocabulary: Vocabulary
    preconditions: Mapping[Action, int]

    def precondition(self, action: Action) -> tuple[Literal, ...]:
        """What must hold before `action`.

        Raises:
            KeyError: the model does not have the action.
        """
        return self.vocabulary.select(self.preconditions[action])

    def broken(
        self, action: Action, contents: Mapping[Cell, int], origin: Cell, destination: Cell
    ) -> tuple[Literal, ...]:
        """The literals of the precondition that do not hold; none if the action is applicable.

        Raises:
            KeyError: the model does not have the action.
        """
        moved = self.vocabulary.index_of_shown[action.shown]
        holding = self.vocabulary.holding(contents, moved, origin, destination)
        return self.vocabulary.select(self.preconditions[action] & ~holding)

    def applicable(self, step: int, contents: Mapping[Cell, int]) -> Iterator[tuple[Cell, Cell]]:
        """The moves, origin and destination, whose action is applicable as the `step`-th.

        Args:
            step: from 1.
            contents: what lies on each cell, as indices into the vocabulary's `shown`.
        """
        vocabulary, actions = self.vocabulary, self.by_step.get(step, {})
        of_move = (1 << vocabulary.placed_size) - 1
        empty = [cell for cell in vocabulary.board.cells if cell not in contents]
        for origin, moved in contents.items():
            if moved in actions:
                demanded = actions[moved] & ~vocabulary.lying(contents, moved)
                if not demanded & ~of_move:
                    for destination in empty:
                        if not demanded & ~vocabulary.placed(origin, destination):
                            yield origin, destination

    @cached_property
    def by_step(self) -> Mapping[int, Mapping[int, int]]:
        """Step to what the moved token shows (an index into the vocabulary's) to its literals."""
        steps: dict[int, dict[int, int]] = {}
        for action, bits in self.preconditions.items():
            moved = self.vocabulary.index_of_shown[action.shown]
            steps.setdefault(action.step, {})[moved] = bits
        return steps

    def formulas(self, action: Action) -> tuple[str, ...]:
        """The precondition in the paper's notation, as in its Fig. 4.

        Left out is what follows from the rest: ``goal(to)`` beside ``to = l11``.
        """
        mine = symbol(action.shown)
        known = [formula(literal, action.shown) for literal in self.precondition(action)]
        implied = {"goal(to)"} if any(text.startswith("to = ") for text in known) else set[str]()
        implied |= {"storage(from)"}
        learned = [text for text in known if text not in implied]
        places = [text for text in learned if text.startswith(("to = ", "from = "))]
        rest = [text for text in learned if text not in places]
        return (*places, *(text.format(v=mine) for text in REMOVED), *rest)

    def effects(self, action: Action) -> tuple[str, ...]:
        """What the action changes, in the paper's notation: the same for every action."""
        mine = symbol(action.shown)
        removed = [f"¬{text.format(v=mine)}" for text in REMOVED]
        added = [text.format(v=mine) for text in ADDED]
        return (removed[0], added[0], added[1], removed[1])

"""Whether a play can still be completed: a search that propagates, over bit sets of tokens.

Each step still to come has a domain: for each goal cell, the set of tokens that may go there.
Placing a token removes it and its cell from the later domains, and of what is left there all
tokens whose precondition looks at that cell and does not like what now lies on it. A quick search
with this forward checking [1] finds most completions without going back once, because tokens that
leave most to their successors are tried first. Where it gets lost, a second one also removes,
before each choice, all tokens without support in an earlier or a later step (arc consistency
[2]), which alone refutes every dead end of an order such as "ascending".

This needs moves from storage to the goal row only, as every exercise has them; a model that says
otherwise is searched state by state (`search_states`, which also is the oracle of the tests).

[1] Haralick, Elliott, Increasing tree search efficiency for constraint satisfaction problems,
Artificial Intelligence 14, 1980.
[2] Mackworth, Consistency in networks of relations, Artificial Intelligence 8, 1977.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING, Final

from maestra.rules.features import FRAME
from maestra.rules.literals import Placed
from maestra.rules.vocabulary import positions

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from maestra.core.board import Cell
    from maestra.core.state import State
    from maestra.core.tokens import Deck
    from maestra.rules.strips import ActionModel

    Tokens = int
    """A set of the deck's tokens, a bit each, in the deck's order."""
    Domain = dict[Cell, Tokens]
    """For each destination, the tokens that may still go there at a step."""

QUICK_NODES: Final = 200
"""Choices before the quick search gives way: a completion of 20 steps takes 20."""
CAREFUL_NODES: Final = 2_000
"""Choices before the careful search gives up: about ten seconds on the largest boards."""
STATE_NODES: Final = 200_000
"""States before the search state by state gives up: more than the paper's board has."""


class Prospect(Enum):
    """Whether a play can still be completed."""

    POSSIBLE = "possible"
    IMPOSSIBLE = "impossible"
    UNDECIDED = "undecided"
    """The search was given up; seen only on models made to be hard."""


@dataclass(frozen=True, slots=True)
class _Node:
    """What is left to choose from the present step on."""

    step: int
    domains: tuple[Domain, ...]
    """One for each step still to come."""
    contents: Mapping[Cell, int]
    """What lies on the watched cells, as indices into the vocabulary's `shown`."""


class _LostError(Exception):
    """More choices than allowed."""


class Completion:
    """Finds out, for plays with one deck, whether a model lets them be completed."""

    def __init__(self, model: ActionModel, lengths: frozenset[int], deck: Deck) -> None:
        """Prepare for plays with `deck`, which end after one of `lengths` moves.

        Raises:
            InvalidError: a token of the deck shows what the model does not know.
        """
        self.model = model
        self.lengths = lengths
        self.vocabulary = model.vocabulary
        self.tokens = tuple(token.id for token in deck.tokens)
        self._place = {token: index for index, token in enumerate(self.tokens)}
        indices = self.vocabulary.indices(deck)
        self._shown = tuple(indices[token] for token in self.tokens)
        self._goal_cells = self.vocabulary.board.goal_cells
        self._columns: dict[tuple[int, Cell, int], tuple[Cell, ...]] = {}
        self._groups: dict[tuple[int, Cell], dict[int, Tokens]] = {}
        self._liked: dict[tuple[int, int], Tokens] = {}
        self._fitting: dict[tuple[int, Cell, int], Tokens] = {}
        self._orders: dict[tuple[int, Cell], tuple[int, ...]] = {}

    def prospect(self, state: State, made: int) -> Prospect:
        """Whether the play can be completed from `state`, after `made` moves."""
        if made in self.lengths:
            return Prospect.POSSIBLE
        contents = {cell: self._shown[self._place[token]] for token, cell in state.cells.items()}
        if not self._one_way:
            return search_states(self.model, self.lengths, contents, made)
        found = [
            self._search(state, contents, made, length)
            for length in sorted(self.lengths)
            if length > made
        ]
        if Prospect.POSSIBLE in found:
            return Prospect.POSSIBLE
        return Prospect.UNDECIDED if Prospect.UNDECIDED in found else Prospect.IMPOSSIBLE

    @cached_property
    def _one_way(self) -> bool:
        """Whether every action takes a token from storage to the goal row."""
        frame = self.vocabulary.bits(Placed(feature, value=True) for feature in FRAME)
        return all(frame & ~bits == 0 for bits in self.model.preconditions.values())

    def _search(
        self, state: State, contents: Mapping[Cell, int], made: int, length: int
    ) -> Prospect:
        domains: list[Domain] = []
        for step in range(made + 1, length + 1):
            domain = self._domain(state, contents, step)
            if not domain:
                return Prospect.IMPOSSIBLE
            domains.append(domain)
        watched = self.vocabulary.offsets
        seen = {cell: shown for cell, shown in contents.items() if cell in watched}
        root = _Node(made + 1, tuple(domains), seen)
        for nodes, careful in ((QUICK_NODES, False), (CAREFUL_NODES, True)):
            budget = iter(range(nodes))
            try:
                done = self._completes(root, state, budget, careful=careful)
            except _LostError:
                continue
            return Prospect.POSSIBLE if done else Prospect.IMPOSSIBLE
        return Prospect.UNDECIDED

    def _completes(
        self, node: _Node, state: State, budget: Iterator[int], *, careful: bool
    ) -> bool:
        """Whether some choice of tokens and cells completes the play from `node`."""
        if not node.domains:
            return True
        if careful and not self._consistent(node):
            return False
        exact = self._exact(node)
        for cell, tokens in node.domains[0].items():
            candidates = tokens & exact
            for token in self._order(node.step, cell) if candidates else ():
                if not candidates >> token & 1:
                    continue
                if next(budget, None) is None:
                    raise _LostError
                after = self._place_token(node, state, token, cell)
                if after is not None and self._completes(after, state, budget, careful=careful):
                    return True
        return False

    def _place_token(self, node: _Node, state: State, token: int, cell: Cell) -> _Node | None:
        """The node after this choice; None when a later step is left without any."""
        shown = self._shown[token]
        others = ~(1 << token)
        later: list[Domain] = []
        for step, domain in enumerate(node.domains[1:], start=node.step + 1):
            keep = others & self._fits(step, cell, shown)
            left = {
                place: kept
                for place, tokens in domain.items()
                if place != cell and (kept := tokens & keep)
            }
            if not left:
                return None
            later.append(left)
        contents = {**node.contents, cell: shown}
        contents.pop(state.cells[self.tokens[token]], None)
        return _Node(node.step + 1, tuple(later), contents)

    def _domain(self, state: State, contents: Mapping[Cell, int], step: int) -> Domain:
        """For each empty goal cell, the tokens that may go there at `step` for all we know now."""
        fitting = -1
        filled = [cell for cell in self._goal_cells if cell in contents]
        for cell in filled if self._relevant(step) else ():
            fitting &= self._fits(step, cell, contents[cell])
        domain: Domain = {}
        actions = self.model.by_step.get(step, {})
        for token, shown in enumerate(self._shown):
            if fitting >> token & 1 and shown in actions:
                origin = state.cells[self.tokens[token]]
                for cell in self._destinations(actions[shown], origin):
                    if cell not in contents:
                        domain[cell] = domain.get(cell, 0) | 1 << token
        return domain

    def _destinations(self, precondition: int, origin: Cell) -> tuple[Cell, ...]:
        """The goal cells to which a token may go from `origin`, by the cells alone."""
        demanded = precondition & ((1 << self.vocabulary.placed_size) - 1)
        key = (demanded, origin)
        if key not in self._reach:
            placed = self.vocabulary.placed
            self._reach[key] = tuple(
                cell for cell in self._goal_cells if not demanded & ~placed(origin, cell)
            )
        return self._reach[key]

    @cached_property
    def _reach(self) -> dict[tuple[int, Cell], tuple[Cell, ...]]:
        return {}

    def _exact(self, node: _Node) -> Tokens:
        """The tokens whose precondition likes everything that lies on the cells now."""
        tokens = -1
        for cell in self._relevant(node.step):
            shown = node.contents.get(cell)
            if shown is None:
                tokens &= self._demands(node.step, cell).get(0, 0)
            else:
                tokens &= self._fits(node.step, cell, shown)
        return tokens

    def _relevant(self, step: int) -> tuple[Cell, ...]:
        """The cells at whose content some precondition of `step` looks."""
        if step not in self._looked_at:
            self._looked_at[step] = tuple(
                cell for cell in self.vocabulary.watched if self._demands(step, cell).keys() - {0}
            )
        return self._looked_at[step]

    @cached_property
    def _looked_at(self) -> dict[int, tuple[Cell, ...]]:
        return {}

    def _demands(self, step: int, cell: Cell) -> Mapping[int, Tokens]:
        """What preconditions of `step` demand of the content of `cell`, and whose they are."""
        key = (step, cell)
        if key not in self._groups:
            vocabulary = self.vocabulary
            block, offset = (1 << vocabulary.block_size) - 1, vocabulary.offsets[cell]
            groups: dict[int, Tokens] = {}
            actions = self.model.by_step.get(step, {})
            for token, shown in enumerate(self._shown):
                if shown in actions:
                    demand = actions[shown] >> offset & block
                    groups[demand] = groups.get(demand, 0) | 1 << token
            self._groups[key] = groups
        return self._groups[key]

    def _fits(self, step: int, cell: Cell, shown: int) -> Tokens:
        """The tokens with an action at `step` that likes `shown` to lie on `cell`."""
        key = (step, cell, shown)
        if key not in self._fitting:
            self._fitting[key] = sum(
                whose & self._likers(demand, shown)
                for demand, whose in self._demands(step, cell).items()
            )
        return self._fitting[key]

    def _likers(self, demand: int, shown: int) -> Tokens:
        """The tokens for whose move a cell with `shown` on it meets `demand`."""
        key = (demand, shown)
        if key not in self._liked:
            patterns = self.vocabulary.patterns
            self._liked[key] = sum(
                1 << token
                for token, moved in enumerate(self._shown)
                if not demand & ~patterns(moved)[shown]
            )
        return self._liked[key]

    def _order(self, step: int, cell: Cell) -> tuple[int, ...]:
        """The tokens, first those that, lying on `cell`, leave most to the later steps."""
        key = (step, cell)
        if key not in self._orders:
            later = range(step + 1, max(self.lengths) + 1)
            room = [
                -sum(self._fits(after, cell, shown).bit_count() for after in later)
                for shown in self._shown
            ]
            self._orders[key] = tuple(sorted(range(len(self.tokens)), key=room.__getitem__))
        return self._orders[key]

    def _consistent(self, node: _Node) -> bool:
        """Remove, in place, every token without support in another step; False if none is left."""
        changed = True
        while changed:
            changed = False
            for index, domain in enumerate(node.domains):
                for cell, tokens in list(domain.items()):
                    left = self._supported(node, index, cell, tokens)
                    if left != tokens:
                        changed = True
                        domain[cell] = left
                        if not left:
                            del domain[cell]
                if not domain:
                    return False
        return True

    def _supported(self, node: _Node, index: int, cell: Cell, tokens: Tokens) -> Tokens:
        """Those of `tokens` that may go to `cell` at this step for all the other steps know."""
        step = node.step + index
        left = tokens
        for place in self._relevant(step):
            if place in node.contents or place not in self._goal_cells:
                continue
            supply = 0
            for domain in node.domains[:index]:
                supply |= domain.get(place, 0)
            left &= self._demands(step, place).get(0, 0) | self._liking_any(step, place, supply)
        for token in positions(left):
            shown = self._shown[token]
            for later, domain in enumerate(node.domains[index + 1 :], start=step + 1):
                keep = self._fits(later, cell, shown) & ~(1 << token)
                if not any(keep & rest for place, rest in domain.items() if place != cell):
                    left ^= 1 << token
                    break
        return left

    def _liking_any(self, step: int, cell: Cell, supply: Tokens) -> Tokens:
        """The tokens with an action at `step` that likes one of `supply` to lie on `cell`."""
        liking = 0
        for token in positions(supply):
            liking |= self._fits(step, cell, self._shown[token]) & ~(1 << token)
        return liking


def search_states(
    model: ActionModel, lengths: frozenset[int], contents: Mapping[Cell, int], made: int
) -> Prospect:
    """Whether the play can be completed, state by state: the slow, obvious search.

    Args:
        model: the actions.
        lengths: after how many moves a play may end.
        contents: what lies on each cell, as indices into the vocabulary's `shown`.
        made: how many moves have been made.
    """
    budget = iter(range(STATE_NODES))
    barren: set[tuple[int, frozenset[tuple[Cell, int]]]] = set()

    def ends(contents: Mapping[Cell, int], made: int) -> bool:
        if made in lengths:
            return True
        key = (made, frozenset(contents.items()))
        if key in barren:
            return False
        if next(budget, None) is None:
            raise _LostError
        for origin, destination in model.applicable(made + 1, contents):
            after = {**contents, destination: contents[origin]}
            del after[origin]
            if ends(after, made + 1):
                return True
        barren.add(key)
        return False

    try:
        return Prospect.POSSIBLE if ends(contents, made) else Prospect.IMPOSSIBLE
    except _LostError:
        return Prospect.UNDECIDED

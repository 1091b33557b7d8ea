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
from typing import TYPE_CHECKING, Final

from maestra.rules.strips.demands import Demands
from maestra.rules.strips.vocabulary import positions

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from maestra.core.board import Cell
    from maestra.core.state import State
    from maestra.core.tokens import Deck
    from maestra.rules.strips.actions import ActionModel
    from maestra.rules.strips.demands import Domain, Place, Tokens

QUICK_NODES: Final = 200
"""Choices before the quick search gives way: a completion of 20 steps takes 20."""
CAREFUL_NODES: Final = 2_000
"""Choices before the careful search gives up: some seconds on the largest boards."""
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
    contents: Mapping[Place, int]
    """What lies on the cells, as indices into the vocabulary's `shown`."""


class _LostError(Exception):
    """More choices than allowed."""


class Completion:
    """Finds out, for plays with one deck, whether a model lets them be completed."""

    def __init__(self, model: ActionModel, lengths: frozenset[int], deck: Deck) -> None:
        """Prepare for plays with `deck`, which end after one of `lengths` moves.

        Raises:
            InvalidError: a token of the deck shows what the model does not know.
        """
        self._model = model
        self._lengths = lengths
        self._demands = Demands(model, deck, max(lengths, default=0))
        self._tokens = tuple(token.id for token in deck.tokens)
        self._shown_by = dict(zip(self._tokens, self._demands.shown, strict=True))

    def prospect(self, state: State, made: int) -> Prospect:
        """Whether the play can be completed from `state`, after `made` moves."""
        if made in self._lengths:
            return Prospect.POSSIBLE
        if not self._demands.one_way:
            contents = {cell: self._shown_by[token] for token, cell in state.cells.items()}
            return search_states(self._model, self._lengths, contents, made)
        columns = state.board.columns
        cells = [state.cells[token] for token in self._tokens]
        lying = [(cell.row - 1) * columns + cell.column - 1 for cell in cells]
        ends = [length for length in sorted(self._lengths) if length > made]
        found = [self._search(lying, made, length) for length in ends]
        if Prospect.POSSIBLE in found:
            return Prospect.POSSIBLE
        return Prospect.UNDECIDED if Prospect.UNDECIDED in found else Prospect.IMPOSSIBLE

    def _search(self, lying: Sequence[Place], made: int, length: int) -> Prospect:
        """Whether a play of `length` moves can be completed; `lying` says where each token is."""
        contents = dict(zip(lying, self._demands.shown, strict=True))
        domains = self._domains(lying, contents, made, length)
        if not all(domains):
            return Prospect.IMPOSSIBLE
        root = _Node(made + 1, domains, contents)
        for nodes, careful in ((QUICK_NODES, False), (CAREFUL_NODES, True)):
            budget = iter(range(nodes))
            try:
                done = self._completes(root, lying, budget, careful=careful)
            except _LostError:
                continue
            return Prospect.POSSIBLE if done else Prospect.IMPOSSIBLE
        return Prospect.UNDECIDED

    def _domains(
        self, lying: Sequence[Place], contents: Mapping[Place, int], made: int, length: int
    ) -> tuple[Domain, ...]:
        """For each step to come, who may go to which empty goal cell for all we know now."""
        demands = self._demands
        goal = frozenset(demands.goal)
        stored = sum(1 << token for token, place in enumerate(lying) if place not in goal)
        fitting = [stored] * (length - made)
        for place in demands.goal:
            if place in contents:
                liking = demands.fitting(place, contents[place])[made + 1 : length + 1]
                fitting = [tokens & likers for tokens, likers in zip(fitting, liking, strict=True)]
        steps = range(made + 1, length + 1)
        return tuple(
            self._domain(lying, contents, tokens, step)
            for step, tokens in zip(steps, fitting, strict=True)
        )

    def _domain(
        self, lying: Sequence[Place], contents: Mapping[Place, int], fitting: Tokens, step: int
    ) -> Domain:
        """For each empty goal cell, those of `fitting` that may go there by the move's cells."""
        demands = self._demands
        reach = demands.reach(step)
        domain = {
            place: left
            for place, tokens in reach.from_anywhere.items()
            if place not in contents and (left := tokens & fitting)
        }
        for token, demanded, places in reach.by_origin:
            if fitting >> token & 1:
                for place in places:
                    if place not in contents and demands.meets(demanded, lying[token], place):
                        domain[place] = domain.get(place, 0) | 1 << token
        return domain

    def _completes(
        self, node: _Node, lying: Sequence[Place], budget: Iterator[int], *, careful: bool
    ) -> bool:
        """Whether some choice of tokens and cells completes the play from `node`."""
        if not node.domains:
            return True
        if careful and not self._consistent(node):
            return False
        exact = self._exact(node)
        for place, tokens in node.domains[0].items():
            candidates = tokens & exact
            for token in self._demands.order(node.step, place) if candidates else ():
                if not candidates >> token & 1:
                    continue
                if next(budget, None) is None:
                    raise _LostError
                after = self._after(node, token, lying[token], place)
                if after is not None and self._completes(after, lying, budget, careful=careful):
                    return True
        return False

    def _exact(self, node: _Node) -> Tokens:
        """The tokens whose precondition likes everything that lies on the cells now."""
        tokens = -1
        for place in self._demands.relevant(node.step):
            shown = node.contents.get(place)
            if shown is None:
                tokens &= self._demands.indifferent(node.step, place)
            else:
                tokens &= self._demands.fitting(place, shown)[node.step]
        return tokens

    def _after(self, node: _Node, token: int, origin: Place, place: Place) -> _Node | None:
        """The node after this choice; None when a later step is left without any."""
        shown = self._demands.shown[token]
        others = ~(1 << token)
        fitting = self._demands.fitting(place, shown)
        later: list[Domain] = []
        for step, domain in enumerate(node.domains[1:], start=node.step + 1):
            keep = others & fitting[step]
            left = {
                goal: kept
                for goal, tokens in domain.items()
                if goal != place and (kept := tokens & keep)
            }
            if not left:
                return None
            later.append(left)
        contents = {**node.contents, place: shown}
        del contents[origin]
        return _Node(node.step + 1, tuple(later), contents)

    def _consistent(self, node: _Node) -> bool:
        """Remove, in place, every token without support in another step; False if none is left."""
        changed = True
        while changed:
            changed = False
            for index, domain in enumerate(node.domains):
                for place, tokens in list(domain.items()):
                    left = self._supported(node, index, place, tokens)
                    changed = changed or left != tokens
                    if left:
                        domain[place] = left
                    else:
                        del domain[place]
                if not domain:
                    return False
        return True

    def _supported(self, node: _Node, index: int, place: Place, tokens: Tokens) -> Tokens:
        """Those of `tokens` that may go to `place` at this step for all the other steps know."""
        demands, step = self._demands, node.step + index
        left = tokens
        for empty in demands.relevant(step):
            if empty in demands.goal and empty not in node.contents:
                supply = 0
                for domain in node.domains[:index]:
                    supply |= domain.get(empty, 0)
                left &= demands.indifferent(step, empty) | self._liking(step, empty, supply)
        for token in positions(left):
            fitting = demands.fitting(place, demands.shown[token])
            for later, domain in enumerate(node.domains[index + 1 :], start=step + 1):
                keep = fitting[later] & ~(1 << token)
                if not any(keep & rest for goal, rest in domain.items() if goal != place):
                    left ^= 1 << token
                    break
        return left

    def _liking(self, step: int, place: Place, supply: Tokens) -> Tokens:
        """The tokens with an action at `step` that likes one of `supply` to lie on `place`."""
        liking = 0
        for token in positions(supply):
            fitting = self._demands.fitting(place, self._demands.shown[token])
            liking |= fitting[step] & ~(1 << token)
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

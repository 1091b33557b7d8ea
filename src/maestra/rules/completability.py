"""Whether a play can still be completed under all rules of an exercise, and what it allows.

A depth-first search over moves. Before each choice, every rule must be possible for itself, the
tokens that can still come to each slot are worked out from the rules about slots and pairs
(`domains`), and tokens that no rule tells apart are tried once. A quick search looks no further
than the slots that are filled; where it gets lost a careful one also makes the open slots arc
consistent before each choice. What was refuted once is remembered by what the future depends on:
so sums and counts beside an order cost a table, not a tree.

Every completion that is found is checked against the plain meaning of the rules. See
docs/decisions for the measurement against a general solver.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Final, TypeAlias, assert_never

from maestra.rules.domains import Domains, View, can_match, view_of
from maestra.rules.forms.base import EachSlot, Pairwise
from maestra.rules.forms.counting import CompareCounts, Count, Total, total_of
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.selection import AllOfThem
from maestra.rules.forms.sources import TakeExtreme
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.looks import kinds_of_tokens, lines_of
from maestra.rules.pairs import Related
from maestra.rules.rule import Rule, broken_rules
from maestra.rules.setting import Index, Line, Mask, Play, Setting, bits
from maestra.rules.token_tests import Comparison, passing

QUICK_CHOICES: Final = 100
"""Before the quick search gives way: a completion of 20 moves takes 20."""
CAREFUL_CHOICES: Final = 3_000
"""Before the careful search gives up: some seconds on the largest boards."""


@dataclass(frozen=True, slots=True)
class Completable:
    """The play can be completed, for example so."""

    example: Play


@dataclass(frozen=True, slots=True)
class DeadEnd:
    """No way to go on ends right."""


@dataclass(frozen=True, slots=True)
class Undecided:
    """The search was given up after `choices`."""

    choices: int


Outlook: TypeAlias = Completable | DeadEnd | Undecided


@dataclass(frozen=True, slots=True)
class MoveAllowed:
    """The move keeps all rules and the exercise can still be completed."""


@dataclass(frozen=True, slots=True)
class MoveRefused:
    """The move breaks `broken`; if none, it leads to a dead end that the rules make together."""

    broken: tuple[Rule, ...]


@dataclass(frozen=True, slots=True)
class MoveUndecided:
    """The move breaks no rule for itself, but whether it leads anywhere was not found out."""


MoveVerdict: TypeAlias = MoveAllowed | MoveRefused | MoveUndecided


class _LostError(Exception):
    """The search has used up its choices."""


@dataclass(frozen=True)
class Conjunction:
    """All rules of an exercise, from one start; keeps what it works out about them."""

    rules: tuple[Rule, ...]
    setting: Setting
    careful_choices: int = CAREFUL_CHOICES

    def may_end(self, play: Play) -> bool:
        """Whether the exercise may end here."""
        return all(rule.holds(play) for rule in self.rules)

    def outlook(self, play: Play) -> Outlook:
        """Whether `play` can be completed."""
        if broken_rules(self.rules, play):
            return DeadEnd()
        try:
            try:
                found = Search(self, QUICK_CHOICES, careful=False).complete(play)
            except _LostError:
                found = Search(self, self.careful_choices, careful=True).complete(play)
        except _LostError:
            return Undecided(self.careful_choices)
        return DeadEnd() if found is None else Completable(found)

    def judge(self, play: Play, token: Index, cell: Index) -> MoveVerdict:
        """Say whether it is right to place `token`, which is left, on `cell`, which is free."""
        after = play.after(token, cell)
        if broken := broken_rules(self.rules, after):
            return MoveRefused(broken)
        outlook = self.outlook(after)
        match outlook:
            case Completable():
                return MoveAllowed()
            case DeadEnd():
                return MoveRefused(())
            case Undecided():
                return MoveUndecided()
            case _:
                assert_never(outlook)

    def allowed_moves(
        self, play: Play, *, undecided: bool = False
    ) -> tuple[tuple[Index, Index], ...]:
        """Every token and goal cell that `judge` allows now, by cell and token.

        A completion that is found shows more than one of them at once: where nothing looks at
        the order in time, each of its moves could have been the next.

        Args:
            play: the moves so far.
            undecided: whether to list also what `judge` did not find out about.
        """
        known: dict[tuple[Index, Index], bool] = {}
        for cell in play.free:
            for token in bits(play.left):
                if (token, cell) not in known:
                    outlook = self.outlook(play.after(token, cell))
                    known[token, cell] = isinstance(outlook, Completable) or (
                        undecided and isinstance(outlook, Undecided)
                    )
                    if isinstance(outlook, Completable) and not self.timed and not self.filling:
                        for move in outlook.example.placed[len(play.placed) :]:
                            known[move] = True
        return tuple(sorted((m for m in known if known[m]), key=lambda move: move[::-1]))

    @cached_property
    def filling(self) -> FillOrder | None:
        """The rule that says which cell is next, if there is one."""
        return next((rule for rule in self.rules if isinstance(rule, FillOrder)), None)

    @cached_property
    def timed(self) -> bool:
        """Whether another rule looks at the order in time."""
        return any(
            Line.TIME in lines_of(rule) and not isinstance(rule, FillOrder) for rule in self.rules
        )

    @cached_property
    def on_row(self) -> bool:
        """Whether a rule looks at the cells of the row."""
        return any(Line.ROW in lines_of(rule) for rule in self.rules)

    @cached_property
    def kinds(self) -> tuple[Mask, ...]:
        """For each token those that no rule tells from it."""
        return kinds_of_tokens(self.rules, self.setting)

    @cached_property
    def models(self) -> Mask:
        """One token of each kind."""
        return sum(1 << k for k, kind in enumerate(self.kinds) if kind & -kind == 1 << k)

    @cached_property
    def others(self) -> tuple[Rule, ...]:
        """The rules that say more than domains do."""
        return tuple(rule for rule in self.rules if not isinstance(rule, EachSlot | Pairwise))

    @cached_property
    def takes(self) -> tuple[TakeExtreme, ...]:
        """The rules that say which token is next."""
        return tuple(rule for rule in self.rules if isinstance(rule, TakeExtreme))

    @cached_property
    def sequence(self) -> tuple[Index, ...] | None:
        """The cells in the order in which they will be filled, if only one is possible."""
        if self.filling is None or self.filling.filling not in (
            Filling.LEFT_TO_RIGHT,
            Filling.RIGHT_TO_LEFT,
        ):
            return None
        keys = self.filling.keys(self.setting.length)
        free = [k for k, token in enumerate(self.setting.given) if token is None]
        return tuple(sorted(free, key=keys.__getitem__))

    @cached_property
    def row_view(self) -> View:
        """The slots of the row; with what is said of time, if each cell has its time."""
        places: dict[Line, Sequence[Index]] = {Line.ROW: range(self.setting.length)}
        if self.sequence is not None:
            places[Line.TIME] = self.sequence
        return view_of(self.rules, self.setting, places)

    @cached_property
    def time_view(self) -> View | None:
        """The slots of time, where they are not also those of the row."""
        if self.sequence is not None or not self.timed:
            return None
        return view_of(self.rules, self.setting, {Line.TIME: range(self.setting.length)})

    def still_needed(self, play: Play) -> int:
        """How many more tokens must come at least."""
        return max((self._needed(rule, play) for rule in self.rules), default=0)

    def _needed(self, rule: Rule, play: Play) -> int:
        match rule:
            case FullRow():
                return len(play.free)
            case AllOfThem(test):
                return (play.left & passing(self.setting, test)).bit_count()
            case Count(_, Comparison.EQUAL | Comparison.AT_LEAST, number):
                return number - rule.amount(play)
            case _:
                return 0


@dataclass(slots=True)
class Search:
    """One search; counts its choices and remembers what it refuted."""

    all: Conjunction
    choices: int
    careful: bool
    refuted: set[Hashable] = field(default_factory=set[Hashable])

    def complete(self, play: Play, closed: frozenset[Index] = frozenset()) -> Play | None:
        """A right play that goes on from `play` and leaves `closed` cells empty."""
        self.choices -= 1
        if self.choices < 0:
            raise _LostError
        needed = self.all.still_needed(play)
        if needed <= 0 and self.all.may_end(play):
            return play
        if needed > min(len(play.free) - len(closed), play.room) or not play.room:
            return None
        ahead = self._ahead(play, closed, max(needed, 1))
        if ahead is None:
            return None
        key = self._key(play, closed, *ahead)
        if key in self.refuted:
            return None
        for token, cell in self._choices(play, *ahead):
            found = (
                self.complete(play, closed | {cell})
                if token is None
                else self.complete(play.after(token, cell), closed)
            )
            if found is not None:
                return found
        self.refuted.add(key)
        return None

    def _ahead(
        self, play: Play, closed: frozenset[Index], needed: int
    ) -> tuple[Domains, Domains] | None:
        """What can still come to each open cell and to each time; None if it is refuted."""
        cells = self._open_cells(play, closed)
        required = cells[:needed] if self.all.sequence is not None else cells
        must_fill = self.all.sequence is not None or needed == len(cells)
        row = self.all.row_view.domains(play.row, play.left)
        row = {cell: row[cell] for cell in cells}
        if not self._narrow(self.all.row_view, row, required if must_fill else ()):
            return None
        time: Domains = {}
        usable = _union(row)
        if self.all.time_view is not None:
            slots = play.slots(Line.TIME)
            time = self.all.time_view.domains(slots, play.left & usable)
            first = len(play.placed)
            if not self._narrow(self.all.time_view, time, range(first, first + needed)):
                return None
            usable &= _union(time)
            row = {cell: domain & usable for cell, domain in row.items()}
        return (row, time) if self._is_hopeful(play, usable, needed) else None

    def _open_cells(self, play: Play, closed: frozenset[Index]) -> tuple[Index, ...]:
        if self.all.sequence is not None:
            return tuple(cell for cell in self.all.sequence if play.row[cell] is None)
        return tuple(cell for cell in play.free if cell not in closed)

    def _narrow(self, view: View, domains: Domains, required: Sequence[Index]) -> bool:
        if self.careful and not (view.narrow(domains, required) and can_match(domains, required)):
            return False
        return all(domains[slot] for slot in required)

    def _is_hopeful(self, play: Play, usable: Mask, needed: int) -> bool:
        """Whether each rule that says more is possible with the tokens that can be used."""
        reduced = replace(play, left=usable)
        if reduced.room < needed:
            return False
        return all(
            not play.left & ~usable & passing(play.setting, rule.test)
            if isinstance(rule, AllOfThem)
            else rule.possible_with(reduced, needed)
            for rule in self.all.others
        )

    def _choices(
        self, play: Play, row: Domains, time: Domains
    ) -> Iterator[tuple[Index | None, Index]]:
        """Tokens and cells to try next, the most promising first; no token closes the cell."""
        tokens = time.get(len(play.placed), play.left)
        for rule in self.all.takes:
            tokens &= rule.next_tokens(play)
        if self.all.filling is not None:
            cells: Sequence[Index] = self.all.filling.next_cells(play)
        elif not self.all.timed:
            cells = (min(row, key=lambda cell: row[cell].bit_count()),)
        else:
            cells = tuple(row) if self.all.on_row else tuple(row)[:1]
        yield from self._in_order(play, {cell: row[cell] & tokens for cell in cells}, row, time)
        if self.all.filling is None and not self.all.timed:
            yield None, cells[0]

    def _in_order(
        self, play: Play, choices: Domains, row: Domains, time: Domains
    ) -> list[tuple[Index, Index]]:
        """One token of each kind for each cell, those first that leave most to the others."""
        ordered: list[tuple[int, Index, Index]] = []
        later = _linked(self.all.time_view, len(play.placed), time)
        for cell, tokens in choices.items():
            linked = [*later, *_linked(self.all.row_view, cell, row)]
            todo = tokens
            while todo:
                token = (todo & -todo).bit_length() - 1
                todo &= ~self.all.kinds[token]
                left = sum((domain & masks[token]).bit_count() for domain, masks in linked)
                ordered.append((-left, token, cell))
        return [(token, cell) for _, token, cell in sorted(ordered)]

    def _key(self, play: Play, closed: frozenset[Index], row: Domains, time: Domains) -> Hashable:
        """What the future depends on."""
        left = play.left
        counts = tuple((left & self.all.kinds[k]).bit_count() for k in bits(self.all.models))
        return (
            len(play.placed),
            closed,
            counts,
            tuple(self._kinds_in(domain) for domain in row.values()),
            tuple(row),
            tuple(self._kinds_in(domain) for domain in time.values()),
            tuple(_past(rule, play) for rule in self.all.others),
        )

    def _kinds_in(self, tokens: Mask) -> Mask:
        """The tokens, each standing for its kind by the kind's first one."""
        kinds, found = self.all.kinds, 0
        while tokens:
            kind = kinds[(tokens & -tokens).bit_length() - 1]
            found |= kind & -kind
            tokens &= ~kind
        return found


def _linked(view: View | None, slot: Index, domains: Domains) -> list[tuple[Mask, Related]]:
    """The open slots linked to `slot`, each with what it can have and what a token here leaves."""
    if view is None:
        return []
    return [(domains[other], masks) for other, masks in view.links[slot] if other in domains]


def _union(domains: Domains) -> Mask:
    tokens = 0
    for domain in domains.values():
        tokens |= domain
    return tokens


def _past(rule: Rule, play: Play) -> Hashable:
    """What of the past the future of `rule` depends on, besides the tokens left."""
    match rule:
        case Count() | CompareCounts():
            return rule.amount(play)
        case Total(attribute) | UntilTotal(attribute):
            return total_of(play, attribute)
        case AllOfThem() | FullRow() | FillOrder():
            return None
        case _:
            return play.placed

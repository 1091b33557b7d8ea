"""The few-shot learner: from demonstrations and answers to a lesson.

The plays fix the contexts (from which start, in which order), the proposals that hold of them
are evaluated there, the search finds the conjunctions that explain them, and people's habits are
weighed in. What was worked out about rows of tokens is kept from one call to the next.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import log2
from typing import Final, assert_never

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.core.state import State
from maestra.core.tokens import TokenId
from maestra.learning.fewshot.filling import fillings
from maestra.learning.fewshot.lesson import Belief, Class, Hypothesis, Lesson, Slip
from maestra.learning.fewshot.posterior import Answered, Evidence, Found, Numbers, Search, Truths
from maestra.learning.fewshot.prior import (
    LAZY,
    LEARNED_AT,
    NEAREST,
    OUTSIDE_BITS,
    OUTSIDE_YES,
    REPEATS,
    TRUST,
)
from maestra.learning.fewshot.proposals import Survivor, surviving
from maestra.learning.fewshot.sampled import sampled
from maestra.learning.fewshot.slips import wrong_move
from maestra.learning.fewshot.space import (
    MAX_ROWS,
    Context,
    Order,
    Rows,
    Words,
    follows,
    how_many,
    pack,
    row_number,
    rows_of,
    size_of,
)
from maestra.rules.answers import (
    Answer,
    MoveQuestion,
    Question,
    Reply,
    RowQuestion,
    RuleQuestion,
)
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.plays import NOBODY, Tokens, Truth
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play, Setting, play_of

PLAUSIBLE: Final = 0.001
"""Weight from which a hypothesis counts for the safe bound."""


def learn(
    demonstrations: Sequence[Demonstration],
    answers: Sequence[Answer] = (),
    seed: int = 0,
    *,
    confirmed: Collection[Index] = (),
) -> Lesson:
    """The lesson of at least one demonstration, all on boards with as many goal cells.

    Args:
        demonstrations: what was shown.
        answers: what was said to questions.
        seed: of the sample that stands for the rows where they are too many to list.
        confirmed: demonstrations, from 0, that are no slips for certain.

    Raises:
        ValueError: no demonstration.
        InvalidError: a move that is not from a storage cell to a goal cell.
    """
    if not demonstrations:
        raise ValueError("no demonstration")
    return _Lecture(tuple(demonstrations), tuple(answers), seed, frozenset(confirmed)).lesson()


@dataclass(frozen=True)
class _Lecture:
    """One run of the learner; keeps what its steps share."""

    demonstrations: tuple[Demonstration, ...]
    answers: tuple[Answer, ...]
    seed: int
    confirmed: frozenset[Index]

    @cached_property
    def plays(self) -> tuple[Play, ...]:
        settings: list[Setting] = []
        plays: list[Play] = []
        for shown in self.demonstrations:
            setting = Setting(shown.deck, shown.start)
            known = next((s for s in settings if s == setting), None)
            if known is None:
                settings.append(known := setting)
            plays.append(play_of(shown, known))
        return tuple(plays)

    @cached_property
    def distinct(self) -> tuple[int, ...]:
        """The plays that show a row for the first time: equal rows count once."""
        seen: dict[tuple[TokenId | None, ...], int] = {}
        for k, play in enumerate(self.plays):
            ids = [token.id for token in play.setting.deck.tokens]
            row = tuple(None if token is None else ids[token] for token in play.row)
            seen.setdefault(row, k)
        return tuple(seen.values())

    @cached_property
    def full(self) -> bool:
        return all(not play.free for play in self.plays)

    @cached_property
    def timed(self) -> bool:
        """Whether somebody did not simply fill from the left: else time tells nothing new."""
        usual = [_order(play) == tuple(range(play.setting.length)) for play in self.plays]
        return not all(usual)

    def _context(self, play: Play) -> Context:
        # With gaps the order of placement says which cells stay free.
        usual = tuple(range(play.setting.length))
        order = _order(play) if self.timed or not self.full else usual
        return Context(play.setting, order, self._rows(play.setting, order))

    def _rows(self, setting: Setting, order: Order) -> Rows:
        """All rows from a start, or some that stand for all."""
        if how_many(setting, full=self.full) <= MAX_ROWS:
            return rows_of(setting, order, full=self.full)
        key = next((known for known in self._sampled if known == setting), setting)
        if key not in self._sampled:
            fixed = [_array(play) for play in self.plays if play.setting == setting]
            for answer in self.answers:
                position = _position(answer.question)
                if position is not None and position.setting == setting and not position.free:
                    fixed.append(_array(position))
            fixed = fixed or [_array(self.plays[0])]
            self._sampled[key] = sampled(
                setting, self._likely, fixed, full=self.full, seed=self.seed
            )
        return self._sampled[key]

    @cached_property
    def _sampled(self) -> dict[Setting, Rows]:
        return {}

    @cached_property
    def _survivors(self) -> list[Survivor]:
        first = [self.plays[k] for k in self.distinct]
        again = [play for k, play in enumerate(self.plays) if k not in self.distinct]
        found = surviving([*first, *again], timed=self.timed, slips=int(len(first) > 1))
        # A row that is shown again, from another start, is no slip.
        sure = {1 << k for k, number in enumerate(self.distinct) if number in self.confirmed}
        return [one for one in found if one.broken < 1 << len(first) and one.broken not in sure]

    @cached_property
    def _likely(self) -> list[Rule]:
        """The rules that hold of all plays, the shortest first."""
        whole = [one for one in self._survivors if not one.broken]
        return [rule for one in sorted(whole, key=lambda one: one.bits) for rule in one.rules]

    @cached_property
    def _contexts_and_layouts(self) -> tuple[tuple[Context, ...], list[Evidence], list[Answered]]:
        contexts: list[Context] = []
        known: dict[tuple[int, Order], int] = {}

        def number(context: Context) -> int:
            key = (id(context.setting), context.order)
            if key not in known:
                known[key] = len(contexts)
                contexts.append(context)
            return known[key]

        layouts: list[Evidence] = []
        for k in self.distinct:
            play = self.plays[k]
            c = number(self._context(play))
            rows = contexts[c].rows
            near = _near(rows, play)
            layouts.append(
                Evidence(c, _one_row(rows, play), pack(near), max(1.0, float(near.sum())))
            )
        answered: list[Answered] = []
        for answer in self.answers:
            position = _position(answer.question)
            if position is None or answer.reply is Reply.UNSURE:
                continue
            setting = next(
                (c.setting for c in contexts if c.setting == position.setting), position.setting
            )
            usual = tuple(range(setting.length))
            order = _order(position) if self.timed or not self.full else usual
            c = number(Context(setting, order, self._rows(setting, order)))
            whole = isinstance(answer.question, RowQuestion)
            asked = _matching(contexts[c].rows, position, whole=whole)
            yes = answer.reply is Reply.YES
            if answer.wrong is None:
                answered.append(Answered(c, asked, yes))
            else:
                mended = tuple(map(pack, _mended(contexts[c].rows, position)))
                answered.append(Answered(c, asked, yes, mended, answer.wrong))
        other = elsewhere(self.plays[0].setting)
        # Placed the other way round, so that what is meant in time differs from the row.
        back = contexts[0].order[::-1]
        number(Context(other, back, self._rows(other, back)))
        return tuple(contexts), layouts, answered

    def lesson(self) -> Lesson:
        contexts, layouts, answered = self._contexts_and_layouts
        truths = Truths(tuple(self._survivors), contexts)
        search = Search(truths, tuple(layouts), tuple(answered))
        meant = tuple(
            (a.question.rule, a.reply is Reply.YES)
            for a in self.answers
            if isinstance(a.question, RuleQuestion)
            and not isinstance(a.question.rule, FillOrder)
            and a.reply is not Reply.UNSURE
        )
        classes = self._classes(search, search.best(), meant)
        scores = np.array([one.bits for one in classes])
        nothing = self._of_nothing(search, meant)
        weights = np.exp2(-(scores - min([nothing, *scores])))
        unknown = float(np.exp2(-(nothing - min([nothing, *scores]))))
        total = weights.sum() + unknown
        order = sorted(range(len(classes)), key=lambda k: -float(weights[k]))
        belief = Belief(
            self.plays,
            contexts,
            truths,
            tuple(classes[k] for k in order),
            tuple(float(weights[k] / total) for k in order),
            fillings(self.plays, self.answers),
            unknown / total,
            self.full,
        )
        return self._told(belief)

    def _classes(
        self, search: Search, found: list[Found], meant: Sequence[tuple[Rule, bool]]
    ) -> list[Class]:
        """Hypotheses of equal truth made one, with people's habits weighed in."""
        truths = search.truths
        contexts = truths.contexts
        weights = self._nearness(search)
        merged: dict[tuple[bytes, int | None], Class] = {}
        for one in found:
            words = tuple(
                np.bitwise_and.reduce(
                    [contexts[c].rows.everything, *(truths.of(part, c) for part in one.parts)],
                    axis=0,
                )
                for c in range(len(contexts))
            )
            key = (b"".join(w.tobytes() for w in words), one.slip)
            if key in merged:
                old = merged[key]
                both = -float(np.logaddexp2(-old.bits, -one.bits))
                merged[key] = replace(old, bits=both)
            else:
                merged[key] = Class(one.parts, one.bits, one.slip, words)
        return [
            replace(
                one,
                bits=one.bits
                + self._habits(search, one.words, weights)
                + self._meaning(truths, one.words, meant),
            )
            for one in merged.values()
        ]

    def _nearness(self, search: Search) -> dict[tuple[int, float], Numbers]:
        return {
            (c, strength): search.truths.contexts[c].nearness(strength)
            for c in {e.context for e in search.layouts}
            for strength in NEAREST
            if strength
        }

    def _habits(
        self,
        search: Search,
        words: tuple[Words, ...],
        weights: dict[tuple[int, float], Numbers],
    ) -> float:
        """Bits more or less than if all allowed plays were equally likely."""
        contexts = search.truths.contexts
        plain = near = 0.0
        sizes: list[float] = []
        for layout in search.layouts:
            c = layout.context
            sizes.append(max(size_of(words[c], contexts[c].rows), 1.0))
            plain += log2(sizes[-1])
        for (c, _), weight in weights.items():
            inside = np.unpackbits(words[c].view(np.uint8), count=len(weight)).astype(np.bool_)
            mass = max(float(weight[inside].sum()), 1e-300)
            for layout in search.layouts:
                if layout.context == c:
                    at = np.unpackbits(layout.rows.view(np.uint8), count=len(weight)).argmax()
                    near += log2(mass) - log2(float(weight[at]))
        share = NEAREST[0.0]
        habit = -float(np.logaddexp2(log2(share) - plain, log2(1 - share) - near)) - plain
        repeated = len(self.plays) - len(self.distinct)
        if repeated:
            usual = log2(LAZY) + repeated * log2(REPEATS)
            chance = log2(1 - LAZY) - repeated * sum(map(log2, sizes)) / len(sizes)
            habit -= float(np.logaddexp2(usual, chance))
        return habit

    def _meaning(
        self, truths: Truths, words: tuple[Words, ...], meant: Sequence[tuple[Rule, bool]]
    ) -> float:
        """Bits for the answers about rules: a rule is meant when it is one, or follows."""
        total = 0.0
        for rule, yes in meant:
            so = follows(words, [truths.of_rule(rule, c) for c in range(len(words))])
            total -= log2(TRUST if so == yes else 1 - TRUST)
        return total

    def _of_nothing(self, search: Search, meant: Sequence[tuple[Rule, bool]]) -> float:
        """Bits if the exercise is about something that cannot be said."""
        contexts = search.truths.contexts
        everything = tuple(c.rows.everything for c in contexts)
        plain = sum(log2(contexts[e.context].rows.size) for e in search.layouts)
        habit = self._habits(search, everything, self._nearness(search))
        said = [answer.yes for answer in search.answers] + [yes for _, yes in meant]
        heard = sum(log2(OUTSIDE_YES if yes else 1 - OUTSIDE_YES) for yes in said)
        return plain + habit + OUTSIDE_BITS - heard

    def _told(self, belief: Belief) -> Lesson:
        filling, sure = belief.filling[0]
        length: tuple[Rule, ...] = (FullRow(),) if belief.full else ()
        order: tuple[Rule, ...] = () if filling is None else (FillOrder(filling),)
        best = belief.classes[0]
        rules = belief.rules_of(best)
        mass: dict[tuple[bytes, ...], float] = {}
        for one, weight in zip(belief.classes, belief.weights, strict=True):
            key = tuple(w.tobytes() for w in one.words)
            mass[key] = mass.get(key, 0.0) + weight
        confidence = sure * mass[tuple(w.tobytes() for w in best.words)]
        sures = tuple(self._sure(belief, rule) for rule in rules)
        status = LearnStatus.LEARNED if confidence >= LEARNED_AT else LearnStatus.AMBIGUOUS
        if belief.outside > 1 / 2 and len(self.distinct) > 1:
            status = LearnStatus.OUTSIDE
        if _contradict(self.answers):
            status = LearnStatus.CONTRADICTORY
        alternatives = tuple(
            Hypothesis((*length, *belief.rules_of(one), *order), weight * sure)
            for one, weight in zip(belief.classes[1:9], belief.weights[1:9], strict=True)
        )
        return Lesson(
            status,
            (*length, *rules, *order),
            (*([1.0] * len(length)), *sures, *([sure] * len(order))),
            confidence,
            alternatives,
            self._slips(belief),
            (*length, *self._bound(belief), *order),
            self.demonstrations,
            self.answers,
            belief,
        )

    def _sure(self, belief: Belief, rule: Rule) -> float:
        """The weight of the hypotheses from which a rule follows."""
        truth = [belief.truths.of_rule(rule, c) for c in range(len(belief.contexts))]
        return sum(
            weight
            for one, weight in zip(belief.classes, belief.weights, strict=True)
            if follows(one.words, truth)
        )

    def _bound(self, belief: Belief) -> tuple[Rule, ...]:
        """All rules that some plausible hypothesis has, without those that follow from others."""
        used: dict[Rule, None] = {}
        words: list[Words] = [c.rows.everything for c in belief.contexts]
        for one, weight in zip(belief.classes, belief.weights, strict=True):
            if weight < PLAUSIBLE or one.slip != belief.classes[0].slip:
                continue
            for rule in belief.rules_of(one):
                truth = [belief.truths.of_rule(rule, c) for c in range(len(words))]
                if not follows(words, truth):
                    used[rule] = None
                    words = [w & t for w, t in zip(words, truth, strict=True)]
        return tuple(used)

    def _slips(self, belief: Belief) -> tuple[Slip, ...]:
        """Layouts that are likelier a slip than not, and the move that is wrong."""
        found: list[Slip] = []
        for k, number in enumerate(self.distinct):
            mine = [
                (one, weight)
                for one, weight in zip(belief.classes, belief.weights, strict=True)
                if one.slip == k
            ]
            likely = sum(weight for _, weight in mine)
            if likely > 1 / 2:
                rules = belief.rules_of(mine[0][0])
                found.append(Slip(number, wrong_move(rules, self.plays[number]), likely))
        return tuple(found)


def _contradict(answers: Sequence[Answer]) -> bool:
    """Whether a question was answered both ways."""
    said = {reply: {a.question for a in answers if a.reply is reply} for reply in Reply}
    return not said[Reply.YES].isdisjoint(said[Reply.NO])


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


def _order(play: Play) -> Order:
    """The goal cells in the order they were filled, the free ones after them."""
    placed = [cell for _, cell in play.placed]
    return (*placed, *(k for k in range(play.setting.length) if k not in placed))


def _array(play: Play) -> Tokens:
    return np.array([NOBODY if token is None else token for token in play.row], np.int16)


def _one_row(rows: Rows, play: Play) -> Words:
    truth = np.zeros(len(rows.row), np.bool_)
    truth[row_number(rows, play)] = True
    return pack(truth)


def _near(rows: Rows, play: Play) -> Truth:
    """The rows with one token in another's stead, or two in each other's place."""
    row = _array(play)
    alike = rows.row == row
    same = alike.sum(axis=1)
    length = len(row)
    swapped = (same == length - 2) & np.isin(rows.row, row).all(axis=1)
    return np.asarray(((same == length - 1) | swapped) & rows.real)


def _mended(rows: Rows, play: Play) -> list[Truth]:
    """For each goal cell the rows of `_near` that differ there."""
    near, row = _near(rows, play), _array(play)
    return [near & (rows.row[:, cell] != token) for cell, token in enumerate(row)]


def _matching(rows: Rows, position: Play, *, whole: bool) -> Words:
    """The rows that have every token of the position in its place; only its own if `whole`."""
    truth = rows.real.copy()
    for cell, token in enumerate(position.row):
        if token is not None or whole:
            truth &= rows.row[:, cell] == (NOBODY if token is None else token)
    return pack(truth)


def _position(question: Question) -> Play | None:
    match question:
        case RowQuestion(play):
            return play
        case MoveQuestion(position, token, cell):
            return position.after(token, cell)
        case RuleQuestion():
            return None
        case _:
            assert_never(question)

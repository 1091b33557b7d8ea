"""What users of the few-shot learner rely on, whatever is shown."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.evidence import Evidence, elsewhere
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson
from maestra.learning.fewshot.questions import QuestionKind, next_question
from maestra.learning.fewshot.slips import wrong_move
from maestra.rules.answers import (
    Answer,
    MoveQuestion,
    Question,
    Reply,
    RowQuestion,
    RuleQuestion,
)
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import BOARD, LETTER_DECK, NUMBER_DECK, WORD
from maestra.rules.plays import Plays
from maestra.rules.rule import Rule, holds
from maestra.rules.setting import Play, Setting, play_of
from maestra.rules.token_tests import has
from tests.learning.fewshot_plays import (
    DECK,
    SMALL_BOARD,
    answered,
    anywhere,
    demonstrated,
    placed,
    rich,
    row,
    shown,
    start,
)

RISING = Ordered("value", Direction.RISING)
FALLING = Ordered("value", Direction.FALLING)
ODD = EveryToken(has("odd", "value"))
ODD_ROW = (0, 1, 6, 7, 9)
ROWS = ((0, 2, 5, 7, 8), (1, 3, 4, 6, 9), (2, 3, 6, 8, 9), (0, 1, 4, 5, 6))
UP = [shown(tokens, turn) for turn, tokens in enumerate(ROWS)]
MIXED = ((3, 9, 0, 5, 1), (8, 1, 6, 7, 2), (5, 2, 4, 0, 9))
"""In no order."""
SLIPPED = [*UP, shown((1, 2, 4, 6, 5), 5)]
"""Rising numbers; at last two of them have changed places."""

SMALL_DECK = Deck(DECK.tokens[:5])
SMALL_ROWS = st.lists(
    st.tuples(st.sampled_from(list(permutations(range(5), 3))), st.integers(0, 3)),
    min_size=1,
    max_size=3,
)


def small_shown(rows: Sequence[tuple[tuple[int, ...], int]]) -> list[Demonstration]:
    return [shown(tokens, turn, deck=SMALL_DECK, board=SMALL_BOARD) for tokens, turn in rows]


def accepts(rules: Sequence[Rule], play: Play) -> bool:
    return all(holds(rule, play) for rule in rules)


# ------------------------------------------------------------------ laws
@settings(max_examples=8)
@given(SMALL_ROWS)
def test_what_was_shown_is_accepted_unless_it_is_called_a_slip(
    rows: list[tuple[tuple[int, ...], int]],
) -> None:
    demonstrations = small_shown(rows)
    lesson = learn(demonstrations)
    slips = {slip.demonstration for slip in lesson.slips}
    for number, one in enumerate(demonstrations):
        repeats = any(rows[number][0] == rows[slip][0] for slip in slips)
        if lesson.belief.classes[0].slip is None and not repeats:
            assert accepts(lesson.rules, play_of(one))
            assert accepts(lesson.safe, play_of(one))


@pytest.mark.parametrize("order", [(1, 0, 2), (2, 1, 0)])
def test_the_order_of_demonstrations_does_not_matter(order: Sequence[int]) -> None:
    plays = [shown(tokens) for tokens in ROWS[:3]]
    one, other = learn(plays), learn([plays[k] for k in order])
    assert other.status is one.status
    assert other.rules == one.rules
    # Single tokens are proposed as the first play has them: that moves a little weight.
    assert other.confidence == pytest.approx(one.confidence, rel=0.1)


def test_the_same_lesson_comes_of_the_same_evidence() -> None:
    answers = [Answer(RowQuestion(row((1, 2, 3, 4, 5))), Reply.YES)]
    one, other = learn(UP[:2], answers), learn(UP[:2], answers)
    assert one.rules == other.rules
    assert one.alternatives == other.alternatives
    assert one.belief.weights == other.belief.weights


def test_an_equal_row_counts_once() -> None:
    again = [UP[0], UP[1], shown(ROWS[0], 4)]
    evidence = Evidence(tuple(again), (), 0)
    assert evidence.distinct == (0, 1)
    assert len(evidence.layouts) == 2
    assert learn(UP[:1] * 3).status is LearnStatus.AMBIGUOUS


def test_hypotheses_that_allow_the_same_rows_are_one() -> None:
    belief = learn(UP[:2]).belief
    keys = [(b"".join(w.tobytes() for w in one.words), one.slip) for one in belief.classes]
    assert len(set(keys)) == len(keys)
    assert sum(belief.weights) + belief.outside == pytest.approx(1)
    assert list(belief.weights) == sorted(belief.weights, reverse=True)


@settings(max_examples=8)
@given(SMALL_ROWS)
def test_only_rules_that_do_not_follow_from_others_are_told(
    rows: list[tuple[tuple[int, ...], int]],
) -> None:
    lesson = learn(small_shown(rows))
    belief = lesson.belief
    told = belief.rules_of(belief.classes[0])
    for rule in told:
        others = [r for r in told if r != rule]
        if others and len(belief.classes[0].parts) > 1 and rule not in _paired(lesson):
            assert any(
                (_allowed(lesson, others, c) & ~belief.truths.of_rule(rule, c)).any()
                for c in range(len(belief.contexts))
            )


def _paired(lesson: Lesson) -> set[Rule]:
    """Rules that are one proposal together with others."""
    belief = lesson.belief
    proposals = (belief.truths.survivors[part].rules for part in belief.classes[0].parts)
    return {rule for rules in proposals if len(rules) > 1 for rule in rules}


def _allowed(lesson: Lesson, rules: Sequence[Rule], context: int) -> np.ndarray:
    belief = lesson.belief
    words = [belief.contexts[context].rows.everything]
    words += [belief.truths.of_rule(rule, context) for rule in rules]
    return np.asarray(np.bitwise_and.reduce(words))


def test_nothing_shown_is_refused() -> None:
    with pytest.raises(ValueError, match="no demonstration"):
        learn([])


# ------------------------------------------------------------------ what is learned
def test_rising_numbers_are_learned_from_three_plays() -> None:
    lesson = learn(UP[:3])
    assert lesson.rules == (FullRow(), RISING)
    assert lesson.confidences[0] == 1.0
    assert lesson.confidences[1] >= lesson.confidence > 0.5
    assert lesson.slips == ()
    assert lesson.demonstrations == tuple(UP[:3])


def test_odd_and_rising_is_learned_from_one_row_from_three_starts() -> None:
    lesson = learn([shown(ODD_ROW, turn) for turn in (0, 4, 7)])
    assert set(lesson.rules) >= {RISING, ODD}


def test_one_play_leaves_it_ambiguous() -> None:
    lesson = learn(UP[:1])
    assert lesson.status is LearnStatus.AMBIGUOUS
    assert lesson.alternatives
    weights = [one.weight for one in lesson.alternatives]
    assert weights == sorted(weights, reverse=True)


def test_what_no_simple_rule_explains_is_outside() -> None:
    plays = [shown((3, 0, 9, 2, 7)), shown((5, 8, 1, 6, 2), 3)]
    refused = [(8, 1, 0, 3, 2), (4, 9, 2, 5, 0), (6, 3, 7, 1, 8), (2, 9, 4, 0, 7), (1, 7, 0, 9, 3)]
    answers = [Answer(RowQuestion(row(one)), Reply.NO) for one in refused]
    lesson = learn(plays, answers)
    assert lesson.status is LearnStatus.OUTSIDE
    assert lesson.belief.outside > 0.5 > lesson.confidence
    # It falls back on what is right whatever is meant.
    assert all(accepts(lesson.safe, play) for play in lesson.belief.plays)


def test_a_row_with_gaps_need_not_be_full() -> None:
    lesson = learn([shown((2, 4, 5)), shown((5, 2, 4), 3), shown((4, 5, 2), 6)])
    assert FullRow() not in lesson.rules


def test_where_nothing_can_differ_nothing_is_learned() -> None:
    deck = Deck((Token(TokenId("a"), ()),))
    board = type(BOARD)(2, 1)
    lesson = learn([shown((0,), deck=deck, board=board)])
    assert lesson.status is LearnStatus.AMBIGUOUS
    assert next_question(lesson, {QuestionKind.ROW, QuestionKind.MOVE}) is None


def test_a_deck_of_everything_can_be_learned_from() -> None:
    lesson = learn([rich((0, 1, 3), order=(2, 0, 1)), rich((2, 3, 5), 1)])
    assert lesson.belief.classes
    assert all(context.rows.size == 120 for context in lesson.belief.contexts)


# ------------------------------------------------------------------ habits
def test_left_to_right_alone_is_no_rule() -> None:
    lesson = learn(UP[:3])
    assert lesson.belief.filling[0][0] is None
    assert not any(isinstance(rule, FillOrder) for rule in lesson.rules)


def test_right_to_left_is_noticed() -> None:
    back = (4, 3, 2, 1, 0)
    belief = learn([shown(tokens, turn, back) for turn, tokens in enumerate(ROWS[:2])]).belief
    assert dict(belief.filling)[Filling.RIGHT_TO_LEFT] > 0.05
    forth = learn(UP[:2]).belief
    assert dict(forth.filling)[Filling.RIGHT_TO_LEFT] < 0.001


def test_ends_first_becomes_a_rule() -> None:
    orders = ((0, 4, 1, 3, 2), (4, 0, 1, 3, 2))
    lesson = learn([shown(r, k, o) for k, (r, o) in enumerate(zip(ROWS, orders, strict=False))])
    assert FillOrder(Filling.ENDS_FIRST) in lesson.rules
    assert len(lesson.confidences) == len(lesson.rules)


def test_an_exercise_may_ask_for_an_order_of_placement_and_for_nothing_else() -> None:
    orders = ((0, 4, 1, 3, 2), (4, 0, 1, 3, 2), (0, 4, 3, 1, 2))
    lesson = learn([shown(r, k, o) for k, (r, o) in enumerate(zip(MIXED, orders, strict=True))])
    assert lesson.rules == (FullRow(), FillOrder(Filling.ENDS_FIRST))
    # Where any row will do an order must be asked for.
    assert lesson.belief.orders[None] < dict(lesson.belief.filling)[None]


def test_any_row_in_any_order_is_no_exercise() -> None:
    belief = learn([shown(tokens, turn) for turn, tokens in enumerate(MIXED)]).belief
    free = sum(weight for one, weight in belief.weighted if not one.parts)
    assert free < 0.05
    assert sum(belief.orders.values()) == pytest.approx(1.0)


@pytest.mark.parametrize("reply", [Reply.YES, Reply.NO, Reply.UNSURE])
def test_an_answer_about_the_order_of_placement_counts(reply: Reply) -> None:
    back = (4, 3, 2, 1, 0)
    plays = [shown(tokens, turn, back) for turn, tokens in enumerate(ROWS[:2])]
    rule = FillOrder(Filling.RIGHT_TO_LEFT)
    before = dict(learn(plays).belief.filling)[Filling.RIGHT_TO_LEFT]
    after = dict(learn(plays, [Answer(RuleQuestion(rule), reply)]).belief.filling)
    change = after[Filling.RIGHT_TO_LEFT] - before
    assert {Reply.YES: change > 0, Reply.NO: change < 0, Reply.UNSURE: change == 0}[reply]


def test_a_row_that_is_right_in_another_order_needs_no_order() -> None:
    back = (4, 3, 2, 1, 0)
    plays = [shown(tokens, turn, back) for turn, tokens in enumerate(ROWS[:2])]
    right = Answer(RowQuestion(row((1, 2, 3, 4, 5))), Reply.YES)
    before, after = learn(plays).belief, learn(plays, [right]).belief
    assert dict(after.filling)[Filling.RIGHT_TO_LEFT] < dict(before.filling)[Filling.RIGHT_TO_LEFT]


def test_what_lies_near_is_a_habit_before_it_is_a_rule() -> None:
    rng = Random(1)  # noqa: S311 - what is drawn is no secret
    near: list[Demonstration] = []
    for _ in range(2):
        setting = anywhere(NUMBER_DECK, BOARD, rng)
        rows = [setting.start.cells[token.id].row for token in setting.deck.tokens]
        nearest = sorted(range(10), key=rows.__getitem__)[:5]
        near.append(demonstrated(placed(setting, sorted(nearest))))
    lesson = learn(near)
    assert RISING in lesson.rules
    assert lesson.status is not LearnStatus.OUTSIDE


def test_who_shows_the_same_row_again_is_not_taken_for_more_sure_than_a_lazy_one() -> None:
    once, again = learn(UP[:1]), learn(UP[:1] * 3)
    assert again.confidence < 0.95
    assert again.belief.outside <= once.belief.outside + 0.2


# ------------------------------------------------------------------ slips
def test_a_slip_is_pointed_out_with_its_move() -> None:
    lesson = learn(SLIPPED)
    assert RISING in lesson.rules
    assert [slip.demonstration for slip in lesson.slips] == [4]
    assert lesson.slips[0].move in (3, 4)
    assert lesson.slips[0].confidence > 0.5


def test_what_was_confirmed_is_no_slip() -> None:
    lesson = learn(SLIPPED, [Answer(RowQuestion(play_of(SLIPPED[4])), Reply.YES)])
    assert lesson.slips == ()
    assert all(one.slip != 4 for one in lesson.belief.classes)
    assert RISING not in lesson.rules
    assert accepts(lesson.rules, play_of(SLIPPED[4]))


def test_a_row_that_was_shown_again_and_confirmed_is_no_slip() -> None:
    again = [*SLIPPED, SLIPPED[4]]
    lesson = learn(again, [Answer(RowQuestion(play_of(again[5])), Reply.YES)])
    assert lesson.slips == ()


def test_the_wrong_move_is_the_one_that_changed_makes_it_right() -> None:
    word = given_row("letter", tuple("CURIE"))
    assert wrong_move((ODD,), row((0, 1, 2, 7, 9))) == 2
    assert wrong_move((RISING,), row((9, 8, 7, 6, 5))) == 1
    assert wrong_move((word,), row((0, 2, 1, 3, 4))) == 2
    nothing = given_row("letter", ("Z",) * 5)
    assert wrong_move((nothing,), row(ODD_ROW)) == 0
    assert wrong_move((nothing,), play_of(shown(ODD_ROW).until(0))) == -1


# ------------------------------------------------------------------ answers
def test_answers_move_the_belief() -> None:
    answers = [
        Answer(RowQuestion(row((1, 2, 3, 4, 5))), Reply.YES),
        Answer(RowQuestion(row((5, 4, 3, 2, 1))), Reply.NO),
        Answer(RowQuestion(row((5, 4, 3, 2, 1))), Reply.UNSURE),
        Answer(RuleQuestion(RISING), Reply.YES),
        Answer(RuleQuestion(FALLING), Reply.NO),
        Answer(RuleQuestion(FALLING), Reply.UNSURE),
    ]
    before, after = learn(UP[:1]), learn(UP[:1], answers)
    assert after.confidence > before.confidence
    assert after.rules == (FullRow(), RISING)
    assert after.answers == tuple(answers)


def test_a_move_that_is_right_leaves_only_rules_that_allow_it() -> None:
    begin = Play.begin(row(ROWS[0]).setting)
    answers = [Answer(MoveQuestion(begin, token, 0), Reply.YES) for token in (7, 8, 9)]
    assert RISING not in learn(UP[:1], answers).rules


def test_who_points_at_the_wrong_cell_tells_more() -> None:
    # All odd but one, in any order: the third is wrong.
    plays = [shown((7, 0, 9, 1, 6)), shown((1, 9, 0, 6, 7), 3)]
    question = RowQuestion(row((7, 0, 5, 1, 9)))
    no, pointed = (learn(plays, [Answer(question, Reply.NO, wrong)]).belief for wrong in (None, 2))
    of_odd = [
        sum(w for one, w in belief.weighted if ODD in belief.rules_of(one))
        for belief in (no, pointed)
    ]
    assert of_odd[1] > of_odd[0]


def test_answers_both_ways_are_not_resolved_silently() -> None:
    question = RowQuestion(row((1, 2, 3, 4, 5)))
    answers = [Answer(question, Reply.YES), Answer(question, Reply.NO)]
    assert learn(UP[:2], answers).status is LearnStatus.CONTRADICTORY


# ------------------------------------------------------------------ the paper's exercises
VALUE, LETTER = "value", "letter"
PAPER: dict[str, tuple[Deck, tuple[Rule, ...]]] = {
    "i": (NUMBER_DECK, (FullRow(), EveryToken(has("odd", VALUE)), Ordered(VALUE))),
    "ii": (NUMBER_DECK, (FullRow(), Ordered(VALUE))),
    "iii": (NUMBER_DECK, (FullRow(), Ordered(VALUE, Direction.FALLING))),
    "iv": (NUMBER_DECK, (FullRow(), from_row(1), StraightUp())),
    "v": (LETTER_DECK, (FullRow(), given_row(LETTER, tuple(WORD)))),
    "vi": (LETTER_DECK, (FullRow(), Ordered(LETTER))),
}


def paper_start(key: str, rng: Random) -> Setting:
    """Tokens anywhere; of the fourth exercise, the first storage row is full."""
    deck = PAPER[key][0]
    if key != "iv":
        return anywhere(deck, BOARD, rng)
    cells = BOARD.storage_cells
    near = [cell for cell in cells if abs(cell.row - BOARD.goal_row) == 1]
    far = rng.sample([cell for cell in cells if cell not in near], len(deck.tokens) - len(near))
    tokens = rng.sample(deck.tokens, len(deck.tokens))
    lies = {t.id: cell for t, cell in zip(tokens, [*near, *far], strict=True)}
    return Setting(deck, type(start())(BOARD, lies))


def right_rows(rules: Sequence[Rule], setting: Setting, *, back: bool = False) -> np.ndarray:
    """Every row that may be laid, from the left or the other way round."""
    rows = np.array(list(permutations(range(len(setting.deck.tokens)), 5)), np.intp)
    plays = Plays.layouts(setting, rows, range(5)[::-1] if back else range(5))
    return rows[np.logical_and.reduce([rule.mask(plays) for rule in rules])]


def truly(rules: Sequence[Rule], question: Question) -> Reply:
    """What somebody who means these rules says."""
    yes = False
    match question:
        case RowQuestion(play):
            yes = accepts(rules, play)
        case MoveQuestion(position, token, cell):
            there = right_rows(rules, position.setting)
            lies = {cell: token} | {k: t for k, t in enumerate(position.row) if t is not None}
            yes = any(all(r[k] == t for k, t in lies.items()) for r in there)
        case RuleQuestion(rule):
            rng = Random(7)  # noqa: S311 - what is drawn is no secret
            key = next(k for k, (_, known) in PAPER.items() if known == rules)
            settings_ = [paper_start(key, rng) for _ in range(2)]
            yes = all(
                len(right_rows((*rules, rule), s, back=back)) == len(right_rows(rules, s))
                for s in settings_
                for back in (False, True)
            )
    return Reply.YES if yes else Reply.NO


@pytest.mark.parametrize("key", PAPER)
def test_the_papers_exercises_take_two_demonstrations_and_three_answers(key: str) -> None:
    rules = PAPER[key][1]
    rng = Random(f"paper {key}")  # noqa: S311 - what is drawn is no secret
    plays: list[Demonstration] = []
    for _ in range(2):
        setting = paper_start(key, rng)
        chosen = rng.choice(right_rows(rules, setting).tolist())
        plays.append(demonstrated(placed(setting, chosen)))
    lesson = learn(plays)
    for _ in range(3):
        question = next_question(lesson)
        if question is None:
            break
        lesson = answered(lesson, question, truly(rules, question))
    for setting in (paper_start(key, rng) for _ in range(2)):
        assert np.array_equal(right_rows(lesson.rules, setting), right_rows(rules, setting))


# ------------------------------------------------------------------ other starts
@pytest.mark.parametrize("count", [2, 5, 7, 10])
def test_another_start_moves_the_tokens(count: int) -> None:
    setting = Setting(Deck(DECK.tokens[:count]), start(0, Deck(DECK.tokens[:count])))
    other = elsewhere(setting)
    assert other.start != setting.start
    assert other.movable == setting.movable
    assert sorted(other.start.cells.values()) == sorted(setting.start.cells.values())

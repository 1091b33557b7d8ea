"""Whatever is done to a draft can be kept, and undone."""

import json
from dataclasses import replace

import pytest
from hypothesis import given

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.json_lines import FormatError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.answers import Answer, RuleQuestion
from maestra.rules.answers import Reply as Word
from maestra.web.teach.actions import (
    MAX_SHOWN,
    MAX_STEPS,
    Action,
    CannotError,
    Deal,
    Equip,
    Finish,
    JudgePlay,
    LayOut,
    Put,
    Show,
    Take,
    Try,
    Undo,
    Why,
    act,
    new_draft,
)
from maestra.web.teach.draft import (
    BroughtBack,
    Draft,
    Examined,
    Shown,
    TakenBack,
    Told,
)
from maestra.web.teach.draft_format import decode_draft, encode_draft
from maestra.web.teach.showing import MAX_TOUCHES, CannotTouchError, Showing, Touch
from tests.web.teach.teaching_drafts import (
    BOARD,
    DECK,
    EXAM,
    NEW,
    RECALLED,
    RULES,
    answers,
    done,
    drafts,
    takes,
    touches,
)


def put(draft: Draft, token: str, row: int, column: int) -> Draft:
    return act(draft, Put(Touch(TokenId(token), Cell(Row(row), Column(column)))))


def row_of(draft: Draft, tokens: str) -> Draft:
    for column, token in enumerate(tokens, start=1):
        draft = put(draft, token, 1, column)
    return draft


def refused(draft: Draft, *actions: Action) -> Why:
    *before, last = actions
    for action in before:
        draft = act(draft, action)
    with pytest.raises(CannotError) as error:
        act(draft, last)
    return error.value.why


def test_a_demonstration_on_another_board_is_refused() -> None:
    other = new_draft(DECK, Board(4, 3), 1)
    assert refused(NEW, Show(put(other, "a", 1, 1).showing)) is Why.IN_USE


@given(drafts())
def test_a_draft_that_is_kept_is_the_same_again(draft: Draft) -> None:
    written = encode_draft(draft)
    again = decode_draft(written)
    assert again == draft
    assert again.taught == draft.taught
    assert encode_draft(again) == written


@given(drafts(), touches)
def test_a_touch_that_is_undone_has_not_been(draft: Draft, touch: Touch) -> None:
    after = done(draft, Put(touch))
    if after is not draft:
        undone = act(after, Undo())
        assert undone.showing == draft.showing
        assert undone.steps == draft.steps


@given(drafts(), takes)
def test_a_step_that_is_undone_has_not_been(draft: Draft, take: Take) -> None:
    empty = replace(draft, showing=Showing(draft.showing.start))
    after = done(empty, take)
    if after is not empty:
        assert act(after, Undo()).taught == empty.taught


@given(drafts())
def test_what_was_shown_can_be_learned_from(draft: Draft) -> None:
    for shown in draft.demonstrations:
        assert shown.moves
        assert all(move.origin.row != 1 and move.destination.row == 1 for move in shown.moves)


def test_a_full_row_ends_by_itself_and_the_tokens_lie_as_before() -> None:
    draft = row_of(NEW, "abc")
    assert [type(step) for step in draft.steps] == [Shown]
    assert draft.showing == Showing(NEW.showing.dealt)
    reopened = act(draft, Undo())
    assert [move.token for move in reopened.showing.moves] == ["a", "b"]


def test_a_row_that_was_called_done_comes_back_whole() -> None:
    draft = act(row_of(NEW, "ab"), Finish())
    assert len(act(draft, Undo()).showing.moves) == 2
    assert act(draft, Undo(whole=True)).showing == draft.showing


def test_a_token_taken_out_of_the_row_takes_its_move_back() -> None:
    home = NEW.showing.now.cells[TokenId("a")]
    draft = put(row_of(NEW, "ab"), "a", home.row, home.column)
    assert [move.token for move in draft.showing.moves] == ["b"]
    assert draft.showing.start == NEW.showing.start


def test_a_token_may_change_its_place_in_the_row() -> None:
    draft = put(row_of(NEW, "ab"), "a", 1, 3)
    assert [(m.token, m.destination.column) for m in draft.showing.moves] == [("b", 2), ("a", 3)]


def test_a_token_moved_about_in_storage_is_another_start() -> None:
    free = next(c for c in BOARD.storage_cells if c not in NEW.showing.now.tokens)
    draft = put(NEW, "a", free.row, free.column)
    assert draft.showing.start.cells[TokenId("a")] == free
    assert draft.showing.moves == ()


def test_the_place_of_a_token_in_the_row_is_kept_for_it() -> None:
    home = NEW.showing.now.cells[TokenId("a")]
    draft = row_of(NEW, "a")
    touch = Touch(TokenId("b"), home)
    assert refused(draft, Put(touch)) is Why.CELL


def test_a_token_of_the_goal_row_stays_there_from_the_start() -> None:
    corner = Cell(Row(1), Column(1))
    draft = act(NEW, LayOut(Touch(TokenId("a"), corner)))
    assert draft.showing.start.cells[TokenId("a")] == corner
    draft = put(put(draft, "b", 1, 2), "c", 1, 3)
    (shown,) = draft.demonstrations
    assert [move.token for move in shown.moves] == ["b", "c"]


@pytest.mark.parametrize(
    ("actions", "why"),
    [
        ([Finish()], Why.NOTHING_SHOWN),
        ([Undo()], Why.NOTHING_TO_UNDO),
        ([Take(TakenBack(0))], Why.NO_SUCH),
        ([Take(BroughtBack(0))], Why.NO_SUCH),
        ([JudgePlay(Word.YES)], Why.NO_EXAM),
        ([Put(Touch(TokenId("a"), Cell(Row(9), Column(9))))], Why.CELL),
        ([Put(Touch(TokenId("z"), Cell(Row(1), Column(1))))], Why.CELL),
        ([LayOut(Touch(TokenId("z"), Cell(Row(1), Column(1))))], Why.CELL),
        ([Take(Told(RULES)), Equip(DECK, BOARD, {})], Why.IN_USE),
        ([Equip(DECK, Board(2, 3), {})], Why.NO_ROOM),
    ],
)
def test_what_cannot_be_done_says_why(actions: list[Action], why: Why) -> None:
    assert refused(NEW, *actions) is why


def test_tokens_are_neither_dealt_nor_laid_once_something_is_moved() -> None:
    draft = row_of(NEW, "a")
    free = next(c for c in BOARD.storage_cells if c not in draft.showing.now.tokens)
    assert refused(draft, Deal()) is Why.IN_USE
    assert refused(draft, LayOut(Touch(TokenId("b"), free))) is Why.IN_USE


def test_a_draft_holds_so_many_demonstrations() -> None:
    draft = NEW
    for _ in range(MAX_SHOWN):
        draft = act(row_of(draft, "a"), Finish())
    assert refused(row_of(draft, "a"), Finish()) is Why.TOO_MUCH


def test_a_draft_holds_so_many_steps() -> None:
    draft = replace(NEW, steps=(Told(RULES),) * MAX_STEPS)
    assert refused(draft, Take(Told(RULES))) is Why.TOO_MUCH


def test_a_demonstration_holds_so_many_touches() -> None:
    home = NEW.showing.now.cells[TokenId("a")]
    free = next(c for c in BOARD.storage_cells if c not in NEW.showing.now.tokens)
    there = (Touch(TokenId("a"), free), Touch(TokenId("a"), home))
    showing = Showing(NEW.showing.dealt, there * (MAX_TOUCHES // 2))
    with pytest.raises(CannotTouchError):
        showing.after(there[0])


def test_what_was_told_becomes_evidence_once_something_is_shown() -> None:
    draft = row_of(act(NEW, Take(Told(RULES))), "abc")
    assert draft.taught.told is None
    assert draft.taught.answers == tuple(Answer(RuleQuestion(r), Word.YES) for r in RULES)


def test_objections_to_told_rules_are_learned_from_only_with_something_shown() -> None:
    told = act(NEW, Take(Told(RULES)))
    objected = act(told, Take(Examined(EXAM, answers()[:1])))
    assert objected.taught.told == RULES
    assert objected.taught.answers == answers()[:1]
    shown = act(row_of(NEW, "abc"), Take(Told(RULES)))
    objected = act(shown, Take(Examined(EXAM, answers()[:1])))
    assert objected.taught.told is None
    assert objected.taught.base == ((0,), objected.taught.answers)
    assert act(shown, Take(Examined(EXAM, ()))).taught.told == RULES


def test_what_was_answered_before_the_draft_cannot_be_undone() -> None:
    draft = replace(NEW, steps=(RECALLED,))
    assert refused(draft, Undo()) is Why.NOTHING_TO_UNDO
    assert decode_draft(encode_draft(draft)) == draft
    assert draft.taught.answers == answers()
    assert draft.taught.exams == (EXAM,)


def test_trying_and_examining_end_when_the_rules_change() -> None:
    tried = act(NEW, Try(Touch(TokenId("a"), Cell(Row(1), Column(1))), allowed=True))
    assert tried.trial.moves
    assert act(tried, Take(Told(RULES))).trial.moves == ()


def test_each_deal_lies_otherwise() -> None:
    dealt = act(NEW, Deal())
    assert dealt.showing.start != NEW.showing.start
    assert new_draft(DECK, BOARD, dealt.seed).showing == dealt.showing


@pytest.mark.parametrize(
    "change",
    [
        {"format": "maestra.draft/2"},
        {"steps": [{"step": "danced"}]},
        {"board": {"rows": 0}},
        {"unknown": 1},
    ],
)
def test_what_is_no_draft_is_refused(change: dict[str, object]) -> None:
    written = json.dumps(json.loads(encode_draft(NEW)) | change)
    with pytest.raises((FormatError, ValueError)):
        decode_draft(written)


def test_a_token_of_a_deck_of_one_can_be_shown() -> None:
    deck = Deck((Token(TokenId("a"), (("value", 1),)),))
    draft = row_of(new_draft(deck, BOARD, 1), "a")
    assert len(draft.steps) == 1, "no token is left, so the row is done"

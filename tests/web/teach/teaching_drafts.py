"""Drafts by whatever somebody may do, without learning from them."""

from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.dialogue import CellIsWrong, Counts, Enough, Side, SlipReplied, SlipReply
from maestra.learning.dialogue import Replied as Answered
from maestra.rules.answers import Answer, MoveQuestion, RowQuestion, RuleQuestion
from maestra.rules.answers import Reply as Word
from maestra.rules.exercise import Exam
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.setting import Play, Setting, play_of
from maestra.storage.drafts import Digest
from maestra.web.teach.actions import (
    Action,
    BeginExam,
    CannotError,
    Choose,
    Deal,
    Equip,
    Finish,
    Hold,
    JudgePlay,
    Keep,
    LayOut,
    LeaveExam,
    Put,
    Rename,
    Show,
    Take,
    Try,
    TryAgain,
    Undo,
    act,
    new_draft,
)
from maestra.web.teach.draft import (
    BroughtBack,
    Draft,
    Examined,
    Recalled,
    Replied,
    Reply,
    TakenBack,
    Told,
)
from maestra.web.teach.showing import Showing, Touch

BOARD = Board(3, 3)
DECK = Deck(
    tuple(
        Token(TokenId(name), (("value", k), ("colour", "red" if k % 2 else "blue")))
        for k, name in enumerate("abcde")
    )
)
RULES = (FullRow(), Ordered("value", Direction.RISING))
EXAM = Exam("2026-05-04", 3, 2, 2, 1)

NEW = new_draft(DECK, BOARD, 1)

_tokens = st.sampled_from([token.id for token in DECK.tokens])
_cells = st.builds(Cell, st.integers(1, 3).map(Row), st.integers(1, 3).map(Column))
_touches = st.builds(Touch, _tokens, _cells)
_words = st.sampled_from(Word)
_said: st.SearchStrategy[Reply] = st.one_of(
    st.builds(Answered, _words),
    st.builds(CellIsWrong, st.none() | st.integers(0, 2)),
    st.builds(SlipReplied, st.sampled_from(SlipReply)),
    st.builds(Counts, st.sampled_from(Side)),
    st.just(Enough()),
)


def answers() -> tuple[Answer, ...]:
    """One about a row, one about a move, one about a rule."""
    showing = Showing(NEW.showing.dealt)
    for column, token in enumerate("abc", start=1):
        showing = showing.after(Touch(TokenId(token), Cell(Row(1), Column(column))))
    row = play_of(showing.demonstration(DECK))
    start = Play.begin(Setting(DECK, NEW.showing.dealt))
    return (
        Answer(RowQuestion(row), Word.NO, 1),
        Answer(MoveQuestion(start, 0, 2), Word.YES),
        Answer(RuleQuestion(RULES[1]), Word.UNSURE),
    )


_answers = st.lists(st.sampled_from(answers()), max_size=3).map(tuple)
_numbers = st.integers(0, 4)
_steps = st.one_of(
    st.builds(TakenBack, _numbers),
    st.builds(BroughtBack, _numbers),
    st.builds(Replied, _said, _answers, st.frozensets(_numbers, max_size=2)),
    st.builds(Told, st.sampled_from([RULES, RULES[:1], None])),
    st.builds(Examined, st.just(EXAM), _answers),
)
takes: st.SearchStrategy[Take] = st.builds(Take, _steps)
_actions: st.SearchStrategy[Action] = st.one_of(
    st.builds(Put, _touches),
    st.builds(Put, _touches),
    st.builds(Put, _touches),
    st.builds(LayOut, _touches),
    st.builds(Hold, st.none() | _tokens),
    st.just(Deal()),
    st.just(Finish()),
    st.just(Undo()),
    st.just(Undo(whole=True)),
    takes,
    st.builds(Choose, st.none() | st.just(("odd:value",))),
    st.builds(Try, _touches, st.booleans()),
    st.just(TryAgain()),
    st.builds(BeginExam, st.integers(0, 9)),
    st.builds(JudgePlay, _words),
    st.just(LeaveExam()),
    st.builds(Rename, st.sampled_from(["", "Up", "Números"])),
    st.builds(Keep, st.just("Up"), st.integers(1, 3)),
    st.just(Equip(DECK, Board(4, 3), {"cup": Digest("0" * 64)})),
    st.just(Show(Showing(NEW.showing.dealt, (Touch(TokenId("a"), Cell(Row(1), Column(1))),)))),
)


def done(draft: Draft, action: Action) -> Draft:
    """The draft after it; as it was, if it cannot be done."""
    try:
        return act(draft, action)
    except CannotError:
        return draft


def drafts() -> st.SearchStrategy[Draft]:
    """Any draft that can come about."""
    return st.lists(_actions, max_size=25).map(_after)


def _after(actions: list[Action]) -> Draft:
    draft = NEW
    for action in actions:
        draft = done(draft, action)
    return draft


touches = _touches
RECALLED = Recalled(answers(), (EXAM,))

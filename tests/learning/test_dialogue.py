"""Teaching as a dialogue: what is asked, what a reply changes, and that it always ends."""

from __future__ import annotations

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
)

from maestra.learning import dialogue as module
from maestra.learning.contradictions import Contradiction, Said, Shown, Understood
from maestra.learning.dialogue import (
    MAX_QUESTIONS,
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    CellIsWrong,
    Counts,
    Dialogue,
    Ending,
    Enough,
    Finished,
    NotAskedError,
    Replied,
    ShownAgain,
    Side,
    SlipReplied,
    SlipReply,
    Terms,
    begin,
    step,
)
from maestra.learning.fewshot.lesson import Lesson
from maestra.learning.fewshot.questions import QuestionKind
from maestra.rules.answers import Answer, Reply
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.rule import Rule
from maestra.rules.setting import play_of
from maestra.rules.token_tests import has
from tests.learning.caregivers import Caregiver, small
from tests.learning.scripts import AMBIGUOUS, LEARNED, OUTSIDE, Install, row, scripted, slip

RISING = Ordered("value", Direction.RISING, strict=True)
FALLING = Ordered("value", Direction.FALLING, strict=True)
RED = EveryToken(has("is-red", "colour"))
MEANT = ((FullRow(), RISING), (FullRow(), RED), (FullRow(),), (FullRow(), RED, FALLING))
YES, NO, UNSURE = (Replied(reply) for reply in Reply)


@pytest.fixture(name="script")
def a_script(monkeypatch: pytest.MonkeyPatch) -> Install:
    return lambda *scenes: scripted(monkeypatch, *scenes)


def talk(dialogue: Dialogue, *events: module.Event) -> Dialogue:
    for event in events:
        dialogue = step(dialogue, event)
    return dialogue


def test_it_asks_nothing_when_it_is_sure(script: Install) -> None:
    script(LEARNED)
    taught = begin([small("abc")])
    assert taught.ask == Finished(Ending.SURE, ())
    assert taught.status is LearnStatus.LEARNED


def test_it_asks_until_it_is_sure(script: Install) -> None:
    script(AMBIGUOUS, AMBIGUOUS, LEARNED)
    taught = begin([small("abc")])
    assert taught.ask == AskQuestion(row("abe"))
    taught = step(taught, YES)
    assert taught.ask == AskQuestion(row("cba"))
    taught = step(taught, NO)
    assert taught.ask == Finished(Ending.SURE, ())
    assert taught.answers == (Answer(row("abe"), Reply.YES), Answer(row("cba"), Reply.NO))
    assert taught.asked == 2


@pytest.mark.parametrize("questions", [0, 1, 3, 5])
def test_it_asks_no_more_than_it_may(script: Install, questions: int) -> None:
    script(AMBIGUOUS)
    taught = begin([small("abc")], terms=Terms(questions))
    for _ in range(questions):
        assert isinstance(taught.ask, AskQuestion)
        taught = step(taught, UNSURE)
    assert taught.ask == Finished(Ending.ASKED_ENOUGH, ())
    assert taught.status is LearnStatus.AMBIGUOUS


@pytest.mark.parametrize("questions", [-1, MAX_QUESTIONS + 1])
def test_nobody_is_asked_more_than_five_questions(questions: int) -> None:
    with pytest.raises(ValueError, match="expected 0 to 5"):
        Terms(questions)


def test_it_stops_when_no_question_helps(script: Install, monkeypatch: pytest.MonkeyPatch) -> None:
    script(AMBIGUOUS)

    def nothing(lesson: Lesson, kinds: object) -> None:
        assert lesson.rules
        assert kinds

    monkeypatch.setattr(module, "next_question", nothing)
    assert begin([small("abc")]).ask == Finished(Ending.NOTHING_HELPS, ())


def test_enough_is_enough_and_nothing_follows(script: Install) -> None:
    script(AMBIGUOUS)
    taught = step(begin([small("abc")]), Enough())
    assert taught.ask == Finished(Ending.TOLD_TO_STOP, ())
    assert step(taught, YES) is taught


def test_after_a_no_to_a_row_it_asks_which_token_is_wrong(script: Install) -> None:
    script(AMBIGUOUS)
    before = Answer(row("abe"), Reply.UNSURE)
    taught = talk(begin([small("abc")], [before]), NO)
    assert taught.ask == AskCell(1)
    taught = step(taught, CellIsWrong(2))
    assert taught.answers == (before, Answer(row("cba"), Reply.NO, wrong=2))
    assert taught.ask == AskQuestion(row("ade"))
    assert taught.asked == 1


def test_who_cannot_tell_which_token_is_wrong_says_so(script: Install) -> None:
    script(AMBIGUOUS)
    taught = talk(begin([small("abc")], [Answer(row("abe"), Reply.UNSURE)]), NO, CellIsWrong(None))
    assert taught.answers[1] == Answer(row("cba"), Reply.NO)
    assert isinstance(taught.ask, AskQuestion)


def test_an_answer_that_denies_what_was_shown_is_put_beside_it(script: Install) -> None:
    script(AMBIGUOUS)
    taught = talk(begin([small("cde"), small("abe")]), NO)
    contradiction = Contradiction(Shown(1), Said(0))
    assert taught.contradictions == (contradiction,)
    assert taught.ask == AskWhichCounts(contradiction)


@pytest.mark.parametrize(
    ("side", "reply", "counting"),
    [
        (Side.EARLIER, Reply.UNSURE, (0, 1)),
        (Side.LATER, Reply.NO, (0,)),
        (Side.NEITHER, Reply.UNSURE, (0,)),
    ],
)
def test_only_what_the_caregiver_picks_counts(
    script: Install, side: Side, reply: Reply, counting: tuple[int, ...]
) -> None:
    learner = script(OUTSIDE)
    taught = talk(begin([small("cde"), small("abe")]), NO, Counts(side))
    assert taught.answers == (Answer(row("abe"), reply),)
    assert taught.counting == counting
    assert learner.shown[-1] == ("cde", "abe")[: len(counting)]
    assert taught.contradictions == ()


def test_an_answer_that_was_dropped_is_not_asked_for_again(script: Install) -> None:
    script(AMBIGUOUS)
    taught = talk(begin([small("cde"), small("abe")]), NO, Counts(Side.EARLIER))
    assert taught.ask == AskQuestion(row("cba"))


def test_an_answer_that_the_rules_do_not_agree_with_is_put_beside_them(
    script: Install,
) -> None:
    script(AMBIGUOUS)
    taught = talk(begin([small("bde")]), NO)
    contradiction = Contradiction(Understood(), Said(0))
    assert taught.ask == AskWhichCounts(contradiction)
    insisting = step(taught, Counts(Side.LATER))
    assert insisting.answers == (Answer(row("abe"), Reply.NO),)
    assert isinstance(insisting.ask, AskQuestion)
    at_the_end = step(insisting, Enough())
    assert at_the_end.ask == Finished(Ending.TOLD_TO_STOP, (contradiction,))
    assert at_the_end.status is LearnStatus.CONTRADICTORY
    giving_in = step(taught, Counts(Side.EARLIER))
    assert giving_in.contradictions == ()


def test_rules_that_are_only_a_guess_overrule_nobody(script: Install) -> None:
    script(OUTSIDE)
    taught = talk(begin([small("bde")]), NO)
    assert taught.contradictions == ()
    assert taught.ask == AskCell(0)


def test_nothing_is_learned_while_something_is_contradictory(script: Install) -> None:
    script(AMBIGUOUS, LEARNED)
    taught = talk(begin([small("abe")]), NO, Enough())
    assert isinstance(taught.ask, Finished)
    assert taught.ask.unsettled == (Contradiction(Shown(0), Said(0)),)
    assert taught.status is LearnStatus.CONTRADICTORY


def test_who_knows_only_questions_is_asked_again(script: Install) -> None:
    script(AMBIGUOUS)
    terms = Terms(follow_ups=False)
    taught = talk(begin([small("cde"), small("abe")], terms=terms), NO)
    assert taught.ask == AskAgain(Contradiction(Shown(1), Said(0)), row("abe"))
    assert taught.asked == 1
    changed = step(taught, YES)
    assert changed.answers == (Answer(row("abe"), Reply.YES),)
    assert (changed.counting, changed.asked) == ((0, 1), 2)
    kept = step(taught, NO)
    assert kept.answers == (Answer(row("abe"), Reply.NO),)
    assert kept.counting == (0,)


def test_who_knows_only_questions_is_not_asked_which_token_is_wrong(
    script: Install,
) -> None:
    script(OUTSIDE)
    taught = talk(begin([small("bde")], terms=Terms(follow_ups=False)), NO)
    assert isinstance(taught.ask, AskQuestion)


def test_without_budget_a_contradiction_is_left_and_named(script: Install) -> None:
    script(AMBIGUOUS)
    taught = talk(begin([small("abe")], terms=Terms(1, follow_ups=False)), NO)
    unsettled = (Contradiction(Shown(0), Said(0)),)
    assert taught.ask == Finished(Ending.ASKED_ENOUGH, unsettled)


def test_a_likely_mistake_is_asked_about_once(script: Install) -> None:
    script((LearnStatus.LEARNED, (slip(1),)))
    taught = begin([small("abc"), small("abd")])
    assert taught.ask == AskSlip(slip(1))
    taught = step(taught, SlipReplied(SlipReply.CONFIRMED))
    assert taught.answers == (Answer(row("abd"), Reply.YES),)
    assert taught.counting == (0, 1)
    assert taught.asked == 0
    assert taught.ask == Finished(Ending.SURE, ())
    again = begin([small("abc"), small("abd")], taught.answers)
    assert again.ask == Finished(Ending.SURE, ())


def test_what_was_meant_against_all_rules_is_put_beside_them(script: Install) -> None:
    script((LearnStatus.LEARNED, (slip(1),)))
    taught = talk(begin([small("abc"), small("bac")]), SlipReplied(SlipReply.CONFIRMED))
    assert taught.ask == AskWhichCounts(Contradiction(Understood(), Said(0)))
    assert step(taught, Counts(Side.EARLIER)).ask == Finished(Ending.SURE, ())
    insisting = step(taught, Counts(Side.LATER))
    assert insisting.status is LearnStatus.CONTRADICTORY


def test_a_demonstration_that_is_taken_back_does_not_count(script: Install) -> None:
    learner = script((LearnStatus.LEARNED, (slip(0),)), (LearnStatus.LEARNED, (slip(0),)), LEARNED)
    shown = [small("bac"), small("cab"), small("abc")]
    taught = begin(shown)
    taught = step(taught, SlipReplied(SlipReply.TAKEN_BACK))
    assert learner.shown[-1] == ("cab", "abc")
    # The first one that is left is the second that was shown.
    assert taught.ask == AskSlip(slip(1))
    taught = step(taught, ShownAgain(small("bcd")))
    assert learner.shown[-1] == ("abc", "bcd")
    assert taught.demonstrations == (*shown, small("bcd"))
    assert taught.counting == (2, 3)


def test_who_takes_everything_back_is_left_with_nothing(script: Install) -> None:
    script((LearnStatus.LEARNED, (slip(0),)))
    taught = talk(begin([small("abc")]), SlipReplied(SlipReply.TAKEN_BACK))
    assert taught.ask == Finished(Ending.NOTHING_LEFT, ())
    assert taught.status is LearnStatus.AMBIGUOUS


def test_who_knows_only_questions_is_not_asked_about_mistakes(script: Install) -> None:
    script((LearnStatus.LEARNED, (slip(0),)))
    taught = begin([small("abc")], terms=Terms(follow_ups=False))
    assert taught.ask == Finished(Ending.SURE, ())


@pytest.mark.parametrize("event", [CellIsWrong(0), Counts(Side.LATER), ShownAgain(small("abc"))])
def test_a_reply_to_something_else_is_refused(script: Install, event: module.Event) -> None:
    script(AMBIGUOUS)
    with pytest.raises(NotAskedError):
        step(begin([small("abc")]), event)


def test_only_the_kinds_that_may_be_asked_are(
    script: Install, monkeypatch: pytest.MonkeyPatch
) -> None:
    script(AMBIGUOUS)
    seen: list[object] = []

    def note(lesson: Lesson, kinds: object) -> None:
        assert lesson.rules
        seen.append(kinds)

    monkeypatch.setattr(module, "next_question", note)
    kinds = frozenset({QuestionKind.MOVE})
    begin([small("abc")], terms=Terms(kinds=kinds))
    assert seen == [kinds]


@pytest.mark.parametrize("meant", MEANT)
def test_a_caregiver_without_mistakes_is_never_contradicted_for_good(
    meant: tuple[Rule, ...],
) -> None:
    caregiver = Caregiver(meant)
    rows = [r for r in ("ace", "abc", "eca") if caregiver.is_right(play_of(small(r)))]
    taught = caregiver.lead(begin([small(r, k) for k, r in enumerate(rows[:2])]))
    assert isinstance(taught.ask, Finished)
    assert all(isinstance(one.earlier, Understood) for one in taught.ask.unsettled)


class Teaching(RuleBasedStateMachine):
    """Somebody shows anything, answers anything, and changes their mind."""

    dialogue: Dialogue
    steps: int = 0
    shown_again: int = 0

    @initialize(
        rows=st.lists(st.permutations("abcde"), min_size=1, max_size=2),
        questions=st.integers(0, MAX_QUESTIONS),
        follow_ups=st.booleans(),
    )
    def begin(self, rows: list[list[str]], questions: int, *, follow_ups: bool) -> None:
        shown = [small("".join(one[:3]), turn) for turn, one in enumerate(rows)]
        terms = Terms(questions, follow_ups=follow_ups)
        self.dialogue = begin(shown, terms=terms)

    def do(self, event: module.Event) -> None:
        before = self.dialogue
        self.dialogue = step(before, event)
        self.steps += 1
        self.is_put(before)

    def is_put(self, before: Dialogue) -> None:
        """Whatever cannot both be is asked about, or named at the end."""
        after = self.dialogue
        new = set(after.contradictions) - set(before.contradictions)
        match after.ask:
            case AskWhichCounts(one) | AskAgain(one, _):
                assert one in after.contradictions
            case Finished(Ending.NOTHING_LEFT):
                pass
            case Finished(_, unsettled):
                assert set(unsettled) == set(after.contradictions)
            case _:
                put = after.put.contradictions
                out_of_budget = after.asked >= after.terms.questions
                assert new <= put or out_of_budget

    @precondition(lambda self: isinstance(self.dialogue.ask, AskQuestion | AskAgain))
    @rule(reply=st.sampled_from(Reply))
    def replies(self, reply: Reply) -> None:
        self.do(Replied(reply))

    @precondition(lambda self: isinstance(self.dialogue.ask, AskCell))
    @rule(cell=st.sampled_from([None, 0, 1, 2]))
    def points_at_a_cell(self, cell: int | None) -> None:
        self.do(CellIsWrong(cell))

    @precondition(lambda self: isinstance(self.dialogue.ask, AskWhichCounts))
    @rule(side=st.sampled_from(Side))
    def picks_what_counts(self, side: Side) -> None:
        self.do(Counts(side))

    @precondition(lambda self: isinstance(self.dialogue.ask, AskSlip))
    @rule(reply=st.sampled_from(SlipReply))
    def looks_at_a_mistake(self, reply: SlipReply) -> None:
        self.do(SlipReplied(reply))

    @precondition(lambda self: isinstance(self.dialogue.ask, Finished))
    @rule()
    def goes_on_talking(self) -> None:
        before = self.dialogue
        assert step(before, Replied(Reply.YES)) is before

    @invariant()
    def asks_at_most_five_questions(self) -> None:
        assert self.dialogue.asked <= self.dialogue.terms.questions <= MAX_QUESTIONS

    @invariant()
    def comes_to_an_end(self) -> None:
        # Each question, its cell and its contradictions, and a mistake in each demonstration.
        most = 4 * self.dialogue.terms.questions + 2 * len(self.dialogue.demonstrations)
        assert self.steps <= most or isinstance(self.dialogue.ask, Finished)

    @invariant()
    def learns_only_from_what_counts(self) -> None:
        kept = [self.dialogue.demonstrations[k] for k in self.dialogue.counting]
        if kept:
            assert list(self.dialogue.lesson.demonstrations) == kept

    def teardown(self) -> None:
        """Whatever was said, "that's enough" ends it."""
        if hasattr(self, "dialogue"):
            assert isinstance(step(self.dialogue, Enough()).ask, Finished)


TestTeaching = Teaching.TestCase
TestTeaching.settings = settings(max_examples=10, stateful_step_count=12)

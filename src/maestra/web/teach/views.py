"""What the pages of teaching show of a draft: boards, sentences, questions."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, assert_never

from maestra.coaching.asking import as_demonstration, asked_play, moments, question_text
from maestra.core.board import Cell
from maestra.core.state import State
from maestra.language import (
    Language,
    check_sentence,
    conjunction_sentences,
    gap_sentences,
    rule_sentences,
)
from maestra.language.terminal import TerminalKey, terminal_sentence
from maestra.learning.contradictions import Contradiction, Said, Shown
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    Dialogue,
    Finished,
)
from maestra.rules.answers import MoveQuestion, Question
from maestra.rules.exercise import GroundedExercise, LearnStatus, RuledExercise
from maestra.rules.forms.length import FullRow
from maestra.rules.setting import Index, Play, Setting
from maestra.rules.summaries.summary import Check, summarise
from maestra.web.board_view import BoardView, board_view
from maestra.web.rule_drawing import draw_rule
from maestra.web.teach.draft import Draft
from maestra.web.teach.pictures import addresses
from maestra.web.teach.understanding import (
    dialogue_of,
    exercise_of,
    slip_of,
    teacher_of,
)

MAX_OTHERS: Final = 3
"""Other exercises that may be meant: more than three are not read."""
SURE: Final = 0.95
FAIRLY: Final = 0.75
_ALL_PERCENT: Final = 100


@dataclass(frozen=True, slots=True)
class RuleView:
    """A rule in words, and how sure it is."""

    id: str
    text: str
    percent: int | None
    """None where it is not a matter of more or less."""
    drawing: str = ""
    """The rule as SVG; empty where there is none."""

    @property
    def how(self) -> str:
        """``sure``, ``fairly`` or ``hardly``; empty where that is no question."""
        if self.percent is None:
            return ""
        share = self.percent / _ALL_PERCENT
        return "sure" if share >= SURE else "fairly" if share >= FAIRLY else "hardly"


@dataclass(frozen=True, slots=True)
class UnderstandingView:
    """What Maestra makes of what was taught."""

    rules: tuple[RuleView, ...]
    verdict: str
    """How sure all of it is, in a sentence."""
    others: tuple[str, ...]
    """What else may be meant, or what is not clear yet."""
    is_sure: bool


@dataclass(frozen=True, slots=True)
class SideView:
    """One of two moments that do not go together."""

    text: str
    board: BoardView | None


@dataclass(frozen=True, slots=True)
class QuestionView:
    """What is asked now."""

    kind: str
    """``question``, ``cell``, ``slip`` or ``sides``."""
    text: str
    board: BoardView | None = None
    sides: tuple[SideView, ...] = ()


@dataclass(frozen=True, slots=True)
class ShownView:
    """A demonstration in small."""

    number: int
    """From 1."""
    board: BoardView
    counts: bool
    doubted: bool
    """Whether one of its moves is probably a slip, and marked."""


@dataclass(frozen=True, slots=True)
class Views:
    """Makes what is shown of one draft in one language."""

    draft: Draft
    language: Language

    def board(
        self,
        state: State,
        *,
        held: bool = False,
        pointed: Collection[Cell] = (),
        wrong: Collection[Cell] = (),
        allowed: Collection[Cell] = (),
    ) -> BoardView:
        """The draft's board with what lies where; with `held`, its token in the hand."""
        draft = self.draft
        return board_view(
            draft.board,
            draft.deck,
            state.cells,
            language=self.language,
            held=draft.held if held else None,
            pointed=pointed,
            wrong=wrong,
            allowed=allowed,
            pictures=addresses(draft.pictures),
        )

    def showing(self) -> BoardView:
        """The board that is played on."""
        return self.board(self.draft.showing.now, held=True)

    def understanding(self) -> UnderstandingView | None:
        """What is understood; None before anything was shown or told."""
        exercise = exercise_of(self.draft)
        match exercise:
            case None:
                return None
            case RuledExercise():
                return self._of_rules(exercise)
            case GroundedExercise():
                return self._of_actions(exercise)
            case _:
                assert_never(exercise)

    def question(self) -> QuestionView | None:
        """What is asked; None where nothing is."""
        draft = self.draft
        if draft.features is not None or draft.taught.told is not None:
            return None
        dialogue = dialogue_of(draft)
        if dialogue is None:
            return None
        text = question_text(dialogue, teacher_of(draft, self.language))
        match dialogue.ask:
            case AskQuestion(question):
                return QuestionView("question", text, self._asked(question))
            case AskCell(number):
                board = self._asked(dialogue.answers[number].question)
                return QuestionView("cell", text, board)
            case AskSlip():
                return QuestionView("slip", text, self._slip(dialogue))
            case AskWhichCounts(contradiction):
                return QuestionView("sides", text, None, self._sides(dialogue, contradiction))
            case AskAgain(contradiction, question):
                sides = self._sides(dialogue, contradiction)
                return QuestionView("question", text, self._asked(question), sides)
            case Finished():
                return None
            case _:
                assert_never(dialogue.ask)

    def demonstrations(self) -> tuple[ShownView, ...]:
        """All that were shown, in small."""
        draft = self.draft
        slips = self._slips()
        counting = draft.taught.counting
        return tuple(
            ShownView(
                number + 1,
                self.board(shown.end, wrong=slips.get(number, ())),
                number in counting,
                number in slips,
            )
            for number, shown in enumerate(draft.demonstrations)
        )

    def play(self, play: Play) -> BoardView:
        """What lies where at the end of a play."""
        return self.board(as_demonstration(play).end)

    # ------------------------------------------------------------ within

    def _of_rules(self, exercise: RuledExercise) -> UnderstandingView:
        sentences = rule_sentences(exercise, self.language)
        told = exercise.status is LearnStatus.TOLD
        setting = Setting(exercise.deck, self.draft.showing.start)
        rules = tuple(
            RuleView(
                said.id,
                said.text,
                None if told else _percent(one.confidence),
                # The sentence stands beside it; that all cells are filled needs no drawing.
                ""
                if isinstance(one.rule, FullRow)
                else draw_rule(one.rule, setting, language=self.language),
            )
            for said, one in zip(sentences, exercise.rules, strict=True)
        )
        others = tuple(self._others(exercise))
        sure = exercise.status in (LearnStatus.LEARNED, LearnStatus.TOLD)
        return UnderstandingView(rules, self._verdict(exercise), others, sure)

    def _others(self, exercise: RuledExercise) -> Iterator[str]:
        match exercise.status:
            case LearnStatus.LEARNED | LearnStatus.TOLD:
                return
            case LearnStatus.OUTSIDE:
                yield " ".join(conjunction_sentences(exercise, exercise.safe, self.language))
            case LearnStatus.AMBIGUOUS | LearnStatus.CONTRADICTORY:
                for other in exercise.alternatives[:MAX_OTHERS]:
                    said = conjunction_sentences(exercise, other.rules, self.language)
                    yield " ".join(said) or self._say(TerminalKey.NO_RULE)
            case _:
                assert_never(exercise.status)

    def _verdict(self, exercise: RuledExercise) -> str:
        percent = _percent(exercise.confidence)
        match exercise.status:
            case LearnStatus.LEARNED:
                return self._say(TerminalKey.SURE, percent=percent)
            case LearnStatus.AMBIGUOUS:
                others = exercise.alternatives
                key = TerminalKey.COULD_ALSO_BE if others else TerminalKey.NOT_SURE
                return self._say(key, percent=percent)
            case LearnStatus.OUTSIDE:
                return self._say(TerminalKey.NO_SIMPLE_RULE)
            case LearnStatus.CONTRADICTORY:
                return self._say(TerminalKey.DOES_NOT_FIT)
            case LearnStatus.TOLD:
                return self._say(TerminalKey.TOLD)
            case _:
                assert_never(exercise.status)

    def _of_actions(self, exercise: GroundedExercise) -> UnderstandingView:
        summary = summarise(exercise)
        said = rule_sentences(summary, self.language)
        gaps = tuple(one.text for one in gap_sentences(summary, self.language))
        rules = tuple(RuleView(one.id, one.text, None) for one in said)
        verdict = check_sentence(summary, self.language) or self._say(TerminalKey.STILL_NARROW)
        return UnderstandingView(rules, verdict, gaps, summary.check is Check.SAME)

    def _asked(self, question: Question) -> BoardView | None:
        """The row that is asked about; of a move, what it makes, and where."""
        match question:
            case MoveQuestion(position, token, cell):
                after = as_demonstration(position.after(token, cell)).end
                return self.board(after, pointed=[self.draft.board.goal_cells[cell]])
            case _:
                play = asked_play(question)
                return None if play is None else self.play(play)

    def _slip(self, dialogue: Dialogue) -> BoardView | None:
        found = slip_of(self.draft, dialogue)
        if found is None:
            return None
        number, move = found
        shown = self.draft.demonstrations[number]
        return self.board(shown.end, wrong=[shown.moves[move].destination])

    def _slips(self) -> Mapping[Index, Collection[Cell]]:
        """Moves that are probably slips, by demonstration."""
        draft = self.draft
        dialogue = None if draft.features is not None else dialogue_of(draft)
        if dialogue is None:
            return {}
        numbers, _ = draft.taught.base
        counting = [numbers[k] for k in dialogue.counting]
        shown = draft.demonstrations
        return {
            counting[slip.demonstration]: [
                shown[counting[slip.demonstration]].moves[slip.move].destination
            ]
            for slip in dialogue.lesson.slips
        }

    def _sides(self, dialogue: Dialogue, contradiction: Contradiction) -> tuple[SideView, ...]:
        earlier, later = moments(dialogue, contradiction, teacher_of(self.draft, self.language))
        first: BoardView | None = None
        match contradiction.earlier:
            case Shown(number):
                first = self.board(dialogue.demonstrations[number].end)
            case Said(number):
                first = self._asked(dialogue.answers[number].question)
            case _:
                pass
        second = self._asked(dialogue.answers[contradiction.later.answer].question)
        return SideView(earlier, first), SideView(later, second)

    def _say(self, key: TerminalKey, **parts: object) -> str:
        return terminal_sentence(key, self.language, **parts)


def _percent(share: float) -> int:
    return round(_ALL_PERCENT * min(1.0, share))

"""What is said while a caregiver teaches: questions, likely mistakes, moments that disagree."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Board
from maestra.core.tokens import Deck
from maestra.language.ca.teaching import TEACHING as TEACHING_CA
from maestra.language.en.teaching import TEACHING as TEACHING_EN
from maestra.language.es.teaching import TEACHING as TEACHING_ES
from maestra.language.languages import Language, speaker_for
from maestra.language.lexicon import NO_LEXICON, Lexicon
from maestra.language.of_rules import Rules
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import (
    Foreign,
    InRow,
    Joint,
    Listing,
    Named,
    Nth,
    Numeral,
    Phrase,
)
from maestra.language.sentences import Sentence
from maestra.language.speaker import Speaker
from maestra.language.teaching_keys import TeachKey
from maestra.language.templates import fill
from maestra.rules.answers import (
    Answer,
    MoveQuestion,
    Question,
    Reply,
    RowQuestion,
    RuleQuestion,
)
from maestra.rules.looks import lines_of
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Line, Play
from maestra.rules.summaries.rule_ids import rule_ids

_TEACHING: Final[Mapping[Language, Mapping[str, str]]] = MappingProxyType(
    {Language.EN: TEACHING_EN, Language.ES: TEACHING_ES, Language.CA: TEACHING_CA}
)


def typed_words(key: TeachKey, language: Language) -> str:
    """What is typed for a reply."""
    return _TEACHING[language][key.value]


@dataclass(frozen=True)
class Teacher:
    """Speaks with a caregiver who teaches with one board and deck."""

    language: Language
    board: Board
    deck: Deck
    lexicon: Lexicon = NO_LEXICON

    def say(self, key: TeachKey, **parts: Phrase | str | int) -> str:
        """A sentence, its gaps filled with phrases, numbers, or text that is said as it is.

        Raises:
            KeyError: a gap without a part.
        """
        spoken = {name: self._speaker.spoken(_phrase(part)) for name, part in parts.items()}
        template = _TEACHING[self.language][key.value]
        text = fill(template, spoken, self._speaker.grammar.derive)
        # What is typed stays as it is typed.
        return text if key.name.startswith("TYPE_") else text[:1].upper() + text[1:]

    def rules(self, rules: Sequence[Rule]) -> tuple[Sentence, ...]:
        """Each rule in words, with an id made of what it says."""
        return tuple(
            Sentence(name, self.rule(rule))
            for name, rule in zip(rule_ids(rules), rules, strict=True)
        )

    def rule(self, rule: Rule) -> str:
        """One rule in words."""
        return self._speaker.sentence(self._rules.says(rule))

    def question(self, question: Question) -> str:
        """A question to be answered yes, no, or unsure."""
        match question:
            case RowQuestion(play):
                return self._row_question(play)
            case MoveQuestion(position, token, cell):
                named, column = _named(position, token), cell + 1
                if not position.placed:
                    return self.say(TeachKey.IS_FIRST_MOVE_RIGHT, token=named, column=column)
                before = _listed(position, [token for token, _ in position.placed], Joint.AND)
                return self.say(TeachKey.IS_MOVE_RIGHT, token=named, column=column, tokens=before)
            case RuleQuestion(rule):
                return self.say(TeachKey.IS_RULE_MEANT, rule=self.rule(rule))
            case _:
                assert_never(question)

    def shown(self, number: int, play: Play, against: Answer) -> str:
        """What was shown in the demonstration of this number, from 1, against an answer."""
        nth = Nth(number)
        if isinstance(against.question, RuleQuestion):
            pair = breaking_pair(against.question.rule, play)
            if pair is not None:
                first, second = (_named(play, token) for token in pair)
                return self.say(TeachKey.SHOWN_BEFORE, nth=nth, first=first, second=second)
        return self.say(TeachKey.SHOWN_ROW, nth=nth, tokens=_row(play))

    def said(self, answer: Answer) -> str:
        """What was answered."""
        yes = answer.reply is Reply.YES
        match answer.question:
            case RowQuestion(play):
                key = TeachKey.SAID_ROW_RIGHT if yes else TeachKey.SAID_ROW_WRONG
                return self.say(key, tokens=_row(play))
            case MoveQuestion(position, token, cell):
                key = TeachKey.SAID_MOVE_RIGHT if yes else TeachKey.SAID_MOVE_WRONG
                return self.say(key, token=_named(position, token), column=cell + 1)
            case RuleQuestion(rule):
                key = TeachKey.SAID_RULE_MEANT if yes else TeachKey.SAID_RULE_NOT_MEANT
                return self.say(key, rule=self.rule(rule))
            case _:
                assert_never(answer.question)

    def understood(self, rules: Sequence[Rule]) -> str:
        """What was understood from the rest, against an answer."""
        said = " ".join(self.rule(rule) for rule in rules)
        return self.say(TeachKey.UNDERSTOOD_RULES, rules=said)

    def slip(self, number: int, play: Play, move: int, rules: Sequence[Rule]) -> str:
        """Whether a move of the demonstration of this number, from 1, was meant.

        Args:
            number: of the demonstration.
            play: what was shown.
            move: the likely mistake, from 0.
            rules: those that would be kept without it.
        """
        nth, (token, cell) = Nth(number), play.placed[move]
        broken = [rule for rule in rules if not rule.holds(play)]
        pairs = (breaking_pair(rule, play, token) for rule in broken)
        pair = next((one for one in pairs if one is not None), None)
        if pair is not None:
            first, second = (_named(play, one) for one in pair)
            return self.say(TeachKey.MEANT_TO_COME_BEFORE, nth=nth, first=first, second=second)
        named = _named(play, token)
        if any(not lines_of(rule) for rule in broken):
            return self.say(TeachKey.MEANT_IN_ROW, nth=nth, token=named)
        return self.say(TeachKey.MEANT_THERE, nth=nth, token=named, column=cell + 1)

    def _row_question(self, play: Play) -> str:
        if not play.tokens:
            return self.say(TeachKey.IS_EMPTY_ROW_RIGHT, row=InRow(self.board.goal_row))
        cells = [cell for _, cell in play.placed]
        if cells == sorted(cells):
            return self.say(TeachKey.IS_ROW_RIGHT, tokens=_row(play))
        order = _listed(play, [token for token, _ in play.placed], Joint.COMMA)
        return self.say(TeachKey.IS_ROW_RIGHT_IN_TIME, tokens=_row(play), order=order)

    @cached_property
    def _speaker(self) -> Speaker:
        return speaker_for(self.language, self.board, self.deck, self.lexicon)

    @cached_property
    def _rules(self) -> Rules:
        return Rules(Tokens(self.board, self.deck))


def breaking_pair(
    rule: Rule, play: Play, token: Index | None = None
) -> tuple[Index, Index] | None:
    """Two tokens next to each other on the rule's line that it does not let lie so.

    Args:
        rule: what is broken.
        play: the play that breaks it.
        token: one of the two; None: whichever.
    """
    for line in sorted(lines_of(rule), key=lambda one: one.value):
        for (first, first_cell), (second, second_cell) in _neighbours(play, line):
            if token is not None and token not in {first, second}:
                continue
            begun = Play.begin(play.setting)
            alone = (begun.after(first, first_cell), begun.after(second, second_cell))
            both = alone[0].after(second, second_cell)
            if not rule.possible(both) and all(rule.possible(one) for one in alone):
                return first, second
    return None


def _neighbours(
    play: Play, line: Line
) -> Iterator[tuple[tuple[Index, Index], tuple[Index, Index]]]:
    placed = play.placed if line is Line.TIME else sorted(play.placed, key=lambda move: move[1])
    yield from pairwise(placed)


def _row(play: Play) -> Phrase:
    return _listed(play, play.tokens, Joint.COMMA) if play.tokens else Foreign("–")


def _listed(play: Play, tokens: Sequence[Index], joint: Joint) -> Listing:
    return Listing(tuple(_named(play, token) for token in tokens), joint)


def _named(play: Play, token: Index) -> Named:
    return Named(play.setting.deck.tokens[token].attributes)


def _phrase(part: Phrase | str | int) -> Phrase:
    match part:
        case str():
            return Foreign(part)
        case int():
            return Numeral(part)
        case _:
            return part

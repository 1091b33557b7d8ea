"""What other parts ask for: rules, gaps, actions and verdicts, in sentences of one language."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from maestra.core.board import Board
from maestra.core.tokens import Deck
from maestra.language.keys import Key
from maestra.language.languages import Language, speaker_for
from maestra.language.lexicon import NO_LEXICON, Lexicon
from maestra.language.of_literals import Conditions, needed
from maestra.language.of_rules import Rules
from maestra.language.of_summary import check_of, gaps_of, rules_of
from maestra.language.of_tokens import Tokens
from maestra.language.of_verdicts import MAX_WORDS, reasons
from maestra.language.phrases import Named, Nth, say
from maestra.rules.account import Account
from maestra.rules.exercise import RuledExercise
from maestra.rules.features import TokenFeature
from maestra.rules.rule import Rule
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.summaries.summary import Summary
from maestra.rules.verdicts import JudgedMove


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence, and the stable id of the rule, step or gap it says."""

    id: str
    text: str


@dataclass(frozen=True, slots=True)
class ActionExplanation:
    """One action as in the paper's Fig. 4 and 6b."""

    name: str
    """``move-v23-t2``."""
    precondition: tuple[str, ...]
    """Its literals as formulas, to be joined by ``∧``."""
    effects: tuple[str, ...]
    sentence: str


def rule_sentences(
    account: Account, language: Language, lexicon: Lexicon = NO_LEXICON
) -> tuple[Sentence, ...]:
    """What the exercise asks for, as a caregiver would say it."""
    if isinstance(account, Summary):
        speaker = speaker_for(language, account.board, account.deck, lexicon)
        return tuple(Sentence(one.id, speaker.sentence(one.phrase)) for one in rules_of(account))
    said = conjunction_sentences(account, account.conjunction, language, lexicon)
    return tuple(Sentence(one.id, text) for one, text in zip(account.rules, said, strict=True))


def conjunction_sentences(
    exercise: RuledExercise,
    rules: Sequence[Rule],
    language: Language,
    lexicon: Lexicon = NO_LEXICON,
) -> tuple[str, ...]:
    """Any rules about the exercise's tokens in words: its own, or those of an alternative."""
    speaker = speaker_for(language, exercise.board, exercise.deck, lexicon)
    said = Rules(Tokens(exercise.board, exercise.deck))
    return tuple(speaker.sentence(said.says(rule)) for rule in rules)


def feature_of_token(
    feature: TokenFeature,
    board: Board,
    deck: Deck,
    language: Language,
    lexicon: Lexicon = NO_LEXICON,
) -> str:
    """What a feature says of a token of `deck`, from the verb on: ``is a multiple of 5``."""
    said = Tokens(board, deck).has(feature)
    return speaker_for(language, board, deck, lexicon).spoken(said).text


def gap_sentences(
    summary: Summary, language: Language, lexicon: Lexicon = NO_LEXICON
) -> tuple[Sentence, ...]:
    """Where the rules say more than has been learned; none if they say the same."""
    speaker = speaker_for(language, summary.board, summary.deck, lexicon)
    return tuple(Sentence(one.id, speaker.sentence(one.phrase)) for one in gaps_of(summary))


def check_sentence(summary: Summary, language: Language, lexicon: Lexicon = NO_LEXICON) -> str:
    """That rules and preconditions say the same, or could not be compared; else empty."""
    speaker = speaker_for(language, summary.board, summary.deck, lexicon)
    said = check_of(summary)
    return "" if said is None else speaker.sentence(said)


def explain_action(
    model: ActionModel, action: Action, language: Language, lexicon: Lexicon = NO_LEXICON
) -> ActionExplanation:
    """One action's precondition and effects, as formulas and as a sentence.

    Raises:
        KeyError: the model does not have the action.
    """
    vocabulary = model.vocabulary
    speaker = speaker_for(language, vocabulary.board, vocabulary.deck, lexicon)
    literals = needed(model.precondition(action))
    token, nth = Named(action.shown), Nth(action.step)
    if literals:
        conditions = Conditions(Tokens(vocabulary.board, vocabulary.deck), action.shown)
        said = say(Key.MAY_GO_IF, token=token, nth=nth, conditions=conditions.listed(literals))
    else:
        said = say(Key.MAY_GO, token=token, nth=nth)
    formulas, effects = model.formulas(action), model.effects(action)
    return ActionExplanation(action.name, formulas, effects, speaker.sentence(said))


def reason(
    judged: JudgedMove,
    account: Account,
    deck: Deck,
    language: Language,
    lexicon: Lexicon = NO_LEXICON,
) -> str:
    """Why a move was refused, in at most twelve words; empty if it was not.

    Args:
        judged: the move and its verdict.
        account: of the exercise it was judged by.
        deck: the tokens it was played with.
        language: to say it in.
        lexicon: a caregiver's own words.
    """
    speaker = speaker_for(language, judged.before.board, deck, lexicon)
    said = (speaker.sentence(why) for why in reasons(judged, account, deck))
    return next((sentence for sentence in said if len(sentence.split()) <= MAX_WORDS), "")

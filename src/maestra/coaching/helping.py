"""Help before an attempt: how much, in which words and gestures, and what comes after silence."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, assert_never

from maestra.coaching.assistance import (
    Encouragement,
    Hint,
    InThisRow,
    OneOfThese,
    Reminder,
    ThisMove,
    YourTurn,
    hint,
)
from maestra.coaching.chance import Chance
from maestra.coaching.commands import Expression, GestureName, Matter, MoveToken, View
from maestra.coaching.fields import MAX_LEVEL, Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.policies import choose, learn
from maestra.coaching.session import AskedMove
from maestra.coaching.settings import Persona
from maestra.coaching.situation import Outcome, Situation
from maestra.coaching.turn import Turn
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.phrases import InRow, Joint, Phrase, Place

SHOWN_LEVEL: Final = 4
"""At which the robot shows the token itself."""
LONG_SILENCE: Final = 3
"""Unanswered prompts at one move after which the caregiver is asked."""
MOST_STRETCHES: Final = 3
"""By how many halves of itself the patience of a human-centred robot grows."""

POLICY: Final = "policy"
SILENCE: Final = "silence"
ASKED: Final = "asked"
ORDERED: Final = "ordered"


def consult(turn: Turn, why: str = POLICY) -> None:
    """Let the policy choose how much to help before the next attempt, and help."""
    session, settings = turn.session, turn.game.settings
    step = session.step
    left = max(turn.game.length - len(session.position.moves), 1)
    situation = Situation(left, step.last, step.silent, step.standing)
    limits = turn.game.limits
    level = choose(session.policy, situation, limits)
    if step.last is Outcome.WRONG:
        level = max(level, step.most)  # never less than what was not enough
    if limits.waits and step.last is Outcome.SILENCE and step.silent == 1:
        level = min(level, 1)
    if settings.errorless or step.attempt > settings.attempts:
        level = max(level, SHOWN_LEVEL)
    turn.change(consulted=True)
    give(turn, limits.clamp(level), why)


def learn_from(turn: Turn, outcome: Outcome) -> None:
    """Let the policy know what became of the attempt that it chose help for."""
    session = turn.session
    if session.consulted:
        policy = learn(session.policy, session.step.standing, outcome)
        turn.change(policy=policy, consulted=False)


def give(turn: Turn, level: int, why: str) -> None:
    """Help at `level`, which is within the limits; the note says with how much in truth."""
    session = turn.session
    found = hint_now(turn, level)
    turn.change(prompt_at=Milliseconds(session.now + patience(turn)))
    if found is None:
        no_way_on(turn)
        return
    given = level_of(found)
    _say(turn, found, why)
    step, tally = session.step, session.tally
    helped = given > 0
    turn.change(
        step=replace(
            step,
            level=given,
            most=max(step.most, given),
            standing=given or step.standing,
        ),
        tally=replace(tally, helps=tally.helps + helped, levels=tally.levels + given),
    )
    made = len(session.position.moves)
    turn.note(Note.HELP, level=given, step=made + 1, attempt=step.attempt, why=why)


def hint_now(turn: Turn, level: int) -> Hint | None:
    """The hint at `level`: about the same move, among the same tokens, for one whole step.

    Other decoys each time would give the right token away.
    """
    session, game = turn.session, turn.game
    chance = Chance(game.seed).split(len(session.position.moves))
    return hint(
        game.referee,
        session.position,
        level,
        game.settings.profile,
        chance,
        session.step.vetoed,
    )


def level_of(given: Hint) -> int:
    """How much a hint says."""
    match given:
        case YourTurn():
            return 0
        case Encouragement() | Reminder():
            return 1
        case InThisRow():
            return 2
        case OneOfThese():
            return 3
        case ThisMove(_, offered):
            return MAX_LEVEL if offered else SHOWN_LEVEL
        case _:
            assert_never(given)


def no_way_on(turn: Turn) -> None:
    """Nothing may be moved, and the exercise may not end: only the caregiver can help."""
    asked = turn.session.question
    turn.change(prompt_at=Milliseconds(turn.session.now + patience(turn)))
    turn.note(Note.NO_WAY_ON, step=len(turn.session.position.moves) + 1)
    turn.say(CoachKey.I_AM_HERE)
    if asked is None or asked[1] is not Matter.NO_WAY_ON:
        turn.ask(Matter.NO_WAY_ON, AskKey.NO_WAY_ON)


def patience(turn: Turn) -> Milliseconds:
    """How long to wait for the patient now; a human-centred robot waits longer each time."""
    settings = turn.game.settings
    if settings.persona is Persona.EXERCISE_CENTRED:
        return settings.patience
    stretches = min(turn.session.step.silent, MOST_STRETCHES)
    return Milliseconds(settings.patience * (2 + stretches) // 2)


def stir(turn: Turn) -> None:
    """The patient is at it: patience begins anew."""
    if turn.session.prompt_at is not None:
        turn.change(prompt_at=Milliseconds(turn.session.now + patience(turn)))


def silence(turn: Turn) -> None:
    """Nobody has moved for as long as the patience lasts: prompt."""
    learn_from(turn, Outcome.SILENCE)
    step, tally = turn.session.step, turn.session.tally
    step = replace(step, attempt=step.attempt + 1, silent=step.silent + 1, last=Outcome.SILENCE)
    turn.change(step=step, tally=replace(tally, silences=tally.silences + 1))
    made = len(turn.session.position.moves)
    turn.note(Note.SILENCE, step=made + 1, attempt=step.attempt - 1)
    consult(turn, SILENCE)
    if step.silent == LONG_SILENCE:
        turn.ask(Matter.LONG_SILENCE, AskKey.LONG_SILENCE)


def more(turn: Turn) -> None:
    """The patient asks: one level more than last time, at least encouragement."""
    if turn.session.asked_move is not None:
        turn.say(CoachKey.I_AM_HERE)
        return
    level = turn.game.limits.clamp(turn.session.step.level + 1)
    give(turn, level, ASKED)


def _say(turn: Turn, found: Hint, why: str) -> None:
    match found:
        case YourTurn():
            if why != POLICY or not turn.session.position.moves:
                turn.say(CoachKey.YOUR_TURN)
            turn.look(())
            turn.show(View.YOUR_TURN)
        case Encouragement():
            turn.say(CoachKey.ENCOURAGE)
            turn.gesture(GestureName.NOD)
        case Reminder(rules):
            rule, chance = turn.session.voice.chance.pick(rules)
            turn.draw_with(chance)
            turn.say(CoachKey.REMIND, rule=rule)
        case InThisRow(row, cells):
            turn.say(CoachKey.LOOK_AT_ROW, row=InRow(row))
            turn.look(cells)
        case OneOfThese(tokens):
            turn.say(CoachKey.ONE_OF_THESE, tokens=turn.listed(tokens, Joint.OR))
            turn.point(turn.session.position.now.cells[token] for token in tokens)
        case ThisMove(_, offered):
            turn.express(Expression.CARING)
            _show_move(turn, found, offered=offered)
        case _:
            assert_never(found)


def _show_move(turn: Turn, found: ThisMove, *, offered: bool) -> None:
    move, session = found.move, turn.session
    parts: dict[str, Phrase] = {"token": turn.named(move.token), "place": Place(move.destination)}
    lies_there = session.table.cells.get(move.token) == move.origin
    if offered and turn.game.settings.robot_moves and session.robot_able and lies_there:
        number = turn.number()
        turn.say(CoachKey.I_PLACE, **parts)
        turn.command(MoveToken(number, move.token, move.origin, move.destination))
        turn.change(asked_move=AskedMove(move, number, skips=False))
        return
    turn.say(CoachKey.TOGETHER if offered else CoachKey.THIS_ONE, **parts)
    if offered:
        turn.gesture(GestureName.OFFER)
    turn.point((move.origin, move.destination))

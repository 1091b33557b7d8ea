"""The guided session as a state machine: what was typed in, what to say and show out.

Pure: no terminal, no clock; chance comes in as a number with every line typed.
"""

from dataclasses import dataclass, replace
from random import Random
from typing import Final, TypeAlias, assert_never

from maestra.cli.demo_accompanying import EXAMPLE, NICKNAME, accompanied
from maestra.cli.demo_asking import answered, asked, replied
from maestra.cli.demo_stages import (
    SUBJECTS,
    Accompanying,
    Asking,
    Choosing,
    Ended,
    Playing,
    Stage,
    Subject,
    Taught,
    Teaching,
)
from maestra.cli.demo_table import Table
from maestra.cli.demo_telling import moves_of, new_rules, understood
from maestra.cli.demo_words import (
    Command,
    Unclear,
    Wish,
    Word,
    accompany_typed,
    understand,
)
from maestra.cli.drawing import label
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Drawn, Output, Said, Tone
from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck
from maestra.language import reason
from maestra.language.terminal import TerminalKey as Key
from maestra.learning.dialogue import Finished
from maestra.rules.position import Position
from maestra.rules.verdicts import JudgedMove

MAX_AT_ONCE: Final = 30
"""Right plays that Maestra shows for one request."""
STARTS_TRIED: Final = 20
"""Arrangements looked at for one from which some move is right."""

Step: TypeAlias = tuple[Stage, tuple[Output, ...]]
"""The next stage, and what to say and show now."""


def begin(speech: Speech, *, by_few: bool = False) -> Step:
    """The first stage; `by_few` says how to learn."""
    welcome = Said(speech.say(Key.WELCOME), Tone.HEADING)
    return Choosing(by_few), (welcome, *_menu(speech))


def step(stage: Stage, line: str, chance: int, speech: Speech) -> Step:
    """The stage after `line` was typed.

    Args:
        stage: the stage before.
        line: what was typed.
        chance: any number; the same one makes the same session.
        speech: the language.
    """
    if not line.strip():
        return stage, ()
    wanted = accompany_typed(line, speech.language)
    if wanted is not None and isinstance(stage, Choosing | Teaching | Playing):
        return accompanied(stage, wanted, speech)
    match stage:
        case Choosing():
            return _choose(stage, line, chance, speech)
        case Teaching():
            return _Teacher(stage, _dealer(chance), speech).step(line)
        case Asking():
            return _reply(stage, line, chance, speech)
        case Playing():
            return _Player(stage, _dealer(chance), speech).step(line)
        case Accompanying() | Ended():
            return stage, ()
        case _:
            assert_never(stage)


def come_back(stage: Accompanying, speech: Speech) -> Step:
    """The stage from which somebody was accompanied, after that session."""
    match stage.back:
        case Choosing() as back:
            return back, _menu(speech)
        case Teaching() | Playing() as back:
            return back, (Drawn(back.state, back.taught.subject.deck),)


def end(speech: Speech) -> Step:
    """The last stage: nothing more is typed."""
    return Ended(), (Said(speech.say(Key.GOODBYE)),)


def _dealer(chance: int) -> Random:
    return Random(chance)  # noqa: S311 - it deals tokens


def _menu(speech: Speech) -> tuple[Output, ...]:
    titles = [
        Said(f"  {number}  {speech.say(subject.title)}")
        for number, subject in enumerate(SUBJECTS, start=1)
    ]
    accompany = speech.say(Key.TYPE_ACCOMPANY)
    how = [
        Said(speech.say(Key.HOW_TO_TEACH, number=EXAMPLE)),
        Said(speech.say(Key.HOW_TO_ACCOMPANY, accompany=accompany, number=EXAMPLE)),
    ]
    return (Said(speech.say(Key.WHICH_EXERCISE)), *titles, *how)


def _choose(stage: Choosing, line: str, chance: int, speech: Speech) -> Step:
    match understand(line, speech.language):
        case Command(Word.QUIT):
            return end(speech)
        case Command(Word.HELP):
            return stage, (_help_choosing(speech),)
        case Command(Word.MENU):
            return stage, _menu(speech)
        case Wish(number, None) if number.isdecimal() and 1 <= int(number) <= len(SUBJECTS):
            subject = SUBJECTS[int(number) - 1]
            return _teach(Taught(subject, by_few=stage.by_few), _dealer(chance), speech)
        case _:
            return stage, (Said(speech.say(Key.PLEASE_CHOOSE, last=len(SUBJECTS))),)


def _teach(taught: Taught, chance: Random, speech: Speech) -> Step:
    """Begin to teach, or go on with it."""
    subject = taught.subject
    stage = Teaching(taught, subject.start(chance))
    title = Said(speech.say(Key.TEACH, title=speech.say(subject.title)), Tone.HEADING)
    example = Said(speech.say(Key.HOW_TO_MOVE, token=_example(subject.deck)))
    how = [title, example]
    if subject.right is not None:
        how.append(Said(speech.say(Key.HOW_TO_SHOW, show=speech.say(Key.TYPE_SHOW))))
    return stage, (*how, _nth(taught, speech), Drawn(stage.start, subject.deck))


def _play(taught: Taught, chance: Random, speech: Speech) -> Step:
    """Begin to play, from an arrangement in which some move is right if there is one."""
    subject = taught.subject
    starts = (subject.start(chance) for _ in range(STARTS_TRIED))
    start = subject.start(chance)
    for start in starts:
        if any(taught.judge.allowed_moves(Position.begin(start))):
            break
    turn = Said(speech.say(Key.YOUR_TURN), Tone.HEADING)
    return Playing(taught, Position.begin(start)), (turn, Drawn(start, subject.deck))


def _reply(stage: Asking, line: str, chance: int, speech: Speech) -> Step:
    """A reply to what is asked, or away from here."""
    match understand(line, speech.language):
        case Command(Word.QUIT):
            return end(speech)
        case Command(Word.MENU):
            return Choosing(stage.taught.by_few), _menu(speech)
        case _:
            return _ask(*replied(stage, line, speech), _dealer(chance), speech)


def _ask(asking: Asking, outputs: tuple[Output, ...], chance: Random, speech: Speech) -> Step:
    """Ask on; when nothing more is asked, play by what is known then."""
    if not isinstance(asking.dialogue.ask, Finished):
        return asking, outputs
    taught = answered(asking)
    step = _play if taught.shown else _teach
    stage, begun = step(taught, chance, speech)
    return stage, (*outputs, *begun)


def _nth(taught: Taught, speech: Speech) -> Said:
    number = len(taught.shown) + 1
    return Said(speech.say(Key.NTH_DEMONSTRATION, number=number), Tone.HEADING)


def _example(deck: Deck) -> str:
    return label(deck.tokens[0])


@dataclass(frozen=True, slots=True)
class _Teacher:
    """The user shows how it goes."""

    stage: Teaching
    chance: Random
    speech: Speech

    @property
    def taught(self) -> Taught:
        """What was shown before."""
        return self.stage.taught

    def step(self, line: str) -> Step:
        """The stage after `line`."""
        match understand(line, self.speech.language):
            case Command(word, count):
                return self._obey(word, count)
            case Wish() as wish:
                return self._move(wish)
            case Unclear():
                return self._stay(_unknown(self.speech))

    def _obey(self, word: Word, count: int) -> Step:
        match word:
            case Word.UNDO:
                return self._undo()
            case Word.DONE:
                return self.done()
            case Word.SHOW:
                return self._show(count)
            case Word.PLAY:
                return self._play()
            case Word.HELP:
                return self._stay(_help(Key.HELP_TEACHING, self.taught.subject, self.speech))
            case Word.MENU:
                return Choosing(self.taught.by_few), _menu(self.speech)
            case Word.QUIT:
                return end(self.speech)
            case Word.TEACH | Word.HINT:
                return self._stay(_unknown(self.speech))

    def _play(self) -> Step:
        """Try it, once what is not clear was asked."""
        if not self.taught.shown:
            return self._stay(Said(self.speech.say(Key.NOTHING_SHOWN)))
        if not self.taught.by_few:
            return _play(self.taught, self.chance, self.speech)
        asking = Asking(self.taught, self.taught.dialogue)
        return _ask(asking, asked(asking, self.speech), self.chance, self.speech)

    def _stay(self, *said: Said) -> Step:
        return self.stage, said

    def _move(self, wish: Wish) -> Step:
        deck = self.taught.subject.deck
        move = Table(self.stage.state, deck, self.speech).move(wish)
        if isinstance(move, Said):
            return self._stay(move)
        stage = replace(self.stage, moves=(*self.stage.moves, move))
        drawn = Drawn(stage.state, deck)
        if any(cell not in stage.state.tokens for cell in stage.state.board.goal_cells):
            return stage, (drawn,)
        after, outputs = _Teacher(stage, self.chance, self.speech).done()
        return after, (drawn, *outputs)

    def _undo(self) -> Step:
        if not self.stage.moves:
            return self._stay(Said(self.speech.say(Key.NOTHING_TO_UNDO)))
        stage = replace(self.stage, moves=self.stage.moves[:-1])
        return stage, (Drawn(stage.state, self.taught.subject.deck),)

    def done(self) -> Step:
        """The stage after this demonstration, which is over."""
        if not self.stage.moves:
            return self._stay(Said(self.speech.say(Key.NOTHING_MOVED)))
        subject = self.taught.subject
        shown = Demonstration(subject.deck, self.stage.start, self.stage.moves)
        return self._learned((shown,), ())

    def _show(self, count: int) -> Step:
        subject = self.taught.subject
        if subject.right is None:
            return self._stay(Said(self.speech.say(Key.CANNOT_SHOW)))
        taught = self.taught
        outputs: list[Output] = []
        for number in range(min(count, MAX_AT_ONCE)):
            play = subject.right_play(taught.shown, self.chance)
            if number:
                outputs.append(_nth(taught, self.speech))
            outputs += moves_of(play, self.speech, one_by_one=count == 1)
            before, taught = taught, taught.with_shown(play)
            if number + 1 < min(count, MAX_AT_ONCE):
                outputs += new_rules(before, taught, self.speech)
        return self._learned(taught.shown[len(self.taught.shown) :], tuple(outputs))

    def _learned(self, shown: tuple[Demonstration, ...], outputs: tuple[Output, ...]) -> Step:
        """What is understood after `shown`, and the board for the next demonstration."""
        taught = self.taught.with_shown(*shown)
        stage = Teaching(taught, taught.subject.start(self.chance))
        before = replace(taught, shown=taught.shown[:-1])
        typed = {"play": Key.TYPE_PLAY, "accompany": Key.TYPE_ACCOMPANY}
        words = {name: self.speech.say(key) for name, key in typed.items()}
        return stage, (
            *outputs,
            *understood(before, taught, self.speech),
            Said(self.speech.say(Key.NEXT_STEP, **words), Tone.ASIDE),
            _nth(taught, self.speech),
            Drawn(stage.start, taught.subject.deck),
        )


@dataclass(frozen=True, slots=True)
class _Player:
    """The user plays."""

    stage: Playing
    chance: Random
    speech: Speech

    @property
    def taught(self) -> Taught:
        """What the moves are judged by."""
        return self.stage.taught

    def step(self, line: str) -> Step:
        """The stage after `line`."""
        match understand(line, self.speech.language):
            case Command(word):
                return self._obey(word)
            case Wish() as wish:
                return self._move(wish)
            case Unclear():
                return self.stage, (_unknown(self.speech),)

    def _obey(self, word: Word) -> Step:
        match word:
            case Word.HINT:
                return self.stage, (self._hint(),)
            case Word.DONE:
                return self.done()
            case Word.PLAY:
                return _play(self.taught, self.chance, self.speech)
            case Word.TEACH:
                return _teach(self.taught, self.chance, self.speech)
            case Word.HELP:
                text = _help(Key.HELP_PLAYING, self.taught.subject, self.speech)
                return self.stage, (text,)
            case Word.MENU:
                return Choosing(self.taught.by_few), _menu(self.speech)
            case Word.QUIT:
                return end(self.speech)
            case Word.UNDO | Word.SHOW:
                return self.stage, (_unknown(self.speech),)

    def _move(self, wish: Wish) -> Step:
        stage, judge = self.stage, self.taught.judge
        move = Table(stage.state, self.taught.subject.deck, self.speech).move(wish)
        if isinstance(move, Said):
            return stage, (move,)
        judged = JudgedMove(stage.state, move, judge.verdict(stage.position, move))
        if judged.is_refused:
            return stage, self._refusal(judged)
        after = replace(stage, position=stage.position.after(move))
        right = Said(self.speech.say(Key.RIGHT), Tone.GOOD)
        drawn = Drawn(after.state, self.taught.subject.deck)
        if any(judge.allowed_moves(after.position)):
            return after, (drawn, right)
        return _Player(after, self.chance, self.speech).complete((drawn, right))

    def _refusal(self, judged: JudgedMove) -> tuple[Output, ...]:
        deck = self.taught.subject.deck
        token = label(deck.by_id[judged.move.token])
        speech = self.speech
        why = reason(judged, self.taught.account, deck, speech.language, speech.words)
        return (
            Said(why, Tone.WRONG),
            Said(speech.say(Key.PUT_BACK, token=token)),
            Drawn(judged.before, deck),
        )

    def done(self) -> Step:
        """The stage after the play, which the user thinks is over."""
        if not self.taught.judge.may_end(self.stage.position):
            return self.stage, (Said(self.speech.say(Key.NOT_YET)),)
        return self.complete(())

    def complete(self, outputs: tuple[Output, ...]) -> Step:
        """The stage after a whole play: praise, and a new arrangement."""
        stage, begun = _play(self.taught, self.chance, self.speech)
        return stage, (*outputs, Said(self.speech.say(Key.COMPLETE), Tone.GOOD), *begun)

    def _hint(self) -> Said:
        moves = self.taught.judge.allowed_moves(self.stage.position)
        move = min(moves, key=lambda one: (one.destination, one.origin), default=None)
        if move is None:
            return Said(self.speech.say(Key.NO_HINT, teach=self.speech.say(Key.TYPE_TEACH)))
        token = label(self.taught.subject.deck.by_id[move.token])
        return Said(self.speech.say(Key.HINT, token=token, column=move.destination.column))


def _unknown(speech: Speech) -> Said:
    return Said(speech.say(Key.UNKNOWN_COMMAND, help=speech.say(Key.TYPE_HELP)))


def _help(key: Key, subject: Subject, speech: Speech) -> Said:
    typed = {word.name.lower(): speech.say(word.value) for word in Word}
    typed["accompany"] = speech.say(Key.TYPE_ACCOMPANY)
    return Said(speech.say(key, token=_example(subject.deck), **typed))


def _help_choosing(speech: Speech) -> Said:
    typed = {"quit": Key.TYPE_QUIT, "accompany": Key.TYPE_ACCOMPANY}
    words = {name: speech.say(key) for name, key in typed.items()}
    return Said(speech.say(Key.HELP_CHOOSING, number=EXAMPLE, patient=NICKNAME, **words))

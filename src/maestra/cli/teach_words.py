"""What a person types in answer to what is asked while teaching."""

from collections.abc import Sequence

from maestra.cli.drawing import label
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move
from maestra.core.text import without_accents
from maestra.language import Language
from maestra.language.teaching import Teacher, typed_words
from maestra.language.teaching_keys import TeachKey as Key
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    CellIsWrong,
    Counts,
    Dialogue,
    Enough,
    Event,
    Finished,
    Replied,
    Side,
    SlipReplied,
    SlipReply,
)
from maestra.rules.answers import Reply, RowQuestion

_REPLIES = {Key.TYPE_YES: Reply.YES, Key.TYPE_NO: Reply.NO, Key.TYPE_UNSURE: Reply.UNSURE}
_MENDING = {Key.TYPE_YES: SlipReply.CONFIRMED, Key.TYPE_NO: SlipReply.TAKEN_BACK}
_SIDES = {"1": Side.EARLIER, "2": Side.LATER}


def word_typed(line: str, keys: Sequence[Key], language: Language) -> Key | None:
    """Which of these words was typed, in `language` or in English, or just its beginning."""
    typed = _plain(line)
    if not typed:
        return None
    for tongue in dict.fromkeys((language, Language.EN)):
        words = {key: _plain(typed_words(key, tongue)) for key in keys}
        found = [key for key, word in words.items() if word == typed]
        found = found or [key for key, word in words.items() if word.startswith(typed)]
        if len(found) == 1:
            return found[0]
    return None


def event_typed(line: str, dialogue: Dialogue, teacher: Teacher) -> Event | None:
    """What was replied; None when it is not understood."""
    keys: list[Key] = [Key.TYPE_ENOUGH]
    match dialogue.ask:
        case AskQuestion() | AskAgain():
            keys += _REPLIES
        case AskCell(number):
            cell = _cell_typed(line, dialogue, number)
            if cell is not None:
                return CellIsWrong(cell)
            keys.append(Key.TYPE_UNSURE)
        case AskSlip():
            keys += _MENDING
        case AskWhichCounts():
            side = _SIDES.get(line.strip())
            if side is not None:
                return Counts(side)
            keys.append(Key.TYPE_NEITHER)
        case Finished():
            return None
    return _event(word_typed(line, keys, teacher.language), dialogue)


def _event(key: Key | None, dialogue: Dialogue) -> Event | None:
    match key:
        case None:
            return None
        case Key.TYPE_ENOUGH:
            return Enough()
        case Key.TYPE_NEITHER:
            return Counts(Side.NEITHER)
        case _ if isinstance(dialogue.ask, AskSlip):
            return SlipReplied(_MENDING[key])
        case _ if isinstance(dialogue.ask, AskCell):
            return CellIsWrong(None)
        case _:
            return Replied(_REPLIES[key])


def row_typed(line: str, like: Demonstration) -> Demonstration | str | None:
    """A demonstration from the same start, by its tokens from left to right.

    Returns:
        the demonstration; the name of a token that is not there or not free; None when there
        are none or too many.
    """
    names = line.replace(",", " ").split()
    free = [cell for cell in like.board.goal_cells if cell not in like.start.tokens]
    stored = {
        _plain(label(token)): token.id
        for token in like.deck.tokens
        if like.start.cells[token.id].row != like.board.goal_row
    }
    if not 0 < len(names) <= len(free):
        return None
    moves: list[Move] = []
    for name, cell in zip(names, free, strict=False):
        token = stored.pop(_plain(name), None)
        if token is None:
            return name
        moves.append(Move(token, like.start.cells[token], cell))
    return Demonstration(like.deck, like.start, tuple(moves))


def _cell_typed(line: str, dialogue: Dialogue, number: int) -> int | None:
    """The goal cell of the token that was typed."""
    question = dialogue.answers[number].question
    if not isinstance(question, RowQuestion):
        return None
    tokens = question.play.setting.deck.tokens
    names = [None if t is None else _plain(label(tokens[t])) for t in question.play.row]
    typed = _plain(line)
    return names.index(typed) if typed in names else None


def _plain(text: str) -> str:
    """Small letters without accents."""
    return without_accents(text.casefold().strip())

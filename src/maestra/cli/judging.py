"""`maestra judge` and `maestra moves`: one line of JSON for each line read, as it is read."""

import sys
from collections.abc import Iterator
from dataclasses import dataclass

import typer

from maestra.cli.faults_at import at_line
from maestra.cli.loading import exercise_in, plays_in, words_in
from maestra.cli.streams import named, print_json, progress, size_of
from maestra.cli.terms import THE_ANSWER_IS_NO
from maestra.core.board import Cell
from maestra.core.formats import encode_move
from maestra.core.state import Move
from maestra.language import Language, Lexicon, reason
from maestra.rules.account import Account, account_of, broken_ids
from maestra.rules.exercise import Exercise
from maestra.rules.judging import Judge
from maestra.rules.position import Position
from maestra.rules.verdicts import JudgedMove, NotKnown


@dataclass(frozen=True, slots=True)
class JudgedPlay:
    """A line of a file of plays, and what is to be said of its moves."""

    judge: Judge
    moves: tuple[JudgedMove, ...]
    end: Position
    """Once every refused move is put back."""

    @property
    def refused(self) -> tuple[int, ...]:
        """Which moves were refused, counted from 1."""
        return tuple(number for number, one in enumerate(self.moves, start=1) if one.is_refused)

    @property
    def complete(self) -> bool:
        """Whether the exercise may end here."""
        return self.judge.may_end(self.end)


def judge(exercise_file: str, plays_file: str, language: str, words_file: str | None) -> None:
    """Print a judgement of each play; exit 1 if any has a refused move."""
    exercise, words = exercise_in(exercise_file), words_in(words_file)
    account, tongue = account_of(exercise), Language(language)
    any_refused = False
    for play in _judged(exercise, plays_file, "Judging"):
        any_refused = any_refused or bool(play.refused)
        print_json(judgement(play, account, tongue, words))
    _exit_if(any_refused)


def moves(exercise_file: str, positions_file: str) -> None:
    """Print the right moves in each position; exit 1 if any holds a refused move."""
    exercise = exercise_in(exercise_file)
    any_refused = False
    for position in _judged(exercise, positions_file, "Looking for moves"):
        allowed = position.judge.allowed_moves(position.end)
        answer: dict[str, object] = {
            "allowed": [encode_move(move) for move in sorted(allowed, key=_by_cells)],
            "complete": position.complete,
        }
        if position.refused:
            any_refused = True
            answer["refused"] = list(position.refused)
        print_json(answer)
    _exit_if(any_refused)


def judgement(
    play: JudgedPlay, account: Account, language: Language, words: Lexicon
) -> dict[str, object]:
    """What is to be said of a play, as `maestra judge` prints it."""
    deck = play.judge.deck
    return {
        "moves": [
            {
                "verdict": "refused" if one.is_refused else "allowed",
                "certainty": "certain" if one.is_certain else "probable",
                "broken": list(broken_ids(one, account, deck)),
                "reason": reason(one, account, deck, language, words),
                **({"ask": True} if isinstance(one.verdict, NotKnown) else {}),
            }
            for one in play.moves
        ],
        "complete": play.complete,
    }


def _judged(exercise: Exercise, file: str, task: str) -> Iterator[JudgedPlay]:
    """Each play of a file, judged; those with one deck share a judge, which learns as it goes."""
    latest: Judge | None = None
    # Where both go to one terminal, a bar would run through the answers.
    apart = not sys.stdout.isatty()
    with progress(task, size_of(file), wanted=apart) as advance:
        for number, play in plays_in(file, advance):
            with at_line(named(file), number):
                if latest is None or latest.deck != play.deck:
                    latest = Judge(exercise, play.deck)
                yield JudgedPlay(latest, *latest.read(play.start, play.moves))


def _by_cells(move: Move) -> tuple[Cell, Cell]:
    return move.origin, move.destination


def _exit_if(any_refused: bool) -> None:
    if any_refused:
        raise typer.Exit(THE_ANSWER_IS_NO)

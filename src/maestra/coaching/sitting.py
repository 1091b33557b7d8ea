"""A patient sits down to a session and rises again: dealt, kept in the record, remembered.

Pure but for the store, a port: whoever has a clock and a seed passes them in.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from maestra.coaching.chance import Chance
from maestra.coaching.difficulty import deal
from maestra.coaching.ports import PatientId, SessionId, Store, StoredSession
from maestra.coaching.recording import Start
from maestra.coaching.remembered import Remembered, read_remembered, write_remembered
from maestra.coaching.session import Session
from maestra.coaching.settings import Settings
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.rules.exercise import Exercise, RuledExercise
from maestra.rules.judging import Judge
from maestra.rules.position import Position

DEALS_TRIED: Final = 200
"""Arrangements looked at for one from which some move is right."""


@dataclass(frozen=True, slots=True)
class Chosen:
    """What is to be played: an exercise that the store has."""

    name: str
    version: int
    exercise: Exercise
    words: str | None = None
    """A caregiver's own, the text of a file of words."""


@dataclass(frozen=True, slots=True)
class Sitting:
    """A session as the store knows it, and all that it follows from."""

    stored: StoredSession
    start: Start

    def keep(self, store: Store) -> None:
        """Have the store know the session, and the settings as they are from now on.

        Raises:
            OSError: it cannot be kept.
        """
        store.save_settings(self.stored.patient, self.stored.settings)
        store.save_session(self.stored)


def known_patient(store: Store, patient: PatientId) -> Remembered:
    """What the store has kept of a patient.

    Raises:
        KeyError: nothing.
        FormatError: something else.
    """
    return read_remembered(store.settings(patient).encode(), f"settings of {patient}")


def sit_down(
    session: SessionId,
    patient: PatientId,
    chosen: Chosen,
    known: Remembered,
    *,
    seed: int,
    utc: str,
) -> Sitting:
    """A session about to begin, its tokens dealt.

    Args:
        session: its id, unique in the store.
        patient: who plays.
        chosen: what is played.
        known: the patient, as the coach is to know them from now on.
        seed: decides everything that is left to chance.
        utc: the time of day.

    Raises:
        InvalidError: the exercise cannot be played on its board.
    """
    settings = known.settings
    deck, state = laid_out(chosen.exercise, settings, Chance(seed))
    policy, words = known.best_policy, chosen.words
    start = Start(chosen.exercise, deck, state, settings, seed, policy, patient, words)
    written = write_remembered(known)
    stored = StoredSession(session, patient, chosen.name, chosen.version, written, utc)
    return Sitting(stored, start)


def rise(store: Store, stored: StoredSession, session: Session, utc: str) -> None:
    """Keep that the session has ended, and what was learned of the patient.

    Doing it again, after a power cut say, changes nothing more. What the caregiver has set
    otherwise meanwhile stays so.

    Raises:
        OSError: it cannot be kept.
    """
    knew = read_remembered(stored.settings.encode(), "settings of the session")
    known = known_patient(store, stored.patient)
    if write_remembered(known) != write_remembered(knew.after(session)):
        store.save_settings(stored.patient, write_remembered(known.after(session)))
    store.save_session(replace(stored, ended_utc=utc))


def laid_out(exercise: Exercise, settings: Settings, chance: Chance) -> tuple[Deck, State]:
    """Tokens of the wanted difficulty where the rules fit others, in any arrangement.

    Drawn again where no move is right; of the paper's six exercises the fourth needs it most, for
    in one arrangement of twelve its first storage row is full.
    """
    deck, state, chance = _dealt(exercise, settings, chance)
    for _ in range(DEALS_TRIED):
        if any(Judge(exercise, deck).allowed_moves(Position.begin(state))):
            break
        deck, state, chance = _dealt(exercise, settings, chance)
    return deck, state


def _dealt(exercise: Exercise, settings: Settings, chance: Chance) -> tuple[Deck, State, Chance]:
    deck = exercise.deck
    if isinstance(exercise, RuledExercise):
        deck, chance = deal(deck, settings.difficulty, chance)
    cells, chance = chance.shuffled(exercise.board.storage_cells)
    ids = [token.id for token in deck.tokens]
    return deck, State(exercise.board, dict(zip(ids, cells, strict=False))), chance

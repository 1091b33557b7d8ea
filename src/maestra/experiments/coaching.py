"""Policies of assistance compared on simulated patients: every policy with every profile.

Each patient has several sessions one after another, and a policy that learns keeps what it
learned. All policies meet the same patients, who begin with the same seeds, so that differences
are the policies' own. The exercise is the paper's ascending one, taught by its twelve
demonstrations, from a new arrangement in each session. The errorless mode is off: it decides in
the policies' place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass, replace
from functools import cache
from math import sqrt
from pathlib import Path
from statistics import fmean, stdev
from typing import Final, TypeAlias, cast

from joblib import Parallel, delayed

from maestra import __version__
from maestra.coaching.chance import Chance
from maestra.coaching.patients import patient_of
from maestra.coaching.policies import Policy
from maestra.coaching.referee import ExerciseReferee
from maestra.coaching.session import Ending, Game
from maestra.coaching.settings import Mental, PolicyName, Profile, Settings, settings_for
from maestra.coaching.simulation import Simulation
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.core.state import State
from maestra.experiments.results import Record, ResultsFile, open_results
from maestra.experiments.shares import Z_95, Share
from maestra.language import Language
from maestra.learning.grounded import learn_grounded
from maestra.learning.teaching_sets import teaching_set
from maestra.rules.paper import PAPER_EXERCISES

SESSIONS_EACH: Final = 10
"""Of one patient, one after another."""
POLICIES: Final = (
    *(f"fixed-{level}" for level in range(6)),
    "ladder",
    "adaptive",
)
MOST_HELPFUL: Final = "fixed-5"
LEAST_SAVING: Final = 0.3
"""Assistance that the adaptive policy is to save against the most helpful one."""
DIGITS: Final = 3


@dataclass(frozen=True, slots=True)
class Sat:
    """One session, in numbers."""

    complete: bool
    errors: int
    levels: int
    """The assistance given: the sum of the levels of all hints."""
    moves: int
    first_time: int
    silences: int
    ms: int


@dataclass(frozen=True, slots=True)
class Mean:
    """A mean with its 95 % interval: normal, over patients, for their sessions hang together."""

    value: float
    low: float
    high: float

    @classmethod
    def of(cls, values: Sequence[float]) -> Mean:
        """Of one number a patient."""
        value = fmean(values)
        spread = Z_95 * stdev(values) / sqrt(len(values)) if len(values) > 1 else 0.0
        return cls(*(round(each, DIGITS) for each in (value, value - spread, value + spread)))


@dataclass(frozen=True, slots=True)
class PolicyRow:
    """A policy with the patients of one profile."""

    profile: str
    policy: str
    sessions: int
    complete: Share
    assistance: Mean
    """A session."""
    errors: Mean
    minutes: Mean
    first_time: Share
    """Own moves that were right at the first attempt."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """The adaptive policy against the most helpful fixed one, over the same patients."""

    profile: str
    completed_more: Mean
    """Its share of completed sessions less the other's; above 0 it completes more."""
    saved: Mean
    """The share of assistance that it saves."""


Key: TypeAlias = tuple[str, str, int]
"""Profile, policy, and the patient's number."""
Runs: TypeAlias = Mapping[Key, tuple[Sat, ...]]


def coaching_runs(
    patients: int,
    seed: int,
    jobs: int,
    results: Path | None = None,
    advance: Callable[[int], None] = lambda _more: None,
) -> Runs:
    """The sessions of each profile, policy and patient; those in the file `results` not again.

    Args:
        patients: of each profile; each has `SESSIONS_EACH` sessions with each policy.
        seed: decides who the patients are, and everything else.
        jobs: processes; -1 for one on each core.
        results: where each finished patient is kept; None keeps none.
        advance: called with the number of patients that are done since the last call.

    Raises:
        FormatError: the file holds something else, or results of other settings.
        OSError: it cannot be read or written.
    """
    with ExitStack() as stack:
        kept = (
            None if results is None else stack.enter_context(open_results(results, header(seed)))
        )
        done = _kept(kept, results)
        wanted = [
            (mental.value, policy, number)
            for number in range(1, patients + 1)
            for mental in Mental
            for policy in POLICIES
        ]
        advance(sum(key in done for key in wanted))
        missing = [key for key in wanted if key not in done]
        for key, sessions in _in_parallel(missing, seed, jobs):
            done[key] = sessions
            if kept is not None:
                kept.add(_record(key, sessions))
            advance(1)
    return {key: done[key] for key in wanted}


def patient_sessions(profile: str, policy: str, number: int, seed: int) -> tuple[Sat, ...]:
    """The sessions of one patient with one policy."""
    chance = Chance(seed).split(number)
    who = Profile(Mental(profile))
    settings = _settings(who, policy)
    patient = patient_of(who, chance)
    referee = _referee()
    known: Policy | None = None
    sat: list[Sat] = []
    for session in range(SESSIONS_EACH):
        own = chance.split(session)
        board, ids = referee.speaker.board, [token.id for token in referee.deck.tokens]
        cells, own = own.shuffled(board.storage_cells)
        start = State(board, dict(zip(ids, cells, strict=False)))
        coach, own = own.word()
        played = Simulation(
            Game(referee, settings, start, coach), patient, own.state, known
        ).play()
        known = played.session.policy
        tally = played.session.tally
        sat.append(
            Sat(
                played.session.ending is Ending.COMPLETE,
                tally.errors,
                tally.levels,
                tally.moves,
                tally.first_time,
                tally.silences,
                played.session.now,
            )
        )
    return tuple(sat)


def policy_rows(runs: Runs) -> tuple[PolicyRow, ...]:
    """A row for each profile and policy."""
    rows: list[PolicyRow] = []
    for profile, policy in dict.fromkeys(key[:2] for key in runs):
        mine = [sat for key, sat in runs.items() if key[:2] == (profile, policy)]
        every = [one for sat in mine for one in sat]
        own = [one for one in every for _ in range(one.moves)]
        first = sum(one.first_time for one in every)
        rows.append(
            PolicyRow(
                profile,
                policy,
                len(every),
                Share.of_all(one.complete for one in every),
                Mean.of([fmean(one.levels for one in sat) for sat in mine]),
                Mean.of([fmean(one.errors for one in sat) for sat in mine]),
                Mean.of([fmean(one.ms / 60_000 for one in sat) for sat in mine]),
                Share.of_all(number < first for number in range(len(own))),
            )
        )
    return tuple(rows)


def comparisons(runs: Runs) -> tuple[Comparison, ...]:
    """For each profile, and for all together, what adaptive does against the most helpful."""
    everybody = "all"
    pairs: dict[str, list[tuple[tuple[Sat, ...], tuple[Sat, ...]]]] = {}
    for (profile, policy, number), sat in runs.items():
        if policy == "adaptive":
            pair = sat, runs[profile, MOST_HELPFUL, number]
            pairs.setdefault(profile, []).append(pair)
            pairs.setdefault(everybody, []).append(pair)
    return tuple(
        Comparison(
            profile,
            Mean.of([_completed(ours) - _completed(theirs) for ours, theirs in mine]),
            Mean.of([1 - _assisted(ours) / _assisted(theirs) for ours, theirs in mine]),
        )
        for profile, mine in sorted(pairs.items(), key=lambda one: one[0] == everybody)
    )


def coaching_json(seed: int, patients: int, runs: Runs) -> Record:
    """Everything as a JSON object."""
    return {
        **header(seed),
        "patients": patients,
        "rows": [asdict(row) for row in policy_rows(runs)],
        "comparisons": [asdict(one) for one in comparisons(runs)],
    }


def header(seed: int) -> Record:
    """What the results were measured with."""
    return {
        "experiment": "coaching",
        "seed": seed,
        "sessions_each": SESSIONS_EACH,
        "version": __version__,
        "command": f"maestra experiment coaching --seed {seed}",
    }


def _settings(profile: Profile, policy: str) -> Settings:
    usual = replace(settings_for(profile), errorless=False)
    name, _, level = policy.partition("-")
    chosen = PolicyName(name)
    return replace(usual, policy=chosen, level=int(level) if level else usual.level)


@cache
def _referee() -> ExerciseReferee:
    paper = PAPER_EXERCISES["ascending"]
    shown = teaching_set(paper.plays(), paper.vocabulary()).demonstrations
    exercise = learn_grounded(shown)
    return ExerciseReferee(exercise, exercise.deck, Language.EN)


def _completed(sat: Sequence[Sat]) -> float:
    return fmean(one.complete for one in sat)


def _assisted(sat: Sequence[Sat]) -> float:
    return fmean(one.levels for one in sat)


def _in_parallel(
    keys: Sequence[Key], seed: int, jobs: int
) -> Iterator[tuple[Key, tuple[Sat, ...]]]:
    work = (delayed(_with_key)(key, seed) for key in keys)
    if keys:
        parallel = Parallel(n_jobs=jobs, return_as="generator_unordered", batch_size=5)
        yield from cast("Iterator[tuple[Key, tuple[Sat, ...]]]", parallel(work))


def _with_key(key: Key, seed: int) -> tuple[Key, tuple[Sat, ...]]:
    return key, patient_sessions(*key, seed)


def _record(key: Key, sessions: Sequence[Sat]) -> Record:
    profile, policy, number = key
    columns = {name: [asdict(sat)[name] for sat in sessions] for name in Sat.__dataclass_fields__}
    return {"profile": profile, "policy": policy, "patient": number, **columns}


def _kept(kept: ResultsFile | None, path: Path | None) -> dict[Key, tuple[Sat, ...]]:
    """The patients of a file; a record that is none is refused with its line."""
    done: dict[Key, tuple[Sat, ...]] = {}
    for line, record in enumerate(kept.records if kept else [], start=2):
        columns = [record.get(name) for name in Sat.__dataclass_fields__]
        match record:
            case {"profile": str(profile), "policy": str(policy), "patient": int(number)} if all(
                isinstance(column, list) and len(cast("list[object]", column)) == SESSIONS_EACH
                for column in columns
            ):
                rows = zip(*cast("list[list[int]]", columns), strict=True)
                done[profile, policy, number] = tuple(Sat(bool(one), *more) for one, *more in rows)
            case _:
                raise FormatError(str(path), line, (Fault("", "no patient", "a finished one"),))
    return done

"""The tables that say how good the few-shot learner is, beside what was wanted of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from statistics import fmean
from types import MappingProxyType
from typing import Final, TypeAlias

from maestra.experiments.fewshot_findings import Finding
from maestra.experiments.fewshot_runs import DESIGNS, PAPERS, WRONG_ANSWERS, Part
from maestra.experiments.pages import Cell, PageTable, percent
from maestra.experiments.shares import Share
from maestra.rules.exercise import LearnStatus

WANTED: Final[Mapping[tuple[int, int], float]] = MappingProxyType(
    {
        (1, 0): 0.60,
        (2, 0): 0.80,
        (3, 0): 0.90,
        (1, 3): 0.92,
        (2, 3): 0.97,
        (3, 3): 0.99,
        (1, 5): 0.96,
        (2, 5): 0.99,
        (3, 5): 0.99,
    }
)
"""The share that is to be exact, by demonstrations and questions."""
EXACT_OF_LEARNED: Final = 0.95
WRONGLY_LEARNED_OUTSIDE: Final = 0.03
LOCATED: Final = 0.85
FALSE_ALARMS: Final = 0.02
PAPER_WANTED: Final[Mapping[int, float]] = MappingProxyType({0: 0.95, 3: 1.0})
"""The share of draws that is to be exact, by questions."""
CONFIDENCES: Final = (0.95, 0.97, 0.99, 0.999, 1.0)
"""The ends of the intervals of confidence that are told apart."""

Found: TypeAlias = Sequence[Finding]


def tables(found: Found) -> tuple[PageTable, ...]:
    """Each table that the findings have something for."""
    by_part = {part: [one for one in found if one.part is part] for part in Part}
    usual = by_part[Part.LANGUAGE]
    made: list[PageTable] = []
    if usual:
        made += [
            _exact(usual),
            _learned(usual),
            _grouped(usual, "families", "Family", lambda one: one.family),
            _grouped(usual, "persons", "Person", lambda one: one.person),
            _calibration(usual),
        ]
    if others := by_part[Part.ROWS_AND_MOVES]:
        title = "Asked only about rows and moves, against questions of all kinds"
        made.append(_compared(others, usual, "kinds", title, "rows and moves"))
    if others := by_part[Part.WRONG_ANSWERS]:
        title = f"Answered wrongly {percent(WRONG_ANSWERS)} of the time, against always rightly"
        made.append(_compared(others, usual, "wrong-answers", title, "some answers wrong"))
    if outside := by_part[Part.OUTSIDE]:
        made.append(_outside(outside))
    slips = by_part[Part.SLIP]
    if slips or by_part[Part.NO_SLIP]:
        made.append(_slips(slips, by_part[Part.NO_SLIP]))
    if papers := [one for one in found if one.part in PAPERS]:
        made.append(_papers(papers))
    return tuple(made)


def _cells(found: Found) -> Iterator[tuple[tuple[int, int], list[Finding]]]:
    """The findings by demonstrations and questions."""
    keys = sorted({(one.demonstrations, one.questions) for one in found})
    for key in keys:
        yield key, [one for one in found if (one.demonstrations, one.questions) == key]


def _samples(found: Found) -> str:
    """How many samples there are, and their seeds."""
    seeds = {one.seed for one in found}
    return f"{len(seeds)} exercises, seeds {min(seeds)} to {max(seeds)}"


def _share(found: Found, so: Callable[[Finding], bool]) -> Share:
    return Share.of_all(so(one) for one in found)


def _is_exact(one: Finding) -> bool:
    return one.exact


def _is_learned(one: Finding) -> bool:
    return one.learned


def _is_wrongly_learned(one: Finding) -> bool:
    return one.learned and not one.exact


def _missed(share: Share, wanted: float) -> str:
    """By how many points, if at all."""
    if not share.of:
        return "-"
    short = 100 * (wanted - share.count / share.of)
    return f"{short:.1f}" if short > 0 else "reached"


def _asked(found: Found) -> str:
    return f"{fmean(one.asked for one in found):.1f}"


def _exact(found: Found) -> PageTable:
    rows: list[tuple[Cell, ...]] = []
    for (shown, asked), here in _cells(found):
        exact = _share(here, _is_exact)
        wanted = WANTED[shown, asked]
        rows.append(
            (
                str(shown),
                str(asked),
                _asked(here),
                exact,
                _share(here, lambda one: one.exact_on_new_decks),
                percent(wanted),
                _missed(exact, wanted),
            )
        )
    return PageTable(
        "exact",
        f"Exact, in percent with 95 % intervals ({_samples(found)})",
        (
            "Demonstrations",
            "Questions at most",
            "asked",
            "Exact on fresh boards",
            "on new decks",
            "Wanted",
            "Missed by",
        ),
        tuple(rows),
    )


def _learned(found: Found) -> PageTable:
    rows: list[tuple[Cell, ...]] = []
    for (shown, asked), here in _cells(found):
        exact = _share([one for one in here if one.learned], _is_exact)
        rows.append(
            (
                str(shown),
                str(asked),
                _share(here, _is_learned),
                exact,
                percent(EXACT_OF_LEARNED),
                _missed(exact, EXACT_OF_LEARNED),
                _share(here, _is_wrongly_learned),
            )
        )
    return PageTable(
        "learned",
        f"Called learned, in percent with 95 % intervals ({_samples(found)})",
        (
            "Demonstrations",
            "Questions at most",
            "Learned",
            "Of them exact",
            "Wanted",
            "Missed by",
            "Learned and not exact",
        ),
        tuple(rows),
    )


def _grouped(found: Found, name: str, what: str, group: Callable[[Finding], str]) -> PageTable:
    cells = list(_cells(found))
    rows: list[tuple[Cell, ...]] = []
    for value in dict.fromkeys(map(group, found)):
        shares = (_share([o for o in here if group(o) == value], _is_exact) for _, here in cells)
        of = len({one.seed for one in found if group(one) == value})
        rows.append((value, str(of), *shares))
    return PageTable(
        name,
        "Exact on fresh boards, in percent with 95 % intervals, after demonstrations + questions",
        (what, "Exercises", *(f"{shown} + {asked}" for (shown, asked), _ in cells)),
        tuple(rows),
    )


def _calibration(found: Found) -> PageTable:
    asked = sorted({one.questions for one in found})
    learned = [one for one in found if one.learned]
    rows: list[tuple[Cell, ...]] = []
    for low, high in pairwise(CONFIDENCES):
        last = high == CONFIDENCES[-1]
        row: list[Cell] = [f"{low:.3f} to {high:.3f}"]
        for questions in asked:
            here = [
                one
                for one in learned
                if one.questions == questions
                and (low <= one.confidence < high or (last and one.confidence == high))
            ]
            row += [str(len(here)), _share(here, _is_exact)]
        rows.append(tuple(row))
    return PageTable(
        "calibration",
        "Of what was called learned with so much confidence, how much is exact, in percent with "
        "95 % intervals; after any number of demonstrations",
        (
            "Confidence",
            *(h for q in asked for h in (f"{q} questions: learned", "of them exact")),
        ),
        tuple(rows),
    )


def _compared(others: Found, usual: Found, name: str, title: str, heading: str) -> PageTable:
    seeds = {one.seed for one in others}
    same = dict(_cells([one for one in usual if one.seed in seeds]))
    rows: list[tuple[Cell, ...]] = []
    for key, here in _cells(others):
        there = same.get(key, [])
        rows.append(
            (
                *map(str, key),
                _share(there, _is_exact),
                _asked(there) if there else "-",
                _share(here, _is_exact),
                _asked(here),
                _share(here, _is_wrongly_learned),
            )
        )
    return PageTable(
        name,
        f"{title}: exact on fresh boards, in percent with 95 % intervals ({_samples(others)})",
        (
            "Demonstrations",
            "Questions at most",
            "Usually",
            "asked",
            heading.capitalize(),
            "asked",
            "learned and not exact",
        ),
        tuple(rows),
    )


def _outside(found: Found) -> PageTable:
    rows: list[tuple[Cell, ...]] = []
    for (shown, asked), here in _cells(found):
        wrong = _share(here, _is_wrongly_learned)
        rows.append(
            (
                str(shown),
                str(asked),
                _share(here, lambda one: one.status is LearnStatus.OUTSIDE),
                _share(here, lambda one: one.status is LearnStatus.AMBIGUOUS),
                wrong,
                f"at most {percent(WRONGLY_LEARNED_OUTSIDE)}",
                _exceeded(wrong, WRONGLY_LEARNED_OUTSIDE),
            )
        )
    return PageTable(
        "outside",
        "Exercises about something that the learner is not shown, in percent with 95 % "
        f"intervals ({_samples(found)})",
        (
            "Demonstrations",
            "Questions at most",
            "Said to be outside",
            "Ambiguous",
            "Learned and not exact",
            "Wanted",
            "Missed by",
        ),
        tuple(rows),
    )


def _exceeded(share: Share, most: float) -> str:
    if not share.of:
        return "-"
    over = 100 * (share.count / share.of - most)
    return f"{over:.1f}" if over > 0 else "reached"


def _slips(slipping: Found, careful: Found) -> PageTable:
    slipped = [one for one in slipping if one.slipped]
    located, alarms = (
        _share(slipped, lambda one: one.located),
        _share(careful, lambda one: one.false_alarms > 0),
    )
    rows: tuple[tuple[Cell, ...], ...] = (
        (
            "the right move of the right demonstration",
            str(len(slipped)),
            located,
            f"at least {percent(LOCATED)}",
            _missed(located, LOCATED),
        ),
        (
            "the right demonstration",
            str(len(slipped)),
            _share(slipped, lambda one: one.found),
            "",
            "",
        ),
        (
            "a right demonstration beside the wrong one",
            str(len(slipped)),
            _share(slipped, lambda one: one.false_alarms > 0),
            "",
            "",
        ),
        (
            "some demonstration where none is wrong",
            str(len(careful)),
            alarms,
            f"at most {percent(FALSE_ALARMS)}",
            _exceeded(alarms, FALSE_ALARMS),
        ),
    )
    (shown,) = DESIGNS[Part.SLIP].demonstrations
    return PageTable(
        "slips",
        f"Pointed out as a likely mistake in {shown} demonstrations, in percent with 95 % "
        "intervals",
        ("Pointed out", "Exercises", "", "Wanted", "Missed by"),
        rows,
    )


def _papers(found: Found) -> PageTable:
    parts = [part for part in Part if part in {one.part for one in found}]
    asked = sorted({one.questions for one in found})
    columns = [(part, questions) for part in parts for questions in asked]
    rows: list[tuple[Cell, ...]] = []
    for key in dict.fromkeys(one.family for one in found):
        row: list[Cell] = [f"`{key}`"]
        for part, questions in columns:
            here = [one for one in found if _is_of(one, key, part, questions)]
            exact = _share(here, _is_exact)
            row.append(f"{exact.count} of {exact.of}")
        rows.append(tuple(row))
    rows.append(
        ("wanted, of 100", *(f"{100 * PAPER_WANTED[questions]:.0f}" for _, questions in columns))
    )
    (shown,) = DESIGNS[Part.PAPER].demonstrations
    return PageTable(
        "paper",
        f"Draws of {shown} uniform demonstrations from which one of the paper's exercises is "
        "learned exactly",
        ("Exercise", *(_of_paper(part, questions) for part, questions in columns)),
        tuple(rows),
    )


def _is_of(one: Finding, key: str, part: Part, questions: int) -> bool:
    return (one.family, one.part, one.questions) == (key, part, questions)


def _of_paper(part: Part, questions: int) -> str:
    start = "fresh starts" if part is Part.PAPER else "one start"
    return f"{start}, {f'at most {questions} questions' if questions else 'no question'}"

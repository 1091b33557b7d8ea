"""A patient's progress as words, tables and pictures; pure, for terminal, paper and web."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from math import ceil
from typing import Final

from maestra.coaching.ports import PatientId
from maestra.coaching.progress import ExerciseProgress, SessionProgress, Trend
from maestra.language import Language
from maestra.language.report_keys import ReportKey
from maestra.language.reports import decimal, report_words

NOTHING: Final = "–"
"""Stands where there is nothing to measure."""
WIDTH: Final = 320
HEIGHT: Final = 150
MARGIN_LEFT: Final = 44
MARGIN: Final = 26

_TRENDS: Final = {
    Trend.RISING: ReportKey.RISING,
    Trend.FALLING: ReportKey.FALLING,
    Trend.STEADY: ReportKey.STEADY,
    Trend.TOO_FEW: ReportKey.TOO_FEW,
}
_STYLE: Final = """
body { font-family: sans-serif; font-size: 12pt; color: #1a1a1a; background: #fff; margin: 2em; }
h2 { break-after: avoid; }
section { break-inside: avoid; }
table { border-collapse: collapse; margin: 0 0 1em; }
th, td { border: 1px solid #767676; padding: 0.3em 0.6em; text-align: left; }
figure { display: inline-block; margin: 0 1em 1em 0; }
@media print { body { margin: 0; } }
"""


@dataclass(frozen=True, slots=True)
class ReportTable:
    """A table of words."""

    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class Chart:
    """One measure over the sessions of an exercise; None where a session has none."""

    title: str
    values: tuple[float | None, ...]
    top: float
    """What the upper end stands for."""


@dataclass(frozen=True, slots=True)
class Report:
    """Says how a patient gets on."""

    patient: PatientId
    exercises: tuple[ExerciseProgress, ...]
    language: Language

    @property
    def title(self) -> str:
        """The heading."""
        return report_words(ReportKey.TITLE, self.language, patient=self.patient)

    @property
    def nothing_yet(self) -> str:
        """Said where there is no session."""
        return self._say(ReportKey.NOTHING_YET)

    @property
    def session_word(self) -> str:
        """What stands under a chart."""
        return self._say(ReportKey.SESSION)

    @property
    def how_to_read(self) -> str:
        """What the figures mean."""
        return self._say(ReportKey.HOW_TO_READ)

    def summary(self) -> ReportTable:
        """A row for each exercise: the measures, each with its trend."""
        heads = (
            ReportKey.EXERCISE,
            ReportKey.SESSIONS,
            ReportKey.COMPLETION,
            ReportKey.FIRST_ATTEMPTS,
            ReportKey.REACTION,
            ReportKey.ASSISTANCE,
        )
        rows = tuple(
            (
                one.exercise,
                str(len(one.sessions)),
                self._percent(one.completion),
                self._with_trend(
                    self._percent(one.first_attempt_share), one.trends.first_attempts
                ),
                self._with_trend(self._seconds(one.reaction), one.trends.reaction),
                self._with_trend(self._level(one.assistance), one.trends.assistance),
            )
            for one in self.exercises
        )
        return ReportTable(tuple(self._say(head) for head in heads), rows)

    def sessions(self, exercise: ExerciseProgress) -> ReportTable:
        """A row for each session of an exercise."""
        heads = (
            ReportKey.BEGUN,
            ReportKey.COMPLETION,
            ReportKey.STEPS,
            ReportKey.FIRST_ATTEMPTS,
            ReportKey.REACTION,
            ReportKey.ASSISTANCE,
            ReportKey.LASTED,
        )
        rows = tuple(self._session(one) for one in exercise.sessions)
        return ReportTable(tuple(self._say(head) for head in heads), rows)

    def charts(self, exercise: ExerciseProgress) -> tuple[Chart, ...]:
        """A picture for each measure."""
        shares = tuple(_times(one.first_attempt_share, 100) for one in exercise.sessions)
        reactions = tuple(_times(one.reaction, 0.001) for one in exercise.sessions)
        levels = tuple(one.assistance for one in exercise.sessions)
        longest = max((one for one in reactions if one), default=1.0)
        return (
            Chart(f"{self._say(ReportKey.FIRST_ATTEMPTS)} (%)", shares, 100.0),
            Chart(f"{self._say(ReportKey.REACTION)} (s)", reactions, float(ceil(longest))),
            Chart(f"{self._say(ReportKey.ASSISTANCE)} (0–5)", levels, 5.0),
        )

    def page(self) -> str:
        """An HTML page to print or keep; needs nothing from elsewhere."""
        return "\n".join(
            [
                "<!DOCTYPE html>",
                f'<html lang="{self.language.value}">',
                f'<head><meta charset="utf-8"><title>{escape(self.title)}</title>',
                f"<style>{_STYLE}</style></head>",
                f"<body><main><h1>{escape(self.title)}</h1>",
                *self._body(),
                "</main></body></html>",
                "",
            ]
        )

    def _body(self) -> Iterator[str]:
        if not self.exercises:
            yield f"<p>{escape(self.nothing_yet)}</p>"
            return
        yield _html_table(self.summary())
        for exercise in self.exercises:
            yield f"<section><h2>{escape(exercise.exercise)}</h2>"
            for chart in self.charts(exercise):
                yield f"<figure>{draw(chart, self.session_word)}</figure>"
            yield f"{_html_table(self.sessions(exercise))}</section>"
        yield f"<p>{escape(self.how_to_read)}</p>"

    def _session(self, one: SessionProgress) -> tuple[str, ...]:
        done = ReportKey.COMPLETED if one.completed else ReportKey.BROKEN_OFF
        minutes = decimal(one.lasted / 60_000, self.language)
        return (
            one.begun_utc[:16].replace("T", " "),
            self._say(done),
            str(one.steps),
            self._percent(one.first_attempt_share),
            self._seconds(one.reaction),
            self._level(one.assistance),
            report_words(ReportKey.MINUTES, self.language, number=minutes),
        )

    def _say(self, key: ReportKey) -> str:
        return report_words(key, self.language)

    def _with_trend(self, text: str, trend: Trend) -> str:
        return f"{text} ({self._say(_TRENDS[trend])})"

    def _percent(self, share: float | None) -> str:
        return self._number(ReportKey.PERCENT, _times(share, 100), 0)

    def _seconds(self, ms: float | None) -> str:
        return self._number(ReportKey.SECONDS, _times(ms, 0.001), 1)

    def _level(self, level: float | None) -> str:
        return self._number(ReportKey.LEVEL, level, 1)

    def _number(self, key: ReportKey, value: float | None, places: int) -> str:
        if value is None:
            return NOTHING
        return report_words(key, self.language, number=decimal(value, self.language, places))


def draw(chart: Chart, horizontal: str) -> str:
    """A chart as an SVG picture: marks and a line, and its values in words for who cannot see."""
    title, bottom = escape(chart.title), HEIGHT - MARGIN
    values = ", ".join(NOTHING if one is None else f"{one:.1f}" for one in chart.values)
    places = [
        (x, y)
        for k, one in enumerate(chart.values)
        if one is not None
        for x, y in [_place(k, one, chart)]
    ]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    marks = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4"/>' for x, y in places)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
        f'viewBox="0 0 {WIDTH} {HEIGHT}" role="img" font-family="sans-serif" font-size="11" '
        f'fill="#1a1a1a"><title>{title}: {values}</title>'
        f'<text x="{WIDTH / 2:.0f}" y="14" text-anchor="middle" font-size="12">{title}</text>'
        f'<path d="M{MARGIN_LEFT} {MARGIN} V{bottom} H{WIDTH - 10}" fill="none" '
        f'stroke="#1a1a1a"/>'
        f'<text x="{MARGIN_LEFT - 6}" y="{MARGIN + 4}" text-anchor="end">{chart.top:.3g}</text>'
        f'<text x="{MARGIN_LEFT - 6}" y="{bottom + 4}" text-anchor="end">0</text>'
        f'<text x="{WIDTH / 2:.0f}" y="{HEIGHT - 8}" text-anchor="middle">'
        f"{escape(horizontal)} 1–{len(chart.values)}</text>"
        f'<polyline points="{line}" fill="none" stroke="#0072b2" stroke-width="2"/>'
        f'<g fill="#0072b2">{marks}</g></svg>'
    )


def _place(number: int, value: float, chart: Chart) -> tuple[float, float]:
    width = WIDTH - MARGIN_LEFT - 20
    x = MARGIN_LEFT + 8 + width * number / max(len(chart.values) - 1, 1)
    bottom = HEIGHT - MARGIN
    return x, bottom - (bottom - MARGIN) * min(value / chart.top, 1)


def _times(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor


def _html_table(table: ReportTable) -> str:
    heads = "".join(f'<th scope="col">{escape(head)}</th>' for head in table.heads)
    rows = "".join(
        f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in table.rows
    )
    return f"<table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>"

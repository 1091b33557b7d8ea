"""The page where rules are changed in words; what is not understood is quoted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, Final, assert_never

from fastapi import APIRouter, Form
from fastapi.responses import HTMLResponse, Response

from maestra.language.understanding import (
    MAX_SENTENCE,
    Listener,
    Several,
    Understood,
    Unknown,
    listener_for,
)
from maestra.rules.exercise import RuledExercise
from maestra.rules.rule import MAX_RULES, Rule
from maestra.rules.setting import Setting
from maestra.rules.telling import clash, with_length
from maestra.web.teach.actions import Take
from maestra.web.teach.bench import AtBench, Bench, WhyNot
from maestra.web.teach.desk import Kept
from maestra.web.teach.draft import Draft, Told
from maestra.web.teach.understanding import exercise_of

PLACE: Final = "words"

router: Final = APIRouter(include_in_schema=False)

Sentence = Annotated[str, Form(max_length=MAX_SENTENCE)]
Number = Annotated[int, Form(ge=1, le=MAX_RULES)]


@dataclass(frozen=True, slots=True)
class Heard:
    """What was typed and why it was not taken."""

    number: int
    """Of the rule it was to replace, from 1; 0 for a new one."""
    sentence: str
    fault: str = ""
    quotes: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Parts that are not understood, each with sentences that would be."""
    readings: tuple[str, ...] = ()
    """What it may mean, if that is several things."""
    apart: tuple[str, ...] = ()
    """Rules that cannot be kept together."""


@router.get("/teach/{draft}/words")
def words(bench: AtBench, draft: str, why: WhyNot = "") -> HTMLResponse:
    """The rules, a sentence each, to be changed."""
    return _page(bench, bench.desk.find(draft), why)


@router.post("/teach/{draft}/words/change")
def change(bench: AtBench, draft: str, number: Number, sentence: Sentence = "") -> Response:
    """Another sentence instead of a rule's; an empty one takes the rule away."""
    if not sentence.strip():
        return remove(bench, draft, number)

    def changed(rules: Sequence[Rule], new: Sequence[Rule]) -> list[Rule]:
        return [*rules[: number - 1], *new, *rules[number:]]

    return _tell(bench, draft, Heard(number, sentence), changed)


@router.post("/teach/{draft}/words/add")
def add(bench: AtBench, draft: str, sentence: Sentence = "") -> Response:
    """One rule more."""
    return _tell(bench, draft, Heard(0, sentence), lambda rules, new: [*rules, *new])


@router.post("/teach/{draft}/words/remove")
def remove(bench: AtBench, draft: str, number: Number) -> Response:
    """One rule less."""
    now = _rules(bench.desk.find(draft).draft)
    left = tuple(rule for k, rule in enumerate(now, start=1) if k != number)
    return bench.change(draft, lambda _: Take(Told(left)), PLACE)


@router.post("/teach/{draft}/words/forget")
def forget(bench: AtBench, draft: str) -> Response:
    """What was shown counts again, instead of the words."""
    return bench.change(draft, lambda _: Take(Told(None)), PLACE)


def _tell(
    bench: Bench,
    draft: str,
    heard: Heard,
    changed: Callable[[Sequence[Rule], Sequence[Rule]], list[Rule]],
) -> Response:
    kept = bench.desk.find(draft)
    now = kept.draft
    listener = listener_for(bench.pages.language, now.board, now.deck)
    found = listener.understand(heard.sentence)
    match found:
        case Understood(new):
            rules = changed(_rules(now), new)
            if now.taught.told is None and not now.taught.showings:
                rules = list(with_length(rules))
            apart = clash(rules, Setting(now.deck, now.showing.start))
            if apart or len(rules) > MAX_RULES:
                return _page(bench, kept, heard=_apart(bench, heard, apart, listener))
            return bench.change(draft, lambda _: Take(Told(tuple(rules))), PLACE)
        case Several(readings):
            fault = bench.pages.say("That can mean several things. Which one do you mean?")
            several = Heard(heard.number, heard.sentence, fault, readings=readings)
            return _page(bench, kept, heard=several)
        case Unknown(quotes):
            fault = bench.pages.say("I did not understand this part:")
            nearest = tuple((one.text, one.nearest) for one in quotes)
            unknown = Heard(heard.number, heard.sentence, fault, nearest)
            return _page(bench, kept, heard=unknown)
        case _:
            assert_never(found)


def _apart(bench: Bench, heard: Heard, rules: Sequence[Rule], listener: Listener) -> Heard:
    fault = bench.pages.say("No row of these tokens keeps all of these rules:")
    said = tuple(listener.says(rule) for rule in rules)
    return Heard(heard.number, heard.sentence, fault, apart=said)


def _rules(draft: Draft) -> tuple[Rule, ...]:
    """Those that count now."""
    exercise = exercise_of(draft)
    return exercise.conjunction if isinstance(exercise, RuledExercise) else ()


def _page(bench: Bench, kept: Kept, why: str = "", heard: Heard | None = None) -> HTMLResponse:
    draft = kept.draft
    listener = listener_for(bench.pages.language, draft.board, draft.deck)
    return bench.page(
        "teach/words.html",
        kept,
        why,
        200 if heard is None else 422,
        sentences=[listener.says(rule) for rule in _rules(draft)],
        told=draft.taught.told is not None,
        by_features=draft.features is not None,
        has_shown=bool(draft.taught.counting),
        heard=heard,
    )

"""A learner by script: the same lessons whatever is shown, so that tests know what comes next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final, TypeAlias

import pytest

from maestra.core.demonstration import Demonstration
from maestra.learning import dialogue
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Hypothesis, Lesson, Slip
from maestra.rules.answers import Answer, Question, RowQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.setting import play_of
from tests.learning.caregivers import small

RISING: Final = Ordered("value", Direction.RISING, strict=True)
NOT_FALLING: Final = Ordered("value", Direction.RISING, strict=False)

Scene: TypeAlias = tuple[LearnStatus, tuple[Slip, ...]]
Install: TypeAlias = Callable[..., "Scripted"]

AMBIGUOUS: Final[Scene] = (LearnStatus.AMBIGUOUS, ())
LEARNED: Final[Scene] = (LearnStatus.LEARNED, ())
OUTSIDE: Final[Scene] = (LearnStatus.OUTSIDE, ())


def slip(demonstration: int, move: int = 1) -> Slip:
    """A likely mistake."""
    return Slip(demonstration, move, 0.9)


def row(tokens: str) -> RowQuestion:
    """Is this row of the small deck right?"""
    return RowQuestion(play_of(small(tokens)))


class Scripted:
    """Stands for the learner: its lessons, one after another, the last one for good."""

    def __init__(self, *scenes: Scene) -> None:
        """Play `scenes`."""
        self.scenes = list(scenes)
        self.shown: list[tuple[str, ...]] = []

    def learn(
        self, shown: Sequence[Demonstration], answers: Sequence[Answer] = (), seed: int = 0
    ) -> Lesson:
        """The next lesson; its rules are the ascending ones."""
        self.shown.append(tuple("".join(m.token for m in one.moves) for one in shown))
        status, slips = self.scenes.pop(0) if len(self.scenes) > 1 else self.scenes[0]
        sure = 0.98 if status is LearnStatus.LEARNED else 0.6
        return replace(
            learn(shown, (), seed),
            status=status,
            slips=slips,
            answers=tuple(answers),
            rules=(FullRow(), RISING),
            confidences=(1.0, sure),
            confidence=sure,
            alternatives=(Hypothesis((FullRow(), NOT_FALLING), 1 - sure),),
            safe=(FullRow(), RISING),
        )


def next_question(lesson: Lesson, kinds: object) -> Question | None:
    """The rows abe, cba, ade, ... as long as they were not asked about."""
    assert kinds
    asked = {answer.question for answer in lesson.answers}
    rows = [row(tokens) for tokens in ("abe", "cba", "ade", "bce", "cde", "bde")]
    return next((one for one in rows if one not in asked), None)


def scripted(monkeypatch: pytest.MonkeyPatch, *scenes: Scene) -> Scripted:
    """Put a learner by script in the place of the real one."""
    learner = Scripted(*scenes)
    monkeypatch.setattr(dialogue, "learn", learner.learn)
    monkeypatch.setattr(dialogue, "next_question", next_question)
    return learner

"""How long learning from few demonstrations takes, and how much memory: `make bench`.

How it grows, and how far estimated sizes are off, is measured by `maestra experiment growth`.
"""

from __future__ import annotations

import subprocess
import sys
from itertools import count

import pytest

from benchmarks.stopwatch import Arguments, Stopwatch
from maestra.experiments.growth import GOALS, MOST_MEMORY_MB, Goal, Size, estimates, lesson_of
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.questions import next_question
from maestra.rules.exercise import LearnStatus

NAMED = [pytest.param(goal, id=goal.name) for goal in GOALS]
LARGEST = max(GOALS, key=lambda goal: goal.size.layouts)
ROUNDS = 20


@pytest.mark.benchmark(group="learn from three demonstrations")
@pytest.mark.parametrize("goal", NAMED)
def test_learn_from_few(benchmark: Stopwatch, goal: Goal) -> None:
    seeds = count()

    def another_lesson() -> Arguments:
        return (lesson_of(goal.size, next(seeds)),), {}

    rounds = ROUNDS if goal is GOALS[0] else 3
    lesson = benchmark.pedantic(learn, setup=another_lesson, rounds=rounds)
    benchmark.extra_info["wanted, s"] = goal.learn_s
    assert lesson.rules


@pytest.mark.benchmark(group="the next question")
def test_the_next_question(benchmark: Stopwatch) -> None:
    # One demonstration: after three of these there is nothing left to ask.
    waiting = [
        lesson
        for seed in range(ROUNDS)
        if (lesson := learn(lesson_of(Size(10, 5, 1), seed))).status is not LearnStatus.LEARNED
    ]
    lessons = iter(waiting)

    def another_lesson() -> Arguments:
        return (next(lessons),), {}

    question = benchmark.pedantic(next_question, setup=another_lesson, rounds=len(waiting))
    assert question is not None


@pytest.mark.benchmark(group="estimated sizes, where rows are sampled")
def test_estimated_sizes(benchmark: Stopwatch) -> None:
    found = benchmark.pedantic(lambda: list(estimates(LARGEST.size, 3)), rounds=1)
    for one in found:
        benchmark.extra_info[f"{one.rule}, largest error"] = f"{one.most:.1%}"


@pytest.mark.benchmark(group="memory of a process that learns the largest lesson")
def test_memory(benchmark: Stopwatch) -> None:
    program = (
        "import resource\n"
        "from maestra.experiments.growth import GOALS, lesson_of\n"
        "from maestra.learning.fewshot.learner import learn\n"
        "for goal in GOALS: learn(lesson_of(goal.size))\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)\n"
    )

    def peak_mb() -> float:
        command = [sys.executable, "-c", program]
        done = subprocess.run(command, capture_output=True, text=True, check=True)  # noqa: S603 - our own program
        return int(done.stdout) / 1024

    peak = benchmark.pedantic(peak_mb, rounds=1)
    benchmark.extra_info["MB"] = round(peak)
    assert peak < MOST_MEMORY_MB

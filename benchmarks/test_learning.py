"""How long learning takes: `make bench`. Each group's brackets are the ratios to its fastest."""

from __future__ import annotations

from random import Random

import pytest

from benchmarks.lessons import (
    LARGE_BOARD,
    LARGE_DECK,
    PAPER_BOARD,
    PAPER_DECK,
    paper_lesson,
    random_lesson,
)
from benchmarks.stopwatch import Stopwatch
from maestra.language.languages import Language
from maestra.language.sentences import explain_action, gap_sentences, rule_sentences
from maestra.learning.compiled_learner import CompiledLesson, learn_compiled
from maestra.learning.grounded import GroundedLearner, learn_grounded, vocabulary_for
from maestra.learning.planning import Limits
from maestra.planners import PLANNERS
from maestra.rules.exercise import GroundedExercise
from maestra.rules.strips.vocabulary import Level
from maestra.rules.summaries.summary import summarise

TWELVE = "learn twelve demonstrations of 'ascending'"
LIMITS = Limits(time_s=120, memory_mb=2_000)


@pytest.mark.benchmark(group=TWELVE)
def test_learn_directly(benchmark: Stopwatch) -> None:
    exercise = benchmark(learn_grounded, paper_lesson(Random(1)))
    assert len(exercise.model.preconditions) == 30


@pytest.mark.benchmark(group=TWELVE)
def test_learn_directly_with_a_vocabulary_in_use(benchmark: Stopwatch) -> None:
    lesson = paper_lesson(Random(1))
    vocabulary = vocabulary_for(lesson)

    def learn() -> GroundedExercise:
        learner = GroundedLearner(vocabulary)
        for demonstration in lesson:
            learner.show(demonstration)
        return learner.exercise()

    assert benchmark(learn) == learn_grounded(lesson)


@pytest.mark.benchmark(group=TWELVE)
@pytest.mark.parametrize("engine", ["clingo", "fast-downward"])
def test_learn_by_planning(benchmark: Stopwatch, engine: str) -> None:
    lesson, planner = paper_lesson(Random(1)), PLANNERS[engine]()
    found = benchmark.pedantic(learn_compiled, (lesson, planner, LIMITS), rounds=5)
    assert isinstance(found, CompiledLesson)
    assert found.exercise.model == learn_grounded(lesson).model


@pytest.mark.benchmark(group=TWELVE)
def test_learn_directly_and_explain(benchmark: Stopwatch) -> None:
    lesson, english = paper_lesson(Random(1)), Language.EN

    def learn_and_explain() -> int:
        exercise = learn_grounded(lesson)
        summary = summarise(exercise)
        said = [*rule_sentences(summary, english), *gap_sentences(summary, english)]
        actions = [explain_action(exercise.model, one, english) for one in exercise.provenance]
        return len(said) + len(actions)

    assert benchmark(learn_and_explain) > 30


@pytest.mark.benchmark(group="one demonstration more, after so many")
@pytest.mark.parametrize("shown", [12, 1_000, 10_000])
def test_one_more(benchmark: Stopwatch, shown: int) -> None:
    pool = random_lesson(PAPER_BOARD, PAPER_DECK, 1_000, Random(1))
    learner = GroundedLearner(vocabulary_for(pool))
    for number in range(shown):
        learner.show(pool[number % len(pool)])
    benchmark(learner.show, pool[0])


@pytest.mark.benchmark(group="100,000 demonstrations, one after another")
def test_a_hundred_thousand(benchmark: Stopwatch) -> None:
    pool = random_lesson(PAPER_BOARD, PAPER_DECK, 1_000, Random(1))

    def learn() -> GroundedLearner:
        learner = GroundedLearner(vocabulary_for(pool))
        for _ in range(100):
            for demonstration in pool:
                learner.show(demonstration)
        return learner

    learner = benchmark.pedantic(learn, rounds=3)
    assert learner.exercise().demonstrations == 100_000
    benchmark.extra_info["demonstrations a second"] = round(100_000 / benchmark.stats["median"])


@pytest.mark.benchmark(group="100 demonstrations on 20 x 20 cells, 100 tokens, 20 goal cells")
@pytest.mark.parametrize("level", Level)
def test_the_large_board(benchmark: Stopwatch, level: Level) -> None:
    lesson = random_lesson(LARGE_BOARD, LARGE_DECK, 100, Random(1))
    exercise = benchmark.pedantic(learn_grounded, (lesson, level), rounds=5)
    assert exercise.demonstrations == 100

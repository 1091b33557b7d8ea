"""The paper's exercises after a few demonstrations and after enough, told in every language."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from maestra.core.demonstration import Demonstration
from maestra.core.state import IllegalMoveError, Move
from maestra.language import (
    Language,
    check_sentence,
    explain_action,
    gap_sentences,
    reason,
    rule_sentences,
)
from maestra.learning.grounded import GroundedLearner
from maestra.rules.account import broken_ids
from maestra.rules.exercise import GroundedExercise, Provenance
from maestra.rules.ground_truth import ground_truth
from maestra.rules.judging import Judge
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.summaries.summary import summarise
from maestra.rules.verdicts import JudgedMove
from tests.rules.positions import positions_of

GOLDEN = Path(__file__).parent / "golden"
FEW = 3
LARGE_PRIME = 1_000_000_007


def few(name: str) -> GroundedExercise:
    """An exercise after a few right plays."""
    paper = PAPER_EXERCISES[name]
    learner = GroundedLearner(paper.vocabulary())
    for number in range(FEW):
        learner.show(right_play(name, number))
    return learner.exercise()


def right_play(name: str, number: int) -> Demonstration:
    """One of a few right plays, drawn from the list of all, the same ones each time."""
    right = PAPER_EXERCISES[name].plays()
    return right.play(LARGE_PRIME ** (number + 2) % right.count)


def enough(name: str) -> GroundedExercise:
    """An exercise when there is nothing more to learn of it."""
    paper = PAPER_EXERCISES[name]
    model = ground_truth(paper.plays(), paper.vocabulary())
    provenance = {action: Provenance(2, ()) for action in model.preconditions}
    return GroundedExercise(model, provenance, frozenset({5}), 12)


def told(name: str, language: Language) -> str:
    """All that is said of an exercise: rules, gaps, every action, every kind of refusal."""
    lines: list[str] = []
    for title, exercise in ((f"after {FEW} demonstrations", few(name)), ("learned", enough(name))):
        summary = summarise(exercise)
        lines += [f"# {name}, {title}"]
        lines += [f"{one.id}: {one.text}" for one in rule_sentences(summary, language)]
        lines += [f"{one.id}: {one.text}" for one in gap_sentences(summary, language)]
        lines += [check_sentence(summary, language) or "-"]
        lines += ["## actions"]
        for action in exercise.model.preconditions:
            one = explain_action(exercise.model, action, language)
            lines += [f"{one.name}: {' ∧ '.join(one.precondition)}", f"  {one.sentence}"]
        lines += ["## refusals", *refusals(name, exercise, language)]
    return "\n".join(lines) + "\n"


def refusals(name: str, exercise: GroundedExercise, language: Language) -> Iterator[str]:
    """What is said of each move that is refused, at each step of a right play; each text once."""
    summary = summarise(exercise)
    one = right_play(name, 0)
    judge = Judge(exercise, one.deck)
    said: set[str] = set()
    for position in positions_of(one):
        state = position.now
        for token, origin in state.cells.items():
            for destination in state.board.cells:
                move = Move(token, origin, destination)
                try:
                    judged = JudgedMove(state, move, judge.verdict(position, move))
                except IllegalMoveError:
                    continue
                if not judged.is_refused:
                    continue
                text = reason(judged, summary, one.deck, language)
                if text not in said:
                    said.add(text)
                    ids = ", ".join(broken_ids(judged, summary, one.deck))
                    yield f"{type(judged.verdict).__name__} ({ids}): {text}"


def main() -> None:
    """Write the golden files anew: python -m tests.language.scenes, then read the difference."""
    GOLDEN.mkdir(exist_ok=True)
    for name in PAPER_EXERCISES:
        for language in Language:
            path = GOLDEN / f"{name}.{language.value}.txt"
            path.write_text(told(name, language), encoding="utf-8")


if __name__ == "__main__":
    main()

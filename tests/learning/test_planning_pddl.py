import re
from functools import cache

from hypothesis import given
from hypothesis import strategies as st
from pddl.core import Domain, Problem
from pddl.logic.base import And, Not
from pddl.logic.predicates import Predicate
from pddl.parser.domain import DomainParser
from pddl.parser.problem import ProblemParser

from maestra.learning.compiled import (
    ActionName,
    DeletionTask,
    LiteralName,
    Transition,
    compile_problem,
)
from maestra.learning.planning import Fluent, Operator, OperatorName, PlanningProblem
from maestra.learning.planning_pddl import compiled_pddl, grounded_pddl, safe_names
from tests.learning.planning_strategies import deletion_tasks, problems

PDDL_NAME = re.compile(r"[a-z][a-z0-9_-]*")


@given(st.lists(st.text()), st.lists(st.sampled_from(["a", "b-2", "x"])))
def test_safe_names_are_pddl_and_tell_everything_apart(names: list[str], taken: list[str]) -> None:
    safe = safe_names(names, taken=taken)
    assert set(safe) == set(names)
    assert len(set(safe.values())) == len(safe)
    assert all(PDDL_NAME.fullmatch(name) for name in safe.values())
    assert not {"and", "not", "define", *taken} & set(safe.values())


def test_names_that_are_pddl_already_stay_and_others_stay_readable() -> None:
    names = ["move-v19-t1", "to = l11", "To: L11", "and", "19", "∃", "→"]
    assert list(safe_names(names).values()) == [
        "move-v19-t1",
        "to-l11",
        "to-l11-2",
        "and-2",
        "x-19",
        "exists-2",
        "x",
    ]


@cache
def parsers() -> tuple[DomainParser, ProblemParser]:
    """Making them takes longer than all the parsing here."""
    return DomainParser(), ProblemParser()


def parse(domain: str, problem: str) -> tuple[Domain, Problem]:
    domains, instances = parsers()
    return domains(domain), instances(problem)


def literals(formula: object) -> set[object]:
    """The parts of a conjunction, however it is nested."""
    if isinstance(formula, And):
        return {part for operand in formula.operands for part in literals(operand)}
    return {formula}


@given(problems())
def test_a_problem_reads_back_from_pddl_as_it_is(
    problem: PlanningProblem,
) -> None:
    text = grounded_pddl(problem)
    domain, instance = parse(text.domain, text.problem)
    fluents = {f: Predicate(name) for f, name in safe_names(problem.fluents).items()}
    actions = {action.name: action for action in domain.actions}
    assert {text.operators[name] for name in actions} == {one.name for one in problem.operators}
    for name, action in actions.items():
        operator = next(o for o in problem.operators if o.name == text.operators[name])
        assert literals(action.precondition) == {fluents[fluent] for fluent in operator.needs}
        added = {fluents[fluent] for fluent in operator.adds}
        assert literals(action.effect) == added | {Not(fluents[f]) for f in operator.deletes}
    assert set(instance.init) == {fluents[fluent] for fluent in problem.initial}
    assert literals(instance.goal) == {fluents[fluent] for fluent in problem.goal}


@given(deletion_tasks())
def test_a_deletion_task_reads_back_from_pddl_as_it_is(
    task: DeletionTask,
) -> None:
    text = compiled_pddl(task)
    domain, instance = parse(text.domain, text.problem)
    held = {
        (text.actions[str(fact.terms[0])], text.literals[str(fact.terms[1])])
        for fact in instance.init
        if isinstance(fact, Predicate)
    }
    assert held == {(action, name) for action, whole in task.whole.items() for name in whole}
    asked = {
        action.name: {
            (text.actions[str(need.terms[0])], text.literals[str(need.terms[1])])
            for need in literals(action.precondition)
            if isinstance(need, Predicate) and need.name == "deleted"
        }
        for action in domain.actions
        if action.name != "delete-literal"
    }
    assert asked == {
        f"validate-d{number}-m{count}": {(move.action, name) for name in move.broken}
        for number, moves in enumerate(task.demonstrations, start=1)
        for count, move in enumerate(moves, start=1)
    }


def test_a_deletion_task_is_readable() -> None:
    move, literal = ActionName("move-v19-t1"), LiteralName("to = l11")
    kept = LiteralName("∃v' (contains(l12, v') ∧ less(v', v19))")
    shown = (Transition(move, frozenset({literal})), Transition(move, frozenset()))
    text = compiled_pddl(DeletionTask({move: frozenset({kept, literal})}, (shown,)))
    assert text.domain == (
        """\
(define (domain compiled)
  (:requirements :strips :typing)
  (:types
    action-model
    literal
    move
  )
  (:constants
    move-v19-t1 - action-model  ; move-v19-t1
    to-l11 - literal  ; to = l11
    exists-v-contains-l12-v-and-less-v-v19 - literal  ; ∃v' (contains(l12, v') ∧ less(v', v19))
    d1-m1 - move
    d1-m2 - move
  )
  (:predicates
    (holds-at-first ?a - action-model ?l - literal)  ; before anything is deleted
    (deleted ?a - action-model ?l - literal)
    (validated ?m - move)
  )
  (:action delete-literal
    :parameters (?a - action-model ?l - literal)
    :precondition (and (holds-at-first ?a ?l))
    :effect (and (deleted ?a ?l)))
  (:action validate-d1-m1
    :parameters ()
    :precondition (and
      (deleted move-v19-t1 to-l11))
    :effect (and
      (validated d1-m1)))
  (:action validate-d1-m2
    :parameters ()
    :precondition (and
      (validated d1-m1))
    :effect (and
      (validated d1-m2)))
)
"""
    )
    assert text.problem == (
        """\
(define (problem compiled-problem)
  (:domain compiled)
  (:init
    (holds-at-first move-v19-t1 to-l11)
    (holds-at-first move-v19-t1 exists-v-contains-l12-v-and-less-v-v19)
  )
  (:goal (and
      (validated d1-m2)))
)
"""
    )


def test_a_name_with_line_breaks_stays_in_its_comment() -> None:
    hostile = OperatorName("x\n(:action y\u2028)")
    problem = PlanningProblem(
        "p", frozenset(), frozenset(), (Operator(hostile, frozenset(), frozenset({Fluent("f")})),)
    )
    text = grounded_pddl(problem)
    domain, _ = parse(text.domain, text.problem)
    assert [text.operators[action.name] for action in domain.actions] == [hostile]


def test_both_texts_of_a_task_speak_of_the_same_moves() -> None:
    action = ActionName("a")
    task = DeletionTask({action: frozenset()}, ((Transition(action, frozenset()),),) * 2)
    lifted, grounded = compiled_pddl(task), grounded_pddl(compile_problem(task))
    assert lifted.domain.count("(:action validate-") == len(grounded.operators) == 2

"""Planning problems as PDDL text: for planners that read it, and for people who audit learning.

Two texts. `grounded_pddl` writes any problem with one proposition for each fluent and one
action without parameters for each operator. `compiled_pddl` writes a deletion task as a person
would: one lifted action that deletes a literal, and one action for each move shown. Both are
plain STRIPS (the second with types), and `compiled_pddl` has the same plans as
`compiled.compile_problem`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from maestra.learning.compiled import ActionName, DeletionTask, LiteralName, Transition
    from maestra.learning.planning import Fluent, Operator, OperatorName, PlanningProblem

_RESERVED: Final = """
    action and assign at constants decrease define derived domain effect either equal exists
    forall goal imply increase init maximize metric minimize not number object objects or over
    parameters precondition predicates problem requirements scale-down scale-up types undefined
    when
    """
"""Words that PDDL or its readers keep for themselves."""
_Name = TypeVar("_Name", bound=str)


@dataclass(frozen=True, slots=True)
class GroundedPddl:
    """A problem's two PDDL texts, and which action is which operator."""

    domain: str
    problem: str
    operators: Mapping[str, OperatorName]
    """By the action's name in the text; a plan comes back in these names."""


@dataclass(frozen=True, slots=True)
class CompiledPddl:
    """A deletion task's two PDDL texts, and the names that had to change for PDDL."""

    domain: str
    problem: str
    actions: Mapping[str, ActionName]
    """The task's actions by their names in the text."""
    literals: Mapping[str, LiteralName]
    """The task's literals by their names in the text."""


def safe_names(names: Iterable[_Name], *, taken: Iterable[str] = ()) -> dict[_Name, str]:
    """A PDDL name for each of `names`, no two alike, none reserved or in `taken`.

    Names that are PDDL already keep their form; PDDL does not tell upper case from lower.
    """
    used = {*_RESERVED.split(), *taken}
    safe: dict[_Name, str] = {}
    for name in names:
        if name in safe:
            continue
        words = name.lower().replace("∃", "exists ").replace("∧", "and")
        slug = re.sub(r"[^a-z0-9_-]+", "-", words).strip("-") or "x"
        slug = slug if slug[0].isalpha() else f"x-{slug}"
        candidate, number = slug, 1
        while candidate in used:
            number += 1
            candidate = f"{slug}-{number}"
        used.add(candidate)
        safe[name] = candidate
    return safe


def grounded_pddl(problem: PlanningProblem) -> GroundedPddl:
    """`problem` as a domain without types and objects: one proposition for each fluent."""
    fluents = safe_names(problem.fluents)
    operators = safe_names(operator.name for operator in problem.operators)
    name = safe_names([problem.name])[problem.name]
    declared = [f"({safe})  ; {_comment(fluent)}" for fluent, safe in fluents.items()]
    domain = _domain(
        name,
        [":strips"],
        [("predicates", declared)],
        (_grounded_action(o, operators[o.name], fluents) for o in problem.operators),
    )
    init = [f"({fluents[fluent]})" for fluent in sorted(problem.initial)]
    goal = [f"({fluents[fluent]})" for fluent in sorted(problem.goal)]
    return GroundedPddl(
        domain,
        _problem(name, init, goal),
        MappingProxyType({operators[o.name]: o.name for o in problem.operators}),
    )


def compiled_pddl(task: DeletionTask) -> CompiledPddl:
    """`task` for people to read: what may be deleted, and what each move shown needs."""
    moves = [
        (f"d{number}-m{count}", move)
        for number, demonstration in enumerate(task.demonstrations, start=1)
        for count, move in enumerate(demonstration, start=1)
    ]
    kept = ["deleted", "holds-at-first", "validated", "action-model", "literal", "move"]
    kept += [move for move, _ in moves]
    actions = safe_names(task.whole, taken=kept)
    used_literals = sorted({literal for whole in task.whole.values() for literal in whole})
    literals = safe_names(used_literals, taken=[*kept, *actions.values()])
    constants = [f"{safe} - action-model  ; {_comment(a)}" for a, safe in actions.items()]
    constants += [f"{safe} - literal  ; {_comment(n)}" for n, safe in literals.items()]
    constants += [f"{move} - move" for move, _ in moves]
    domain = _domain(
        "compiled",
        [":strips", ":typing"],
        [
            ("types", ["action-model", "literal", "move"]),
            ("constants", constants),
            ("predicates", _COMPILED_PREDICATES),
        ],
        [_DELETE_LITERAL, *_compiled_validations(moves, actions, literals)],
    )
    init = [
        f"(holds-at-first {actions[action]} {literals[literal]})"
        for action, whole in task.whole.items()
        for literal in sorted(whole)
    ]
    goal = [
        f"(validated d{number}-m{len(demonstration)})"
        for number, demonstration in enumerate(task.demonstrations, start=1)
        if demonstration
    ]
    return CompiledPddl(
        domain,
        _problem("compiled", init, goal),
        MappingProxyType({safe: action for action, safe in actions.items()}),
        MappingProxyType({safe: literal for literal, safe in literals.items()}),
    )


_COMPILED_PREDICATES: Final = [
    "(holds-at-first ?a - action-model ?l - literal)  ; before anything is deleted",
    "(deleted ?a - action-model ?l - literal)",
    "(validated ?m - move)",
]

_DELETE_LITERAL: Final = """\
  (:action delete-literal
    :parameters (?a - action-model ?l - literal)
    :precondition (and (holds-at-first ?a ?l))
    :effect (and (deleted ?a ?l)))"""


def _compiled_validations(
    moves: list[tuple[str, Transition]],
    actions: Mapping[ActionName, str],
    literals: Mapping[LiteralName, str],
) -> Iterator[str]:
    before: list[str] = []
    for name, move in moves:
        action = actions[move.action]
        needs = [f"(deleted {action} {literals[literal]})" for literal in sorted(move.broken)]
        yield _action(f"validate-{name}", [*before, *needs], [f"(validated {name})"])
        before = [f"(validated {name})"]


def _grounded_action(operator: Operator, name: str, fluents: Mapping[Fluent, str]) -> str:
    effects = [f"({fluents[fluent]})" for fluent in sorted(operator.adds)]
    effects += [f"(not ({fluents[fluent]}))" for fluent in sorted(operator.deletes)]
    needs = [f"({fluents[fluent]})" for fluent in sorted(operator.needs)]
    return f"  ; {_comment(operator.name)}\n{_action(name, needs, effects)}"


def _action(name: str, needs: list[str], effects: list[str]) -> str:
    return (
        f"  (:action {name}\n    :parameters ()\n"
        f"    :precondition {_conjunction(needs)}\n    :effect {_conjunction(effects)})"
    )


def _conjunction(parts: list[str]) -> str:
    return "\n      ".join(["(and", *parts]) + ")"


def _domain(
    name: str,
    requirements: list[str],
    sections: list[tuple[str, list[str]]],
    actions: Iterable[str],
) -> str:
    blocks = [f"(define (domain {name})", f"  (:requirements {' '.join(requirements)})"]
    # An empty section is left out: some readers refuse it.
    blocks += [_section(title, lines) for title, lines in sections if lines]
    return "\n".join([*blocks, *actions, ")", ""])


def _problem(name: str, init: list[str], goal: list[str]) -> str:
    head = f"(define (problem {name}-problem)\n  (:domain {name})"
    return f"{head}\n{_section('init', init)}\n  (:goal {_conjunction(goal)})\n)\n"


def _section(title: str, lines: list[str]) -> str:
    return "\n    ".join([f"  (:{title}", *lines]) + "\n  )"


def _comment(text: str) -> str:
    """`text` on one line, whatever is in it."""
    return " ".join(text.split())

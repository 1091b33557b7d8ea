"""Stands in for Madagascar, which no registry carries: started and answering as its programs.

It reads the two PDDL files and searches forward step by step, each step holding every operator
that can be taken and adds something new, deletes or not. That solves any problem without deletes,
with as much superfluous as Madagascar's M; with deletes it finds some plans and misses others.

What it prints and writes is what the original's source does: options in `main`, plans in
`fprintplan` (IPC format with -Q), "PLAN FOUND", "PLAN NOT FOUND". A problem named
`hang-problem`, `hoard-problem`, `cramped-problem`, `mumble-problem` or `lie-problem` makes it
show an ending that is hard to come by: working on for ever, taking memory until malloc refuses
(the original does not check, so it dies of the null pointer), MpC's refusal to go on, an end
without a plan or a reason, and a plan that is none.
"""

import os
import re
import signal
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final, TypeAlias

Tree: TypeAlias = "list[Tree] | str"
LAST_STEP: Final = 20


@dataclass(frozen=True)
class Action:
    """A grounded operator."""

    name: str
    needs: frozenset[str]
    adds: frozenset[str]
    deletes: frozenset[str]


def read(path: str) -> list[Tree]:
    text = re.sub(r";[^\n]*", "", Path(path).read_text(encoding="utf-8"))
    words = iter(re.findall(r"[()]|[^\s()]+", text))
    assert next(words) == "("
    return list(branches(words))


def branches(words: Iterator[str]) -> Iterator[Tree]:
    for word in words:
        if word == ")":
            return
        yield list(branches(words)) if word == "(" else word


def head(tree: Tree) -> str:
    return tree[0] if isinstance(tree[0], str) else ""


def atoms(conjunction: Tree) -> tuple[frozenset[str], frozenset[str]]:
    """The propositions of a conjunction, plain and negated."""
    assert head(conjunction) == "and"
    plain = {head(part) for part in conjunction[1:] if head(part) != "not"}
    return frozenset(plain), frozenset(
        head(part[1]) for part in conjunction[1:] if head(part) == "not"
    )


def read_action(tree: Tree) -> Action:
    assert isinstance(tree[1], str)
    assert tree[2:4] == [":parameters", []]
    assert tree[4] == ":precondition"
    assert tree[6] == ":effect"
    needs, _ = atoms(tree[5])
    adds, deletes = atoms(tree[7])
    return Action(tree[1], needs, adds, deletes)


def section(tree: list[Tree], name: str) -> list[Tree]:
    (found,) = (part[1:] for part in tree if head(part) == name)
    assert isinstance(found, list)
    return found


def search(state: frozenset[str], goal: frozenset[str], actions: list[Action]) -> list[list[str]]:
    """The operators of each step; the last step does not reach the goal if no plan was found."""
    steps: list[list[str]] = []
    while not goal <= state and len(steps) < LAST_STEP:
        step: list[str] = []
        for action in actions:
            if action.needs <= state and not action.adds <= state:
                # One after another within a step, as E-step plans allow.
                state = (state - action.deletes) | action.adds
                step.append(action.name)
        steps.append(step)
    return steps if goal <= state else []


def show_a_rare_ending(name: str, plan_file: str) -> None:
    if name == "hang-problem":
        while True:
            time.sleep(60)
    if name == "hoard-problem":
        taken: list[bytearray] = []
        try:
            while True:
                taken.append(bytearray(2**20))
        except MemoryError:
            os.kill(os.getpid(), signal.SIGSEGV)
    if name == "cramped-problem":
        sys.stdout.write("Was not allowed to increase horizon length. Exiting..\n")
        sys.exit(1)
    if name == "mumble-problem":
        sys.stdout.write("ERROR: no such thing as\n   a table\n\n")
        sys.exit(3)
    if name == "lie-problem":
        Path(plan_file).write_text("0 : (o0)\n0 : (unheard-of)\n", encoding="utf-8")
        sys.exit(0)


def main(arguments: list[str]) -> None:
    quiet, o, plan_file, m, megabytes, domain_file, problem_file = arguments
    assert (quiet, o, m) == ("-Q", "-o", "-m")
    assert int(megabytes) > 0
    domain, problem = read(domain_file), read(problem_file)
    (name,) = section(problem, "problem")
    assert isinstance(name, str)
    show_a_rare_ending(name, plan_file)
    actions = [read_action(part) for part in domain if head(part) == ":action"]
    initial = frozenset(head(fact) for fact in section(problem, ":init"))
    (conjunction,) = section(problem, ":goal")
    goal, _ = atoms(conjunction)
    steps = search(initial, goal, actions)
    if not steps:
        sys.stdout.write(f"PLAN NOT FOUND: {LAST_STEP} steps tested\n")
        return
    lines = [f"{number} : ({name})\n" for number, step in enumerate(steps) for name in step]
    Path(plan_file).write_text("".join(lines), encoding="utf-8")
    sys.stdout.write(f"PLAN FOUND: {len(steps)} steps\n{len(lines)} actions in the plan.\n")


if __name__ == "__main__":
    main(sys.argv[1:])

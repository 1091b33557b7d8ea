"""The code blocks of a Markdown page, and how each is run.

`console` blocks hold commands after `$ ` and, under each, what it prints; `...` there stands
for anything, and a command with nothing under it may print what it likes. `bash` blocks are
scripts, `python` blocks are executed one after the other in one namespace a page, `pycon`
blocks are doctests. A comment on the line before a block changes how it runs:

    <!-- run: exit=1 -->        the (last) command ends with this exit code
    <!-- run: by-hand -->       a person runs it; test_documentation.py lists all of these
"""

import doctest
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Final

RUN_AS_SHELL: Final = frozenset({"bash", "console"})
RUN_IN_PYTHON: Final = frozenset({"pycon", "python"})
# Shown, not run; any other language is refused, so that no block escapes by its name.
SHOWN: Final = frozenset({"json", "jsonl", "makefile", "mermaid", "pddl", "text", "toml", "yaml"})

COMMAND_SECONDS: Final = 60

_FENCE = re.compile(r"^(?P<indent> *)(?P<fence>`{3,}|~{3,}) *(?P<language>[\w+-]*)")
_NOTE = re.compile(r"^ *<!-- run: (?P<note>\S+) -->$")


class BlockError(AssertionError):
    """A block that cannot be run, or that did not do what the page says."""


@dataclass(frozen=True, slots=True)
class Block:
    """One fenced block of a page; `line` is its first line inside the fence, from 1."""

    page: str
    line: int
    language: str
    text: str
    exit_code: int = 0
    is_by_hand: bool = False

    @property
    def place(self) -> str:
        """Where it stands, as an editor understands it."""
        return f"{self.page}:{self.line}"


@dataclass(frozen=True, slots=True)
class Command:
    """One command of a `console` block and the output shown under it."""

    line: str
    shown: str


def blocks(page: str, markdown: str) -> tuple[Block, ...]:
    """All fenced blocks of `markdown`, in order.

    Raises:
        BlockError: a fence is not closed, or a `run:` comment says nothing we know.
    """
    found: list[Block] = []
    lines = iter(enumerate(markdown.splitlines(), start=1))
    before = ""
    for number, line in lines:
        if opening := _FENCE.match(line):
            body: list[str] = []
            for _, inside in lines:
                if inside.strip().startswith(opening["fence"]):
                    break
                body.append(inside.removeprefix(opening["indent"]))
            else:
                msg = f"{page}:{number}: the block is not closed"
                raise BlockError(msg)
            found.append(_block(page, number + 1, opening["language"], body, before))
        before = line
    return tuple(found)


def _block(page: str, line: int, language: str, body: list[str], before: str) -> Block:
    text = "".join(f"{one}\n" for one in body)
    note = _NOTE.match(before)
    if note is None:
        return Block(page, line, language, text)
    if note["note"] == "by-hand":
        return Block(page, line, language, text, is_by_hand=True)
    if code := re.fullmatch(r"exit=(\d+)", note["note"]):
        return Block(page, line, language, text, exit_code=int(code[1]))
    msg = f"{page}:{line - 2}: expected exit=N or by-hand, found {note['note']}"
    raise BlockError(msg)


def commands(block: Block) -> tuple[Command, ...]:
    """The commands of a `console` block; `> ` continues the one before.

    Raises:
        BlockError: the block does not begin with a command.
    """
    found: list[Command] = []
    for line in block.text.splitlines(keepends=True):
        if line.startswith("$ "):
            found.append(Command(line.removeprefix("$ "), ""))
        elif not found:
            msg = f"{block.place}: a console block begins with `$ `"
            raise BlockError(msg)
        elif line.startswith("> ") and not found[-1].shown:
            found[-1] = Command(found[-1].line + line.removeprefix("> "), "")
        else:
            found[-1] = Command(found[-1].line, found[-1].shown + line)
    return tuple(found)


def run_block(block: Block, folder: Path, names: dict[str, object]) -> None:
    """Run `block` in `folder`, Python in the namespace `names`; blocks that are shown pass.

    Raises:
        BlockError: it failed, or printed something else than the page shows.
    """
    match block.language:
        case "console":
            *first, last = commands(block)
            for command in first:
                _run_shell(block, command, folder, 0)
            _run_shell(block, last, folder, block.exit_code)
        case "bash":
            _run_shell(
                block, Command(f"set -euo pipefail\n{block.text}", ""), folder, block.exit_code
            )
        case "python":
            exec(compile(block.text, block.place, "exec"), names)  # noqa: S102 - this is its purpose
        case "pycon":
            _run_doctest(block, names)
        case shown if shown not in SHOWN:
            msg = (
                f"{block.place}: nobody knows whether to run {shown or 'a block without language'}"
            )
            raise BlockError(msg)
        case _:
            pass


def _run_shell(block: Block, command: Command, folder: Path, exit_code: int) -> None:
    tools = os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))
    done = subprocess.run(
        ["/bin/bash", "-c", command.line],
        cwd=folder,
        env={**os.environ, "PATH": tools, "NO_COLOR": "1", "COLUMNS": "100", "LC_ALL": "C.UTF-8"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=COMMAND_SECONDS,
        check=False,
    )
    if done.returncode != exit_code:
        msg = (
            f"{block.place}: `{command.line.strip()}` ended with {done.returncode}: {done.stdout}"
        )
        raise BlockError(msg)
    if command.shown and not matches(command.shown, done.stdout):
        msg = f"{block.place}: the page shows\n{command.shown}and it printed\n{done.stdout}"
        raise BlockError(msg)


def _run_doctest(block: Block, names: dict[str, object]) -> None:
    example = doctest.DocTestParser().get_doctest(
        block.text, names, block.place, block.page, block.line
    )
    report: list[str] = []
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    runner.run(example, out=report.append, clear_globs=False)
    names.update(example.globs)
    if report:
        raise BlockError("".join(report))


def matches(shown: str, printed: str) -> bool:
    """Whether `printed` is what the page shows, `...` standing for anything."""
    pattern = ".*".join(re.escape(part) for part in shown.rstrip().split("..."))
    return re.fullmatch(pattern, printed.rstrip(), re.DOTALL) is not None

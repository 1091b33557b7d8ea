"""What README and docs tell a reader to type works."""

import re
import shutil
from pathlib import Path
from typing import Final

import pytest

from tests.docs.blocks import Block, BlockError, blocks, commands, matches, run_block

ROOT: Final = Path(__file__).parents[2]
PAGES: Final = tuple(
    path.relative_to(ROOT).as_posix()
    for path in (
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *sorted((ROOT / "docs").rglob("*.md")),
    )
)

# Each block that a person must run, by page and first line, with the reason; a block that is
# marked by-hand and not here fails, and so does one here that no page has any more.
BY_HAND: Final = {
    ("README.md", "$ make run"): "waits for a person",
    ("README.md", "$ source .venv/bin/activate"): "changes the reader's shell",
    ("docs/tutorial/first-steps.md", "$ source .venv/bin/activate"): "changes the reader's shell",
    ("docs/tutorial/teach.md", "$ maestra teach shown.jsonl -o ascending.json"): (
        "waits for a person"
    ),
    ("docs/tutorial/teach.md", "$ maestra exam letters.json"): "waits for a person",
    ("docs/how-to/run-the-server.md", "$ make run"): "waits for a person",
    ("docs/tutorial/teach-in-the-browser.md", "$ make run"): "waits for a person",
    (
        "docs/how-to/run-the-server.md",
        "$ maestra serve --host 0.0.0.0 --port 8443 --certificate maestra.pem --key maestra.key",
    ): "serves until it is stopped",
    ("docs/how-to/run-the-server.md", "$ maestra serve --behind-proxy"): (
        "serves until it is stopped"
    ),
    ("README.md", "$ make test"): "runs this very test",
    ("CONTRIBUTING.md", "$ make setup"): "changes the environment the tests run in",
    ("CONTRIBUTING.md", "$ make test"): "runs this very test",
}


def read(page: str) -> tuple[Block, ...]:
    return blocks(page, (ROOT / page).read_text(encoding="utf-8"))


@pytest.mark.parametrize("page", PAGES)
def test_every_block_of_a_page_does_what_the_page_says(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if (ROOT / "examples").is_dir():
        shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "__main__"}
    for block in read(page):
        if not block.is_by_hand:
            run_block(block, tmp_path, names)


def test_blocks_left_to_a_person_are_listed_with_the_reason() -> None:
    marked = {
        (block.page, block.text.splitlines()[0])
        for page in PAGES
        for block in read(page)
        if block.is_by_hand
    }
    assert marked == set(BY_HAND)


def test_every_make_target_that_is_named_exists() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([a-z-]+):", makefile, flags=re.MULTILINE))
    named = {
        target
        for page in PAGES
        for target in re.findall(
            r"(?:`|\$ )make ([a-z-]+)", (ROOT / page).read_text(encoding="utf-8")
        )
    }
    assert named <= targets


def one_block(markdown: str) -> Block:
    (block,) = blocks("page.md", markdown)
    return block


def run(markdown: str, folder: Path) -> None:
    names: dict[str, object] = {}
    for block in blocks("page.md", markdown):
        run_block(block, folder, names)


def test_a_block_knows_its_page_line_and_language() -> None:
    block = one_block("# A title\n\n```json\n{}\n```\n")
    assert (block.place, block.language, block.text) == ("page.md:4", "json", "{}\n")


def test_an_indented_block_loses_its_indent() -> None:
    assert one_block("1. So:\n\n    ```bash\n    true\n    ```\n").text == "true\n"


def test_a_block_that_is_not_closed_is_refused() -> None:
    with pytest.raises(BlockError, match=r"page\.md:1: the block is not closed"):
        blocks("page.md", "```bash\ntrue\n")


def test_an_unknown_note_is_refused() -> None:
    with pytest.raises(BlockError, match="expected exit=N or by-hand, found never"):
        blocks("page.md", "<!-- run: never -->\n```bash\ntrue\n```\n")


def test_a_block_by_hand_is_known_as_such() -> None:
    assert one_block("<!-- run: by-hand -->\n```console\n$ sleep 9\n```\n").is_by_hand


def test_a_command_may_go_on_in_the_next_line() -> None:
    (command,) = commands(one_block("```console\n$ echo a \\\n> b\na b\n```\n"))
    assert (command.line, command.shown) == ("echo a \\\nb\n", "a b\n")


def test_a_console_block_without_a_command_is_refused() -> None:
    with pytest.raises(BlockError, match="begins with"):
        commands(one_block("```console\nhello\n```\n"))


def test_output_as_shown_passes(tmp_path: Path) -> None:
    run("```console\n$ true\n$ echo 1; echo 2\n1\n2\n```\n", tmp_path)


def test_other_output_than_shown_fails(tmp_path: Path) -> None:
    with pytest.raises(BlockError, match="the page shows"):
        run("```console\n$ echo 1\n2\n```\n", tmp_path)


@pytest.mark.parametrize("language", ["bash", "console"])
def test_a_command_that_fails_is_an_error(tmp_path: Path, language: str) -> None:
    prompt = "$ " if language == "console" else ""
    with pytest.raises(BlockError, match="ended with 3"):
        run(f"```{language}\n{prompt}exit 3\n```\n", tmp_path)


def test_an_exit_code_that_the_page_names_is_right(tmp_path: Path) -> None:
    run("<!-- run: exit=3 -->\n```console\n$ exit 3\n```\n", tmp_path)


def test_an_exit_code_that_does_not_come_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(BlockError, match="ended with 0"):
        run("<!-- run: exit=3 -->\n```bash\ntrue\n```\n", tmp_path)


def test_python_blocks_of_a_page_share_their_names(tmp_path: Path) -> None:
    run("```python\nx = 1\n```\n```pycon\n>>> x + 1\n2\n```\n", tmp_path)


def test_a_wrong_doctest_fails(tmp_path: Path) -> None:
    with pytest.raises(BlockError, match="Expected"):
        run("```pycon\n>>> 1 + 1\n3\n```\n", tmp_path)


def test_python_that_raises_fails(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError):
        run("```python\n1 / 0\n```\n", tmp_path)


@pytest.mark.parametrize("language", ["sh", ""])
def test_a_language_nobody_knows_is_refused(tmp_path: Path, language: str) -> None:
    with pytest.raises(BlockError, match="nobody knows"):
        run(f"```{language}\ntrue\n```\n", tmp_path)


def test_what_is_only_shown_is_not_run(tmp_path: Path) -> None:
    run("```text\nexit 1\n```\n", tmp_path)


@pytest.mark.parametrize(
    ("shown", "printed", "is_right"),
    [
        ("took ... s\n", "took 0.31 s\n", True),
        ("a\n...\nz\n", "a\nb\nc\nz\n", True),
        ("a.c\n", "abc\n", False),
        ("a\n", "a\nb\n", False),
    ],
    ids=["number", "lines", "a dot is a dot", "more"],
)
def test_three_dots_stand_for_anything(shown: str, printed: str, *, is_right: bool) -> None:
    assert matches(shown, printed) is is_right

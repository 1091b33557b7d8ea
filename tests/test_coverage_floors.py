"""The floors that `make tests` sets under the coverage are really there."""

import textwrap
from pathlib import Path

import pytest

from tests.coverage_floors import Measured, packages

PROJECT = """
    [tool.coverage.run]
    branch = true
    source = ["src/maestra"]

    [tool.maestra.coverage-floors]
    core = 100
    "*" = 60
"""

# The test below runs three of its four lines and one of its two branches: 4 of 6.
HALF_TESTED = """
    def sign(number):
        if number < 0:
            return "minus"
        return "plus"
"""


@pytest.fixture
def project(pytester: pytest.Pytester) -> pytest.Pytester:
    """A little project whose `cli` is half tested and whose `core` is fully tested."""
    pytester.makepyprojecttoml(PROJECT)
    plugin = Path(__file__).with_name("coverage_floors.py").read_text(encoding="utf-8")
    write(pytester.path / "tests/__init__.py", "")
    write(pytester.path / "tests/coverage_floors.py", plugin)
    write(pytester.path / "src/maestra/__init__.py", "")
    write(pytester.path / "src/maestra/core/__init__.py", "ONE = 1")
    write(pytester.path / "src/maestra/cli.py", HALF_TESTED)
    write(
        pytester.path / "tests/test_it.py",
        """
        import sys
        sys.path.insert(0, "src")

        def test_plus():
            from maestra.cli import sign
            from maestra.core import ONE
            assert sign(ONE) == "plus"
        """,
    )
    return pytester


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(textwrap.dedent(text), encoding="utf-8")


def run(project: pytest.Pytester) -> pytest.RunResult:
    return project.runpytest_subprocess(
        "-p", "tests.coverage_floors", "--cov", "--coverage-floors", "-p", "no:randomly"
    )


def test_packages_above_their_floors_pass(project: pytest.Pytester) -> None:
    result = run(project)
    assert result.ret == pytest.ExitCode.OK
    result.stdout.fnmatch_lines(["cli*66.67 %*of 60 %", "core*100.00 %*of 100 %"])


def test_a_package_below_its_floor_fails_the_run(project: pytest.Pytester) -> None:
    write(
        project.path / "src/maestra/core/__init__.py", f"ONE = 1\n{textwrap.dedent(HALF_TESTED)}"
    )
    result = run(project)
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    result.stdout.fnmatch_lines(["core*of 100 %  TOO LITTLE"])


def test_a_package_that_no_test_imports_fails_the_run(project: pytest.Pytester) -> None:
    write(project.path / "src/maestra/storage/__init__.py", "TWO = 2")
    result = run(project)
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    result.stdout.fnmatch_lines(["storage*0.00 %*of 60 %  TOO LITTLE"])


def test_a_run_without_any_data_fails(project: pytest.Pytester) -> None:
    write(project.path / "tests/test_it.py", "def test_nothing(): pass")
    (project.path / "pyproject.toml").write_text(
        textwrap.dedent(PROJECT).replace("src/maestra", "nowhere"), encoding="utf-8"
    )
    result = run(project)
    assert result.ret == pytest.ExitCode.TESTS_FAILED
    result.stdout.fnmatch_lines(["core*0.00 %*of 100 %  TOO LITTLE"])


def test_pytests_own_line_is_the_last_one(project: pytest.Pytester) -> None:
    assert "1 passed" in run(project).outlines[-1]


def test_a_floor_is_no_rounded_number() -> None:
    assert Measured("core", 99.999, 100).is_short()
    assert not Measured("core", 100.0, 100).is_short()


def test_packages_without_a_line_have_no_coverage_to_measure(tmp_path: Path) -> None:
    write(tmp_path / "empty/__init__.py", "")
    write(tmp_path / "app.py", "x = 1")
    write(tmp_path / "core/board.py", "y = 2")
    assert tuple(packages(tmp_path)) == ("app", "core")

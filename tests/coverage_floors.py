"""A pytest plugin: each package of `maestra` has its own least coverage.

`--coverage-floors` reads `[tool.maestra.coverage-floors]` of pyproject.toml after pytest-cov
has written its data, and fails the session for every package below its floor. A package that
is not named there has the floor of "*".
"""

import tomllib
from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass
from io import StringIO
from pathlib import Path

import pytest
from coverage import Coverage
from coverage.exceptions import NoDataError


@dataclass(frozen=True, slots=True)
class Measured:
    """The covered percent of one package, lines and branches together, and its floor."""

    package: str
    percent: float
    floor: float

    def is_short(self) -> bool:
        """Whether the package is below its floor."""
        return self.percent < self.floor


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--coverage-floors",
        action="store_true",
        help="fail when a package is covered less than pyproject.toml demands (needs --cov)",
    )


def pytest_configure(config: pytest.Config) -> None:
    is_worker = hasattr(config, "workerinput")
    if config.getoption("--coverage-floors") and not is_worker:
        config.pluginmanager.register(CoverageFloors(config.rootpath))


class CoverageFloors:
    """Measures once, when the tests are over, and says so in pytest's summary."""

    def __init__(self, root: Path) -> None:
        self._root = root
        self._measured: tuple[Measured, ...] = ()

    # Outermost, so that it goes on after pytest-cov's own wrapper has combined the data.
    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> Generator[None, object, object]:
        result = yield
        self._measured = measure(self._root)
        session.testsfailed += sum(one.is_short() for one in self._measured)
        return result

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        terminalreporter.section("coverage floors")
        for one in self._measured:
            terminalreporter.write_line(
                f"{one.package:<14}{one.percent:>7.2f} %  of {one.floor:g} %"
                + ("  TOO LITTLE" if one.is_short() else ""),
                red=one.is_short(),
            )


def measure(root: Path) -> tuple[Measured, ...]:
    """The coverage of each package under `root`/src/maestra, from the data pytest-cov wrote."""
    settings = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    floors = settings["tool"]["maestra"]["coverage-floors"]
    coverage = Coverage(config_file=str(root / "pyproject.toml"))
    coverage.load()
    source = root / "src" / "maestra"
    return tuple(
        Measured(name, _percent(coverage, source, name), _floor(floors, name))
        for name in packages(source)
    )


def packages(source: Path) -> Iterable[str]:
    """The packages and modules directly in `source` that have a line to run, by name."""
    for path in sorted(source.iterdir()):
        modules = [path] if path.suffix == ".py" else list(path.rglob("*.py"))
        if any(module.read_text(encoding="utf-8").strip() for module in modules):
            yield path.stem


def _percent(coverage: Coverage, source: Path, name: str) -> float:
    patterns = [str(source / f"{name}.py"), str(source / name / "*")]
    try:
        return coverage.report(include=patterns, file=StringIO())
    except NoDataError:  # no test has so much as imported it
        return 0.0


def _floor(floors: Mapping[str, float], name: str) -> float:
    return floors.get(name, floors["*"])

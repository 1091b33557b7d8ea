"""The house keeps its shape: the import contracts cover every package that must be pure."""

import ast
import tomllib
from pathlib import Path
from typing import Final

import pytest

ROOT: Final = Path(__file__).parents[1]
SOURCE: Final = ROOT / "src" / "maestra"
PURE: Final = ("core", "rules", "learning", "language", "coaching")

# Input, output, clocks and chance that need no import, so import-linter cannot see them.
IMPURE_CALLS: Final = frozenset({"breakpoint", "input", "open", "print"})
IMPURE_METHODS: Final = frozenset({"read_bytes", "read_text", "write_bytes", "write_text"})

MODULES: Final = tuple(
    path.relative_to(SOURCE).as_posix()
    for package in PURE
    for path in sorted((SOURCE / package).rglob("*.py"))
)


def impurities(source: str) -> list[str]:
    """The calls in `source` that read, write or draw, as `line: name`."""
    found: list[str] = []
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Call(func=ast.Name(name)) if name in IMPURE_CALLS:
                found.append(f"{node.lineno}: {name}")
            case ast.Call(func=ast.Attribute(attr=name)) if name in IMPURE_METHODS:
                found.append(f"{node.lineno}: {name}")
            case ast.Attribute(value=ast.Name("numpy" | "np"), attr="random"):
                found.append(f"{node.lineno}: numpy.random")
            case _:
                pass
    return found


@pytest.mark.parametrize("module", MODULES)
def test_nothing_from_coaching_down_reads_writes_or_draws(module: str) -> None:
    assert impurities((SOURCE / module).read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    "source",
    [
        "open('x')",
        "print()",
        "Path('x').read_text()",
        "import numpy as np; np.random.default_rng()",
    ],
)
def test_a_call_with_a_side_effect_is_found(source: str) -> None:
    assert len(impurities(source)) == 1


def test_the_pure_contract_names_every_package_that_must_be_pure() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = {one["id"]: one for one in settings["tool"]["importlinter"]["contracts"]}
    named = set(contracts["pure"]["source_modules"])
    present = {f"maestra.{package}" for package in PURE if (SOURCE / package).is_dir()}
    absent = {f"maestra.{package}" for package in PURE} - present
    assert present <= named
    # import-linter refuses the name of a missing package, but not that of what is in it.
    assert {f"{package}.**" for package in absent} <= named

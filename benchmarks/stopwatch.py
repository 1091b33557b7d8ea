"""The part of pytest-benchmark's fixture that is used here, with its types, which it lacks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import ParamSpec, Protocol, TypeAlias, TypeVar

P = ParamSpec("P")
T = TypeVar("T")
Arguments: TypeAlias = tuple[tuple[object, ...], dict[str, object]]


class Stopwatch(Protocol):
    """What the fixture `benchmark` is."""

    extra_info: dict[str, object]
    stats: Mapping[str, float]

    def __call__(self, function: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Time the call as often as is needed."""
        ...

    def pedantic(
        self,
        target: Callable[..., T],
        args: tuple[object, ...] = (),
        *,
        setup: Callable[[], Arguments] | None = None,
        rounds: int = 1,
        iterations: int = 1,
    ) -> T:
        """Time the call `rounds` times; `setup` makes its arguments, untimed."""
        ...

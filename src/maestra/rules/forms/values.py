"""What tokens show as small whole numbers, for many plays at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from maestra.rules.plays import Plays, Truth, as_table
from maestra.rules.setting import Line, Setting


def value_numbers(setting: Setting, attribute: str) -> NDArray[np.int64]:
    """A number from 0 for each value that occurs; -1 for none."""

    def work_out() -> NDArray[np.int64]:
        values = setting.values(attribute)
        kinds = dict.fromkeys(value for value in values if value is not None)
        numbers = {value: k for k, value in enumerate(kinds)}
        return np.array([*(-1 if v is None else numbers[v] for v in values), -1], np.int64)

    return setting.remember(("value numbers", attribute), work_out)


def all_valued(plays: Plays, line: Line, attribute: str) -> Truth:
    """Whether every token of the line has the attribute."""
    values = plays.setting.values(attribute)
    valued = plays.setting.mask(lambda k: values[k] is not None)
    table = as_table(plays.setting, valued, nobody=True)
    return np.asarray(table[plays.line(line)].all(axis=1))

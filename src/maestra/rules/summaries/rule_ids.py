"""Stable names of rules, steps and gaps, for programs: ``left-to-right``, ``increasing-value``."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Final, cast

from maestra.rules.features import TokenFeature
from maestra.rules.forms.base import Direction
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import FillOrder
from maestra.rules.rule import Rule
from maestra.rules.rule_json import rule_adapter
from maestra.rules.setting import ORIGIN_ROW, Line
from maestra.rules.token_tests import Has, Not

_NOT_IN_NAMES: Final = re.compile(r"[\W_]+")


def rule_ids(rules: Sequence[Rule]) -> tuple[str, ...]:
    """An id for each rule, in kebab-case, unique among them."""
    return number_equal_ones([_rule_id(rule) for rule in rules])


def number_equal_ones(names: Sequence[str]) -> tuple[str, ...]:
    """The names, equal ones numbered from the second on."""
    times: Counter[str] = Counter()
    unique: list[str] = []
    for name in names:
        times[name] += 1
        unique.append(name if times[name] == 1 else f"{name}-{times[name]}")
    return tuple(unique)


def _rule_id(rule: Rule) -> str:
    """A short name for the rules most met, else one made of all that the rule says."""
    match rule:
        case FillOrder(filling):
            return filling.value
        case Ordered(attribute, direction, strict, line):
            rising = direction is Direction.RISING
            if strict:
                name = "increasing" if rising else "decreasing"
            else:
                name = "not-decreasing" if rising else "not-increasing"
            return _kebab(name, attribute, "" if line is Line.ROW else "in-time")
        case EveryToken(Has(TokenFeature(name, attribute))):
            if attribute == ORIGIN_ROW:
                return _kebab("from-storage-row", name.removeprefix("is-"))
            return _kebab("only", name, attribute)
        case EveryToken(Not(Has(TokenFeature(name, attribute)))):
            return _kebab("no", name, attribute)
        case Pattern(tests, repeat=False, line=Line.ROW) if all(isinstance(t, Has) for t in tests):
            return "given-row"
        case StraightUp(mirrored):
            return "mirrored-column" if mirrored else "same-column"
        case _:
            return _kebab(*_leaves(rule_adapter().dump_python(rule, mode="json")))


def _leaves(written: object) -> Iterator[str]:
    """All that a rule's JSON says, its form first; names of fields and "no" add nothing."""
    if isinstance(written, dict):
        fields = cast("dict[str, object]", written)
        yield from _leaves([fields[name] for name in sorted(fields, key="form".__ne__)])
    elif isinstance(written, list):
        for each in cast("list[object]", written):
            yield from _leaves(each)
    else:
        yield "" if written is None or written is False else str(written)


def _kebab(*words: str) -> str:
    return "-".join(
        filter(None, (_NOT_IN_NAMES.sub("-", word.lower()).strip("-") for word in words))
    )

"""One rule for each meaning: rules that say the same in another way are written in one way.

A sentence is read as one rule, so rules that no sentence should tell apart have one form here:
no `not` before `not`, `and` and `or`; lists of tests nested to the right; an order of all pairs
as `Ordered`; letters of a template by their first appearance.
"""

from __future__ import annotations

from dataclasses import fields, replace
from functools import reduce
from typing import Any, Final, TypeAlias, assert_never, cast

from maestra.rules.forms.base import Direction
from maestra.rules.forms.conditions import At
from maestra.rules.forms.counting import Count, Equation, Operation
from maestra.rules.forms.order import Ordered, order_of
from maestra.rules.forms.patterns import Template
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.pairs import Compare
from maestra.rules.rule import Rule
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Either,
    Has,
    Not,
    TokenTest,
)

_Joined: TypeAlias = type[Either] | type[Both]

_ORDERS: Final = {
    order_of(direction, strict=strict): (direction, strict)
    for direction in Direction
    for strict in (True, False)
}


def canonical(rule: Rule) -> Rule:
    """The rule with the same meaning that all others with this meaning lead to."""
    changed = {
        field.name: new
        for field in fields(cast("Any", rule))
        if (new := _part(old := getattr(rule, field.name))) is not old
    }
    tidy = cast("Rule", replace(cast("Any", rule), **changed)) if changed else rule
    match tidy:
        case EachPair(Pairs.ALL, Compare(attribute, comparison, None), line) if (
            comparison in _ORDERS
        ):
            direction, strict = _ORDERS[comparison]
            return Ordered(attribute, direction, strict, line)
        case Template():
            return replace(tidy, letters=letters_of(tidy.letters))
        case Equation(operation=Operation.PRODUCT):
            return _sum_of_one(tidy)
        case _:
            return tidy


def _part(value: object) -> object:
    match value:
        case Not() | Either() | Both():
            return canonical_test(value)
        case At() | Count():
            return canonical(value)
        case tuple():
            return _parts(cast("tuple[object, ...]", value))
        case _:
            return value


def _parts(parts: tuple[object, ...]) -> tuple[object, ...]:
    new = tuple(_part(part) for part in parts)
    return new if new != parts else parts


def canonical_test(test: TokenTest) -> TokenTest:
    """The same of what is asked of one token."""
    match test:
        case Not(Not(of)):
            return canonical_test(of)
        case Not(Either(first, second)):
            return canonical_test(Both(Not(first), Not(second)))
        case Not(Both(first, second)):
            return canonical_test(Either(Not(first), Not(second)))
        case Either() | Both():
            return _joined(type(test), test)
        case Anything() | Has() | Compared() | Among() | Not():
            return test
        case _:
            assert_never(test)


def _joined(kind: _Joined, test: Either | Both) -> TokenTest:
    """A list of tests, what asks nothing left out."""
    members: list[TokenTest] = []
    for each in (canonical_test(test.first), canonical_test(test.second)):
        members += listed(kind, each)
    asking = [each for each in members if not isinstance(each, Anything)]
    if len(asking) < len(members) and (kind is Either or not asking):
        return Anything()
    *others, last = asking
    return reduce(lambda rest, one: kind(one, rest), reversed(others), last)


def listed(kind: _Joined, test: TokenTest) -> list[TokenTest]:
    """The tests that `test` joins; itself alone if it joins none in this way."""
    members: list[TokenTest] = []
    while isinstance(test, kind):
        members.append(test.first)
        test = test.second
    return [*members, test]


def letters_of(letters: str) -> str:
    """The same pattern with A for what comes first, B for the next other one, and so on."""
    order = list(dict.fromkeys(letters))
    return "".join(_letter(order.index(letter)) for letter in letters)


_LETTERS: Final = 26


def _letter(number: int) -> str:
    """A to Z; a pattern with more letters goes on in a script that has enough of them."""
    return chr(ord("A") + number) if number < _LETTERS else chr(ord("一") + number)


def _sum_of_one(rule: Equation) -> Equation:
    """A product of one number on each side at most is a sum."""
    if len(rule.left) > 1:
        return rule
    if not rule.right:
        return replace(rule, operation=Operation.SUM)
    if len(rule.right) == 1 and rule.constant == 1:
        return replace(rule, operation=Operation.SUM, constant=0)
    return rule

"""From the forest of a sentence's parse trees to what it may mean."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from heapq import nsmallest
from itertools import islice, product
from typing import Final, cast

from maestra.core.tokens import Value
from maestra.language.keys import Key
from maestra.language.of_tokens import Tokens
from maestra.language.understanding.forest import Node, symbol_of, token_of, ways_of
from maestra.language.understanding.grammar import SENTENCES, Production
from maestra.language.understanding.terminals import Terminals
from maestra.language.wordings import Wording, fields_of, scale_of
from maestra.rules.canonical import letters_of
from maestra.rules.features import TokenFeature
from maestra.rules.registry import PARAMETER_FEATURES, TOKEN_FEATURES
from maestra.rules.rule import Rule
from maestra.rules.token_tests import Both, Either, Has, Not, TokenTest

MAX_MEANINGS: Final = 64
"""Of one phrase: what can be understood in more ways than this is not understood."""
MAX_WAYS: Final = 8
"""To part a sentence into clauses: the fewest, for what one rule says is seldom two."""
_JOINTS: Final = {Key.EITHER_OF: Either, Key.BOTH_OF: Both}


@dataclass(frozen=True, slots=True)
class Said:
    """What follows a verb: the thing, whether the wording says it is not so, the other token."""

    thing: object
    negated: bool
    other: object = None


@dataclass
class Reader:
    """Reads the forest of one sentence about one deck: each of its nodes once."""

    productions: Mapping[str, Production]
    terminals: Terminals
    tokens: Tokens
    _known: dict[int, list[tuple[object, ...]]] = field(
        default_factory=dict[int, list[tuple[object, ...]]]
    )
    _parted: dict[int, list[tuple[Node, ...]]] = field(
        default_factory=dict[int, list[tuple[Node, ...]]]
    )

    def clauses(self, root: Node) -> Iterator[list[list[Rule]]]:
        """The ways to part the whole sentence, each as the rules that each clause may say."""
        for nodes in self._rows(root):
            yield [[cast("Rule", one) for (one,) in self._read(node)] for node in nodes]

    def _rows(self, node: Node) -> list[tuple[Node, ...]]:
        """The clauses that stand side by side below a node."""
        if id(node) not in self._parted:
            self._parted[id(node)] = nsmallest(MAX_WAYS, self._parts(node), key=len)
        return self._parted[id(node)]

    def _parts(self, node: Node) -> Iterator[tuple[Node, ...]]:
        if token_of(node) is not None:
            yield ()
        elif symbol_of(node) == "rule":
            yield (node,)
        else:
            for way in ways_of(node):
                for row in product(*[self._rows(side) for side in way.sides]):
                    yield tuple(one for part in row for one in part)

    def _read(self, node: Node) -> list[tuple[object, ...]]:
        """All that a node may mean; a part of a production means several things in a row."""
        if id(node) not in self._known:
            found = dict.fromkeys(islice(self._meanings(node), MAX_MEANINGS))
            self._known[id(node)] = list(found)
        return self._known[id(node)]

    def _meanings(self, node: Node) -> Iterator[tuple[object, ...]]:
        token = token_of(node)
        if token is not None:
            terminal, text = token
            if terminal.startswith("_"):
                yield ()
            else:
                yield from ((one,) for one in self.terminals.read(terminal, text))
            return
        symbol = symbol_of(node)
        for way in ways_of(node):
            for row in product(*[self._read(side) for side in way.sides]):
                members = tuple(one for part in row for one in part)
                if not symbol or symbol.startswith("_"):
                    yield members
                else:
                    yield from ((one,) for one in self._meaning(way.alias or symbol, members))

    def _meaning(self, name: str, members: tuple[object, ...]) -> Iterator[object]:
        if name in self.productions:
            yield from self._of_production(self.productions[name], members)
        elif name in _LISTS:
            yield _LISTS[name](members)
        else:
            # A symbol that is another one.
            yield from members

    def _of_production(
        self, production: Production, members: tuple[object, ...]
    ) -> Iterator[object]:
        if production.key in _JOINTS:
            yield _joined(_JOINTS[production.key], cast("Sequence[TokenTest]", members))
        elif production.key is not None:
            yield production.key
        elif production.wordings:
            named = dict(zip(production.slots, members, strict=True))
            for wording in production.wordings:
                yield from self._of_wording(production.symbol, wording, named)
        elif production.slots:
            yield from _of_verb(production, cast("Said", members[0]))
        else:
            yield True

    def _of_wording(
        self, symbol: str, wording: Wording, read: Mapping[str, object]
    ) -> Iterator[object]:
        gaps = dict(read)
        other = gaps.pop("other", None) if "other" not in wording.gaps else None
        attribute = gaps.pop("things", gaps.pop("thing", None))
        if attribute is not None:
            # "Even numbers" are even in what is called a number.
            gaps.update({"attribute": attribute} if "attribute" in wording.gaps else {})
        for thing in wording.things(gaps, self.tokens):
            if not self._makes_sense(thing) or not _is_about(thing, attribute):
                continue
            if symbol in SENTENCES or symbol == "kind":
                yield thing
            else:
                yield Said(thing, wording.negated, other)

    def _makes_sense(self, thing: object) -> bool:
        """Whether a feature is one that the attribute can have."""
        if not isinstance(thing, Has):
            return True
        fields = fields_of(thing)
        family, parameter = str(fields["family"]), str(fields["parameter"])
        definition = (PARAMETER_FEATURES if parameter else TOKEN_FEATURES)[family]
        accepts = not parameter or PARAMETER_FEATURES[family].accepts(parameter)
        return accepts and scale_of(thing.feature.attribute, self.tokens.deck) in definition.scales


def _of_verb(production: Production, said: Said) -> Iterator[object]:
    """What is said with its verb, which says that it is so or that it is not so."""
    if production.symbol.startswith(("one_test", "item")):
        thing = cast("TokenTest", said.thing)
        yield Not(thing) if production.negated else thing
    elif not production.symbol.startswith("one_relation"):
        yield said.thing, production.negated
    elif said.negated is production.negated:
        yield said.thing, said.other


def _test_of(found: object) -> TokenTest:
    """A kind, what follows a verb, or a value that is shown."""
    match found:
        case Said(thing):
            return cast("TokenTest", thing)
        case tuple():
            attribute, value = cast("tuple[str, Value]", found)
            return Has(TokenFeature(f"is-{value}", attribute))
        case _:
            return cast("TokenTest", found)


def _joined(kind: type[Either | Both], tests: Sequence[TokenTest]) -> TokenTest:
    *others, last = tests
    return reduce(lambda rest, one: kind(one, rest), reversed(others), last)


def _is_about(thing: object, attribute: object) -> bool:
    """Whether `thing` asks about an attribute, if both name one."""
    return attribute is None or fields_of(thing).get("attribute", attribute) == attribute


def _either(found: Sequence[object]) -> TokenTest:
    # The noun may name an attribute, and need not.
    asked = [_test_of(each) for each in found if each is not None and not isinstance(each, str)]
    return _joined(Either, asked)


def _both(found: Sequence[object]) -> TokenTest:
    return _joined(Both, [_test_of(each) for each in found])


_LISTS: Final[Mapping[str, Callable[[tuple[object, ...]], object]]] = {
    "letters": lambda found: letters_of("".join(map(str, found)).upper()),
    "either_kind": _either,
    "either_value": _either,
    "both_kinds": _both,
    "values": lambda found: found,
    "stages": lambda found: found,
    "terms_plus": lambda found: found,
    "terms_times": lambda found: found,
}
"""What lists mean, by their symbol."""

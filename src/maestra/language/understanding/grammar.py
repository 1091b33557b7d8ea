"""A language's grammar for one deck and board, made from the tables that say rules.

Each template becomes a production: its words a terminal, its gaps symbols. Terminals for what
only the deck knows (values, attributes) list how the language says each of them. The grammar is
text for lark; `Production` says what a tree of it stands for.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Final, TypeAlias

from maestra.language.keys import Key, Predicate
from maestra.language.of_pairs import RELATIONS
from maestra.language.of_places import (
    CONDITIONS,
    FILLINGS,
    LINES,
    PEAKS,
    SPOTS,
    STAGES,
    TAKINGS,
)
from maestra.language.of_rules import RULES
from maestra.language.of_tokens import QUANTITIES, TESTS
from maestra.language.phrases import Joint
from maestra.language.speaker import BESIDE_ATTRIBUTE, WITHOUT_ADJECTIVE, Speaker
from maestra.language.synonyms import Synonyms
from maestra.language.templates import Agreement, Slot, Spoken, parse
from maestra.language.tongue import VerbForms
from maestra.language.understanding.plain import Plainly, escaped
from maestra.language.wordings import Wording

SENTENCES: Final[Mapping[str, Sequence[Wording]]] = {
    "rule": RULES,
    "amount": QUANTITIES,
    "filling": FILLINGS,
    "line": LINES,
    "spot": SPOTS,
    "stage": STAGES,
    "condition": CONDITIONS,
}
"""Symbols for what keys say."""
SAID: Final[Mapping[str, Sequence[Wording]]] = {
    "test": TESTS,
    "relation": RELATIONS,
    "peak": PEAKS,
    "choice": TAKINGS,
}
"""Symbols for what is said of a token by a verb, in several forms of it."""
OTHERS: Final = (
    Key.THE_ONE_ON_ITS_LEFT,
    Key.THE_ONE_BEFORE_IT,
    Key.THE_NEIGHBOUR_ON_ITS_LEFT,
    Key.THE_ONE_JUST_BEFORE_IT,
    Key.EVERY_ONE_ON_ITS_LEFT,
    Key.EVERY_ONE_BEFORE_IT,
    Key.THE_OPPOSITE_ONE,
    Key.ITS_MODEL,
    Key.THIS_ONE,
)
"""The other token of two, when it is no place."""
FORMS: Final = ("must", "does", "that", "do")
_CONJUGATED: Final = {"": "does", "clause": "does", **{form: form for form in FORMS}}
_OPTIONAL: Final = frozenset({"a"})
"""A word that may be missing, but is no article: it can be a letter on a token."""
_END: Final = "(?= |$)"
_TERMINAL: Final = re.compile(r"_?[A-Z][A-Z0-9_]*")
_NAME: Final = re.compile(r"\w+")
_GAP: Final = "\u25a1"
_COMPOSED: Final = frozenset(
    {
        *SENTENCES,
        "values",
        "letters",
        "stages",
        "terms_plus",
        "terms_times",
        "the_tokens",
        "way",
    }
)
"""Symbols of the grammar; others are terminals."""


Template: TypeAlias = tuple[str, Mapping[str, str]]
"""A template, and the symbol of each of its gaps without the form."""


@dataclass(frozen=True, slots=True)
class Production:
    """What a node of a tree stands for."""

    symbol: str
    slots: tuple[str, ...] = ()
    """The gap that each child fills."""
    wordings: tuple[Wording, ...] = ()
    """What is then said."""
    key: Key | None = None
    """What is said by this node alone."""
    negated: bool = False


@dataclass
class Grammar:
    """The productions of one language for one deck and board, and their text for lark."""

    plainly: Plainly
    speaker: Speaker
    synonyms: Synonyms
    terminals: Mapping[str, str]
    """Patterns of the terminals that mean something, by symbol in capitals."""
    productions: dict[str, Production] = field(default_factory=dict[str, Production])
    _rules: dict[str, list[str]] = field(default_factory=dict[str, list[str]])
    _literals: dict[str, str] = field(default_factory=dict[str, str])
    _known: dict[tuple[str, str], str] = field(default_factory=dict[tuple[str, str], str])

    def __post_init__(self) -> None:
        """Write every production."""
        for symbol, table in SENTENCES.items():
            self._sentences(symbol, table)
        for symbol, table in SAID.items():
            self._said(symbol, table)
        self._several()
        self._others()
        self._lists()

    def text(self) -> str:
        """The grammar."""
        rules = self._complete()
        lines = [f"{name}: " + "\n    | ".join(ways) for name, ways in rules.items()]
        lines += [f"{name}: /(?:{p}){_END}/" for p, name in self._literals.items()]
        lines += [f"{name}: /(?:{p}){_END}/" for name, p in self.terminals.items()]
        return "\n".join(lines) + "\n"

    def _complete(self) -> dict[str, list[str]]:
        """The rules without those that need what this deck has no word for."""
        rules = self._rules
        while True:
            known = {*rules, *self.terminals, *self._literals.values()}
            complete = {
                name: [way for way in ways if set(_NAME.findall(way.split(" -> ")[0])) <= known]
                for name, ways in rules.items()
            }
            complete = {name: ways for name, ways in complete.items() if ways}
            if complete == rules:
                return rules
            rules = complete

    # ------------------------------------------------------------ productions

    def _add(self, production: Production, right: Sequence[str]) -> None:
        """One way to say what `production` stands for; words with a mark may be missing."""
        for chosen in product(
            *((part[:-1], "") if part[-1] == "?" else (part,) for part in right)
        ):
            self._add_exactly(production, " ".join(filter(None, chosen)))

    def _add_exactly(self, production: Production, right: str) -> None:
        """The same words may stand for several things."""
        known = self._known.get((production.symbol, right))
        if known is None:
            name = f"p{len(self.productions)}"
            self._known[production.symbol, right] = name
            self.productions[name] = production
            self._way(production.symbol, f"{right} -> {name}")
        else:
            found = self.productions[known]
            wordings = dict.fromkeys((*found.wordings, *production.wordings))
            self.productions[known] = replace(found, wordings=tuple(wordings))

    def _way(self, symbol: str, right: str) -> None:
        """One way to derive a symbol, ending in a symbol of its own.

        lark 1.1 and 1.3 keep one derivation only of a symbol that ends in a terminal one way and
        in a symbol the other way, over the same words.
        """
        production, arrow, name = right.partition(" -> ")
        last = production.rpartition(" ")[2]
        if _TERMINAL.fullmatch(last):
            ending = f"_end{last.lower()}"
            self._rules.setdefault(ending, [last])
            production = f"{production.removesuffix(last)}{ending}"
        self._rules.setdefault(symbol, []).append(f"{production}{arrow}{name}")

    def _sentences(self, symbol: str, table: Sequence[Wording]) -> None:
        """A production for each template of each key, shared by wordings with the same gaps."""
        for template, wordings in self._templates(table):
            right, slots = self._right(template, wordings[0])
            self._add(Production(symbol, slots, wordings), right)

    def _templates(self, table: Sequence[Wording]) -> Iterator[tuple[str, tuple[Wording, ...]]]:
        words, others = self.speaker.words.sentences, self.synonyms.sentences
        for key in _keys(table):
            alike: dict[tuple[tuple[str, str], ...], list[Wording]] = {}
            for wording in table:
                if wording.says is key:
                    symbols = ((name, gap.part.symbol) for name, gap in wording.gaps.items())
                    alike.setdefault(tuple(sorted(symbols)), []).append(wording)
            for template in (words[key], *others.get(key, ())):
                for wordings in alike.values():
                    yield template, tuple(wordings)

    def _said(self, symbol: str, table: Sequence[Wording]) -> None:
        """What follows each verb, and each form of the verb with it."""
        verbs: set[str] = set()
        for predicate in _predicates(table):
            wordings = tuple(wording for wording in table if wording.says is predicate)
            for said in _said_too(predicate):
                for verb, template in self._predicates(said):
                    verbs.add(verb)
                    self._rest(f"{symbol}_of_{_name(verb)}", template, wordings)
            for name, verb, template in self._own(predicate):
                verbs.add(verb)
                named = tuple(_named(wording, name) for wording in wordings)
                self._rest(f"{symbol}_of_{_name(verb)}", template, named)
        for form in FORMS:
            for verb in sorted(verbs):
                self._verb(symbol, form, verb)

    def _own(self, predicate: Predicate) -> Iterator[tuple[str, str, str]]:
        """A caregiver's words for relations: which one, a verb, and what follows it."""
        for (name, said), (verb, template) in self.speaker.words.relations.items():
            if said is predicate:
                yield name, verb, template

    def _predicates(self, predicate: Predicate) -> Iterator[tuple[str, str]]:
        yield self.speaker.words.predicates[predicate]
        yield from self.synonyms.predicates.get(predicate, ())

    def _rest(self, symbol: str, template: str, wordings: tuple[Wording, ...]) -> None:
        right, slots = self._right(template, wordings[0])
        self._add(Production(symbol, slots, wordings), right)
        gaps = wordings[0].gaps
        if "attribute" in gaps and "attribute" not in slots:
            more, by = self._right(self.speaker.words.sentences[Key.BY_ATTRIBUTE], wordings[0])
            self._add(Production(symbol, (*slots, *by), wordings), [*right, *more])
        if any("way" in wording.gaps for wording in wordings):
            self._add(Production(symbol, (*slots, "way"), wordings), [*right, "way"])

    def _verb(self, symbol: str, form: str, verb: str) -> None:
        forms = self.speaker.words.verbs[verb]
        rest = f"{symbol}_of_{_name(verb)}"
        for negated in (False, True):
            words = self._literal([_conjugated(forms, form, negated=negated)])
            self._add(
                Production(f"one_{symbol}_{form}", ("said",), negated=negated), [*words, rest]
            )

    # ------------------------------------------------------------ templates

    def _right(self, template: str, wording: Wording) -> tuple[list[str], tuple[str, ...]]:
        """The right side of a production, and which gap each of its symbols fills."""
        right: list[str] = []
        slots: list[str] = []
        run: list[tuple[str, ...]] = []
        for piece in parse(template):
            match piece:
                case Slot(name, form):
                    run.append((self._before(form),))
                    right += self._run(run)
                    run = []
                    right.append(self._symbol(name, form, wording))
                    slots.append(name)
                case Agreement(_, _, forms):
                    run.append(forms)
                case _:
                    run.append((piece,))
        return [*right, *self._run(run)], tuple(slots)

    def _run(self, run: Sequence[tuple[str, ...]]) -> list[str]:
        """The terminal for words between gaps."""
        return self._literal(["".join(chosen) for chosen in product(*run)])

    def _before(self, form: str) -> str:
        """What a form of a phrase puts before it, such as a preposition."""
        if form not in {"of", "to"}:
            return ""
        return self.speaker.grammar.derive(Spoken(_GAP), form).replace(_GAP, "")

    def _symbol(self, name: str, form: str, wording: Wording) -> str:
        if name == "other" and name not in wording.gaps:
            return "other"
        if name in {"thing", "things"}:
            return name.upper()
        symbol = wording.gaps[name].part.symbol
        if symbol in SAID:
            return f"{symbol}_{_CONJUGATED[form]}"
        if symbol == "kind":
            return "kinds"
        return symbol if symbol in _COMPOSED else symbol.upper()

    def _literal(self, texts: Iterable[str]) -> list[str]:
        """The terminal for any of these words, none of which mean anything alone."""
        said = sorted({self.plainly.text(text) for text in texts} - {""}, key=len, reverse=True)
        if not said:
            return []
        pattern = "|".join(_loosely(text) for text in said)
        name = self._literals.setdefault(pattern, f"_W{len(self._literals)}")
        return [f"{name}?" if all(text.strip() in _OPTIONAL for text in said) else name]

    # ------------------------------------------------------------ what joins phrases

    def _several(self) -> None:
        """Tests joined by "and" or "or"; what is inside another begins with a word of its own."""
        words = self.speaker.words.sentences
        for form in FORMS:
            for joint, key in ((Joint.OR, Key.EITHER_OF), (Joint.AND, Key.BOTH_OF)):
                listed = f"{joint.value}_{form}"
                self._add(
                    Production(listed, (), key=key),
                    [f"item_{form}+", *self._joint(joint), f"item_{form}"],
                )
                opening = self._literal([words[key].partition("{")[0]])
                for symbol in (f"test_{form}", f"item_{form}"):
                    self._way(symbol, f"{' '.join(opening)} {listed}")
                self._way(f"test_{form}", listed)
            for symbol in (f"test_{form}", f"item_{form}"):
                self._way(symbol, f"one_test_{form}")
            for verb in sorted(self.speaker.words.verbs):
                if f"test_of_{_name(verb)}" in self._rules:
                    # "red or blue": the verb is not said again.
                    self._add(Production(f"item_{form}", ("said",)), [f"test_of_{_name(verb)}"])
            for symbol in ("relation", "peak", "choice"):
                self._way(f"{symbol}_{form}", f"one_{symbol}_{form}")

    def _joint(self, joint: Joint) -> list[str]:
        """The terminal for the word that joins phrases."""
        return self._literal(self.joints(joint))

    def joints(self, joint: Joint) -> set[str]:
        """The words that join phrases; one may give way to the sound of the next."""
        join = self.speaker.grammar.join
        return {join(["7", last], joint)[1:-1].strip() for last in "7io"}

    def _others(self) -> None:
        sentences = self.speaker.words.sentences
        for key in OTHERS:
            for template in (sentences[key], *self.synonyms.sentences.get(key, ())):
                self._add(Production("other", (), key=key), self._literal([template]))
        self._way("other", "spot")
        self._add(Production("way"), self._literal([sentences[Key.IN_THAT_ORDER]]))
        self._add(Production("the_tokens"), self._literal([sentences[Key.THE_TOKENS]]))

    def _lists(self) -> None:
        """Lists of one kind of thing, and the whole: one rule or more."""
        _and = self._joint(Joint.AND)
        self._way("start", f"rule ({_and[0]}? rule)*")
        _or = self._joint(Joint.OR)
        both = f"({_and[0]} | {_or[0]})"
        self._way("kinds", "kind | either_kind | both_kinds | either_value")
        self._way("either_kind", f"kind {both} kind | kind {_or[0]} test_of_{_name(self._be)}")
        self._way("both_kinds", f"kind {_and[0]} test_of_{_name(self._be)}")
        self._way("either_value", f"VALUE ({both}? VALUE)* {both} VALUE THINGS?")
        self._way("either_value", f"THINGS VALUE ({both}? VALUE)* {both} VALUE")
        self._way("values", f"VALUE ({_and[0]}? VALUE)*")
        self._way("letters", "LETTER+")
        self._way("stages", f"stage ({_and[0]}? stage)*")
        for joint in (Joint.PLUS, Joint.TIMES):
            word = self._joint(joint)[0]
            self._way(f"terms_{joint.value}", f"_term ({word} _term)*")
        self._way("_term", "spot")
        self._way("_term", "NUMBER")
        for predicate in _predicates(TESTS):
            wordings = tuple(wording for wording in TESTS if wording.says is predicate)
            for said in _said_too(predicate):
                for template in self._kinds_of(said):
                    self._rest("kind", template, wordings)

    @property
    def _be(self) -> str:
        """The verb that says what something is."""
        return self.speaker.words.predicates[Predicate.ODD][0]

    def _kinds_of(self, predicate: Predicate) -> Iterator[str]:
        if predicate in self.speaker.words.kinds:
            yield self.speaker.words.kinds[predicate]
        yield from self.synonyms.kinds.get(predicate, ())


def _keys(table: Sequence[Wording]) -> tuple[Key, ...]:
    """The keys of a table, each once."""
    return tuple(dict.fromkeys(one.says for one in table if isinstance(one.says, Key)))


def _predicates(table: Sequence[Wording]) -> tuple[Predicate, ...]:
    """The predicates of a table, each once."""
    return tuple(dict.fromkeys(one.says for one in table if isinstance(one.says, Predicate)))


def _said_too(predicate: Predicate) -> Iterator[Predicate]:
    """A predicate, and what is said instead where there is no word for it."""
    yield predicate
    for others in (WITHOUT_ADJECTIVE, BESIDE_ATTRIBUTE):
        if predicate in others:
            yield others[predicate]


def _named(wording: Wording, relation: str) -> Wording:
    """The wording of one relation that has words of its own."""
    gaps = {name: gap for name, gap in wording.gaps.items() if name != "relation"}
    return replace(wording, fixed={**wording.fixed, "name": relation}, gaps=gaps)


def _name(verb: str) -> str:
    """A verb's name as lark takes it."""
    return re.sub(r"\W", "_", verb)


def _conjugated(forms: VerbForms, form: str, *, negated: bool) -> str:
    match form:
        case "must":
            return forms.must_not if negated else forms.must
        case "does":
            return forms.does_not if negated else forms.does
        case "that":
            return forms.that_not if negated else forms.that
        case _:
            return forms.do_not if negated else forms.do


def _loosely(text: str) -> str:
    """A pattern for the words; those that may be missing may be."""
    words = text.split()
    needed = any(word not in _OPTIONAL for word in words)
    return "".join(
        f"(?: {escaped(word)})?" if needed and word in _OPTIONAL else f" {escaped(word)}"
        for word in words
    )

"""What a caregiver's sentence says: rules, one of several things, or nothing that is known.

A sentence is made plain, parsed with the grammar that the words' own tables make for the deck
(Earley, so that nothing is lost to a wrong guess), and read as every rule that it may say. Of
these the ones count that would be said just so; then those that differ in nothing but what
people may leave out. What the grammar does not know is found by reading the rest without it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property, lru_cache
from itertools import islice, product
from typing import Final, TypeAlias

from lark import Lark
from lark.exceptions import UnexpectedInput

from maestra.core.board import Board
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import Deck
from maestra.language.languages import Language, speaker_for, synonyms_of
from maestra.language.lexicon import NO_LEXICON, Lexicon
from maestra.language.of_rules import Rules
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import Joint
from maestra.language.speaker import Speaker
from maestra.language.synonyms import Synonyms
from maestra.language.understanding.examples import rules_like
from maestra.language.understanding.grammar import Grammar
from maestra.language.understanding.nearest import Nearest
from maestra.language.understanding.plain import Plainly
from maestra.language.understanding.reader import Reader
from maestra.language.understanding.terminals import Terminals
from maestra.rules.canonical import canonical
from maestra.rules.fitting import misfits
from maestra.rules.rule import Rule
from maestra.rules.rule_json import decode_rule, encode_rule

MAX_SENTENCE: Final = 1_000
"""Characters of what is said at once: several rules, and read in seconds at worst."""
MAX_WORDS: Final = 120
"""Of one sentence that is read as a whole; of a longer one each clause is read alone."""
MAX_CLAUSES: Final = 12
"""Parts between commas and "and" that are tried together, to find which one is not understood."""
_RANKS: Final = 3
"""How like a sentence is to what would be said: to the letter, but for case, made plain."""
SUGGESTIONS: Final = 3
MAX_READINGS: Final = 64
"""Of one sentence: nobody chooses among more."""


@dataclass(frozen=True, slots=True)
class Understood:
    """The sentence says these rules."""

    rules: tuple[Rule, ...]


@dataclass(frozen=True, slots=True)
class Several:
    """The sentence says one of these, and nothing in it tells which."""

    sentences: tuple[str, ...]
    """Each of the readings, said so that it cannot be mistaken."""


@dataclass(frozen=True, slots=True)
class Quote:
    """A part of what was said that is not understood, and the nearest sentences that are."""

    text: str
    nearest: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Unknown:
    """Some of the sentence is not understood."""

    quotes: tuple[Quote, ...]


Understanding: TypeAlias = Understood | Several | Unknown


@dataclass(frozen=True)
class Listener:
    """Understands sentences of one language about one board and deck."""

    speaker: Speaker
    synonyms: Synonyms

    def says(self, rule: Rule) -> str:
        """The rule as a sentence."""
        if rule not in self._said:
            self._said[rule] = self.speaker.sentence(Rules(self.tokens).says(rule))
        return self._said[rule]

    @cached_property
    def _said(self) -> dict[Rule, str]:
        """What was said of rules while one sentence is read."""
        return {}

    def understand(self, sentence: str) -> Understanding:
        """What `sentence` says.

        Raises:
            InvalidError: it is longer than `MAX_SENTENCE`.
        """
        if len(sentence) > MAX_SENTENCE:
            length = f"{len(sentence)} characters"
            raise InvalidError([Fault("sentence", length, f"at most {MAX_SENTENCE}")])
        self._said.clear()
        found = self.readings(sentence)
        if len(found) == 1:
            return Understood(found[0])
        if found:
            return Several(self._sentences(found))
        return self._in_parts(sentence)

    def readings(self, sentence: str) -> list[tuple[Rule, ...]]:
        """The rules that `sentence` may say, the likeliest alone if one is likelier."""
        text = self.plainly.text(sentence)
        if not 0 < len(text.split()) <= MAX_WORDS:
            return []
        try:
            forest: object = self._parser.parse(text)
        except UnexpectedInput:
            return []
        heard = (sentence, sentence.casefold(), text)
        reader = Reader(self._grammar.productions, self._terminals, self.tokens)
        ranked: dict[tuple[Rule, ...], tuple[int, int]] = {}
        for clauses in reader.clauses(forest):
            chosen = [self._likeliest(clause, heard) for clause in clauses]
            for rules, rank in _combined(chosen):
                ranked.setdefault(rules, rank)
        best = min(ranked.values(), default=None)
        return [rules for rules, rank in ranked.items() if rank == best]

    @property
    def tokens(self) -> Tokens:
        """What is spoken of."""
        return Tokens(self.speaker.board, self.speaker.deck)

    @cached_property
    def plainly(self) -> Plainly:
        """How sentences are made plain."""
        return Plainly(self.speaker.grammar, self.synonyms)

    @cached_property
    def _terminals(self) -> Terminals:
        return Terminals(self.speaker, self.plainly, self.synonyms)

    @cached_property
    def _grammar(self) -> Grammar:
        return Grammar(self.plainly, self.speaker, self.synonyms, self._terminals.patterns)

    @cached_property
    def _parser(self) -> Lark:
        text = self._grammar.text()
        return Lark(text, parser="earley", lexer="dynamic", ambiguity="forest", start="start")

    @cached_property
    def _nearest(self) -> Nearest:
        rules = rules_like(self.speaker.deck, self.speaker.board)
        return Nearest(self.plainly, tuple(dict.fromkeys(map(self.says, rules))))

    def fits(self, rule: Rule) -> bool:
        """Whether the deck has what the rule asks for, and the rule is within its limits."""
        if misfits([rule], self.speaker.deck):
            return False
        try:
            written = json.loads(json.dumps(encode_rule(rule)), parse_float=Decimal)
            return decode_rule(written) == rule
        except InvalidError:
            return False

    def _likeliest(self, clause: Iterable[Rule], heard: Sequence[str]) -> tuple[list[Rule], int]:
        """The rules that one clause may say, and how far its words are from theirs."""
        rules = [rule for rule in dict.fromkeys(map(canonical, clause)) if self.fits(rule)]
        said = {rule: self.says(rule).rstrip(".") for rule in rules}
        for rank in range(_RANKS):
            if exact := [rule for rule in rules if self._is_in(said[rule], heard, rank)]:
                # What says more of the sentence says what the others do not.
                longest = max(len(said[rule]) for rule in exact)
                return [rule for rule in exact if len(said[rule]) == longest], rank
        return rules, _RANKS

    def _is_in(self, said: str, heard: Sequence[str], rank: int) -> bool:
        """Whether a sentence is a part of what was heard, as it stands or made plainer."""
        forms = (said, said.casefold(), self.plainly.text(said))
        return forms[rank] in heard[rank]

    def _in_parts(self, sentence: str) -> Understanding:
        """What is said clause by clause, with as few words not understood as can be."""
        spans = self._clauses(sentence)
        best: list[tuple[int, tuple[_Part, ...]]] = [(0, ())]
        for end in range(1, len(spans) + 1):
            ways = (
                (cost + part.cost, (*parts, part))
                for start, (cost, parts) in enumerate(best)
                for part in self._parts(sentence[spans[start][0] : spans[end - 1][1]])
                if part.found or start == end - 1
            )
            best.append(min(ways, key=lambda way: way[0]))
        parts = best[-1][1]
        unknown = [part.text for part in parts if not part.found]
        if unknown or not parts:
            return Unknown(tuple(map(self._quote, unknown or [sentence.strip()])))
        several = next((part.found for part in parts if len(part.found) > 1), None)
        if several is not None:
            return Several(self._sentences(several))
        return Understood(tuple(rule for part in parts for rule in part.found[0]))

    def _parts(self, text: str) -> Iterator[_Part]:
        yield _Part(text.strip(" ,;:.!?"), tuple(self.readings(text)))

    def _clauses(self, sentence: str) -> list[tuple[int, int]]:
        """Where the parts of a sentence begin and end that may each say a rule."""
        joint = "|".join(map(re.escape, sorted(self._grammar.joints(Joint.AND))))
        marks = r"[,;:.!?]+"
        for pattern in (
            rf"{marks}\s+(?:(?:{joint})\s+)?|{marks}$|\s+(?:{joint})\s+",
            r"[.!?]+(?:\s+|$)",
        ):
            ends = [(match.start(), match.end()) for match in re.finditer(pattern, sentence)]
            starts = [0, *(end for _, end in ends)]
            stops = [*(start for start, _ in ends), len(sentence)]
            spans = [
                (start, stop)
                for start, stop in zip(starts, stops, strict=True)
                if self.plainly.text(sentence[start:stop])
            ]
            if len(spans) <= MAX_CLAUSES:
                return spans
        return [(0, len(sentence))]

    def _quote(self, text: str) -> Quote:
        return Quote(text, self._nearest.to(text, SUGGESTIONS))

    def _sentences(self, readings: Iterable[tuple[Rule, ...]]) -> tuple[str, ...]:
        return tuple(" ".join(map(self.says, rules)) for rules in readings)


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of a sentence, and the rules that it may say."""

    text: str
    found: tuple[tuple[Rule, ...], ...]

    @property
    def cost(self) -> int:
        """How much is lost where it is not understood."""
        return 0 if self.found else len(self.text.split())


def _combined(
    clauses: Sequence[tuple[list[Rule], int]],
) -> Iterator[tuple[tuple[Rule, ...], tuple[int, int]]]:
    """The rules that clauses say together; exact words come first, then few rules."""
    rank = (max((rank for _, rank in clauses), default=0), len(clauses))
    for rules in islice(product(*(rules for rules, _ in clauses)), MAX_READINGS):
        yield rules, rank


@lru_cache(maxsize=16)
def listener_for(
    language: Language, board: Board, deck: Deck, lexicon: Lexicon = NO_LEXICON
) -> Listener:
    """Understands sentences about a board and deck; the last ones are kept."""
    return Listener(speaker_for(language, board, deck, lexicon), synonyms_of(language))

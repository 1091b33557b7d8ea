"""What only a deck and a board know, in every way a language says it.

Values, attributes, rows, comparatives, relations: each is said by the language's own speaker and
made plain, so that what is read is what would be said.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Final

from maestra.core.tokens import Scale, Value
from maestra.language.phrases import Degree, InRow, Nth, ValueNamed
from maestra.language.speaker import Speaker
from maestra.language.synonyms import Synonyms
from maestra.language.understanding.plain import Plainly, escaped
from maestra.language.wordings import ORIGINS

_NUMBER: Final = r" -?\d+(?:\.\d+)?"
_LETTER: Final = r" \w"
_SPELLED: Final = r" [^\W\d_]+"
MAX_PLACES: Final = 100
"""Rows, columns and places of a row are named up to this: as many as the largest board has."""
_CELL: Final = (77, 88)
"""Stands for any cell while its words are found out."""


@dataclass(frozen=True)
class Terminals:
    """The terminals of one language for one deck and board."""

    speaker: Speaker
    plainly: Plainly
    synonyms: Synonyms

    @cached_property
    def patterns(self) -> Mapping[str, str]:
        """A pattern for each that has words, by symbol in capitals."""
        listed = {
            name: "|".join(map(escaped, sorted(words, key=len, reverse=True)))
            for name, words in self._words.items()
            if words
        }
        values = "|".join(filter(None, (listed.get("VALUE"), _NUMBER)))
        return {
            **listed,
            "VALUE": values,
            "NUMBER": _NUMBER,
            "LETTER": _LETTER,
            "SPELLED": _SPELLED,
            "PLACE": self._place,
        }

    def read(self, symbol: str, text: str) -> list[object]:
        """What may be meant by the text of a terminal."""
        match symbol:
            case "NUMBER":
                return [number_of(text)]
            case "LETTER" | "SPELLED":
                return [text.strip()]
            case "PLACE":
                numbers = [int(word) for word in text.split() if word.isdigit()]
                return [(numbers[0], numbers[1])]
            case "VALUE":
                return [*self._words["VALUE"].get(text, ()), *self._numbers(text)]
            case _:
                return list(self._words[symbol].get(text, ()))

    def _numbers(self, text: str) -> Iterator[tuple[str, Value]]:
        """A number, shown under any attribute that has numbers."""
        if re.fullmatch(_NUMBER, text):
            for attribute in self._numeric:
                yield attribute, number_of(text)

    @property
    def _numeric(self) -> list[str]:
        scales = self.speaker.deck.scales
        return [*(name for name in scales if scales[name] is Scale.NUMBER), *ORIGINS]

    @property
    def _attributes(self) -> list[str]:
        return [*self.speaker.deck.scales, *ORIGINS]

    @cached_property
    def _place(self) -> str:
        """The pattern of any cell's name."""
        row, column = _CELL
        text = self.plainly.text(self.speaker.grammar.place(row, column).text)
        pattern = escaped(text)
        return pattern.replace(str(row), r"\d+").replace(str(column), r"\d+")

    @cached_property
    def _words(self) -> Mapping[str, Mapping[str, list[object]]]:
        """For each terminal that can be listed: its texts, and what each may mean."""
        return {
            "ATTRIBUTE": self._indexed(self._of_attributes()),
            "VALUE": self._indexed(self._of_values()),
            "ROW": self._indexed(self._of_rows()),
            "NTH": self._indexed(self._of_ordinals()),
            "RELATION_NAME": self._indexed((name, name) for name in self.speaker.deck.relations),
            "SHOWN": self._indexed(self._of_partners()),
            "THINGS": self._indexed(self._of_things()),
            "THING": self._indexed(self._of_thing()),
            **{
                f"{degree.value.upper()}_{called}": self._indexed(self._of_degrees(degree))
                for degree in Degree
                for called in ("THING", "THINGS")
            },
        }

    def _indexed(self, said: Iterable[tuple[str, object]]) -> dict[str, list[object]]:
        found: dict[str, list[object]] = {}
        for words, meant in said:
            text = self.plainly.text(words)
            if text and meant not in found.setdefault(text, []):
                found[text].append(meant)
        return found

    def _of_attributes(self) -> Iterator[tuple[str, object]]:
        for attribute in self._attributes:
            words = self.speaker.attribute(attribute)
            for noun in (words.noun, words.plural or words.noun, attribute):
                yield noun, attribute

    def _of_values(self) -> Iterator[tuple[str, object]]:
        deck = self.speaker.deck
        for attribute in deck.scales:
            shown = [token.value(attribute) for token in deck.tokens]
            listed = (*deck.orders.get(attribute, ()), *deck.cycles.get(attribute, ()))
            for value in dict.fromkeys((*shown, *listed)):
                if isinstance(value, str):
                    for words in self._ways(attribute, value):
                        yield words, (attribute, value)

    def _ways(self, attribute: str, value: str) -> Iterator[str]:
        """How a value is said, alone and in every form of its word."""
        yield value
        spoken = self.speaker.spoken(ValueNamed(attribute, value))
        yield spoken.text
        word = self.speaker.words.values.get((attribute, value), value)
        yield from word.split("|")

    def _of_rows(self) -> Iterator[tuple[str, object]]:
        for row in range(MAX_PLACES + 1):
            yield self.speaker.spoken(InRow(row)).text, row
        rows = self.speaker.board.rows
        for row in (1, rows):
            yield self.speaker.grammar.row(row, MAX_PLACES + rows).text, row

    def _of_ordinals(self) -> Iterator[tuple[str, object]]:
        for number in range(1, MAX_PLACES + 1):
            spoken = self.speaker.spoken(Nth(number))
            for words in (spoken.text, *spoken.forms.values()):
                yield words, number

    def _of_partners(self) -> Iterator[tuple[str, object]]:
        for pairs in self.speaker.deck.relations.values():
            for pair in pairs:
                for name in pair:
                    yield name, name

    def _of_things(self) -> Iterator[tuple[str, object]]:
        yield self.speaker.grammar.token.forms["plural"], None
        for attribute in self.speaker.deck.scales:
            words = self.speaker.attribute(attribute)
            for noun in (words.things, words.plural):
                if noun is not None:
                    yield noun, attribute

    def _of_thing(self) -> Iterator[tuple[str, object]]:
        yield self.speaker.grammar.token.text, None
        for attribute in self.speaker.deck.scales:
            yield self.speaker.attribute(attribute).noun, attribute

    def _of_degrees(self, degree: Degree) -> Iterator[tuple[str, object]]:
        common = {
            Degree.MORE: self.synonyms.more,
            Degree.LESS: self.synonyms.less,
            Degree.MOST: self.synonyms.most,
            Degree.LEAST: self.synonyms.least,
        }[degree]
        for attribute in self._attributes:
            own = self.speaker.degree(attribute, degree)
            forms = own.split("|") if own else []
            if self.speaker.deck.scales.get(attribute) is Scale.NUMBER:
                forms += common
            for form in forms:
                yield form, attribute


def number_of(text: str) -> Value:
    """The number that digits say."""
    number = Decimal(text.strip())
    return int(number) if number == number.to_integral_value() else number.normalize()

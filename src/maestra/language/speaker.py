"""From the intermediate explanation to words: each phrase of the tree, in one language."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Board
from maestra.core.tokens import Attributes, Deck, Scale, Value
from maestra.language.keys import Key, Predicate
from maestra.language.phrases import (
    Adjective,
    AttributeNamed,
    Count,
    Degree,
    Does,
    Foreign,
    InRow,
    Joint,
    Kind,
    Listing,
    Named,
    Nth,
    Numeral,
    Phrase,
    Place,
    Say,
    Several,
    Things,
    ValueNamed,
    say,
)
from maestra.language.templates import Gender, Spoken, fill, slots
from maestra.language.tongue import AttributeWords, Grammar, Naming, VerbForms, Words, inflect
from maestra.language.wordings import ORIGINS

_UNKNOWN: Final = AttributeWords("")
WITHOUT_ADJECTIVE: Final = MappingProxyType(
    {
        Predicate.MORE: Predicate.HAS_MORE,
        Predicate.LESS: Predicate.HAS_LESS,
        Predicate.MOST: Predicate.HIGHEST,
        Predicate.LEAST: Predicate.LOWEST,
        Predicate.MOST_LEFT: Predicate.HIGHEST_LEFT,
        Predicate.LEAST_LEFT: Predicate.LOWEST_LEFT,
        Predicate.AMONG_MOST: Predicate.AMONG_HIGHEST,
        Predicate.AMONG_LEAST: Predicate.AMONG_LOWEST,
        Predicate.AMONG_MOST_OF_ROW: Predicate.AMONG_HIGHEST_OF_ROW,
        Predicate.AMONG_LEAST_OF_ROW: Predicate.AMONG_LOWEST_OF_ROW,
    }
)
"""What is said instead where the attribute has no comparative or superlative."""
BESIDE_ATTRIBUTE: Final = MappingProxyType(
    {
        Predicate.IS: Predicate.SHOWS,
        Predicate.ABOVE: Predicate.HAS_ABOVE,
        Predicate.BELOW: Predicate.HAS_BELOW,
        Predicate.AMOUNT: Predicate.HAS_AMOUNT,
    }
)
"""What is said instead where a value is not understood without its attribute."""
_OF_NUMBERS: Final = frozenset(
    {
        Predicate.ODD,
        Predicate.EVEN,
        Predicate.PRIME,
        Predicate.MULTIPLE_OF,
        Predicate.DIGITS,
        Predicate.ABOVE,
        Predicate.BELOW,
        Predicate.AMOUNT,
        Predicate.MORE_BY,
        Predicate.LESS_BY,
        Predicate.APART_BY,
        Predicate.TWICE,
        Predicate.HALF,
        Predicate.TIMES,
        Predicate.TOGETHER,
    }
)
"""What is said of an attribute with numbers, unless another attribute is named."""
_HEADS: Final = (Naming.PLAIN, Naming.WORD, Naming.MEASURE, Naming.QUALITY)
"""Which way to name a token is preferred."""


@dataclass(frozen=True)
class Speaker:
    """Says things about one board and deck in one language."""

    grammar: Grammar
    words: Words
    board: Board
    deck: Deck

    def sentence(self, phrase: Phrase) -> str:
        """The phrase in words, beginning with a capital."""
        text = self.spoken(phrase).text
        return text[:1].upper() + text[1:]

    def spoken(self, phrase: Phrase) -> Spoken:  # noqa: C901, PLR0912 - one case for each kind of phrase
        """The phrase in words, with what others agree with."""
        match phrase:
            case Say(key, parts):
                spoken = self._parts(parts)
                text = self._fill(self.words.sentences[key], spoken)
                # What is said of "46 on its left" agrees with 46, of "the last" with a token.
                return Spoken(text, gender=spoken.get("token", self.grammar.token).gender)
            case Does():
                return self._does(phrase)
            case Several():
                return self._several(phrase)
            case Listing():
                return self._listing(phrase)
            case Named(shown):
                return self._named(shown)
            case ValueNamed(attribute, value):
                return self._value(attribute, value)
            case AttributeNamed(attribute):
                words = self.attribute(attribute)
                forms = {"plural": words.plural or words.noun}
                return Spoken(words.noun, forms, words.gender)
            case Things(attribute):
                return self._things(attribute)
            case Kind(predicate, parts):
                return self._kind(predicate, parts)
            case Adjective():
                return self._adjective(phrase, self.grammar.token)
            case Place(cell):
                return self.grammar.place(cell.row, cell.column)
            case InRow(row):
                return self.grammar.row(row, self.board.rows)
            case Numeral(number):
                return Spoken(self.grammar.numeral(number), many=number != 1)
            case Count(number):
                return self.grammar.count(number)
            case Nth(number):
                return self.grammar.nth(number)
            case Foreign(text):
                return Spoken(text)
            case _:
                assert_never(phrase)

    def _fill(self, template: str, phrases: Mapping[str, Spoken]) -> str:
        return fill(template, phrases, self.grammar.derive)

    def _parts(self, parts: Mapping[str, Phrase]) -> dict[str, Spoken]:
        return {name: self.spoken(part) for name, part in parts.items()}

    def _does(self, does: Does) -> Spoken:
        """What is said of a subject, in every form of the verb; `clause` has the subject too."""
        subject = self.grammar.token if does.subject is None else self.spoken(does.subject)
        verb, template = self._predicate(does)
        plural = replace(self.grammar.token, many=True)
        rests = (
            self._rest(template, does.parts, subject, does.predicate),
            self._rest(template, does.parts, plural, does.predicate),
        )
        return self._conjugate(self.words.verbs[verb], rests, does, subject)

    def _rest(
        self, template: str, parts: Mapping[str, Phrase], subject: Spoken, predicate: Predicate
    ) -> str:
        """What follows the verb, and where it is needed by which attribute."""
        text = self._fill(template, {**self._agreeing(parts, subject), "subject": subject})
        if "way" in parts:
            text = f"{text} {self.spoken(parts['way']).text}"
        attribute = parts.get("attribute")
        numeric = predicate in _OF_NUMBERS
        if isinstance(attribute, AttributeNamed) and self._is_shared(
            template, attribute, parts, numeric=numeric
        ):
            text = f"{text} {self.spoken(say(Key.BY_ATTRIBUTE, attribute=attribute)).text}"
        return text

    def _is_shared(
        self,
        template: str,
        attribute: AttributeNamed,
        parts: Mapping[str, Phrase],
        *,
        numeric: bool,
    ) -> bool:
        """Whether the words alone do not tell which attribute is meant.

        What is said of numbers is taken to be about them, if nothing else is said.
        """
        if "attribute" in slots(template):
            return False
        scale = self.deck.scales.get(attribute.attribute, Scale.NUMBER)
        if attribute.attribute in ORIGINS or (scale is not Scale.NUMBER and numeric):
            return True
        said = self._fill_of(template, parts)
        return any(
            self._fill_of(template, moved) == said
            for rival in self.deck.scales
            if rival != attribute.attribute
            and (moved := self._said_of(rival, attribute.attribute, parts)) is not None
        )

    def _fill_of(self, template: str, parts: Mapping[str, Phrase]) -> str:
        token = self.grammar.token
        return self._fill(template, {**self._agreeing(parts, token), "subject": token})

    def _said_of(
        self, rival: str, attribute: str, parts: Mapping[str, Phrase]
    ) -> Mapping[str, Phrase] | None:
        """The same said of another attribute; None if it makes no sense of that one."""
        scales = self.deck.scales
        moved: dict[str, Phrase] = {}
        own = False
        for name, part in parts.items():
            match part:
                case ValueNamed(_, value):
                    if not self._shows(rival, value):
                        return None
                    moved[name] = ValueNamed(rival, value)
                    own = True
                case Adjective():
                    moved[name] = replace(part, attribute=rival)
                    # "The smallest" is said of any order, "smaller" of numbers alone.
                    own = own or part.degree in {Degree.MOST, Degree.LEAST}
                    if self.degree(rival, part.degree) is None:
                        return None
                case _:
                    moved[name] = part
        alike = _alike(scales[rival]) == _alike(scales.get(attribute, Scale.NUMBER))
        return moved if own or alike else None

    def _shows(self, attribute: str, value: Value) -> bool:
        if not isinstance(value, str):
            return self.deck.scales[attribute] is Scale.NUMBER
        return any(token.value(attribute) == value for token in self.deck.tokens)

    def _predicate(self, does: Does) -> tuple[str, str]:
        """The verb and what follows it; a relation may have words of the caregiver's."""
        relation = does.parts.get("relation")
        if isinstance(relation, Foreign):
            own = self.words.relations.get((relation.text, does.predicate))
            if own is not None:
                return own
        return self.words.predicates[self._sayable(does.predicate, does.parts)]

    def _conjugate(
        self, verb: VerbForms, rests: tuple[str, str], does: Does, subject: Spoken
    ) -> Spoken:
        rest, of_many = rests
        negated = does.negated
        forms = {
            "must": f"{verb.must_not if negated else verb.must} {rest}",
            "does": f"{verb.does_not if negated else verb.does} {rest}",
            "that": f"{verb.that_not if negated else verb.that} {rest}",
            "do": f"{verb.do_not if negated else verb.do} {of_many}",
        }
        # A language may leave the pronoun out.
        clause = f"{subject.text} {forms['does']}".lstrip()
        return Spoken(forms["does"], {**forms, "clause": clause})

    def _agreeing(self, parts: Mapping[str, Phrase], subject: Spoken) -> dict[str, Spoken]:
        """The parts of what is said of `subject`; adjectives agree with it."""
        spoken: dict[str, Spoken] = {}
        for name, part in parts.items():
            match part:
                case Adjective():
                    spoken[name] = self._adjective(part, subject)
                case ValueNamed(attribute, value) if self._naming(attribute) is Naming.QUALITY:
                    word = self._value_word(attribute, value)
                    spoken[name] = Spoken(inflect(word, subject.gender, many=subject.many))
                case _:
                    spoken[name] = self.spoken(part)
        return spoken

    def _several(self, several: Several) -> Spoken:
        members = [self._member(each) for each in several.of]
        forms = {
            name: self.grammar.join([each.forms[name] for each in members], several.joint)
            for name in ("must", "does", "that", "do")
        }
        return Spoken(forms["does"], forms)

    def _member(self, member: Does | Several) -> Spoken:
        """One of several things; if it is several itself, where it begins is heard."""
        spoken = self.spoken(member)
        if isinstance(member, Does):
            return spoken
        key = Key.EITHER_OF if member.joint is Joint.OR else Key.BOTH_OF
        template = self.words.sentences[key]
        forms = {
            name: self._fill(template, {"several": Spoken(form)})
            for name, form in spoken.forms.items()
        }
        return Spoken(forms["does"], forms)

    def _listing(self, listing: Listing) -> Spoken:
        items = [self.spoken(item) for item in listing.items]
        joint = listing.joint
        names = frozenset(items[0].forms).intersection(*(item.forms for item in items))
        forms = {
            name: self.grammar.join([item.forms[name] for item in items], joint) for name in names
        }
        text = self.grammar.join([item.text for item in items], joint)
        return Spoken(text, forms, items[0].gender, len(items) > 1 or items[0].many)

    def _kind(self, predicate: Predicate, parts: Mapping[str, Phrase]) -> Spoken:
        plural = replace(self.grammar.token, many=True)
        template = self.words.kinds[self._sayable(predicate, parts)]
        text = self._rest(template, parts, plural, predicate)
        if "things" in slots(template):
            return Spoken(text, gender=self.spoken(parts["things"]).gender, many=True)
        multiples = predicate is Predicate.MULTIPLE_OF
        return Spoken(text, gender=Gender.MASCULINE if multiples else plural.gender, many=True)

    def _things(self, attribute: str) -> Spoken:
        """What tokens are called that show `attribute` and nothing else."""
        words = self.attribute(attribute)
        alone = all(len(token.attributes) == 1 for token in self.deck.tokens)
        if not alone or words.things is None:
            return replace(self.grammar.token, text=self.grammar.token.forms["plural"], many=True)
        return Spoken(words.things, gender=words.gender, many=True)

    def _sayable(self, predicate: Predicate, parts: Mapping[str, Phrase]) -> Predicate:
        """What can be said of the attribute with the words there are."""
        adjective, attribute = parts.get("adjective"), parts.get("attribute")
        if (
            isinstance(adjective, Adjective)
            and self.degree(adjective.attribute, adjective.degree) is None
        ):
            return WITHOUT_ADJECTIVE.get(predicate, predicate)
        if isinstance(attribute, AttributeNamed) and self._is_apart(attribute.attribute):
            return BESIDE_ATTRIBUTE.get(predicate, predicate)
        return predicate

    def degree(self, attribute: str, degree: Degree) -> str | None:
        """What the greater or lesser of tokens is called, if there is a word."""
        words = self.attribute(attribute)
        match degree:
            case Degree.MORE:
                return words.more
            case Degree.LESS:
                return words.less
            case Degree.MOST:
                return words.most
            case Degree.LEAST:
                return words.least
            case _:
                assert_never(degree)

    def _adjective(self, adjective: Adjective, subject: Spoken) -> Spoken:
        word = self.degree(adjective.attribute, adjective.degree) or ""
        if adjective.many:
            return Spoken(inflect(word, self.grammar.token.gender, many=True))
        return Spoken(inflect(word, subject.gender, many=subject.many))

    def attribute(self, attribute: str) -> AttributeWords:
        """The words of an attribute."""
        words = self.words.attributes.get(attribute, replace(_UNKNOWN, noun=attribute))
        if attribute not in self._namesakes:
            return words
        return replace(words, noun=attribute, plural=None, things=None)

    @cached_property
    def _namesakes(self) -> frozenset[str]:
        """Attributes of the deck that would be called the same; their names tell them apart."""
        known = self.words.attributes
        nouns = {name: known[name].noun if name in known else name for name in self.deck.scales}
        counts = Counter(nouns.values())
        return frozenset(name for name, noun in nouns.items() if counts[noun] > 1)

    def _is_apart(self, attribute: str) -> bool:
        """Whether a value of `attribute` is said with the attribute's name beside it."""
        return self._naming(attribute) in {None, Naming.MEASURE}

    def _naming(self, attribute: str) -> Naming | None:
        return self.attribute(attribute).naming

    def _value_word(self, attribute: str, value: Value) -> str:
        if isinstance(value, str):
            return self.words.values.get((attribute, value), value)
        return self.grammar.numeral(value)

    def _value(self, attribute: str, value: Value) -> Spoken:
        """A value where it stands for a token: 34, C, red."""
        words = self.attribute(attribute)
        text = self._value_word(attribute, value)
        match words.naming:
            case Naming.PLAIN:
                return self.grammar.plain(text, value, words)
            case Naming.WORD:
                return self.grammar.word(text.split("|")[0])
            case _:
                return Spoken(text.split("|")[0])

    def _named(self, shown: Attributes) -> Spoken:
        if shown not in self._names:
            self._names[shown] = self._name(shown)
        return self._names[shown]

    @cached_property
    def _names(self) -> dict[Attributes, Spoken]:
        return {}

    def _name(self, shown: Attributes) -> Spoken:
        """A token by the one attribute that names it best, and those that tell it from others."""
        ranked = sorted(shown, key=lambda pair: _HEADS.index(self._manner(*pair)))
        if not ranked:
            return self.grammar.token
        (attribute, value), *others = ranked
        words = self.attribute(attribute)
        text = self._value_word(attribute, value)
        manner = self._manner(attribute, value)
        match manner:
            case Naming.PLAIN:
                head = self.grammar.plain(text, value, words)
            case Naming.WORD:
                head = self.grammar.word(text.split("|")[0])
            case Naming.QUALITY:
                head = self.grammar.quality(text)
            case Naming.MEASURE:
                head = self.grammar.measure(words, text)
            case _:
                assert_never(manner)
        rivals = {t.attributes for t in self.deck.tokens if (attribute, value) in t.attributes}
        more: list[str] = []
        for pair in others:
            rest = {rival for rival in rivals if pair in rival}
            if len(rest) < len(rivals):
                rivals = rest
                more.append(inflect(self._value_word(*pair), head.gender))
        return self.grammar.qualify(head, more) if more else head

    def _manner(self, attribute: str, value: Value) -> Naming:
        default = Naming.WORD if isinstance(value, str) else Naming.MEASURE
        return self._naming(attribute) or default


def _alike(scale: Scale) -> Scale:
    """The scale of which the same is said: a cycle is spoken of as an order."""
    return Scale.ORDER if scale is Scale.CYCLE else scale

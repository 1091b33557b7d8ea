"""A caregiver's own words as a JSON file: docs/how-to/your-own-words.md shows one."""

from collections.abc import Iterator
from typing import Annotated, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictStr, ValidationError

from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object
from maestra.language.keys import Predicate
from maestra.language.languages import Language, words_of
from maestra.language.lexicon import Lexicon
from maestra.language.templates import Gender, slots
from maestra.language.tongue import AttributeWords, Naming, OwnWords

WORDS_FORMAT: Final = "maestra.words/1"

_Word = Annotated[StrictStr, Field(min_length=1, max_length=100, pattern=r"^[^{}\[\]@#]+$")]
_Phrase = Annotated[StrictStr, Field(min_length=1, max_length=200, pattern=r"^[^\[\]@#]+$")]
_ByLanguage = dict[Literal["en", "es", "ca"], _Word]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class AttributeJson(_Strict):
    """The words of one attribute in one language."""

    noun: Annotated[_Word, Field(description="What the attribute is called: size.")]
    gender: Annotated[
        Literal["m", "f"], Field(description="The noun's gender; English does not need it.")
    ] = "m"
    plural: Annotated[_Word | None, Field(description="The noun's plural: sizes.")] = None
    things: Annotated[
        _Word | None, Field(description="What tokens are called that show only this: numbers.")
    ] = None
    more: Annotated[
        _Word | None,
        Field(description="The greater of two: bigger. Forms by gender: más alto|más alta."),
    ] = None
    less: Annotated[_Word | None, Field(description="The lesser of two: smaller.")] = None
    most: Annotated[_Word | None, Field(description="The greatest of all: biggest.")] = None
    least: Annotated[_Word | None, Field(description="The least of all: smallest.")] = None
    naming: Annotated[
        Literal["plain", "word", "quality", "measure"] | None,
        Field(
            description="How a token is named by it: plain (34), word (cup), quality (the red "
            "token), measure (size 3)."
        ),
    ] = None

    def words(self) -> AttributeWords:
        """The same, for the language."""
        naming = None if self.naming is None else Naming(self.naming)
        return AttributeWords(
            self.noun,
            Gender(self.gender),
            self.plural,
            self.things,
            self.more,
            self.less,
            self.most,
            self.least,
            naming,
        )


class RelationJson(_Strict):
    """The words of one of a deck's relations in one language."""

    verb: Annotated[_Word, Field(description="A verb that the language knows: be, have, go.")]
    rest: Annotated[
        _Phrase,
        Field(description="What follows, said of the second token: the mate of {other}."),
    ]
    back: Annotated[
        _Phrase | None, Field(description="What follows, said of the first token of the pair.")
    ] = None


class WordsJson(_Strict):
    """A file of words."""

    format: Annotated[Literal["maestra.words/1"], Field(description="What the file is.")]
    attributes: Annotated[
        dict[_Word, dict[Literal["en", "es", "ca"], AttributeJson]],
        Field(description="Attribute, as the tokens name it, to its words in each language."),
    ] = Field(default_factory=dict[str, dict[Literal["en", "es", "ca"], AttributeJson]])
    values: Annotated[
        dict[_Word, dict[_Word, _ByLanguage]],
        Field(description="Attribute, value as tokens show it, and its word in each language."),
    ] = Field(default_factory=dict[str, dict[str, _ByLanguage]])
    relations: Annotated[
        dict[_Word, dict[Literal["en", "es", "ca"], RelationJson]],
        Field(description="Relation, as the deck names it, to its words in each language."),
    ] = Field(default_factory=dict[str, dict[Literal["en", "es", "ca"], RelationJson]])

    def lexicon(self) -> Lexicon:
        """The words by language.

        Raises:
            InvalidError: a verb that a language does not know, or a gap other than {other}; all
                of them at once.
        """
        refuse(list(self._faults()))
        return Lexicon({language.value: self._own(language.value) for language in Language})

    def _own(self, code: str) -> OwnWords:
        attributes = {
            name: each.words()
            for name, by_language in self.attributes.items()
            for language, each in by_language.items()
            if language == code
        }
        values = {
            (name, value): word
            for name, by_value in self.values.items()
            for value, by_language in by_value.items()
            for language, word in by_language.items()
            if language == code
        }
        relations = {
            (name, side): (each.verb, rest)
            for name, by_language in self.relations.items()
            for language, each in by_language.items()
            for side, rest in (
                (Predicate.RELATED, each.rest),
                (Predicate.RELATED_BACK, each.back),
            )
            if language == code and rest is not None
        }
        return OwnWords(attributes, values, relations)

    def _faults(self) -> Iterator[Fault]:
        for name, by_language in self.relations.items():
            for code, each in by_language.items():
                where = f"relations.{name}.{code}"
                verbs = words_of(Language(code)).verbs
                if each.verb not in verbs:
                    yield Fault(f"{where}.verb", each.verb, f"one of {', '.join(verbs)}")
                for field, rest in (("rest", each.rest), ("back", each.back)):
                    if rest is not None and slots(rest) != frozenset({"other"}):
                        yield Fault(f"{where}.{field}", rest, "words with {other} in them")


def read_words(text: bytes, file: str = "-") -> Lexicon:
    """The words in a file's bytes.

    Raises:
        FormatError: it is no file of words; with every fault.
    """
    fields = decode_object(text, file, 1, WORDS_FORMAT)
    try:
        return WordsJson.model_validate(fields).lexicon()
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_validation(error, WordsJson)) from None
    except InvalidError as error:
        raise FormatError(file, 1, error.faults) from None

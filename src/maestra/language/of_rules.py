"""What is said of a rule: the table of all forms, and rules as phrases by it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final, cast

from maestra.core.board import Cell, Column, Row
from maestra.core.tokens import LETTER, Scale
from maestra.language.keys import Key
from maestra.language.of_pairs import Two
from maestra.language.of_places import (
    ALONG,
    AMOUNT,
    CHOICE,
    CONDITION,
    FILLINGS,
    PEAK,
    PLACE,
    PLACE_OF_ROW,
    STAGES,
    TEST,
    WHOLE_AMOUNT,
    Filled,
    Spot,
    Stage,
    first_said,
    number_of_tokens,
    spot,
)
from maestra.language.of_tokens import Tokens, board_row, storage_row_of
from maestra.language.phrases import (
    Count,
    Does,
    Foreign,
    InRow,
    Joint,
    Listing,
    Numeral,
    Phrase,
    Place,
    Say,
    Several,
    ValueNamed,
    say,
)
from maestra.language.wordings import ATTRIBUTE, NUMBER, ORIGINS, About, Part, Wording, put
from maestra.rules.canonical import canonical, canonical_test
from maestra.rules.features import TokenFeature
from maestra.rules.fields import Position
from maestra.rules.forms.base import FIRST, Direction
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Equation, Kinds, Operation, Total
from maestra.rules.forms.counting import Count as Counted
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
    order_of,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import Compare, Relation, different, same
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.token_tests import Anything, Comparison, Has, Not, TokenTest, has

_ORDERS: Final = {
    order_of(direction, strict=strict): (direction, strict)
    for direction in Direction
    for strict in (True, False)
}


def _tokens(about: About) -> Tokens:
    return about if isinstance(about, Tokens) else Tokens(about.board, about.deck)


# ---------------------------------------------------------------- tests of every token


def _kind(test: TokenTest, about: About) -> Phrase | None:
    return _tokens(about).kind(test)


_KIND: Final = (Part("kind", _kind), "test")
_NO_KIND: Final = (
    Part(
        "kind",
        lambda test, about: _kind(test.of, about) if isinstance(test, Not) else None,
        lambda test, _: Not(test),
    ),
    "test",
)


def _source(key: Key, name: str, *, negated: bool) -> Wording:
    """All from one row or column, or none."""

    def phrase(test: TokenTest, about: About) -> Phrase | None:
        if isinstance(test, Not) is not negated:
            return None
        positive = test.of if isinstance(test, Not) else test
        if not isinstance(positive, Has):
            return None
        return _tokens(about).has(positive.feature).parts.get(name)

    def meaning(read: int, about: About) -> TokenTest | None:
        row = storage_row_of(read, about) if name == "row" else read
        found = None if row is None else has_origin(name, row)
        return Not(found) if found is not None and negated else found

    if name == "row":
        return put(key, EveryToken, row=(Part("row", phrase, meaning), "test"))
    return put(key, EveryToken, column=(Part("number", phrase, meaning), "test"))


def has_origin(name: str, number: int) -> Has:
    """That a token comes from a storage row, or from a column."""
    attribute = ORIGINS[0] if name == "row" else ORIGINS[1]
    return Has(TokenFeature(f"is-{number}", attribute))


# ---------------------------------------------------------------- two tokens


def _beside(key: Key | Spot) -> tuple[Part, str]:
    """How each token stands to the one that `key` names."""

    def phrase(relation: Relation, about: About) -> Phrase | None:
        other = spot(key.position, key.line, about) if isinstance(key, Spot) else say(key)
        return Two(_tokens(about), None, other).stands(relation)

    def meaning(read: tuple[Relation, object], _: About) -> Relation | None:
        relation, other = read
        return relation if other == key else None

    return Part("relation", phrase, meaning), "relation"


def _ordered(key: Key) -> tuple[Any, ...]:
    """As `_beside`, of an order: a comparison of one attribute."""
    part, _ = _beside(key)

    def phrase(fields: tuple[str, Direction, bool], about: About) -> Phrase | None:
        attribute, direction, strict = fields
        return part.phrase(Compare(attribute, order_of(direction, strict=strict)), about)

    def meaning(read: object, about: About) -> tuple[str, Direction, bool] | None:
        match part.meaning(read, about):
            case Compare(attribute, comparison, None) if comparison in _ORDERS:
                return attribute, *_ORDERS[comparison]
            case _:
                return None

    return Part("relation", phrase, meaning), "attribute", "direction", "strict"


def _neighbours(key: Key, *, ordered: bool) -> tuple[Part, str]:
    """As `_beside`, only of orders or only of what is none."""
    part, name = _beside(key)

    def fits(relation: Relation) -> bool:
        own = isinstance(relation, Compare) and relation.other is None
        return (own and cast("Compare", relation).comparison in _ORDERS) is ordered

    def phrase(relation: Relation, about: About) -> Phrase | None:
        return part.phrase(relation, about) if fits(relation) else None

    def meaning(read: object, about: About) -> Relation | None:
        relation = cast("Relation | None", part.meaning(read, about))
        return relation if relation is not None and (ordered or fits(relation)) else None

    return Part("relation", phrase, meaning), name


def _to_place(fields: tuple[Relation, Position], about: About) -> Phrase | None:
    relation, first = fields
    return Two(_tokens(about), None, spot(first, Line.ROW, about)).stands(relation)


def _of_place(read: tuple[Relation, object], _: About) -> tuple[Relation, Position] | None:
    match read:
        case (relation, Spot(position, Line.ROW)):
            return relation, position
        case _:
            return None


_TO_PLACE: Final = (Part("relation", _to_place, _of_place), "relation", "first")


def _pairs(pairs: Pairs, line: Line) -> dict[str, object]:
    return {"pairs": pairs, "line": line}


# ---------------------------------------------------------------- patterns and sums


def _steps(tests: tuple[TokenTest, ...], about: About) -> Phrase:
    stages = [Stage(nth, test) for nth, test in enumerate(tests, start=1)]
    return Listing(tuple(first_said(STAGES, each, about) for each in stages), Joint.COMMA)


def _tests(stages: tuple[Stage, ...], _: About) -> tuple[TokenTest, ...] | None:
    numbered = [stage.nth for stage in stages] == list(range(1, len(stages) + 1))
    return tuple(stage.test for stage in stages) if numbered else None


def _values(tests: tuple[TokenTest, ...], about: About) -> Phrase | None:
    found = tuple(_tokens(about).value_of(test) for test in tests)
    known = tuple(value for value in found if value is not None)
    if len(known) < len(found) or any(_is_shared(value, about) for value in known):
        return None
    return Listing(known, Joint.COMMA)


def _is_shared(named: ValueNamed, about: About) -> bool:
    """Whether a value alone does not tell under which attribute it is shown."""
    others = [name for name in about.deck.scales if name != named.attribute]
    if not isinstance(named.value, str):
        return any(about.deck.scales[name] is Scale.NUMBER for name in others)
    return any(token.value(name) == named.value for token in about.deck.tokens for name in others)


_STEPS: Final = (Part("stages", _steps, _tests), "tests")
_VALUES: Final = (
    Part(
        "values",
        _values,
        lambda pairs, _: tuple(
            Has(TokenFeature(f"is-{value}", attribute)) for attribute, value in pairs
        ),
    ),
    "tests",
)
_LETTERS: Final = (
    Part("letters", lambda text, _: Listing(tuple(map(Foreign, text)), Joint.COMMA)),
    "letters",
)


def _places(joint: Joint) -> tuple[Part, str]:
    def phrase(places: tuple[Position, ...], about: About) -> Phrase:
        return Listing(tuple(spot(place, Line.ROW, about) for place in places), joint)

    def meaning(terms: tuple[object, ...], _: About) -> tuple[Position, ...] | None:
        spots = [term for term in terms if isinstance(term, Spot) and term.line is Line.ROW]
        return tuple(one.position for one in spots) if len(spots) == len(terms) else None

    return Part(f"terms_{joint.value}", phrase, meaning), "left"


def _terms(joint: Joint, neutral: int) -> tuple[Part, str, str]:
    """Places, and a number at the end unless it changes nothing."""
    part, _ = _places(joint)

    def phrase(fields: tuple[tuple[Position, ...], Any], about: About) -> Phrase:
        places, constant = fields
        terms: list[Phrase] = [spot(place, Line.ROW, about) for place in places]
        if not terms or constant != neutral:
            terms.append(Numeral(constant))
        return Listing(tuple(terms), joint)

    def meaning(terms: tuple[object, ...], about: About) -> tuple[object, object] | None:
        last = terms[-1]
        ends = not isinstance(last, Spot)
        places = part.meaning(terms[:-1] if ends else terms, about)
        return None if places is None else (places, last if ends else neutral)

    return Part(f"terms_{joint.value}", phrase, meaning), "right", "constant"


def _compared(compare: Callable[[str], Relation]) -> tuple[Part, str]:
    """What two tokens show is compared under an attribute; understood, and said otherwise."""
    return (
        Part("attribute", lambda _, __: None, lambda attribute, _: compare(attribute)),
        "relation",
    )


def _spelled(word: str, about: About) -> tuple[TokenTest, ...] | None:
    """The tokens that show the letters of a word; None unless there is one for each."""
    shown = {
        value.casefold(): value
        for token in about.deck.tokens
        if isinstance(value := token.value(LETTER), str)
    }
    if not all(letter in shown for letter in word):
        return None
    return tuple(has(f"is-{shown[letter]}", LETTER) for letter in word)


_WORD: Final = (Part("spelled", lambda _, __: None, _spelled), "tests")


# ---------------------------------------------------------------- what the start fixes


def _model_row(row: int, about: About) -> Phrase | None:
    return board_row(about.board, row)


_MODEL_ROW: Final = (
    Part("row", _model_row, lambda row, about: storage_row_of(row, about) or None),
    "row",
)


def _cue_cell(pair: tuple[int, int], about: About) -> Phrase | None:
    row, column = pair
    return Place(Cell(Row(board_row(about.board, row).row), Column(column)))


def _cue_place(cell: tuple[int, int], about: About) -> tuple[int, int] | None:
    row = storage_row_of(cell[0], about)
    return None if not row else (row, cell[1])


_CUE_PLACE: Final = (Part("place", _cue_cell, _cue_place), "row", "column")


def _goal_row(_: Filling | None, about: About) -> Phrase:
    return InRow(about.board.goal_row)


_GOAL_ROW: Final = (
    Part(
        "row",
        _goal_row,
        lambda row, about: True if row == about.board.goal_row else None,
    ),
)
_THE_TOKENS: Final = (Part("the_tokens", lambda _, __: say(Key.THE_TOKENS)),)
_ORDER: Final = (
    Part(
        "filling",
        lambda filling, about: first_said(FILLINGS, Filled(filling), about),
        lambda filled, _: filled.filling,
    ),
    "filling",
)
_FOREIGN: Final = Part("shown", lambda text, _: None if text is None else Foreign(text))
_RELATION: Final = Part("relation_name", lambda text, _: None if text is None else Foreign(text))
_WHICH, _FIRST_TEST, _SECOND_TEST = ((TEST, name) for name in ("test", "first", "second"))
_ATTRIBUTE: Final = (ATTRIBUTE, "attribute")

RULES: Final[tuple[Wording, ...]] = (
    _source(Key.FROM_ROW, "row", negated=False),
    _source(Key.NOT_FROM_ROW, "row", negated=True),
    _source(Key.FROM_COLUMN, "column", negated=False),
    _source(Key.NOT_FROM_COLUMN, "column", negated=True),
    put(Key.ONLY, EveryToken, kind=_KIND, row=_GOAL_ROW),
    put(Key.NONE, EveryToken, kind=_NO_KIND, row=_GOAL_ROW),
    put(Key.ONLY_THAT, EveryToken, does=_WHICH),
    put(Key.USE_ALL, AllOfThem, kind=_KIND),
    put(Key.USE_ALL_TOKENS, AllOfThem, {"test": Anything()}),
    put(Key.USE_ALL_THAT, AllOfThem, does=_WHICH),
    # Two tokens.
    *(
        put(Key.EACH_TOKEN, Ordered, {"line": line}, does=_ordered(key))
        for line, key in (
            (Line.ROW, Key.THE_ONE_ON_ITS_LEFT),
            (Line.TIME, Key.THE_ONE_BEFORE_IT),
        )
    ),
    *(
        put(
            Key.EACH_TOKEN,
            EachPair,
            _pairs(Pairs.NEIGHBOURS, line),
            does=_neighbours(key, ordered=ordered),
        )
        for line, key, ordered in (
            (Line.ROW, Key.THE_ONE_ON_ITS_LEFT, False),
            (Line.ROW, Key.THE_NEIGHBOUR_ON_ITS_LEFT, True),
            (Line.TIME, Key.THE_ONE_BEFORE_IT, False),
            (Line.TIME, Key.THE_ONE_JUST_BEFORE_IT, True),
        )
    ),
    *(
        put(key, EachPair, _pairs(pairs, line), does=_beside(other))
        for key, pairs, line, other in (
            (Key.EACH_TOKEN, Pairs.ALL, Line.ROW, Key.EVERY_ONE_ON_ITS_LEFT),
            (Key.EACH_TOKEN, Pairs.ALL, Line.TIME, Key.EVERY_ONE_BEFORE_IT),
            (Key.EACH_TOKEN, Pairs.FIRST_WITH_REST, Line.ROW, Spot(FIRST, Line.ROW)),
            (Key.EACH_TOKEN, Pairs.FIRST_WITH_REST, Line.TIME, Spot(FIRST, Line.TIME)),
            (Key.IN_EACH_PAIR, Pairs.TWO_BY_TWO, Line.ROW, Key.THE_ONE_ON_ITS_LEFT),
            (Key.IN_EACH_PAIR, Pairs.TWO_BY_TWO, Line.TIME, Key.THE_ONE_BEFORE_IT),
            (Key.IN_RIGHT_HALF, Pairs.MIRRORED, Line.ROW, Key.THE_OPPOSITE_ONE),
        )
    ),
    put(Key.SUBJECT_MUST, TwoPlaces, subject=(PLACE_OF_ROW, "second"), does=_TO_PLACE),
    put(Key.SUBJECT_MUST, ExtremeAt, subject=(PLACE_OF_ROW, "position"), does=PEAK),
    put(Key.SUBJECT_MUST, At, subject=PLACE, does=_WHICH),
    # The shape of the whole.
    *(
        put(key, form, {field: value}, along=ALONG, attribute=_ATTRIBUTE)
        for key, form, field, value in (
            (Key.CYCLE_RISING, CyclicOrdered, "direction", Direction.RISING),
            (Key.CYCLE_FALLING, CyclicOrdered, "direction", Direction.FALLING),
            (Key.RISE_AND_FALL, RiseAndFall, "direction", Direction.RISING),
            (Key.FALL_AND_RISE, RiseAndFall, "direction", Direction.FALLING),
            (Key.EQUAL_STEPS, EqualSteps, "ratio", False),
            (Key.EQUAL_RATIOS, EqualSteps, "ratio", True),
        )
    ),
    put(Key.ZIGZAG, Zigzag, along=ALONG, attribute=_ATTRIBUTE),
    put(Key.BLOCKS, Blocks, along=ALONG, attribute=_ATTRIBUTE),
    put(Key.THIS_ROW, Pattern, {"repeat": False, "line": Line.ROW}, tokens=_VALUES),
    put(Key.PATTERN, Pattern, {"repeat": False}, along=ALONG, steps=_STEPS),
    put(Key.PATTERN_REPEATED, Pattern, {"repeat": True}, along=ALONG, steps=_STEPS),
    *(
        put(
            key,
            Template,
            {"repeat": repeat},
            along=ALONG,
            attribute=_ATTRIBUTE,
            pattern=_LETTERS,
        )
        for key, repeat in ((Key.TEMPLATE, False), (Key.TEMPLATE_REPEATED, True))
    ),
    # How many, and how much.
    put(
        Key.PLACE_SO_MANY,
        Counted,
        {"test": Anything()},
        amount=WHOLE_AMOUNT,
        count=(Part("number", number_of_tokens), "comparison", "number"),
    ),
    put(Key.HAS_ONE_THAT, Counted, {"number": 1}, amount=WHOLE_AMOUNT, does=_WHICH),
    put(Key.HAS_MANY_THAT, Counted, amount=WHOLE_AMOUNT, does=_WHICH),
    *(
        put(key, CompareCounts, {"comparison": comparison}, first=_FIRST_TEST, second=_SECOND_TEST)
        for key, comparison in (
            (Key.HAS_AS_MANY_AS, Comparison.EQUAL),
            (Key.HAS_AT_LEAST_AS_MANY_AS, Comparison.AT_LEAST),
            (Key.HAS_AT_MOST_AS_MANY_AS, Comparison.AT_MOST),
            (Key.HAS_MORE_THAN, Comparison.MORE),
            (Key.HAS_FEWER_THAN, Comparison.LESS),
            (Key.HAS_NOT_AS_MANY_AS, Comparison.DIFFERENT),
        )
    ),
    put(Key.KINDS, Kinds, amount=AMOUNT, attribute=_ATTRIBUTE),
    put(Key.TOTAL, Total, amount=AMOUNT, attribute=_ATTRIBUTE),
    put(
        Key.EQUATION,
        Equation,
        {"operation": Operation.SUM},
        left=_places(Joint.PLUS),
        right=_terms(Joint.PLUS, 0),
        attribute=_ATTRIBUTE,
    ),
    put(
        Key.EQUATION,
        Equation,
        {"operation": Operation.PRODUCT},
        left=_places(Joint.TIMES),
        right=_terms(Joint.TIMES, 1),
        attribute=_ATTRIBUTE,
    ),
    put(
        Key.IF_THEN,
        IfThen,
        condition=(CONDITION, "condition"),
        consequence=(CONDITION, "consequence"),
    ),
    put(Key.WORD_WITH, Word, relation=_RELATION, value=_FOREIGN, attribute=_ATTRIBUTE),
    put(Key.WORD, Word, {"relation": None, "value": None}, attribute=_ATTRIBUTE),
    # Where from, when, and how many.
    put(Key.SAME_COLUMN, StraightUp, {"mirrored": False}),
    put(Key.MIRRORED_COLUMN, StraightUp, {"mirrored": True}),
    put(Key.TAKE, TakeExtreme, {"among": Anything()}, does=CHOICE),
    put(Key.TAKE_OF_THOSE, TakeExtreme, among=(TEST, "among"), does=CHOICE),
    put(Key.PLACE, FillOrder, tokens=_THE_TOKENS, row=_GOAL_ROW, order=_ORDER),
    put(Key.ALL_BEFORE, Before, {"line": Line.TIME}, first=_FIRST_TEST, second=_SECOND_TEST),
    put(Key.ALL_LEFT_OF, Before, {"line": Line.ROW}, first=_FIRST_TEST, second=_SECOND_TEST),
    *(
        put(
            key,
            Follows,
            {"line": line, "immediately": immediately},
            first=_WHICH,
            second=(TEST, "follower"),
        )
        for key, line, immediately in (
            (Key.NEXT_AFTER, Line.TIME, True),
            (Key.LATER_AFTER, Line.TIME, False),
            (Key.NEXT_RIGHT_OF, Line.ROW, True),
            (Key.LATER_RIGHT_OF, Line.ROW, False),
        )
    ),
    *(
        put(key, ModelRow, {"reading": reading}, row=_MODEL_ROW, does=_beside(Key.ITS_MODEL))
        for key, reading in (
            (Key.MODEL_COPIED, Reading.COPIED),
            (Key.MODEL_MIRRORED, Reading.MIRRORED),
            (Key.MODEL_REVERSED, Reading.REVERSED),
        )
    ),
    put(Key.CUE, Cue, place=_CUE_PLACE, does=_beside(Key.THIS_ONE)),
    put(Key.FILL_ROW, FullRow, row=_GOAL_ROW),
    put(Key.UNTIL_TOTAL, UntilTotal, k=(NUMBER, "number"), attribute=_ATTRIBUTE),
    # Never said, only understood: the lines above say the same.
    *(
        put(
            key,
            Ordered,
            {"direction": direction, "strict": True, "line": Line.ROW},
            attribute=_ATTRIBUTE,
            row=_GOAL_ROW,
            scales=scales,
        )
        for direction, keys in (
            (
                Direction.RISING,
                (Key.SMALL_TO_LARGE, Key.IN_THE_ALPHABET, Key.FIRST_TO_LAST),
            ),
            (
                Direction.FALLING,
                (Key.LARGE_TO_SMALL, Key.BACK_IN_THE_ALPHABET, Key.LAST_TO_FIRST),
            ),
        )
        for key, scales in zip(
            keys,
            ({Scale.NUMBER}, {Scale.LETTER}, {Scale.ORDER, Scale.CYCLE}),
            strict=True,
        )
    ),
    put(Key.ALL_THE_SAME, EachPair, _pairs(Pairs.ALL, Line.ROW), attribute=_compared(same)),
    put(Key.ALL_DIFFERENT, EachPair, _pairs(Pairs.ALL, Line.ROW), attribute=_compared(different)),
    put(
        Key.NEIGHBOURS_DIFFER,
        EachPair,
        _pairs(Pairs.NEIGHBOURS, Line.ROW),
        attribute=_compared(different),
    ),
    put(Key.HAS_OF_KIND, Counted, amount=WHOLE_AMOUNT, kind=_KIND),
    put(Key.SPELL, Pattern, {"repeat": False, "line": Line.ROW}, word=_WORD),
)
"""Every form of rule; of several lines for a rule the first that fits is said."""


@dataclass(frozen=True, slots=True)
class Rules:
    """Says rules about one deck and board."""

    tokens: Tokens

    def says(self, rule: Rule) -> Say:
        """The rule as a sentence; rules of one meaning in one way."""
        return first_said(RULES, canonical(rule), self.tokens)

    def placing(self, filling: Filling | None, counts: tuple[int, ...] | None) -> Say:
        """Into which row the tokens go, how many (None: as many as fit), and in which order."""
        if filling is None:
            return self.placing_in(say(Key.ANY_ORDER), counts)
        return self.placing_in(first_said(FILLINGS, Filled(filling), self.tokens), counts)

    def placing_in(self, order: Say, counts: tuple[int, ...] | None) -> Say:
        """As `placing`, in an order that is said already."""
        tokens = say(Key.THE_TOKENS)
        if counts is not None:
            many = Listing(tuple(Count(number) for number in counts), Joint.OR)
            tokens = say(Key.SO_MANY_TOKENS, count=many)
        row = InRow(self.tokens.board.goal_row)
        return say(Key.PLACE, tokens=tokens, row=row, order=order)

    def does(self, test: TokenTest, subject: Phrase | None = None) -> Does | Several:
        """That a token passes a test."""
        return self.tokens.passes(canonical_test(test), subject)


def relation_of(rule: Ordered | EachPair) -> Relation:
    """What the left, or earlier, of two tokens must be to the other."""
    if isinstance(rule, EachPair):
        return rule.relation
    return Compare(rule.attribute, order_of(rule.direction, strict=rule.strict))

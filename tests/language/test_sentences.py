"""What other parts ask for: rules, gaps, actions, and why a move is refused."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Attributes, Deck, Token, TokenId
from maestra.language import (
    Language,
    check_sentence,
    explain_action,
    feature_of_token,
    gap_sentences,
    reason,
    rule_sentences,
)
from maestra.language.languages import speaker_for
from maestra.language.phrases import Adjective, Degree
from maestra.learning.grounded import learn_grounded
from maestra.rules.account import broken_ids
from maestra.rules.features import CellFeature, PairFeature, TokenFeature
from maestra.rules.fields import Position
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.pairs import different, same
from maestra.rules.rule import Rule
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows
from maestra.rules.summaries.summary import Check, Narrow, Step, Summary, Unseen, summarise
from maestra.rules.token_tests import Anything, Not, has
from maestra.rules.verdicts import (
    AfterTheEnd,
    Allowed,
    BrokenPrecondition,
    DeadEnd,
    JudgedMove,
    NotShown,
    PutBack,
    Verdict,
)
from tests.language.scenes import enough

BOARD = Board()
EN, ES, CA = Language


def number(value: int) -> Attributes:
    return (("value", value),)


DECK = Deck(tuple(Token(TokenId(f"t{v}"), number(v)) for v in (11, 19, 23, 34, 46)))
LEFT_TO_RIGHT = FillOrder(Filling.LEFT_TO_RIGHT)


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def state(goal: Sequence[int] = ()) -> State:
    """The first numbers in the goal row from the left, the others in row 2."""
    cells: dict[TokenId, Cell] = {}
    for column, token in enumerate(DECK.tokens, start=1):
        cells[token.id] = cell(2, column)
    for column, value in enumerate(goal, start=1):
        cells[TokenId(f"t{value}")] = cell(1, column)
    return State(BOARD, cells)


def summary(*rules: Rule, **others: Any) -> Summary:  # noqa: ANN401 - any field of a summary
    base = Summary(BOARD, DECK, True, rules, (), frozenset({5}), (), Check.SAME)  # noqa: FBT003 - the field is `places`
    return replace(base, **others)


def judged(value: int, to: Cell, verdict: Verdict | None, goal: Sequence[int] = ()) -> JudgedMove:
    before = state(goal)
    token = TokenId(f"t{value}")
    known = verdict or NotShown(Action(number(value), len(goal) + 1))
    return JudgedMove(before, Move(token, before.cells[token], to), known)


def why(one: JudgedMove, of: Summary, language: Language = EN) -> str:
    return reason(one, of, DECK, language)


def broken(value: int, *literals: Literal, step: int = 2) -> BrokenPrecondition:
    return BrokenPrecondition(Action(number(value), step), literals)


def test_ascending_reads_as_the_paper_would_have_it() -> None:
    said = rule_sentences(summarise(enough("ascending")), EN)
    assert " ".join(one.text for one in said) == (
        "Put the tokens in the top row from left to right. "
        "Each token must be larger than the one on its left."
    )
    assert [one.id for one in said] == ["left-to-right", "increasing-value"]


def test_the_papers_action_reads_as_in_its_figures() -> None:
    exercise = enough("ascending")
    said = explain_action(exercise.model, Action(number(23), 2), EN)
    assert said.name == "move-v23-t2"
    assert said.precondition == (
        "to = l12",
        "contains(from, v23)",
        "empty(to)",
        "∃v' (contains(l11, v') ∧ less-than(v', v23))",
    )
    assert said.effects[0] == "¬contains(from, v23)"
    assert said.sentence == (
        "23 may go second if it goes to row 1, column 2 and it is larger than the token in "
        "row 1, column 1."
    )


def test_an_action_without_conditions_says_so() -> None:
    deck = Deck((Token(TokenId("a"), number(1)),))
    board = Board(2, 2)
    plays = [
        Demonstration(
            deck, State(board, {TokenId("a"): origin}), (Move(TokenId("a"), origin, goal),)
        )
        for origin in board.storage_cells
        for goal in board.goal_cells
    ]
    model = learn_grounded(plays, features=["destination"]).model
    assert explain_action(model, Action(number(1), 1), EN).sentence == (
        "1 may go first if it goes to the goal row."
    )
    away = Demonstration(
        deck,
        State(board, {TokenId("a"): board.cells[0]}),
        (Move(TokenId("a"), board.cells[0], board.cells[2]),),
    )
    free = learn_grounded([*plays, away], features=["destination"]).model
    assert explain_action(free, Action(number(1), 1), EN).sentence == "1 may go first."


CELL = CellFeature
CONDITIONS: list[tuple[Literal, str]] = [
    (Placed(CELL("destination"), cell(1, 2)), "it goes to row 1, column 2"),
    (Placed(CELL("origin"), cell(2, 3)), "it comes from row 2, column 3"),
    (Placed(CELL("origin-row"), 2), "it comes from row 2"),
    (Placed(CELL("origin-column"), 2), "it comes from column 2"),
    (Placed(CELL("destination-column"), 3), "it goes to column 3"),
    (Placed(CELL("same-column"), value=True), "it stays in its column"),
    (Placed(CELL("to-goal-row"), value=True), "it goes to the goal row"),
    (
        Shows(cell(1, 1), TokenFeature("odd", "value")),
        "the token in row 1, column 1 is odd",
    ),
    (Contains(cell(1, 1), number(19)), "19 is in row 1, column 1"),
    (
        Related(cell(1, 1), PairFeature("less-than", "value"), converse=True),
        "it is smaller than the token in row 1, column 1",
    ),
]


@pytest.mark.parametrize(("literal", "text"), CONDITIONS)
def test_each_condition_has_its_words(literal: Literal, text: str) -> None:
    gap = Narrow(2, (number(34),), (literal, Placed(CELL("origin-row"), 2)))
    narrow = summary(gaps=(gap,), check=Check.WIDER)
    (said,) = gap_sentences(narrow, EN)
    assert said.id == "narrow-2"
    assert text in said.text
    assert said.text.startswith("So far 34 may go second only if ")


def test_gaps_name_what_was_seen_or_the_few_that_were_not() -> None:
    values = tuple(number(v) for v in (11, 19, 23))
    gaps = (
        Unseen(1, values[:2], values[2:]),
        Unseen(2, values[:1], values[1:]),
        Unseen(3, (), values),
        Narrow(4, values[:2], (Placed(CELL("origin"), cell(2, 3)),)),
        Narrow(4, values[2:], (Placed(CELL("destination"), cell(1, 3)),)),
        Narrow(5, values[:1], tuple(literal for literal, _ in CONDITIONS[-4:])),
    )
    said = gap_sentences(summary(gaps=gaps, check=Check.WIDER), EN)
    assert [one.text for one in said] == [
        "I have not yet seen 23 go first.",
        "So far I have only seen 11 go second.",
        "I have not yet seen 11, 19 or 23 go third.",
        "So far I have only seen 11 or 19 go fourth from row 2, column 3.",
        "So far I have only seen 23 go fourth to row 1, column 3.",
        "I have not seen 11 go fifth in enough different plays.",
    ]
    assert [one.id for one in said][-3:] == ["narrow-4", "narrow-4-2", "narrow-5"]


def test_what_no_rule_says_is_said_step_by_step() -> None:
    steps = (
        Step(1, (number(11), number(19)), None),
        Step(2, (number(23),), cell(1, 3)),
        Step(3, (), cell(1, 1)),
    )
    said = rule_sentences(summary(steps=steps, lengths=frozenset({3})), EN)
    assert [one.text for one in said] == [
        "Put three tokens in the top row in this order.",
        "First: 11 or 19.",
        "Second: 23, in row 1, column 3.",
        "Third: row 1, column 1.",
    ]
    assert [one.id for one in said] == ["placing", "step-1", "step-2", "step-3"]


def test_any_number_of_tokens_may_be_asked_for_in_any_order() -> None:
    said = rule_sentences(summary(lengths=frozenset({1, 2})), EN)
    assert said[0].text == "Put one or two tokens in the top row in any order."


def test_moves_that_do_not_place_tokens_are_told_without_a_placing() -> None:
    elsewhere = summary(
        places=False, steps=(Step(1, (number(11),), None),), check=Check.NOT_COMPARED
    )
    assert [one.text for one in rule_sentences(elsewhere, EN)] == ["First: 11."]
    assert check_sentence(elsewhere, EN).startswith("I could not compare")
    assert check_sentence(summary(check=Check.WIDER), EN) == ""


RELATED = Related(cell(1, 1), PairFeature("less-than", "value"), converse=False)


@pytest.mark.parametrize(
    ("one", "of", "text", "ids"),
    [
        (
            judged(34, cell(1, 2), broken(34, RELATED), [46]),
            summary(LEFT_TO_RIGHT, Ordered("value")),
            "34 is not larger than 46 on its left.",
            ("increasing-value",),
        ),
        (
            judged(34, cell(1, 2), broken(34, RELATED), [46]),
            summary(LEFT_TO_RIGHT, gaps=(Narrow(2, (number(34),), (RELATED,)),)),
            "34 is not larger than 46 on its left.",
            ("narrow-2",),
        ),
        (
            judged(34, cell(1, 3), broken(34, RELATED), [46, 11]),
            summary(),
            "34 is not larger than 46 in column 1.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 2), broken(34, replace(RELATED, cell=cell(1, 3))), [46]),
            summary(),
            "There is still no token in row 1, column 3.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 2), broken(34, replace(RELATED, cell=cell(2, 5)))),
            summary(),
            "34 is not larger than 46 in row 2, column 5.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 1), broken(34, Shows(cell(2, 2), TokenFeature("even", "value")))),
            summary(),
            "19 in row 2, column 2 is not even.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 2), broken(34, Contains(cell(1, 1), number(19))), [46]),
            summary(),
            "So far 19 has been in row 1, column 1 first.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 3), None, [46]),
            summary(LEFT_TO_RIGHT),
            "The next token goes to row 1, column 2.",
            ("left-to-right",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(EveryToken(has("odd", "value"))),
            "34 is not odd.",
            ("only-odd-value",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(EveryToken(Not(has("even", "value")))),
            "34 is even.",
            ("no-even-value",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(EveryToken(has("is-2", "origin:row"))),
            "Take the tokens only from row 3.",
            ("from-storage-row-2",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(StraightUp()),
            "34 stays in its own column.",
            ("same-column",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(StraightUp(mirrored=True)),
            "Move each token to the opposite column, as in a mirror.",
            ("mirrored-column",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(Pattern((has("is-11", "value"), has("is-19", "value")))),
            "11 goes to row 1, column 1.",
            ("given-row",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(Pattern((has("odd", "value"), Anything()))),
            "From left to right: the first is odd, the second is any.",
            ("pattern-odd-value-has-anything-row",),
        ),
        (
            judged(34, cell(1, 2), None, [46]),
            summary(TwoPlaces(Position(1), Position(2), same("value"))),
            "This token does not go here now.",
            ("two-places-1-2-value-equal-compare",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(gaps=(Unseen(1, (number(11),), (number(34),)),), check=Check.WIDER),
            "I have not yet seen 34 go first.",
            ("unseen-1",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(steps=(Step(1, (number(11),), None),)),
            "I have not yet seen 34 go first.",
            ("step-1",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(check=Check.NOT_COMPARED),
            "I have not yet seen 34 go first.",
            ("placing",),
        ),
        (
            judged(34, cell(1, 1), None),
            summary(LEFT_TO_RIGHT, Ordered("value")),
            "Then the row can no longer be filled.",
            ("left-to-right",),
        ),
        (
            judged(46, cell(1, 2), None, [46]),
            summary(LEFT_TO_RIGHT),
            "46 is already in the top row.",
            ("left-to-right",),
        ),
        (
            judged(34, cell(3, 2), None),
            summary(LEFT_TO_RIGHT),
            "The tokens go to the top row.",
            ("left-to-right",),
        ),
        (
            judged(34, cell(1, 1), DeadEnd(Action(number(34), 1))),
            summary(LEFT_TO_RIGHT),
            "Then the row can no longer be filled.",
            ("left-to-right",),
        ),
        (
            judged(34, cell(1, 1), AfterTheEnd(Action(number(34), 6))),
            summary(),
            "The row is finished.",
            ("placing",),
        ),
        (judged(34, cell(1, 1), Allowed(Action(number(34), 1))), summary(), "", ()),
    ],
)
def test_a_refusal_says_what_is_not_so(
    one: JudgedMove, of: Summary, text: str, ids: tuple[str, ...]
) -> None:
    assert why(one, of) == text
    assert broken_ids(one, of, DECK) == ids


def test_a_token_put_back_needs_no_reason() -> None:
    one = replace(judged(34, cell(1, 1), None), verdict=PutBack(NotShown(Action(number(34), 1))))
    assert (why(one, summary()), broken_ids(one, summary(), DECK)) == ("", ())


@pytest.mark.parametrize(
    ("literal", "text"),
    [
        (Placed(CELL("destination"), cell(1, 2)), "34 goes to row 1, column 2."),
        (Placed(CELL("destination-column"), 2), "34 goes to column 2."),
        (Placed(CELL("origin"), cell(3, 2)), "So far 34 has come from row 3, column 2."),
        (Placed(CELL("origin-column"), 2), "So far 34 has come from column 2."),
        (Placed(CELL("origin-row"), 3), "The tokens come from row 3."),
        (Placed(CELL("same-column"), value=True), "34 stays in its own column."),
        (Placed(CELL("from-storage"), value=True), "34 is already in the top row."),
        (Placed(CELL("to-goal-row"), value=True), "The tokens go to the top row."),
    ],
)
def test_a_wrong_cell_is_named_by_the_right_one(literal: Literal, text: str) -> None:
    elsewhere = summary(places=False, check=Check.NOT_COMPARED)
    assert why(judged(34, cell(1, 1), broken(34, literal, step=1)), elsewhere) == text


def test_where_a_token_goes_is_said_before_what_lies_there_and_that_before_where_from() -> None:
    origin = Placed(CELL("origin"), cell(3, 2))
    end = Placed(CELL("destination"), cell(1, 4))
    far = replace(RELATED, cell=cell(1, 1))
    near = replace(RELATED, cell=cell(1, 2))
    row = [46, 23]

    def said(*literals: Literal) -> str:
        one = judged(19, cell(1, 3), broken(19, *literals, step=3), row)
        return why(one, summary(places=False))

    assert said(origin, far, near, end) == "19 goes to row 1, column 4."
    assert said(origin, far, near) == "19 is not larger than 23 on its left."
    assert said(origin, far) == "19 is not larger than 46 in column 1."


def test_a_token_on_the_right_is_compared_too() -> None:
    right = replace(RELATED, cell=cell(1, 2), converse=True)
    before = State(BOARD, {**state().cells, TokenId("t11"): cell(1, 2)})
    verdict = broken(34, right, step=2)
    move = Move(TokenId("t34"), before.cells[TokenId("t34")], cell(1, 1))
    one = JudgedMove(before, move, verdict)
    assert why(one, summary()) == "34 is not smaller than 11 on its right."
    assert why(one, summary(Ordered("value"))) == "11 is not larger than 34 on its left."


def test_a_long_reason_gives_way_to_a_shorter_one() -> None:
    deck = Deck(
        tuple(
            Token(
                TokenId(f"t{size}"),
                (("name", f"the big pot for soup number {size}"), ("size", size)),
            )
            for size in (1, 2)
        )
    )
    before = State(BOARD, {TokenId("t1"): cell(2, 1), TokenId("t2"): cell(1, 1)})
    action = Action(deck.by_id[TokenId("t1")].attributes, 2)
    move = Move(TokenId("t1"), cell(2, 1), cell(1, 2))
    of = replace(summary(Ordered("size")), deck=deck)
    one = JudgedMove(before, move, NotShown(action))
    assert reason(one, of, deck, EN) == "It is not bigger than the one on its left."
    assert reason(one, of, deck, ES) == "No es más grande que la de su izquierda."
    assert reason(one, of, deck, CA) == "No és més gran que la de la seva esquerra."


def test_all_of_them_is_no_rule_that_a_single_move_breaks_if_there_is_room() -> None:
    one = judged(34, cell(1, 1), None)
    full = judged(34, cell(1, 5), None, [11, 19, 23])
    of = summary(AllOfThem(has("odd", "value")))
    assert broken_ids(one, of, DECK) == ("placing",)
    assert broken_ids(full, of, DECK) == ("placing",)


def test_several_cells_with_one_condition_are_said_together() -> None:
    said = explain_action(enough("ascending").model, Action(number(34), 4), EN)
    assert said.sentence == (
        "34 may go fourth if it goes to row 1, column 4 and it is larger than the tokens in the "
        "top row, columns 1, 2 and 3."
    )


def test_what_was_compared_is_said_to_be_the_same() -> None:
    assert check_sentence(summary(), EN).endswith("they say the same.")


def test_a_single_condition_that_is_no_cell_is_said_as_a_condition() -> None:
    gap = Narrow(2, (number(34),), (RELATED,))
    (said,) = gap_sentences(summary(gaps=(gap,), check=Check.WIDER), EN)
    assert said.text == (
        "So far 34 may go second only if it is larger than the token in row 1, column 1."
    )


def test_neighbours_that_do_not_fit_are_named() -> None:
    twins = Deck((*DECK.tokens, Token(TokenId("u34"), number(34))))
    before = State(BOARD, {**state([34]).cells, TokenId("u34"): cell(2, 4)})
    move = Move(TokenId("u34"), cell(2, 4), cell(1, 2))
    one = JudgedMove(before, move, NotShown(Action(number(34), 2)))
    of = replace(summary(EachPair(Pairs.NEIGHBOURS, different("value")), FullRow()), deck=twins)
    assert reason(one, of, twins, ES) == "El 34 no tiene otro número que el 34 de su izquierda."


def test_when_no_reason_is_short_enough_a_plain_one_is_left() -> None:
    long = "the big pot for the onion soup that grandmother made"
    deck = Deck(
        tuple(Token(TokenId(f"t{k}"), (("name", f"{long} {k}"), ("size", k))) for k in (1, 2))
    )
    before = State(BOARD, {TokenId("t1"): cell(2, 1), TokenId("t2"): cell(1, 1)})
    shown = deck.by_id[TokenId("t1")].attributes
    smaller = Related(cell(1, 1), PairFeature("less-than", "size"), converse=False)
    verdict = BrokenPrecondition(Action(shown, 2), (smaller,))
    one = JudgedMove(before, Move(TokenId("t1"), cell(2, 1), cell(1, 2)), verdict)
    assert reason(one, summary(), deck, EN) == "This token does not go here now."


def test_a_comparative_alone_agrees_with_a_token() -> None:
    speaker = speaker_for(ES, BOARD, DECK)
    assert speaker.sentence(Adjective("size", Degree.LEAST)) == "Más pequeña"


@pytest.mark.parametrize(
    ("feature", "said"),
    [
        ("multiple-of-5", ("is a multiple of 5", "es múltiplo de 5", "és múltiple de 5")),
        ("digits-1", ("has one digit", "tiene una cifra", "té una xifra")),
        ("above-30", ("is above 30", "está por encima de 30", "està per sobre de 30")),
        ("odd", ("is odd", "es impar", "és senar")),
    ],
)
def test_what_a_feature_says_of_a_token_begins_with_the_verb(
    feature: str, said: tuple[str, str, str]
) -> None:
    deck = Deck((Token(TokenId("19"), number(19)), Token(TokenId("30"), number(30))))
    of = TokenFeature(feature, "value")
    assert tuple(feature_of_token(of, BOARD, deck, language) for language in Language) == said

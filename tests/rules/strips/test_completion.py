import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Row
from maestra.core.faults import InvalidError
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner
from maestra.rules.features import CellFeature, PairFeature, select_features
from maestra.rules.strips import completion
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.completion import Completion, Prospect, search_states
from maestra.rules.strips.demands import Demands
from maestra.rules.strips.literals import Placed, Related
from maestra.rules.strips.vocabulary import Level, Vocabulary
from tests.rules import by_definition
from tests.rules.ascending import ascending, exercise_of, moves, paper_lesson, start
from tests.rules.lessons import Lesson, lessons

LENGTHS = st.frozensets(st.integers(0, 3), min_size=1, max_size=3)


def search(model: ActionModel, lengths: frozenset[int], state: State, made: int) -> Prospect:
    """The slow, obvious search."""
    index = model.vocabulary.index_of_token
    contents = {at: index[token] for token, at in state.cells.items()}
    return search_states(model, lengths, contents, made)


@st.composite
def models(draw: st.DrawFn) -> tuple[Lesson, ActionModel]:
    """What a lesson teaches with some literals taken away, so that more can be completed."""
    lesson = draw(lessons(most=3))
    learner = GroundedLearner(lesson.vocabulary)
    for play in lesson.demonstrations:
        learner.show(play)
    model = learner.exercise().model
    kept = draw(st.sampled_from(["all", "some", "of the move's cells"]))
    size = lesson.vocabulary.size
    masks = {
        "all": st.just(lesson.vocabulary.everything),
        "some": st.integers(0, (1 << size) - 1),
        "of the move's cells": st.just((1 << lesson.vocabulary.placed_size) - 1),
    }
    frame = 0b11 if draw(st.booleans()) else 0
    return lesson, ActionModel(
        lesson.vocabulary,
        {
            action: bits & (draw(masks[kept]) | frame)
            for action, bits in model.preconditions.items()
        },
    )


@given(models(), LENGTHS)
def test_a_play_can_be_completed_if_trying_everything_finds_how(
    pair: tuple[Lesson, ActionModel], lengths: frozenset[int]
) -> None:
    lesson, model = pair
    sets = {action: frozenset(model.precondition(action)) for action in model.preconditions}
    found = Completion(model, lengths, lesson.deck)
    for play in lesson.demonstrations:
        for made, state in enumerate(play.states()):
            expected = (
                Prospect.POSSIBLE
                if by_definition.can_end(sets, lengths, lesson.deck, state, made)
                else Prospect.IMPOSSIBLE
            )
            assert found.prospect(state, made) is expected
            assert search(model, lengths, state, made) is expected


@given(models(), LENGTHS)
def test_the_careful_search_alone_finds_the_same(
    pair: tuple[Lesson, ActionModel], lengths: frozenset[int]
) -> None:
    lesson, model = pair
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(completion, "QUICK_NODES", 0)
        careful = Completion(model, lengths, lesson.deck)
        for play in lesson.demonstrations:
            for made, state in enumerate(play.states()):
                assert careful.prospect(state, made) is search(model, lengths, state, made)


def of_ascending(*chosen: int) -> Prospect:
    """Whether a play that began with the tokens of these ranks can be completed."""
    exercise = exercise_of(paper_lesson())
    begin = state = start()
    for move in moves(begin, chosen):
        state = state.after(move)
    return Completion(exercise.model, exercise.lengths, exercise.deck).prospect(state, len(chosen))


@pytest.mark.parametrize("rank", range(6))
def test_any_of_the_six_lowest_can_be_completed(rank: int) -> None:
    assert of_ascending(rank) is Prospect.POSSIBLE


@pytest.mark.parametrize("chosen", [(6,), (0, 7), (0, 1, 2, 9), (5, 7)])
def test_a_row_for_which_too_few_larger_tokens_are_left_cannot(chosen: tuple[int, ...]) -> None:
    assert of_ascending(*chosen) is Prospect.IMPOSSIBLE


def test_a_finished_play_is_complete() -> None:
    assert of_ascending(0, 1, 2, 3, 4) is Prospect.POSSIBLE


def test_nothing_shown_cannot_be_completed() -> None:
    exercise = exercise_of(paper_lesson())
    nothing = ActionModel(exercise.model.vocabulary, {})
    assert Completion(nothing, frozenset(), exercise.deck).prospect(start(), 0) is (
        Prospect.IMPOSSIBLE
    )
    assert Completion(nothing, frozenset({3}), exercise.deck).prospect(start(), 0) is (
        Prospect.IMPOSSIBLE
    )


def test_a_deck_with_something_unknown_is_refused() -> None:
    exercise = exercise_of(paper_lesson())
    other = Deck((Token(TokenId("x"), (("value", 99),)),))
    with pytest.raises(InvalidError, match=r"tokens\.x"):
        Completion(exercise.model, exercise.lengths, other)


def test_a_token_that_wants_something_on_a_cell_does_not_come_while_it_is_empty() -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in (1, 2)))
    words = Vocabulary(Board(2, 3), deck, Level.A, select_features(deck, ["cells", "less-than"]))
    frame = [Placed(CellFeature(name), value=True) for name in ("from-storage", "to-goal-row")]
    smaller = Related(words.board.goal_cells[0], PairFeature("less-than", "value"), converse=False)
    one, two = words.shown
    wanting = words.bits([*frame, smaller])
    model = ActionModel(words, {Action(one, 1): words.bits(frame), Action(two, 2): wanting})
    found = Completion(model, frozenset({2}), deck)
    storage = words.board.storage_cells

    def after_first(column: int) -> State:
        cells = (words.board.goal_cells[column - 1], storage[1])
        return State(words.board, {t.id: at for t, at in zip(deck.tokens, cells, strict=True)})

    begin = State(words.board, {t.id: at for t, at in zip(deck.tokens, storage, strict=False)})
    assert found.prospect(begin, 0) is Prospect.POSSIBLE
    assert found.prospect(after_first(1), 1) is Prospect.POSSIBLE
    assert found.prospect(after_first(2), 1) is Prospect.IMPOSSIBLE


def test_a_token_that_goes_straight_up_comes_only_where_its_column_is_free() -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in (1, 2)))
    words = Vocabulary(Board(3, 2), deck, Level.A, select_features(deck, ["same-column"]))
    names = ("from-storage", "to-goal-row", "same-column")
    straight_up = words.bits(Placed(CellFeature(name), value=True) for name in names)
    model = ActionModel(
        words, {Action(shown, step): straight_up for shown in words.shown for step in (1, 2)}
    )
    found = Completion(model, frozenset({2}), deck)
    left, right, under_left, *_ = (*words.board.storage_cells,)

    def lying(first: Cell, second: Cell) -> State:
        cells = (first, second)
        return State(words.board, {t.id: at for t, at in zip(deck.tokens, cells, strict=True)})

    assert found.prospect(lying(left, right), 0) is Prospect.POSSIBLE
    assert found.prospect(lying(left, under_left), 0) is Prospect.IMPOSSIBLE
    taken = words.board.goal_cells[0]
    assert found.prospect(lying(taken, right), 1) is Prospect.POSSIBLE
    assert found.prospect(lying(taken, left), 1) is Prospect.IMPOSSIBLE


# ------------------------------------------------------------------ giving up


def test_a_search_that_takes_too_long_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(completion, "QUICK_NODES", 2)
    monkeypatch.setattr(completion, "CAREFUL_NODES", 2)
    assert of_ascending() is Prospect.UNDECIDED
    assert of_ascending(0, 1) is Prospect.UNDECIDED
    assert of_ascending(0, 1, 2) is Prospect.POSSIBLE


def test_a_play_that_can_end_sooner_is_not_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(completion, "QUICK_NODES", 2)
    monkeypatch.setattr(completion, "CAREFUL_NODES", 2)
    exercise = exercise_of([*paper_lesson(), ascending((0, 1))])
    found = Completion(exercise.model, exercise.lengths, exercise.deck)
    assert found.prospect(start(), 0) is Prospect.POSSIBLE
    longer = Completion(exercise.model, frozenset({1, 5}), exercise.deck)
    assert longer.prospect(start(), 0) is Prospect.POSSIBLE
    no_end = Completion(exercise.model, frozenset({5, 6}), exercise.deck)
    assert no_end.prospect(start(), 0) is Prospect.UNDECIDED


def test_the_search_state_by_state_gives_up_too(monkeypatch: pytest.MonkeyPatch) -> None:
    exercise = exercise_of(paper_lesson())
    monkeypatch.setattr(completion, "STATE_NODES", 2)
    assert search(exercise.model, exercise.lengths, start(), 0) is Prospect.UNDECIDED


def test_the_search_state_by_state_passes_no_barren_state_twice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in range(3)))
    board = Board(3, 3)
    words = Vocabulary(board, deck, Level.A, select_features(deck, ["cells"]))
    anything = {Action(shown, step): 0 for shown in words.shown for step in (1, 2)}
    state = State(board, {t.id: at for t, at in zip(deck.tokens, board.cells, strict=False)})
    after_two = set[State]()
    for one in by_definition.applicable(_sets(words, anything), deck, state, 0):
        between = state.after(one)
        after_two.add(between)
    monkeypatch.setattr(completion, "STATE_NODES", 10_000)
    assert search(ActionModel(words, anything), frozenset({3}), state, 0) is Prospect.IMPOSSIBLE
    # One node for the start and one for each state after one move; those after two have no
    # action, and are reached several times, but counted once.
    twice = {
        between.after(two)
        for between in after_two
        for two in by_definition.applicable(_sets(words, anything), deck, between, 1)
    }
    nodes = 1 + len(after_two) + len(twice)
    monkeypatch.setattr(completion, "STATE_NODES", nodes)
    assert search(ActionModel(words, anything), frozenset({3}), state, 0) is Prospect.IMPOSSIBLE
    monkeypatch.setattr(completion, "STATE_NODES", nodes - 1)
    assert search(ActionModel(words, anything), frozenset({3}), state, 0) is Prospect.UNDECIDED


def _sets(words: Vocabulary, bits: dict[Action, int]) -> by_definition.Preconditions:
    return {action: frozenset(words.select(some)) for action, some in bits.items()}


# ------------------------------------------------------------------ one way


def of_frame(words: Vocabulary, *names: str) -> ActionModel:
    demanded = words.bits(Placed(CellFeature(name), value=True) for name in names)
    return ActionModel(words, {Action(words.shown[0], 1): demanded})


def test_moves_go_one_way_if_every_action_says_so() -> None:
    deck = Deck((Token(TokenId("t"), (("value", 1),)),))
    words = Vocabulary(Board(2, 2), deck, Level.A, select_features(deck, None))
    frame = ("from-storage", "to-goal-row")
    assert Demands(of_frame(words, *frame), deck, 1).one_way
    assert not Demands(of_frame(words, "from-storage"), deck, 1).one_way
    assert not Demands(of_frame(words), deck, 1).one_way
    assert Demands(ActionModel(words, {}), deck, 1).one_way


def test_on_a_board_without_storage_no_way_is_one_way() -> None:
    deck = Deck((Token(TokenId("t"), (("value", 1),)),))
    words = Vocabulary(Board(1, 2), deck, Level.A, select_features(deck, None))
    model = of_frame(words, "from-storage", "to-goal-row")
    assert not Demands(model, deck, 1).one_way
    state = State(Board(1, 2), {TokenId("t"): Board(1, 2).cells[0]})
    assert Completion(model, frozenset({1}), deck).prospect(state, 0) is Prospect.IMPOSSIBLE


def test_without_the_words_for_it_no_way_is_one_way() -> None:
    deck = Deck((Token(TokenId("t"), (("value", 1),)),))
    words = Vocabulary(Board(2, 2), deck, Level.A, (CellFeature("destination"),))
    model = ActionModel(words, {Action(words.shown[0], 1): 0})
    assert not Demands(model, deck, 1).one_way
    state = State(Board(2, 2), {TokenId("t"): Board(2, 2).cells[0]})
    assert Completion(model, frozenset({1}), deck).prospect(state, 0) is Prospect.POSSIBLE


def test_an_order_of_twenty_among_a_hundred_is_decided_without_giving_up() -> None:
    board = Board(20, 20, Row(3))
    deck = Deck(tuple(Token(TokenId(f"{n:03}"), (("value", n),)) for n in range(100)))
    words = Vocabulary(board, deck, Level.A, select_features(deck, ["destination", "less-than"]))
    frame = [Placed(CellFeature(name), value=True) for name in ("from-storage", "to-goal-row")]
    left = [
        one
        for one in words.literals
        if not isinstance(one, Placed) and not getattr(one, "converse", True)
    ]
    preconditions = {
        Action(shown, step): words.bits(
            [
                *frame,
                Placed(CellFeature("destination"), board.goal_cells[step - 1]),
                *(one for one in left if step > 1 and one.cell == board.goal_cells[step - 2]),
            ]
        )
        for shown in words.shown
        for step in range(1, 21)
    }
    found = Completion(ActionModel(words, preconditions), frozenset({20}), deck)
    begin = State(
        board, {t.id: at for t, at in zip(deck.tokens, board.storage_cells, strict=False)}
    )

    def after_first(rank: int) -> State:
        cells: dict[TokenId, Cell] = dict(begin.cells)
        cells[deck.tokens[rank].id] = board.goal_cells[0]
        return State(board, cells)

    assert found.prospect(after_first(80), 1) is Prospect.POSSIBLE
    assert found.prospect(after_first(81), 1) is Prospect.IMPOSSIBLE

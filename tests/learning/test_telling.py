from hypothesis import assume, given
from hypothesis import strategies as st

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning import telling
from maestra.learning.grounded import GroundedLearner
from maestra.learning.teaching_sets import open_literals
from maestra.learning.telling import MostTelling
from maestra.rules.features import select_features
from maestra.rules.right_plays import RightPlays
from maestra.rules.strips.vocabulary import Level, Vocabulary
from tests.rules.small_exercises import every_play, small_exercises, vocabularies


@given(st.data())
def test_no_play_settles_more_than_the_most_telling(data: st.DataObject) -> None:
    plays = data.draw(small_exercises(tokens=3))
    assume(0 < plays.count <= 500)
    vocabulary = data.draw(vocabularies(plays))
    needed = open_literals(plays, vocabulary)
    some = data.draw(st.lists(st.integers(0, vocabulary.everything), min_size=1, max_size=3))
    needed = {
        key: bits & some[index % len(some)] for index, (key, bits) in enumerate(needed.items())
    }
    learner = GroundedLearner(vocabulary)

    def settled_by_the_best() -> int:
        return max(
            sum(
                (needed[seen.moved, seen.step] & ~seen.holding).bit_count()
                for seen in learner.observe(play)
            )
            for play in every_play(plays)
        )

    search = MostTelling(plays, vocabulary, needed)
    best = search.most_telling()
    assert (best.settled if best else 0) == settled_by_the_best()


@given(st.data())
def test_settling_the_most_telling_play_again_and_again_leaves_nothing_open(
    data: st.DataObject,
) -> None:
    plays = data.draw(small_exercises())
    assume(plays.count)
    vocabulary = data.draw(vocabularies(plays))
    search = MostTelling(plays, vocabulary, open_literals(plays, vocabulary))
    while best := search.most_telling():
        before = sum(bits.bit_count() for bits in search.open_literals.values())
        search.settle(best.demonstration)
        after = sum(bits.bit_count() for bits in search.open_literals.values())
        assert before - after == best.settled
    assert not search.open_literals


def test_a_limited_search_still_finds_a_telling_play() -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in range(12)))
    board = Board(10, 10)
    plays = RightPlays(board, deck, lengths=frozenset({1}))
    vocabulary = Vocabulary(board, deck, Level.A, select_features(deck, None))
    search = MostTelling(plays, vocabulary, open_literals(plays, vocabulary))
    best = search.most_telling()
    assert best is not None
    assert telling.MAX_ARRANGED < 12 * 10
    assert best.settled > 90

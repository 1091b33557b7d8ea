"""The page of sentences says what Maestra says and understands."""

from pathlib import Path

import pytest

from maestra.core.board import Board
from maestra.language import Language
from maestra.language.understanding import Understood, listener_for
from maestra.rules.canonical import canonical
from tests.docs.sentences_page import DECK, forms, page
from tests.rules.rule_strategies import FORMS

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "sentences.md"


def test_the_page_is_what_would_be_written_now() -> None:
    assert PAGE.read_text(encoding="utf-8") == page()


def test_every_form_is_on_the_page() -> None:
    assert {type(rules[0]) for rules in forms().values()} == set(FORMS)


@pytest.mark.parametrize("language", Language)
def test_every_sentence_on_the_page_is_understood(language: Language) -> None:
    heard = listener_for(language, Board(), DECK)
    for rules in forms().values():
        assert heard.understand(heard.says(rules[0])) == Understood((canonical(rules[0]),))

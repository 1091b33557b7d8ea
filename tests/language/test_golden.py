import pytest

from maestra.language import Language
from maestra.rules.paper import PAPER_EXERCISES
from tests.language.scenes import GOLDEN, told


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize("name", PAPER_EXERCISES)
def test_what_is_said_of_an_exercise_is_what_was_read_and_approved(
    name: str, language: Language
) -> None:
    golden = GOLDEN / f"{name}.{language.value}.txt"
    assert told(name, language) == golden.read_text(encoding="utf-8")

import pytest

from maestra.language.templates import Gender, Spoken, fill, parse, slots


def text(spoken: Spoken, form: str) -> str:
    return spoken.forms.get(form, spoken.text)


def test_gaps_are_filled_in_the_form_they_ask_for() -> None:
    token = Spoken("el 34", {"bare": "34"})
    assert fill("{token} ({token:bare})", {"token": token}, text) == "el 34 (34)"


@pytest.mark.parametrize(
    ("spoken", "agreed"),
    [
        (Spoken("x"), "rojo es"),
        (Spoken("x", gender=Gender.FEMININE), "roja es"),
        (Spoken("x", many=True), "rojo son"),
    ],
)
def test_words_agree_in_gender_and_number(spoken: Spoken, agreed: str) -> None:
    assert fill("[t@rojo|roja] [t#es|son]", {"t": spoken}, text) == agreed


def test_the_names_of_all_gaps_are_known() -> None:
    assert slots("{one} and [two@a|b] of {three:of}") == {"one", "two", "three"}
    assert parse("nothing") == ("nothing",)
    assert slots("") == frozenset()


def test_a_gap_without_a_phrase_is_a_mistake() -> None:
    with pytest.raises(KeyError):
        fill("{token}", {}, text)

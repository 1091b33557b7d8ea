"""The page "What counts", as a browser without script sees and sends it."""

import re
from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient

from maestra.language import Language
from maestra.web.access.visitor import Role

Login = Callable[[Role], TestClient]
ABOVE_30 = "above-30:value"


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


@pytest.fixture
def root(caregiver: TestClient) -> str:
    """Twice shown: two tokens above 30 in a row."""
    root = caregiver.post("/teach", data={"deck": "numbers"}).url.path
    for first, second in (("34", "51"), ("68", "46")):
        caregiver.post(f"{root}/move", data={"cell": "1,1", "token": first})
        caregiver.post(f"{root}/move", data={"cell": "1,2", "token": second})
        caregiver.post(f"{root}/done")
    return root


def boxes(page: str) -> dict[str, str]:
    """The text beside each box, by what it sends."""
    found = re.findall(r'name="feature" value="([^"]*)"[^>]*> <span>(.*?)</span></label>', page)
    return {name: " ".join(re.sub(r"<[^>]*>", " ", text).split()) for name, text in found}


def checked(page: str) -> set[str]:
    return set(re.findall(r'name="feature" value="([^"]*)" checked', page))


def understood(page: str) -> str:
    """The rules and the verdict below what was chosen."""
    found = re.search(r'aria-labelledby="so-far">(.*?)</section>', page, re.DOTALL)
    assert found is not None
    return re.sub(r"<[^>]*>|\s+", " ", found[1])


@pytest.mark.parametrize(
    ("language", "text"),
    [
        (Language.EN, "it is above 30 such as 32; not 19"),
        (Language.ES, "está por encima de 30 por ejemplo 32; pero no 19"),
        (Language.CA, "està per sobre de 30 per exemple 32; però no 19"),
    ],
)
def test_a_feature_with_a_parameter_is_a_box_with_a_token_that_has_it_and_one_that_has_not(
    caregiver: TestClient, root: str, language: Language, text: str
) -> None:
    caregiver.post("/language", data={"language": language.value})
    assert boxes(caregiver.get(f"{root}/features").text)[ABOVE_30] == text


@pytest.mark.parametrize(
    ("language", "words"),
    [
        (Language.EN, "above 30"),
        (Language.ES, "por encima de 30"),
        (Language.CA, "per sobre de 30"),
    ],
)
def test_choosing_it_changes_what_is_learned(
    caregiver: TestClient, root: str, language: Language, words: str
) -> None:
    caregiver.post("/language", data={"language": language.value})
    places = ["destination"]
    without = caregiver.post(f"{root}/features", data={"feature": places}).text
    assert words not in understood(without)
    page = caregiver.post(f"{root}/features", data={"feature": [*places, ABOVE_30]}).text
    assert words in understood(page)
    assert checked(page) == {ABOVE_30, *places}


def test_the_boxes_with_parameters_are_folded_away_until_one_is_chosen(
    caregiver: TestClient, root: str
) -> None:
    assert "<details>" in caregiver.get(f"{root}/features").text
    page = caregiver.post(f"{root}/features", data={"feature": [ABOVE_30]}).text
    assert "<details open>" in page


def test_what_another_program_chose_has_a_box_that_keeps_it(
    caregiver: TestClient, root: str
) -> None:
    page = caregiver.post(f"{root}/features", data={"feature": ["above-33"]}).text
    assert "above-33:value" in checked(page)


def test_all_that_is_offered_can_be_chosen_at_once(caregiver: TestClient, root: str) -> None:
    every = set(boxes(caregiver.get(f"{root}/features").text))
    answer = caregiver.post(f"{root}/features", data={"feature": sorted(every)})
    assert answer.status_code == 200
    assert checked(answer.text) == every


def test_a_value_of_one_token_needs_no_example(caregiver: TestClient, root: str) -> None:
    there = boxes(caregiver.get(f"{root}/features").text)
    assert there["is-19:value"] == "it is 19"
    assert there["odd:value"].endswith("such as 19, 23, 51; not 32")


@pytest.mark.parametrize(
    ("language", "colour", "red"),
    [
        (Language.EN, "(colour)", "it is red"),
        (Language.ES, "(color)", "es roja"),
        (Language.CA, "(color)", "és vermella"),
    ],
)
def test_properties_are_called_as_the_language_calls_them(
    caregiver: TestClient, language: Language, colour: str, red: str
) -> None:
    caregiver.post("/language", data={"language": language.value})
    root = caregiver.post("/teach", data={"deck": "shapes"}).url.path
    there = boxes(caregiver.get(f"{root}/features").text)
    assert colour in there["same:colour"]
    assert there["is-red:colour"].startswith(red)

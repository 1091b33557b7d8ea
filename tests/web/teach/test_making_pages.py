"""Tokens, words, features, trying and the exam, as a browser without script sends them."""

import re
from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient

from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.library.included import first_start
from maestra.web.teach.decks import MOST_PROPERTIES
from maestra.web.teach.pictures import MOST_AT_ONCE

Login = Callable[[Role], TestClient]
ROW = ("19", "32", "46", "57", "68")


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


@pytest.fixture
def root(caregiver: TestClient) -> str:
    return caregiver.post("/teach", data={"deck": "numbers"}).url.path


@pytest.fixture
def taught(caregiver: TestClient, root: str) -> str:
    """Ascending, as it was shown and answered."""
    for column, token in enumerate(ROW, start=1):
        caregiver.post(f"{root}/move", data={"cell": f"1,{column}", "token": token})
    caregiver.post(f"{root}/reply", data={"said": "yes"})
    return root


@pytest.fixture
def told(caregiver: TestClient, context: Context) -> str:
    """Rules that were told, of which nothing was shown."""
    first_start(context.store, "2026-05-04T12:00:00+00:00")
    return caregiver.post("/teach/from", data={"name": "Make exactly 100"}).url.path


def tokens_on(page: str) -> set[str]:
    return set(re.findall(r'data-token="([^"]*)"', page))


# ---------------------------------------------------------------- tokens and board


@pytest.mark.parametrize(
    ("place", "fields", "tokens"),
    [
        ("numbers", {"first": "1", "last": "3"}, {"1", "2", "3"}),
        ("list", {"numbers": "4, 0.5"}, {"4", "0.5"}),
        ("letters", {"letters": "cat"}, {"C", "A", "T"}),
        ("words", {"words": "tea\ncake, food"}, {"tea", "food-cake"}),
        ("shapes", {"colour": ["red"], "shape": ["circle", "star"]}, {"red-circle", "red-star"}),
        ("shapes", {"colour": ["red", "blue"]}, {"red", "blue"}),
    ],
)
def test_tokens_are_what_was_written(
    caregiver: TestClient, root: str, place: str, fields: dict[str, str], tokens: set[str]
) -> None:
    page = caregiver.post(f"{root}/tokens/{place}", data=fields).text
    assert {"-".join(sorted(one.split("-"))) for one in tokens_on(page)} == {
        "-".join(sorted(one.split("-"))) for one in tokens
    }


@pytest.mark.parametrize(
    ("place", "fields", "line"),
    [
        ("numbers", {"first": "1", "last": "999"}, "That is too much: at most 70 tokens."),
        ("list", {"numbers": "1 two"}, "“two” is no number."),
        ("list", {"numbers": ""}, "Please write at least one token"),
        ("letters", {"letters": "12"}, "Please write at least one token"),
        ("words", {"words": "x" * 50}, "is too long."),
        ("shapes", {}, "Please write at least one token"),
        ("board", {"rows": "40", "columns": "5"}, "Please take 2 to 8 rows and 1 to 10 columns."),
        ("table", {"property": ["a", "a"], "value": ["1", "2"]}, "each property once."),
    ],
)
def test_what_makes_no_tokens_is_refused_where_it_was_written(
    caregiver: TestClient, root: str, place: str, fields: dict[str, str], line: str
) -> None:
    answer = caregiver.post(f"{root}/tokens/{place}", data=fields)
    assert answer.status_code == 422
    assert line in answer.text
    assert 'aria-current="page">Tokens and board' in answer.text


def test_too_many_properties_are_refused_as_such(caregiver: TestClient, root: str) -> None:
    wide = MOST_PROPERTIES + 1
    typed = {"property": [f"p{k}" for k in range(wide)], "value": ["x"] * wide}
    answer = caregiver.post(f"{root}/tokens/table", data=typed)
    assert answer.status_code == 422
    assert f"at most {MOST_PROPERTIES} properties." in answer.text


def test_too_many_pictures_at_once_are_refused_as_such(caregiver: TestClient, root: str) -> None:
    files = [("files", (f"{k}.png", b"", "image/png")) for k in range(MOST_AT_ONCE + 1)]
    answer = caregiver.post(f"{root}/tokens/pictures", files=files)
    assert answer.status_code == 422
    assert f"Please choose 1 to {MOST_AT_ONCE} pictures at a time." in answer.text


def test_the_board_may_be_larger_and_have_its_goal_row_at_the_bottom(
    caregiver: TestClient, root: str
) -> None:
    fields = {"rows": "6", "columns": "4", "goal": "last"}
    page = caregiver.post(f"{root}/tokens/board", data=fields).text
    assert 'value="6,4"' in page
    assert page.index('class="row goal"') > page.index('value="5,4"')
    small = caregiver.post(f"{root}/tokens/board", data={"rows": "2", "columns": "5"}).text
    assert "There are more tokens than storage cells." in small


def test_tokens_are_laid_by_hand_and_dealt(caregiver: TestClient, root: str) -> None:
    laid = {"cell": "1,3", "token": "19"}
    page = caregiver.post(f"{root}/tokens/move", data=laid).text
    assert 'value="1,3" aria-label="row 1, column 3, token 19"' in page
    assert (
        "token 19, in your hand"
        in caregiver.post(f"{root}/tokens/move", data={"cell": "1,3"}).text
    )
    released = caregiver.post(f"{root}/tokens/move", data={"cell": "1,3"}).text
    assert "token 19, in your hand" not in released
    empty = caregiver.post(f"{root}/tokens/move", data={"cell": "1,1"}).text
    assert "Please choose an empty cell." in empty
    assert 'column 3, token 19"' not in caregiver.post(f"{root}/tokens/deal").text


def test_a_property_is_called_as_the_language_calls_it(caregiver: TestClient, root: str) -> None:
    caregiver.post("/language", data={"language": "es"})
    fields = {"property": ["value", "Tamaño"], "value": ["1", "9", "2", "8"], "ordered": ["0"]}
    page = caregiver.post(f"{root}/tokens/table", data=fields).text
    assert '<input type="hidden" name="property" value="size">' in page


def test_words_may_be_in_the_order_of_the_table(caregiver: TestClient, root: str) -> None:
    days = ["Monday", "Tuesday", "Wednesday"]
    fields = {"property": ["day", ""], "value": [x for day in days for x in (day, "")]}
    page = caregiver.post(f"{root}/tokens/table", data={**fields, "ordered": ["0"]}).text
    assert 'name="ordered" value="0" checked' in page
    assert page.index('value="Monday"') < page.index('value="Tuesday"')


def test_tokens_stay_once_a_row_was_shown(caregiver: TestClient, taught: str) -> None:
    page = caregiver.get(f"{taught}/tokens").text
    assert "These tokens are in use" in page
    refused = caregiver.post(f"{taught}/tokens/list", data={"numbers": "1 2"}).text
    assert "Your demonstrations need" in refused
    fresh = caregiver.post(f"{taught}/tokens/again")
    assert fresh.url.path != f"{taught}/tokens"
    assert "These tokens are in use" not in fresh.text


# ---------------------------------------------------------------- in words


def test_a_rule_is_written_otherwise_and_learned_again(caregiver: TestClient, taught: str) -> None:
    sentence = "From left to right, the numbers go up and down by turns."
    page = caregiver.post(
        f"{taught}/words/change", data={"number": "2", "sentence": sentence}
    ).text
    assert sentence in page
    assert "The rules are now as you wrote them." in page
    back = caregiver.post(f"{taught}/words/forget").text
    assert "Each token must be larger than the one on its left." in back


def test_a_rule_is_added_and_left_out(caregiver: TestClient, taught: str) -> None:
    page = caregiver.post(f"{taught}/words/add", data={"sentence": "Use only odd numbers."}).text
    assert "Rule 3" in page
    page = caregiver.post(f"{taught}/words/change", data={"number": "3", "sentence": " "}).text
    assert "Rule 3" not in page


def test_rules_may_be_said_before_anything_is_shown(caregiver: TestClient, root: str) -> None:
    page = caregiver.post(f"{root}/words/add", data={"sentence": "Use only odd numbers."}).text
    assert "Fill the whole of the top row." in page
    assert "You told me so." in caregiver.get(root).text


def test_what_is_not_understood_is_quoted_with_what_could_be_said(
    caregiver: TestClient, taught: str
) -> None:
    answer = caregiver.post(
        f"{taught}/words/change", data={"number": "1", "sentence": "Make it pretty."}
    )
    assert answer.status_code == 422
    assert "I did not understand this part:" in answer.text
    assert "<q>Make it pretty</q>" in answer.text
    assert "You could say:" in answer.text


def test_rules_that_cannot_be_kept_together_are_shown(caregiver: TestClient, taught: str) -> None:
    caregiver.post(f"{taught}/words/add", data={"sentence": "Use only odd numbers."})
    answer = caregiver.post(f"{taught}/words/add", data={"sentence": "Use only even numbers."})
    assert answer.status_code == 422
    assert "No row of these tokens keeps all of these rules:" in answer.text


# ---------------------------------------------------------------- trying


def test_each_move_is_judged_at_once(caregiver: TestClient, taught: str) -> None:
    path = f"{taught}/try/move"
    assert "Place a token." in caregiver.get(f"{taught}/try").text
    assert "Allowed." in caregiver.post(path, data={"cell": "1,1", "token": "46"}).text
    refused = caregiver.post(path, data={"cell": "1,2", "token": "19"}).text
    assert "19 is not larger than 46 on its left." in refused
    assert "Place a token." in caregiver.post(f"{taught}/try/again").text
    for column, token in enumerate(ROW[:-1], start=1):
        caregiver.post(path, data={"cell": f"1,{column}", "token": token})
    page = caregiver.post(path, data={"cell": "1,5", "token": ROW[-1]}).text
    assert "The row is complete and right." in page


def test_trying_by_pressing_twice(caregiver: TestClient, taught: str) -> None:
    page = caregiver.get(f"{taught}/try").text
    home = re.search(r'value="(\d,\d)" aria-label="[^"]*token 46"', page)
    assert home
    path = f"{taught}/try/move"
    assert "token 46, in your hand" in caregiver.post(path, data={"cell": home[1]}).text
    assert "token 46, in your hand" not in caregiver.post(path, data={"cell": home[1]}).text
    assert "Please choose an empty cell." in caregiver.post(path, data={"cell": "1,1"}).text


def test_there_is_nothing_to_try_before_anything_is_taught(
    caregiver: TestClient, root: str
) -> None:
    assert "There is nothing to try yet." in caregiver.get(f"{root}/try").text
    moved = caregiver.post(f"{root}/try/move", data={"cell": "1,1", "token": "46"}).text
    assert "Please move a token to the goal row first." in moved


# ---------------------------------------------------------------- the exam


def judged(browser: TestClient, root: str, said: str) -> str:
    page = browser.post(f"{root}/exam/begin").text
    for _ in range(10):
        page = browser.post(f"{root}/exam/judge", data={"said": said}).text
    return page


def test_what_is_judged_otherwise_goes_back_to_learning(
    caregiver: TestClient, taught: str
) -> None:
    page = judged(caregiver, taught, "no")
    assert "You agreed with 0 of 5 plays." in page
    assert "Maestra has learned from that" in page


def test_what_is_unsure_counts_for_nothing(caregiver: TestClient, taught: str) -> None:
    page = judged(caregiver, taught, "unsure")
    assert "You judged none of my plays" in page
    assert "Maestra has learned from that" not in page


def test_objections_to_rules_that_were_only_told_change_nothing(
    caregiver: TestClient, told: str
) -> None:
    page = judged(caregiver, told, "no")
    assert "Maestra has learned from that, but the rules stay the same." in page


def test_an_exam_is_left_and_an_old_page_of_it_refused(caregiver: TestClient, taught: str) -> None:
    caregiver.post(f"{taught}/exam/begin")
    left = caregiver.post(f"{taught}/exam/enough").text
    assert "Show me examples" in left
    over = "The examples are over."
    assert over in caregiver.post(f"{taught}/exam/judge", data={"said": "yes"}).text
    assert over in caregiver.post(f"{taught}/exam/enough").text
    caregiver.post(f"{taught}/exam/begin")
    caregiver.post(f"{taught}/exam/judge", data={"said": "yes"})
    old = caregiver.post(f"{taught}/exam/judge", data={"said": "yes", "at": "0.0.0"})
    assert "This page was older" in old.text
    assert "What came of it" in caregiver.post(f"{taught}/exam/enough").text


def test_there_is_no_exam_before_anything_is_taught(caregiver: TestClient, root: str) -> None:
    assert "There are no rules yet" in caregiver.get(f"{root}/exam").text
    assert "Please move a token" in caregiver.post(f"{root}/exam/begin").text


# ---------------------------------------------------------------- what counts


def test_only_what_is_checked_counts(caregiver: TestClient, taught: str) -> None:
    page = caregiver.get(f"{taught}/features").text
    assert "such as 19, 23, 51" in page
    assert "You have said what counts." not in page
    chosen = {"feature": ["less-than:value", "destination"]}
    page = caregiver.post(f"{taught}/features", data=chosen).text
    assert "You have said what counts." in page
    assert "Not clear yet:" in page
    assert "so Maestra learns steps" in caregiver.get(f"{taught}/words").text
    assert "Is it right" not in caregiver.get(taught).text
    saved = caregiver.post(f"{taught}/save", data={"name": "By features"}).text
    assert "version 1." in saved
    again = caregiver.post("/teach/from", data={"name": "By features"}).url.path
    assert "You have said what counts." in caregiver.get(f"{again}/features").text
    tried = {"cell": "1,1", "token": "19"}
    assert "Allowed." in caregiver.post(f"{taught}/try/move", data=tried).text
    assert "You have said what counts." not in caregiver.post(f"{taught}/features/none").text


def test_what_cannot_count_is_refused(caregiver: TestClient, root: str) -> None:
    answer = caregiver.post(f"{root}/features", data={"feature": ["vowel"]})
    assert answer.status_code == 422
    assert "That cannot count with these tokens." in answer.text


def test_a_taken_name_is_refused_at_its_field(
    caregiver: TestClient, taught: str, told: str
) -> None:
    del told
    answer = caregiver.post(f"{taught}/save", data={"name": "Make exactly 100"})
    assert answer.status_code == 422
    assert "The library has an exercise of this name." in answer.text

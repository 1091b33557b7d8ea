"""A caregiver teaches on the pages, as a browser without script sends them."""

import re
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest
from fastapi.testclient import TestClient

from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.library.included import first_start
from maestra.web.teach import desk

Login = Callable[[Role], TestClient]


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


def begun(browser: TestClient, deck: str = "numbers") -> str:
    answer = browser.post("/teach", data={"deck": deck}, follow_redirects=False)
    assert answer.status_code == 303
    return answer.headers["location"]


def place_of(page: str, token: str) -> str:
    """The cell where a token lies, as its button has it."""
    found = re.search(rf'value="(\d+,\d+)" aria-label="[^"]*token {token}"', page)
    assert found, token
    return found[1]


def press(browser: TestClient, root: str, cell: str) -> str:
    answer = browser.post(f"{root}/move", data={"cell": cell})
    assert answer.status_code == 200
    return answer.text


def show_row(browser: TestClient, root: str, tokens: str) -> str:
    page = browser.get(f"{root}?more=yes").text
    for column, token in enumerate(tokens.split(), start=1):
        press(browser, root, place_of(page, token))
        page = press(browser, root, f"1,{column}")
    return page


def test_a_newcomer_teaches_ascending_and_saves_it(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = show_row(caregiver, root, "19 32 46 57 68")
    assert "Fill the whole of the top row." in page
    page = caregiver.post(f"{root}/reply", data={"said": "yes"}).text
    assert "I am 9" in page
    page = caregiver.post(f"{root}/save", data={"name": "Ascending"}).text
    assert "Saved as “Ascending”, version 1." in page


PLACES = ["", "/tokens", "/features", "/words", "/try", "/exam"]


@pytest.mark.parametrize("language", ["en", "es", "ca"])
def test_each_page_is_there_from_the_start_in_each_language(
    caregiver: TestClient, language: str
) -> None:
    caregiver.post("/language", data={"language": language})
    root = begun(caregiver)
    for place in PLACES:
        assert f'<html lang="{language}">' in caregiver.get(f"{root}{place}").text


@pytest.mark.parametrize("deck", ["letters", "words", "shapes"])
def test_each_deck_has_its_pages(caregiver: TestClient, deck: str) -> None:
    root = begun(caregiver, deck)
    for place in PLACES:
        assert caregiver.get(f"{root}{place}").status_code == 200


# ---------------------------------------------------------------- the board


def test_nothing_is_lost_by_a_reload_and_a_restart(
    caregiver: TestClient, context: Context
) -> None:
    root = begun(caregiver)
    page = caregiver.get(root).text
    press(caregiver, root, place_of(page, "19"))
    assert "token 19, in your hand" in caregiver.get(root).text
    caregiver.app.state.context = replace(context)  # type: ignore[attr-defined] # the app under test
    assert "token 19, in your hand" in caregiver.get(root).text
    page = press(caregiver, root, "1,1")
    assert place_of(page, "19") == "1,1"


def test_a_token_is_put_down_again_where_it_was(caregiver: TestClient) -> None:
    root = begun(caregiver)
    cell = place_of(caregiver.get(root).text, "19")
    assert "token 19, in your hand" in press(caregiver, root, cell)
    assert "token 19, in your hand" not in press(caregiver, root, cell)
    assert "Please choose an empty cell." in press(caregiver, root, "1,3")


def test_a_whole_move_can_be_sent_at_once(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = caregiver.post(f"{root}/move", data={"cell": "1,2", "token": "36"}).text
    assert place_of(page, "36") == "1,2"
    undone = caregiver.post(f"{root}/undo").text
    assert place_of(undone, "36") != "1,2"
    assert "There is nothing to undo." in caregiver.post(f"{root}/undo").text


def test_a_short_row_is_done_when_the_caregiver_says_so(caregiver: TestClient) -> None:
    root = begun(caregiver)
    assert "Please move a token to the goal row first." in caregiver.post(f"{root}/done").text
    caregiver.post(f"{root}/move", data={"cell": "1,1", "token": "19"})
    page = caregiver.post(f"{root}/done").text
    assert "Row 1" in page


def test_the_tokens_are_dealt_again_until_something_is_moved(caregiver: TestClient) -> None:
    root = begun(caregiver)
    before = caregiver.get(root).text
    assert caregiver.post(f"{root}/deal").text != before
    caregiver.post(f"{root}/move", data={"cell": "1,1", "token": "19"})
    assert "Your demonstrations need" in caregiver.post(f"{root}/deal").text


def test_a_demonstration_is_taken_back_and_counts_again(caregiver: TestClient) -> None:
    root = begun(caregiver)
    show_row(caregiver, root, "19 32 46 57 68")
    page = caregiver.post(f"{root}/take-back", data={"number": 1}).text
    assert "taken back" in page
    assert "Nothing yet." in page
    page = caregiver.post(f"{root}/bring-back", data={"number": 1}).text
    assert "taken back" not in page
    assert "That is so already." in caregiver.post(f"{root}/bring-back", data={"number": 1}).text


# ---------------------------------------------------------------- questions


def mark_of(page: str) -> str:
    found = re.search(r'name="at" value="([^"]*)"', page)
    assert found
    return found[1]


def test_an_old_page_is_refused_kindly(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = show_row(caregiver, root, "19 32 46 57 68")
    old = {"said": "yes", "at": mark_of(page)}
    assert "This page was older" not in caregiver.post(f"{root}/reply", data=old).text
    assert "This page was older" in caregiver.post(f"{root}/reply", data=old).text
    assert "This page was older" in caregiver.post(f"{root}/reply", data={"said": "no"}).text


def test_two_answers_at_once_leave_one_answer(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = show_row(caregiver, root, "19 32 46 57 68")
    sent = {"said": "yes", "at": mark_of(page)}
    with ThreadPoolExecutor(4) as pool:
        posted = [pool.submit(caregiver.post, f"{root}/reply", data=sent) for _ in range(4)]
        refused = ["This page was older" in one.result().text for one in posted]
    assert refused.count(False) == 1
    assert "I am 9" in caregiver.get(root).text


def test_a_question_waits_while_another_row_is_shown(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = show_row(caregiver, root, "19 32 46 57 68")
    assert "Is " in page
    assert "I show another row instead" in page
    assert "Back to the question" in caregiver.get(f"{root}?more=yes").text


def test_that_is_enough_ends_the_questions(caregiver: TestClient) -> None:
    root = begun(caregiver)
    show_row(caregiver, root, "19 32 46 57 68")
    page = caregiver.post(f"{root}/reply", data={"said": "enough"}).text
    assert "Show another row, if you like" in page


def test_what_is_no_answer_is_refused(caregiver: TestClient) -> None:
    root = begun(caregiver)
    assert caregiver.post(f"{root}/reply", data={"said": "perhaps"}).status_code == 422


def answered(browser: TestClient, root: str, page: str) -> set[str]:
    """Answer "no" to whatever is asked; the kinds of what was asked."""
    kinds: set[str] = set()
    for _ in range(12):
        if 'value="unknown-cell"' in page:
            kinds.add("cell")
            page = browser.post(f"{root}/wrong", data={"cell": "1,1"}).text
        elif 'value="confirmed"' in page:
            kinds.add("slip")
            page = browser.post(f"{root}/reply", data={"said": "again"}).text
        elif 'value="neither"' in page:
            kinds.add("sides")
            page = browser.post(f"{root}/reply", data={"said": "neither"}).text
        elif 'value="unsure"' in page:
            kinds.add("question")
            page = browser.post(f"{root}/reply", data={"said": "no"}).text
        else:
            break
    return kinds


def test_questions_slips_and_contradictions_are_all_shown_and_answered(
    caregiver: TestClient,
) -> None:
    root = begun(caregiver)
    kinds: set[str] = set()
    for row in ("19 32 46 57 68", "23 34 36 51 63", "19 36 32 46 68", "68 57 46 32 19"):
        page = show_row(caregiver, root, row)
        kinds |= answered(caregiver, root, page)
    assert {"question", "sides"} <= kinds
    refused = caregiver.post(f"{root}/wrong", data={"cell": "2,1"}).text
    assert "Please choose an empty cell." in refused


# ---------------------------------------------------------------- keeping it


def test_a_name_is_kept_while_it_is_typed(caregiver: TestClient) -> None:
    root = begun(caregiver)
    show_row(caregiver, root, "19 32 46 57 68")
    caregiver.post(f"{root}/name", data={"name": "Going up"})
    assert 'value="Going up"' in caregiver.get(root).text
    page = caregiver.post(f"{root}/name").text
    assert 'value="Going up"' not in page


@pytest.mark.parametrize("name", ["", "   ", "x" * 81])
def test_a_name_that_is_none_is_refused_at_its_field(caregiver: TestClient, name: str) -> None:
    root = begun(caregiver)
    show_row(caregiver, root, "19 32 46 57 68")
    answer = caregiver.post(f"{root}/save", data={"name": name})
    assert answer.status_code == 422
    assert "Please write a name, of at most 80 letters." in answer.text


def test_nothing_is_saved_before_anything_was_shown(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = caregiver.post(f"{root}/save", data={"name": "Nothing"}).text
    assert "Please move a token to the goal row first." in page


def test_teaching_goes_on_where_an_exercise_was_saved(
    caregiver: TestClient, context: Context
) -> None:
    root = begun(caregiver)
    show_row(caregiver, root, "19 32 46 57 68")
    caregiver.post(f"{root}/reply", data={"said": "yes"})
    caregiver.post(f"{root}/save", data={"name": "Ascending"})
    again = caregiver.post("/teach/from", data={"name": "Ascending"})
    assert "Row 1" in again.text
    assert "I am 9" in again.text
    page = caregiver.post(f"{again.url.path}/save", data={"name": "Ascending"}).text
    assert "Saved as “Ascending”, version 1." in page
    stored = context.store.exercise("Ascending")
    assert len(stored.demonstrations.splitlines()) == 1
    assert caregiver.post("/teach/from", data={"name": "Nobody’s"}).status_code == 404


def test_a_told_exercise_of_the_library_is_taught_on(
    caregiver: TestClient, context: Context
) -> None:
    first_start(context.store, "2026-05-04T12:00:00+00:00")
    page = caregiver.post("/teach/from", data={"name": "Make exactly 100"}).text
    assert "You told me so." in page


def test_drafts_are_listed_and_forgotten(caregiver: TestClient) -> None:
    root = begun(caregiver)
    assert f'href="{root}"' in caregiver.get("/teach").text
    assert f'href="{root}"' not in caregiver.post(f"{root}/delete").text
    assert caregiver.get(root).status_code == 404


def test_a_draft_is_its_owners_alone(somebody: Login) -> None:
    root = begun(somebody(Role.CAREGIVER))
    other = somebody(Role.ADMINISTRATOR)
    assert other.get(root).status_code == 404
    assert other.post(f"{root}/undo").status_code == 404
    assert root not in other.get("/teach").text


def test_nobody_has_drafts_without_end(
    caregiver: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(desk, "MAX_DRAFTS", 1)
    root = begun(caregiver)
    refusal = "You have very many exercises begun. Please delete some."
    assert refusal in caregiver.post("/teach", data={"deck": "letters"}).text
    assert refusal in caregiver.post(f"{root}/tokens/again").text
    assert caregiver.post("/api/drafts", json={"ready": "letters"}).status_code == 409

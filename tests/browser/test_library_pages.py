import re
from pathlib import Path

from playwright.sync_api import Page, expect

from tests.browser.sizes import Size


def test_the_list_follows_what_is_typed_and_forgets_nothing(caregiver_at: Page) -> None:
    page = caregiver_at
    page.goto("/library")
    expect(page.locator(".exercise")).to_have_count(12)
    search = page.get_by_label("Search", exact=True)
    search.press_sequentially("curie")
    expect(page.locator(".exercise")).to_have_count(1)
    expect(search).to_be_focused()
    expect(search).to_have_value("curie")
    expect(page.get_by_text("Found: 1")).to_be_visible()
    page.locator('button[lang="ca"]').click()
    expect(page.locator("html")).to_have_attribute("lang", "ca")
    expect(page.get_by_role("link", name="Escriure CURIE")).to_be_visible()
    expect(page.locator("#search")).to_have_value("curie")


def test_an_exercise_goes_away_comes_back_and_travels_as_a_file(
    caregiver_at: Page, size: Size, tmp_path: Path
) -> None:
    page = caregiver_at
    page.goto("/library")
    page.get_by_role("link", name="Count in twos").click()
    with page.expect_download() as saved:
        page.get_by_role("link", name="Save as a file").click()
    file = tmp_path / f"{size.name}.exercise.json"
    saved.value.save_as(file)
    page.get_by_role("button", name="Take from the library").click()
    expect(page.get_by_text("“Count in twos” is no longer in the library.")).to_be_visible()
    page.get_by_role("button", name="Put it back").first.click()
    expect(page.get_by_role("heading", level=1, name="Count in twos")).to_be_visible()
    page.goto("/library")
    page.get_by_label("A file that somebody gave you").set_input_files(file)
    page.get_by_role("button", name="Bring it in").click()
    expect(page.get_by_role("heading", level=1, name=size.name)).to_be_visible()
    expect(page.get_by_text(re.compile("^Brought in by Ana on "))).to_be_visible()


def test_the_help_is_at_the_same_place_on_each_page(caregiver_at: Page) -> None:
    places: set[tuple[int, int]] = set()
    for path in ("/", "/teach", "/library", "/patients", "/sessions", "/progress", "/help"):
        caregiver_at.goto(path)
        box = caregiver_at.get_by_role("link", name="Help", exact=True).bounding_box()
        assert box is not None
        places.add((round(box["x"]), round(box["y"])))
    assert len(places) == 1

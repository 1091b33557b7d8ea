import re
from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient

from maestra.language import Language
from maestra.web.access.visitor import Role

Login = Callable[[Role], TestClient]


@pytest.mark.parametrize("language", Language)
def test_the_help_is_written_in_each_language_with_its_pictures(
    somebody: Login, language: Language
) -> None:
    browser = somebody(Role.CAREGIVER)
    browser.headers["accept-language"] = language.value
    page = browser.get("/help").text
    assert f'<html lang="{language.value}">' in page
    pictures = re.findall(r'src="(/static/help/[^"]+)"', page)
    assert len(pictures) == 3
    for picture in pictures:
        answer = browser.get(picture)
        assert (answer.status_code, answer.headers["content-type"]) == (200, "image/webp")


def test_the_help_has_the_same_parts_in_each_language(somebody: Login) -> None:
    browser = somebody(Role.CAREGIVER)
    parts: set[tuple[str, ...]] = set()
    for language in Language:
        browser.headers["accept-language"] = language.value
        page = browser.get("/help").text
        parts.add(tuple(re.findall(r'<h2 id="(\w+)"|<(li|dt|img)\b', page)))
    assert len(parts) == 1


def test_style_and_module_come_compressed_and_only_once(somebody: Login) -> None:
    browser = somebody(Role.CAREGIVER)
    for name in ("maestra.css", "maestra.js"):
        answer = browser.get(f"/static/{name}")
        assert answer.headers["content-encoding"] == "gzip"
        assert answer.headers["cache-control"] == "no-cache"
        same = {"if-none-match": answer.headers["etag"]}
        assert browser.get(f"/static/{name}", headers=same).status_code == 304

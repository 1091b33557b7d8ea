"""A house in which everything has happened once, so that every page has something to show."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final

from playwright.sync_api import Page

from maestra.coaching.ports import PatientId, SessionId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.settings import Mental, Profile, settings_for
from maestra.language import Language
from maestra.web.access.visitor import Role
from maestra.web.library.collection import exercise_id
from tests.browser.roles import NAMES, log_in
from tests.browser.serving import Served
from tests.web.people import add_account
from tests.web.played import play

Form = dict[str, str | float | bool]

HERON: Final = PatientId("heron")
EXERCISE: Final = "Five numbers, ascending"
PIN: Final = "4711"


@dataclass(frozen=True, slots=True)
class World:
    """What there is, by what addresses call it."""

    draft: str
    room: str
    session: SessionId
    screen_code: str
    account: str

    def filled(self, path: str) -> str:
        """The path of a route with its gaps filled."""
        gaps: Mapping[str, str] = {
            "account": self.account,
            "draft": self.draft,
            "name": self.room,
            "pseudonym": HERON,
            "session": self.session,
            "wanted": exercise_id(EXERCISE),
        }
        return path.format_map(gaps)


def populate(served: Served, caregiver: Page, language: Language = Language.EN) -> World:
    """Let everything happen; `caregiver` becomes the page of one who is logged in.

    Both the caregiver and the patient then read `language`.
    """
    store = served.context.store
    ana = add_account(served.context, NAMES[Role.CAREGIVER], Role.CAREGIVER)
    rosa = add_account(served.context, NAMES[Role.RESEARCHER], Role.RESEARCHER)
    store.custody.own(HERON, ana.account)
    settings = replace(settings_for(Profile(Mental.MODERATE)), language=language)
    store.save_settings(HERON, write_remembered(Remembered(settings)))
    store.save_name(HERON, "Montserrat Pujol")
    sessions = play(store, HERON, EXERCISE, sessions=3)
    log_in(served, caregiver, Role.CAREGIVER)
    world = World(
        draft=_taught(caregiver),
        room=_begun(caregiver),
        session=sessions[-1],
        screen_code=_screen(caregiver),
        account=rosa.account,
    )
    caregiver.request.post("/language", form={"language": language.value})
    return world


def _taught(page: Page) -> str:
    """A draft with one demonstration."""
    begun = page.request.post("/teach", form={"deck": "numbers"})
    root = begun.url
    text = begun.text()
    for column, token in enumerate(("19", "32", "46", "57", "68"), start=1):
        found = re.search(rf'value="(\d+,\d+)" aria-label="[^"]*token {token}"', text)
        assert found is not None
        form: Form = {"token": _id_of(text, token), "cell": f"1,{column}"}
        text = page.request.post(f"{root}/move", form=form).text()
    return root.rsplit("/", 1)[-1].split("?")[0]


def _id_of(text: str, token: str) -> str:
    found = re.search(rf'data-token="([^"]+)"[^>]*><span class="label">{token}<', text)
    assert found is not None
    return found[1]


def _begun(page: Page) -> str:
    """A session that is about to begin."""
    form: Form = {"patient": HERON, "exercise": EXERCISE, "board": ""}
    return page.request.post("/sessions", form=form).url.rsplit("/", 1)[-1]


def _screen(page: Page) -> str:
    """The code of a patient's screen."""
    form: Form = {"patient": HERON, "label": "Tablet in the day room", "pin": PIN}
    made = page.request.post("/devices/screens", form=form).text()
    found = re.search(r'<p class="code"><code>([^<]+)</code>', made)
    assert found is not None
    return found[1]

"""What each route answers to whom: one line a route, one column a kind of visitor.

`in`: the route does what it is there for, or says what is wrong in what was sent. `led`: to the
entrance (programs: 401). `denied`: 403. `missing`: 404, as for what never was.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Final


class Who(Enum):
    """The columns."""

    NOBODY = "nobody"
    OWNER = "owner"
    """The caregiver whose patient, draft, device or room it is."""
    OTHER = "other"
    """Another caregiver."""
    RESEARCHER = "researcher"
    ADMINISTRATOR = "administrator"
    SCREEN = "screen"
    """The screen of the owner's patient, open."""
    STRANGER = "stranger"
    """The screen of another patient, open."""
    BOARD = "board"
    """A board in the room where the owner's patient plays."""
    ELSEWHERE = "elsewhere"
    """A robot in another room."""


class Is(Enum):
    """The cells."""

    IN = "in"
    LED = "led"
    DENIED = "denied"
    MISSING = "missing"


Row = Mapping[Who, Is]


def row(cells: str) -> Row:
    """A row from one word for each column."""
    return dict(zip(Who, map(Is, cells.split()), strict=True))


#                    nobody  owner   other   researcher administr.    screen stranger board elsewh.
EVERYBODY: Final = row("in   in      in      in         in            in     in       in     in")
PEOPLE: Final = row("led     in      in      in         in            led    led      led    led")
CARERS: Final = row("led     in      in      denied     in            led    led      led    led")
CHIEFS: Final = row("led     denied  denied  denied     in            led    led      led    led")
FOLLOW: Final = PEOPLE
"""Progress, of whom one may see."""
TAKEN_BACK: Final = row("led missing missing denied     missing       led    led      led    led")
"""There is nothing to take back: that it is not theirs is told the same way."""
PATIENT: Final = row("led    in      missing denied     in            led    led      led    led")
PROGRESS: Final = row("led   in      missing in         in            led    led      led    led")
DRAFT: Final = row("led      in      missing missing    missing       led    led      led    led")
DEVICE: Final = PATIENT
TAKING_PART: Final = row("led in     in      in         in            in     in       in     in")
ROOMS: Final = row("led      in      in      denied     in            in     in       in     in")
"""The list of rooms, which holds those that one may enter."""
ROOM: Final = row(
    "led       in      missing denied     in            in     missing  in     missing"
)
STEER: Final = row(
    "led      in      missing denied     in            denied missing  denied missing"
)
"""What only caregivers do in a room."""
SESSION: Final = row("led    in      missing denied     in            led    led      led    led")
SCREEN_STREAM: Final = row(
    "led missing missing denied missing       in     in       missing missing"
)
SCREENS: Final = row("led    led     led     led        led           in     in       led    led")


@dataclass(frozen=True, slots=True)
class Line:
    """A route, whom it is for, and what a right request to it holds."""

    method: str
    path: str
    row: Row
    form: Mapping[str, Any] | None = None
    json: Any = None
    files: Mapping[str, Any] | None = None

    @property
    def name(self) -> str:
        """As pytest shows it."""
        return f"{self.method} {self.path}"


def form(**fields: object) -> Mapping[str, Any]:
    """A form's fields."""
    return fields


PATIENT_GAP: Final = "{pseudonym}"
"""Whatever stands in this gap, wherever in the request."""
PICTURE: Final = form(files=("cup.png", b"no picture", "image/png"))
MOVES: Final = {"moves": [{"token": "19", "destination": [1, 1]}]}

TABLE: Final = (
    # ------------------------------------------------ the entrance
    Line("GET", "/", PEOPLE),
    Line("GET", "/set-up", EVERYBODY),
    Line("POST", "/set-up", EVERYBODY),
    Line("GET", "/login", EVERYBODY),
    Line("POST", "/login", EVERYBODY),
    Line("GET", "/login/code", EVERYBODY),
    Line("POST", "/login/code", EVERYBODY),
    Line("POST", "/logout", EVERYBODY),
    Line("POST", "/language", EVERYBODY, form(language="en")),
    Line("GET", "/help", EVERYBODY),
    Line("GET", "/api/openapi.json", EVERYBODY),
    Line("GET", "/static/maestra.css", EVERYBODY),
    # ------------------------------------------------ one's own account
    Line("GET", "/account", PEOPLE),
    Line("POST", "/account/language", PEOPLE, form(language="en")),
    Line("POST", "/account/password", PEOPLE),
    Line("GET", "/account/new-password", PEOPLE),
    Line("POST", "/account/new-password", PEOPLE),
    Line("GET", "/account/second-factor", PEOPLE),
    Line("POST", "/account/second-factor", PEOPLE),
    Line("POST", "/account/second-factor/offer", PEOPLE),
    Line("POST", "/account/second-factor/off", PEOPLE),
    Line("POST", "/account/logins/end", PEOPLE),
    # ------------------------------------------------ accounts, audit
    Line("GET", "/accounts", CHIEFS),
    Line("POST", "/accounts", CHIEFS, form(name="New", role="caregiver")),
    Line("GET", "/accounts/{account}", CHIEFS),
    Line("POST", "/accounts/{account}/role", CHIEFS, form(role="caregiver")),
    Line("POST", "/accounts/{account}/disable", CHIEFS),
    Line("POST", "/accounts/{account}/enable", CHIEFS),
    Line("POST", "/accounts/{account}/reset", CHIEFS),
    Line("POST", "/accounts/{account}/patients", CHIEFS),
    Line("GET", "/audit", CHIEFS),
    # ------------------------------------------------ devices and screens
    Line("GET", "/devices", CARERS),
    Line("POST", "/devices/screens", CARERS),
    Line("POST", "/devices/programs", CHIEFS, form(kind="board", label="x", room="x")),
    Line("POST", "/devices/{device}/remove", DEVICE),
    Line("GET", "/screen", EVERYBODY),
    Line("POST", "/screen", EVERYBODY),
    Line("POST", "/screen/close", EVERYBODY),
    Line("POST", "/screen/leave", EVERYBODY),
    # ------------------------------------------------ teaching
    Line("GET", "/teach", PEOPLE),
    Line("POST", "/teach", PEOPLE, form(deck="numbers")),
    Line("POST", "/teach/from", PEOPLE, form(name="ascending")),
    Line("POST", "/teach/pictures", PEOPLE, files=PICTURE),
    Line("GET", "/teach/{draft}", DRAFT),
    Line("POST", "/teach/{draft}/bring-back", DRAFT, form(number="1")),
    Line("POST", "/teach/{draft}/deal", DRAFT),
    Line("POST", "/teach/{draft}/delete", DRAFT),
    Line("POST", "/teach/{draft}/done", DRAFT),
    Line("GET", "/teach/{draft}/exam", DRAFT),
    Line("POST", "/teach/{draft}/exam/begin", DRAFT),
    Line("POST", "/teach/{draft}/exam/enough", DRAFT),
    Line("POST", "/teach/{draft}/exam/judge", DRAFT, form(said="yes")),
    Line("GET", "/teach/{draft}/features", DRAFT),
    Line("POST", "/teach/{draft}/features", DRAFT),
    Line("POST", "/teach/{draft}/features/none", DRAFT),
    Line("POST", "/teach/{draft}/move", DRAFT, form(token="1", cell="1,1")),
    Line("POST", "/teach/{draft}/name", DRAFT, form(name="x")),
    Line("POST", "/teach/{draft}/reply", DRAFT, form(said="yes")),
    Line("POST", "/teach/{draft}/save", DRAFT, form(name="x")),
    Line("POST", "/teach/{draft}/take-back", DRAFT, form(number="1")),
    Line("GET", "/teach/{draft}/tokens", DRAFT),
    Line("POST", "/teach/{draft}/tokens/again", DRAFT),
    Line("POST", "/teach/{draft}/tokens/board", DRAFT, form(rows="4", columns="5")),
    Line("POST", "/teach/{draft}/tokens/deal", DRAFT),
    Line("POST", "/teach/{draft}/tokens/letters", DRAFT, form(letters="A B C")),
    Line("POST", "/teach/{draft}/tokens/list", DRAFT, form(numbers="1 2 3")),
    Line("POST", "/teach/{draft}/tokens/move", DRAFT, form(token="1", cell="1,1")),
    Line("POST", "/teach/{draft}/tokens/numbers", DRAFT, form(first="1", last="3")),
    Line("POST", "/teach/{draft}/tokens/pictures", DRAFT, files=PICTURE),
    Line("POST", "/teach/{draft}/tokens/shapes", DRAFT),
    Line("POST", "/teach/{draft}/tokens/table", DRAFT, form(token="1", property="x", value="1")),
    Line("POST", "/teach/{draft}/tokens/words", DRAFT, form(words="a b c")),
    Line("GET", "/teach/{draft}/try", DRAFT),
    Line("POST", "/teach/{draft}/try/again", DRAFT),
    Line("POST", "/teach/{draft}/try/move", DRAFT, form(token="1", cell="1,1")),
    Line("POST", "/teach/{draft}/undo", DRAFT),
    Line("GET", "/teach/{draft}/words", DRAFT),
    Line("POST", "/teach/{draft}/words/add", DRAFT, form(sentence="x")),
    Line("POST", "/teach/{draft}/words/change", DRAFT, form(number="1", sentence="x")),
    Line("POST", "/teach/{draft}/words/forget", DRAFT),
    Line("POST", "/teach/{draft}/words/remove", DRAFT, form(number="1")),
    Line("POST", "/teach/{draft}/wrong", DRAFT, form(cell="1,1")),
    Line("GET", "/pictures/{digest}", TAKING_PART),
    Line("GET", "/api/drafts", PEOPLE),
    Line("POST", "/api/drafts", PEOPLE, json={"ready": "numbers"}),
    Line("GET", "/api/drafts/{draft}", DRAFT),
    Line("DELETE", "/api/drafts/{draft}", DRAFT),
    Line("POST", "/api/drafts/{draft}/answers", DRAFT, json={"answer": "yes", "mark": "x"}),
    Line("POST", "/api/drafts/{draft}/demonstrations", DRAFT, json=MOVES),
    Line("DELETE", "/api/drafts/{draft}/demonstrations/1", DRAFT),
    Line("PUT", "/api/drafts/{draft}/demonstrations/1", DRAFT, json=MOVES),
    Line("POST", "/api/drafts/{draft}/save", DRAFT, json={"name": "x"}),
    Line("POST", "/api/drafts/{draft}/undo", DRAFT),
    # ------------------------------------------------ the library
    Line("GET", "/library", PEOPLE),
    Line("POST", "/library/files", PEOPLE),
    Line("GET", "/library/{exercise}", PEOPLE),
    Line("POST", "/library/{exercise}/again", PEOPLE, form(version="1")),
    Line("POST", "/library/{exercise}/copy", PEOPLE),
    Line("GET", "/library/{exercise}/file", PEOPLE),
    Line("GET", "/library/{exercise}/pddl", PEOPLE),
    Line("GET", "/library/{exercise}/picture", PEOPLE),
    Line("POST", "/library/{exercise}/removal", PEOPLE),
    Line("POST", "/library/{exercise}/return", PEOPLE),
    Line("POST", "/library/{exercise}/title", PEOPLE, form(title="x")),
    Line("GET", "/api/exercises", PEOPLE),
    Line("POST", "/api/exercises", PEOPLE, json={}),
    Line("GET", "/api/exercises/{exercise}", PEOPLE),
    Line("DELETE", "/api/exercises/{exercise}", PEOPLE),
    Line("GET", "/api/exercises/{exercise}/file", PEOPLE),
    Line("GET", "/api/exercises/{exercise}/pddl", PEOPLE),
    Line("POST", "/api/exercises/{exercise}/return", PEOPLE),
    # ------------------------------------------------ patients
    Line("GET", "/patients", CARERS),
    Line("GET", "/patients/new", CARERS),
    Line("POST", "/patients", CARERS),
    Line("GET", "/patients/{pseudonym}", PATIENT),
    Line("GET", "/patients/{pseudonym}/erase", PATIENT),
    Line("POST", "/patients/{pseudonym}/erase", PATIENT),
    Line("GET", "/patients/{pseudonym}/everything.json", PATIENT),
    Line("POST", "/patients/{pseudonym}/exercises", PATIENT),
    Line("POST", "/patients/{pseudonym}/name", PATIENT),
    Line("GET", "/patients/{pseudonym}/preview", PATIENT),
    Line("GET", "/patients/{pseudonym}/preview/heard", PATIENT),
    Line("POST", "/patients/{pseudonym}/profile", PATIENT),
    Line("POST", "/patients/{pseudonym}/profile/leave", PATIENT),
    Line("POST", "/patients/{pseudonym}/profile/take", PATIENT),
    Line("GET", "/patients/{pseudonym}/settings", PATIENT),
    Line("POST", "/patients/{pseudonym}/settings", PATIENT),
    Line("POST", "/patients/{pseudonym}/settings/draft", PATIENT),
    Line("POST", "/patients/{pseudonym}/settings/forget", PATIENT),
    Line("POST", "/patients/{pseudonym}/settings/undo", PATIENT),
    Line("GET", "/api/patients", FOLLOW),
    Line("POST", "/api/patients", CARERS, json={"patient": "somebody"}),
    Line("GET", "/api/patients/{pseudonym}", PROGRESS),
    Line("DELETE", "/api/patients/{pseudonym}", PATIENT),
    Line("GET", "/api/patients/{pseudonym}/everything", PATIENT),
    Line("GET", "/api/patients/{pseudonym}/exercises", PATIENT),
    Line("PUT", "/api/patients/{pseudonym}/exercises", PATIENT, json={"exercises": []}),
    Line("GET", "/api/patients/{pseudonym}/settings", PATIENT),
    Line("PUT", "/api/patients/{pseudonym}/settings", PATIENT, json={}),
    # ------------------------------------------------ progress
    Line("GET", "/progress", FOLLOW),
    Line("GET", "/progress/{pseudonym}", PROGRESS),
    Line("GET", "/progress/{pseudonym}/exercise?name=ascending&session={session}", PROGRESS),
    Line("GET", "/progress/{pseudonym}/print", PROGRESS),
    Line("GET", "/progress/{pseudonym}/sessions/{session}", PROGRESS),
    Line("GET", "/api/patients/{pseudonym}/progress", PROGRESS),
    Line("GET", "/api/patients/{pseudonym}/sessions", PROGRESS),
    Line("GET", "/api/patients/{pseudonym}/sessions/{session}", PROGRESS),
    Line("POST", "/progress/{pseudonym}/sessions/{session}/teach", TAKEN_BACK),
    Line("GET", "/api/exports/csv", FOLLOW),
    # ------------------------------------------------ sessions and rooms
    Line("GET", "/sessions", CARERS),
    Line("GET", "/sessions/new-session", CARERS),
    Line("POST", "/sessions", CARERS),
    Line("GET", "/sessions/{room}", SESSION),
    Line("POST", "/sessions/{room}", SESSION, form(cell="1,1")),
    Line("POST", "/sessions/{room}/do", SESSION, form(wish="pause")),
    Line("GET", "/rooms/{room}", ROOM),
    Line("POST", "/rooms/{room}", ROOM, form(cell="1,1")),
    Line("GET", "/patient", SCREENS),
    Line("POST", "/patient", SCREENS, form(cell="1,1")),
    Line("GET", "/api/rooms", ROOMS),
    Line("POST", "/api/rooms", PATIENT, json={"patient": PATIENT_GAP, "exercise": "ascending"}),
    Line("GET", "/api/rooms/{room}", ROOM),
    Line("POST", "/api/rooms/{room}/end", STEER),
    Line("POST", "/api/rooms/{room}/events", ROOM, json={}),
    Line("GET", "/api/rooms/{room}/speech/{said}", ROOM),
    Line("WS", "/api/rooms/{room}/stream", ROOM),
    Line("WS", "/api/screen/stream", SCREEN_STREAM),
)

"""What the headers promise, held by a real browser."""

from playwright.sync_api import Page

from tests.browser.watching import Watch

INJECTED = """() => {
    const script = document.createElement("script");
    script.textContent = "document.title = 'taken over'";
    document.body.append(script);
    document.body.insertAdjacentHTML("beforeend",
        '<img id="handler" src="/static/none.png" onerror="document.title = 1">' +
        '<p id="styled" style="color: rgb(1, 2, 3)">x</p>');
}"""
FOREIGN = """async () => {
    const link = document.createElement("script");
    link.src = "https://elsewhere.example/x.js";
    document.body.append(link);
    const answer = fetch("https://elsewhere.example/");
    return answer.then(() => "fetched", () => "refused");
}"""


def test_no_script_handler_or_style_that_is_put_into_a_page_has_an_effect(
    caregiver: Page, watch: Watch
) -> None:
    watch.tolerate("refused by the policy")
    watch.tolerate("Content Security Policy")
    watch.tolerate("404 for GET .*/static/none.png")
    caregiver.goto("/library")
    caregiver.evaluate(INJECTED)
    caregiver.wait_for_timeout(500)
    assert caregiver.title() == "Library – Maestra"
    colour = "() => getComputedStyle(document.querySelector('#styled')).color"
    assert caregiver.evaluate(colour) != "rgb(1, 2, 3)"
    refused = [fault for fault in watch.faults if "refused by the policy" in fault]
    assert {one.split("policy: ")[1].split()[0] for one in refused} >= {
        "script-src-elem",
        "script-src-attr",
        "style-src-attr",
    }


def test_nothing_is_asked_of_another_site(caregiver: Page, watch: Watch) -> None:
    watch.tolerate("refused by the policy")
    watch.tolerate("Content Security Policy")
    watch.tolerate("Refused to")
    watch.tolerate("asked elsewhere")
    answers: list[str] = []
    caregiver.context.on("response", lambda answer: answers.append(answer.url))
    assert caregiver.evaluate(FOREIGN) == "refused"
    assert [url for url in answers if "elsewhere" in url] == []


def test_no_page_can_be_shown_inside_another(caregiver: Page, watch: Watch) -> None:
    watch.tolerate("refused by the policy")
    watch.tolerate("frame-ancestors")
    watch.tolerate("X-Frame-Options")
    watch.tolerate("Refused to display")
    caregiver.goto("/library")
    caregiver.evaluate(
        "() => { const frame = document.createElement('iframe'); frame.src = '/library';"
        " document.body.append(frame); }"
    )
    caregiver.wait_for_timeout(500)
    inner = [one for one in caregiver.frames if one is not caregiver.main_frame]
    assert all("Exercises" not in one.content() for one in inner)

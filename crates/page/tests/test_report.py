"""The figures of `restitution report` in a real browser: values under the pointer and by arrow keys."""

import csv

import pytest
from command import restitution


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "report"
    restitution("report", "--quick", "-o", str(folder))
    return folder


@pytest.fixture
def page(browser, report):
    page = browser.new_page(viewport={"width": 1200, "height": 900})
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(report.joinpath("index.html").as_uri())
    yield page
    assert not faults
    page.close()


READING = ".reading:not([hidden])"


def figure(page, name):
    return page.locator("svg.chart", has=page.locator(f"title[id={name}-title]"))


def test_a_line_is_read_under_the_pointer(page, report):
    svg = figure(page, "ends-of-contact")
    svg.scroll_into_view_if_needed()
    box = svg.bounding_box()
    page.mouse.move(box["x"] + box["width"] * 363 / 980, box["y"] + 100)
    head, *rows = page.inner_text(READING).splitlines()
    u = float(head.split("≈")[1])
    shown = {name: float(value.replace("−", "-")) for name, value in (row.rsplit(": ", 1) for row in rows)}
    with open(report / "ends-of-contact.csv", encoding="utf-8") as file:
        known = list(csv.DictReader(file))
    low = max((row for row in known if float(row["u"]) <= u), key=lambda row: float(row["u"]))
    high = min((row for row in known if float(row["u"]) >= u), key=lambda row: float(row["u"]))
    for end, column in (("zero compression", "epsilon_zero_compression"), ("zero force", "epsilon_zero_force")):
        value = next(value for name, value in shown.items() if end in name)
        assert 0.97 * float(high[column]) <= value <= 1.03 * float(low[column]), "between its neighbours in the table"
    page.mouse.move(1, 1)
    assert page.locator(READING).count() == 0


def test_a_mark_says_what_it_is(page):
    mark = figure(page, "speed-1").locator("path.mark").first
    mark.scroll_into_view_if_needed()
    mark.hover()
    assert page.inner_text(READING) == mark.text_content()


def test_arrow_keys_read_too(page):
    svg = figure(page, "ends-of-contact")
    svg.focus()
    page.keyboard.press("ArrowRight")
    first = page.inner_text(READING)
    page.keyboard.press("ArrowRight")
    assert page.inner_text(READING) != first
    page.keyboard.press("Escape")
    assert page.locator(READING).count() == 0

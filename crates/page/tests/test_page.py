"""The page in a real browser, against the command that wrote it.

Needs Chromium and the command: `make test-page` sees to both.
"""

import csv
import io
import math
import random
import re

import pytest
from command import ROOT, restitution
from playwright.sync_api import expect

STATES = 1000
BOUND = 1e-12  # of the evaluators, relative, as the page's last line says
ENDS = ("zero-compression", "zero-force")


def rows(*arguments):
    return list(csv.DictReader(io.StringIO(restitution(*arguments, "--format", "csv"))))


@pytest.fixture(scope="session")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "explore.html"
    restitution("page", "-o", str(path))
    return path


@pytest.fixture(params=["light", "dark"])
def page(browser, file, request):
    page = opened(browser, file, color_scheme=request.param)
    yield page
    assert page.faults == [], page.faults
    assert all(url.startswith("file:") for url in page.requests), page.requests
    page.close()


def opened(browser, file, **options):
    page = browser.new_page(**options)
    page.faults, page.requests = [], []
    page.on("pageerror", lambda error: page.faults.append(str(error)))
    page.on("console", lambda message: page.faults.append(message.text) if message.type == "error" else None)
    page.on("request", lambda request: page.requests.append(request.url))
    page.goto(file.as_uri())
    return page


def read(page, name):
    """The values of a row of the table below the figure, with all their bits."""
    cells = page.locator("#readout tbody tr", has=page.get_by_role("rowheader", name=name, exact=True)).locator("td")
    return [float(cell.get_attribute("data-value")) for cell in cells.all()]


def test_it_is_one_small_file_that_asks_for_nothing(file):
    content = file.read_text(encoding="utf-8")
    assert len(content.encode()) < 200_000
    assert not re.search(r"https?://|src=|@import|url\(", content)


def test_a_thousand_states_have_the_values_of_the_command(browser, file):
    page = opened(browser, file)
    generator = random.Random(1999)
    states = [(10 ** generator.uniform(-6, 3), 10 ** generator.uniform(-7, 4)) for _ in range(STATES)]
    found = page.evaluate(
        """(states) => states.map(([gStar, g]) => {
            const set = (id, value) => {
                document.getElementById(id).value = String(value);
                document.getElementById(id).dispatchEvent(new Event("input", { bubbles: true }));
            };
            set("g-star", gStar);
            set("velocity", g);
            const value = (row, column) =>
                Number(document.querySelectorAll("#readout tbody tr")[row].querySelectorAll("td")[column].dataset.value);
            return [value(0, 0), value(1, 0), value(1, 1), value(2, 0), value(2, 1)];
        })""",
        states,
    )
    page.close()
    dampings = ",".join(f"{state[0]!r}" for state in found)
    for (g_star, g), (u, *_) in zip(states, found):
        assert math.isclose(u, (g / g_star) ** 0.2 / 1.1534488580952888, rel_tol=1e-14)
    for column, end in enumerate(ENDS, 1):
        for quantity, place in (("epsilon", column), ("loss", column + 2)):
            exact = rows("epsilon", "--u", dampings, "--end", end, "--quantity", quantity)
            assert len(exact) == STATES
            name = "epsilon" if quantity == "epsilon" else "one_minus_epsilon"
            worst = max(abs(state[place] / float(row[name]) - 1) for state, row in zip(found, exact))
            print(f"{end}, {quantity}: largest relative difference {worst:.2e}")
            assert worst <= BOUND


def test_values_are_read_with_the_pointer(page):
    plot = page.locator("#plot")
    plot.scroll_into_view_if_needed()
    box = plot.bounding_box()
    page.mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 100)
    slow = read(page, "ε")
    page.mouse.move(box["x"] + 0.8 * box["width"], box["y"] + 100)
    fast = read(page, "ε")
    assert 0 < fast[0] < slow[0] < 1 and 0 < fast[1] < slow[1] < 1 and slow[0] < slow[1]


def test_it_works_with_the_keyboard_alone(page):
    page.keyboard.press("Tab")
    page.keyboard.press("ArrowDown")
    assert page.locator("input[value=measured]").is_checked() and page.locator("#measured-epsilon").is_visible()
    while page.evaluate("document.activeElement.id") != "measured-epsilon":
        page.keyboard.press("Tab")
    page.keyboard.press("Control+A")
    page.keyboard.type("0.6")
    page.locator("#velocity").focus()
    page.keyboard.press("Control+A")
    page.keyboard.type("1")
    assert math.isclose(read(page, "ε")[0], 0.6, rel_tol=1e-12)
    page.locator("#slider").focus()
    before = read(page, "ε")[0]
    for _ in range(50):
        page.keyboard.press("ArrowRight")
    assert read(page, "ε")[0] < before


def test_a_file_is_dropped_and_fitted(page):
    data = ROOT / "crates/cli/examples/data/ice_bridges.csv"
    transfer = page.evaluate_handle(
        """(content) => {
            const transfer = new DataTransfer();
            transfer.items.add(new File([content], "ice.csv", { type: "text/csv" }));
            return transfer;
        }""",
        data.read_text(encoding="utf-8"),
    )
    page.dispatch_event("#drop", "drop", {"dataTransfer": transfer})
    page.wait_for_selector("#fit:enabled")
    assert "28 rows" in page.inner_text("#data-note") and page.locator("circle.datum").count() > 20
    page.click("#fit")
    fitted = read(page, "g*, cm/s")[0]
    assert page.inner_text("#data-note").startswith("g* = ")
    command = rows("fit", str(data))[0]
    assert command["unit"] == "cm/s" and math.isclose(fitted, float(command["value"]), rel_tol=6e-3), "to its digits"
    page.click("#clear")
    assert page.locator("circle.datum").count() == 0


@pytest.mark.parametrize(
    "content, said",
    [
        ("a;b\n0,1;0,9\n0,2;0,8\n", "2 rows"),
        ("# comment\n0.1\t0.9\n0.2\t0.8\nx y\n", "lines that are no pair of a velocity and an ε: 1"),
        ("\ufeffg [m/s],eps\r\n0.1,0.5\r\n1,0.4\r\n", "2 rows, velocities in m/s, as it says"),
        ("v (mm s-1) eps\n0.1 0.5\n1 0.4\n", "2 rows, velocities in mm/s, as it says"),
        ("1e999,0.5\nnan,0.4\n1e-320,0.5\n-1,0.5\n1,2.5\n3,0.5\n", "1 row, velocities taken in cm/s; lines that are no pair of a velocity and an ε: 5"),
        ("<img src=x onerror=alert(1)>,b\n1,0.5\n2,0.4\n", "2 rows"),
        ("1,0.5\n2,0.4\n" * 100_000, "200000 rows"),
        ("", "no line with a velocity"),
        ("\x00\x01\x02", "no line with a velocity"),
    ],
)
def test_files_as_they_come(page, tmp_path, content, said):
    path = tmp_path / "data.txt"
    path.write_text(content, encoding="utf-8")
    page.once("pageerror", lambda error: pytest.fail(str(error)))
    page.set_input_files("#file", path)
    page.wait_for_function("document.getElementById('data-note').textContent !== ''")
    assert said in page.inner_text("#data-note")


@pytest.mark.parametrize(
    "field, wrong, said",
    [
        ("g-star", "0", "give a positive number"),
        ("g-star", "-1", "give a positive number"),
        ("g-star", "fast", "write a number"),
        ("g-star", "", "write a number"),
        ("g-star", "1,203", "write a number"),
        ("g-star", "1e400", "write a number"),
    ],
)
def test_wrong_fields_say_what_is_wanted(page, field, wrong, said):
    page.fill(f"#{field}", wrong)
    assert said in page.inner_text("#fault") and page.locator("#figure").is_hidden()
    assert page.get_attribute(f"#{field}", "aria-invalid") == "true"
    page.fill(f"#{field}", "0,5")
    assert page.inner_text("#fault") == "" and page.locator("#figure").is_visible()


def test_a_material_has_conditions_and_lines_for_codes(page):
    page.check("input[value=material]")
    page.select_option("#example", "glass")
    assert page.input_value("#young") == "63"
    assert page.locator("#validity tbody tr").count() == 3
    assert read(page, "duration of contact, s")[0] > 0
    lines = page.locator(".code pre").all_inner_texts()
    assert any("wall/gran granular hertz" in line for line in lines), "a sphere meets a plane at first"
    page.select_option("#against", "sphere")
    assert any("pair_coeff * * hertz" in line for line in page.locator(".code pre").all_inner_texts())
    page.locator(".code button").first.click()
    expect(page.locator(".code button").first).to_have_text("Copied")


def test_narrow_and_dark(browser, file):
    page = opened(browser, file, viewport={"width": 400, "height": 800}, color_scheme="dark")
    for kind in ("g-star", "measured", "material", "material-measured"):
        page.check(f"input[value={kind}]")
        assert page.evaluate("document.documentElement.scrollWidth") <= 400
    background = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert sum(map(int, re.findall(r"\d+", background)[:3])) < 150
    page.close()

"""The robot that the page draws: it looks like the stills, moves at the screen's rate, and at rest draws no frames."""

import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from tests.browser.stage_frames import FRONT_END, MOST_SCRIPT_MS
from workbook.lab.panel.reactions import MOMENTS
from workbook.pictures import humanoid
from workbook.pictures.joints import CHEER, NEUTRAL, SQUAT, STEP, WAVE, pose

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.whole]
GROUNDS = {"light": "#ffffff", "dark": "#111111"}
REST_MS = 5000
SAME, OTHER = 0.01, 0.03
"""Shares of pixels that differ.

The page's robot may differ from the still by at most the first share, because raised arms are shaded on the other side.
Two poses differ by at least the second.
"""

# Count the frames, and the script time in them.
COUNTED = """
() => {
    const asked = window.requestAnimationFrame.bind(window);
    window.frames_ms = [];
    window.requestAnimationFrame = move => asked(now => {
        const began = performance.now();
        move(now);
        window.frames_ms.push(performance.now() - began);
    });
}
"""
_SHOW = """
async ([code, figure, ground]) => {
    document.body.style = `margin: 0; background: ${ground}`;
    const url = URL.createObjectURL(new Blob([code], {type: 'text/javascript'}));
    const {Robot} = await import(url);
    window.robot = new Robot(figure);
    window.robot.node.setAttribute('width', figure.size[0]);
    window.robot.node.style.display = 'block';
    document.body.replaceChildren(window.robot.node);
}
"""
_TAKE = "news => window.robot.take(news)"
# The drawing's attributes, to the last digit. (Two screenshots of the same drawing may differ in the last bits of some
# pixels.)
_DRAWN = """
() => {
    const drawn = window.robot.node.cloneNode(true);
    drawn.querySelectorAll('[display="none"]').forEach(part => part.remove());
    return drawn.outerHTML;
}
"""
_FRAMES = "() => window.frames_ms.length"
# Twelve joints at 50 Hz, for two seconds.
_WAVE = """
neutral => new Promise(done => {
    let count = 0;
    const timer = setInterval(() => {
        count += 1;
        window.robot.take({pose: neutral.map((angle, at) => angle + 0.3 * Math.sin(count / 8 + at)), beat: 1});
        if (count === 100) {
            clearInterval(timer);
            done();
        }
    }, 20);
})
"""


def shown(page: Page, ground: str = GROUNDS["light"]) -> None:
    page.evaluate(COUNTED)
    figure = json.loads((FRONT_END / "figure.json").read_text(encoding="utf-8"))
    page.evaluate(_SHOW, [(FRONT_END / "rig.js").read_text(encoding="utf-8"), figure, ground])


def await_rest(page: Page) -> None:
    # Poll by time, because polling at each frame would itself request frames.
    page.wait_for_function("() => window.robot._frame === null", polling=20)


@pytest.fixture
def moving_page(browser: Browser) -> Iterator[Page]:
    """Open a page of the figure's size, for a reader who hasn't requested reduced motion."""
    size = {"width": humanoid.WIDTH, "height": humanoid.HEIGHT}
    context = browser.new_context(viewport=size, reduced_motion="no-preference")  # type: ignore[arg-type]
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    yield page
    context.close()
    assert not errors


def other_pixels(page: Page, still: bytes) -> float:
    """Return the share of pixels in which the page clearly differs from a still on white."""
    drawn = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    picture = Image.open(io.BytesIO(still)).convert("RGBA")
    ground = Image.new("RGBA", picture.size, "#ffffff")
    ground.alpha_composite(picture)
    wanted = np.asarray(ground.convert("RGB"), dtype=int)
    return float((np.abs(np.asarray(drawn, dtype=int) - wanted).max(axis=2) > 60).mean())


@pytest.mark.parametrize("lamp", [None, "operational", "error"])
def test_it_looks_like_the_still(moving_page: Page, lamp: humanoid.Lamp | None) -> None:
    shown(moving_page)
    wrong = humanoid.draw(pose(left_shoulder=2.0), scale=1.0)
    for angles in (NEUTRAL, WAVE, SQUAT, STEP, CHEER, pose(waist=0.4, neck=-0.5)):
        moving_page.evaluate(_TAKE, {"awake": True, "face": lamp, "pose": angles})
        await_rest(moving_page)
        assert other_pixels(moving_page, humanoid.draw(angles, lamp=lamp, scale=1.0)) < SAME
        assert other_pixels(moving_page, wrong) > OTHER


def test_asleep_it_looks_like_the_still(moving_page: Page) -> None:
    shown(moving_page)
    assert other_pixels(moving_page, humanoid.placeholder("", scale=1.0)) < SAME
    expect(moving_page.get_by_role("img", name="a humanoid robot with twelve joints, asleep")).to_be_visible()


def test_it_glides_and_then_rests(moving_page: Page, artifacts: Path) -> None:
    shown(moving_page)
    moving_page.evaluate(_WAVE, list(NEUTRAL))
    spent: list[float] = moving_page.evaluate("() => window.frames_ms")
    mean = sum(spent) / len(spent)
    assert len(spent) > 40, "frames in two seconds, also on a busy machine"
    assert mean < MOST_SCRIPT_MS
    await_rest(moving_page)
    before = moving_page.evaluate(_FRAMES)
    moving_page.wait_for_timeout(REST_MS)  # the interval that is measured
    assert moving_page.evaluate(_FRAMES) == before
    size = sum(path.stat().st_size for path in FRONT_END.iterdir())
    measured = {
        "script_ms": mean,
        "longest_ms": max(spent),
        "frames_in_2_s": len(spent),
        "front_end_bytes": size,
    }
    (artifacts / "rig.json").write_text(json.dumps(measured, indent=1))


def test_a_reader_who_wants_no_motion_gets_one_frame_for_each_message(moving_page: Page) -> None:
    moving_page.emulate_media(reduced_motion="reduce")
    shown(moving_page)
    for count, news in enumerate(
        ({"awake": True, "pose": list(CHEER)}, {"beat": 1}, {"walk": [0.5, 0]}, {"touch": 1})
    ):
        moving_page.evaluate(_TAKE, news)
        await_rest(moving_page)
        assert moving_page.evaluate(_FRAMES) == count + 1
    assert other_pixels(moving_page, humanoid.draw(CHEER, scale=1.0)) > SAME, "it is in mid-step"


EFFECTS: dict[str, dict[str, Any]] = {
    "beat": {"beat": 1},
    "battery": {"battery": 15.0},
    "error": {"face": "error"},
    "operational": {"face": "operational"},
    "tilt": {"tilt": 0.3},
    "walk": {"walk": [0.8, 0.0]},
    "touch": {"touch": 1},
    "look": {"look": 0.4},
    "alarm": {"alarm": True},
    "alert": {"alert": 1},
    "thought": {"thought": 1},
    "nod": {"nod": 1},
    "shake": {"shake": 1},
    "fall": {"tilt": 1.5},
    "nothing else": {},
}


def test_it_knows_the_effects_that_happen_once(moving_page: Page) -> None:
    shown(moving_page)
    assert sorted(moving_page.evaluate("() => window.robot.moments")) == sorted(MOMENTS)


@pytest.mark.parametrize("theme", GROUNDS)
def test_each_effect_can_be_seen(moving_page: Page, artifacts: Path, theme: str) -> None:
    looks = {}
    moving_page.clock.install()
    moving_page.clock.pause_at(2_000_000_000)
    for name, news in EFFECTS.items():
        shown(moving_page, GROUNDS[theme])
        moving_page.evaluate(_TAKE, {"awake": True})
        moving_page.clock.run_for(1000)
        moving_page.evaluate(_TAKE, news)
        moving_page.clock.run_for(200)  # in the middle of a short animation
        looks[name] = np.asarray(Image.open(io.BytesIO(moving_page.screenshot())).convert("RGB"), dtype=int)
        Image.fromarray(looks[name].astype(np.uint8)).save(artifacts / f"rig_{name}_{theme}.png")
    calm = looks.pop("nothing else")
    changed = {name: int((np.abs(look - calm).max(axis=2) > 40).sum()) for name, look in looks.items()}
    assert min(changed.values()) > 60, changed


def test_what_messages_brought_ends(moving_page: Page) -> None:
    shown(moving_page)
    moving_page.evaluate(_TAKE, {"awake": True})
    await_rest(moving_page)
    calm = moving_page.evaluate(_DRAWN)
    everything = {key: value for news in EFFECTS.values() for key, value in news.items()}
    moving_page.evaluate(_TAKE, everything)
    moving_page.evaluate(
        _TAKE, {"awake": True} | dict.fromkeys(("battery", "face", "tilt", "walk", "look", "alarm"))
    )
    await_rest(moving_page)
    moving_page.wait_for_function(
        "() => Object.values(window.robot._signs_on).every(timer => timer === null)"
    )
    await_rest(moving_page)
    assert moving_page.evaluate(_DRAWN) == calm

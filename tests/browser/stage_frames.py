"""Measure the cost of a frame: the script time of the rig alone, and of a full stage that moves or rests."""

import json

from playwright.sync_api import Page, ViewportSize

from tests.browser.student_lab import ROOT

FRONT_END = ROOT / "workbook/lab/front_end/panel"
VIEW = ViewportSize(width=660, height=900)
MOST_SCRIPT_MS = 4.0
# A stage with all that it may show: twelve joints at 50 Hz, a second robot, an image, boxes, and sparklines.
_MEASURE = """
async ([rig, stage, figure]) => {
    const load = code => import(URL.createObjectURL(new Blob([code], {type: 'text/javascript'})));
    const [{Robot}, {Stage}] = [await load(rig), await load(stage)];
    const asked = window.requestAnimationFrame.bind(window);
    let spent = 0;
    const counted = work => {
        const began = performance.now();
        work();
        spent += performance.now() - began;
    };
    window.requestAnimationFrame = move => asked(now => counted(() => move(now)));
    // For each frame of two seconds, the time (ms) that scripts took since the one before. Messages come at 50 Hz.
    const measure = act => new Promise(done => {
        const frames = [];
        let count = 0;
        const look = () => {
            frames.push(spent);
            spent = 0;
            count < 100 ? asked(look) : done(frames.slice(1));
        };
        const timer = setInterval(() => {
            count += 1;
            counted(() => act(count));
            if (count === 100) {
                clearInterval(timer);
            }
        }, 20);
        asked(look);
    });
    const moved = count => ({
        pose: figure.neutral.map((angle, at) => angle + 0.3 * Math.sin(count / 8 + at)), awake: true, beat: 1,
    });

    const robot = new Robot(figure);
    document.body.replaceChildren(robot.node);
    const alone = await measure(count => robot.take(moved(count)));
    const shown = new Stage(async () => new Robot(figure));
    document.body.replaceChildren(shown.node);
    window.stage = shown;
    await shown.bring();
    const src = document.createElement('canvas').toDataURL('image/jpeg');
    const seen = count => {
        if (count % 8 === 0) {
            const boxes = [['ball', count, 60, 20, 20, 1], ['cup', 90, 40, 12, 20, 1]];
            shown.take({kind: 'robot', image: {src, width: 160, height: 120}, boxes, words: String(count)});
        }
        if (count % 12 === 0) {
            const numbers = Array.from({length: 60}, (_, at) => Math.sin(count + at));
            const topic = {numbers, value: 'x', reacts: false};
            shown.take({kind: 'news', topics: {'/mood': topic, '/wind': topic, '/heat': topic, '/noise': topic}});
        }
    };
    const moving = await measure(count => {
        const news = moved(count);
        shown.take({kind: 'robot', ...news, raw: news.pose});
        seen(count);
    });
    while (Object.values(shown._robots).some(one => one._frame !== null)) {
        await new Promise(asked);
    }
    const resting = await measure(seen);
    return {'the rig alone': alone, 'a full stage that moves': moving, 'a full stage whose robots rest': resting};
}
"""


def script_ms(page: Page) -> dict[str, list[float]]:
    """Return the script time (ms) of each frame within two seconds, by page content.

    The stage remains as `window.stage`.
    """
    rig, stage, figure = (
        (FRONT_END / name).read_text(encoding="utf-8") for name in ("rig.js", "stage.js", "figure.json")
    )
    page.add_style_tag(path=FRONT_END / "panel.css")
    measured: dict[str, list[float]] = page.evaluate(_MEASURE, [rig, stage, json.loads(figure)])
    return measured

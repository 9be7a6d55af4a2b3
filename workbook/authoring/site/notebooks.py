"""Convert notebooks to pages: images become files, predictions become clickable, and recorded robots move.

The pages don't run code, but show the outputs that are committed with the notebook.
"""

import base64
import hashlib
import io
import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from html import unescape
from pathlib import Path
from typing import Any

from PIL import Image

from workbook.authoring.site.errors import cell_target
from workbook.authoring.site.links import Links
from workbook.authoring.site.recordings import SiteRobot, site_robots
from workbook.lesson.prediction import Prediction
from workbook.lesson.prediction_views import pieces
from workbook.templating import render

Cell = dict[str, Any]
Output = dict[str, Any]
ROOT = "../"
"""Relative path from a notebook's page to the site's root."""
WAYS = (("clone", "clone-and-make-lab"), ("container", "container"), ("wheel", "wheel"))
_PICTURE = re.compile(
    r'(?:<picture>.*?)?<img alt="(?P<alt>[^"]*)" width="(?P<width>\d+)" height="(?P<height>\d+)" '
    r'src="data:image/(?P<kind>\w+);base64,(?P<data>[^"]*)"[^>]*>(?:\s*</picture>)?',
    re.DOTALL,
)
_PREDICT = re.compile(r"^predict\(\s*\"([\w-]+)\"", re.MULTILINE)
_REVEAL = re.compile(r"\breveal\(\s*\"([\w-]+)\"")
_OUTCOME = "border-left:6px solid"
_HAPPENED = re.compile(r"<b>✓ (\w)</b>")
_WIDGET = "application/vnd.jupyter.widget-view+json"
_READ = "This page shows a recorded run."
_TASK = "You can read the task here. To use the judge, the hints, and the robot, run the course."


@dataclass
class Pictures:
    """Writes images to a folder, each only once. The file's name is the hash of its bytes."""

    folder: Path
    url: str
    sizes: dict[str, int] = field(default_factory=dict)

    def put(self, content: bytes, suffix: str) -> str:
        """Write an image and return its URL."""
        name = f"{hashlib.sha256(content).hexdigest()[:16]}.{suffix}"
        if name not in self.sizes:
            self.folder.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_bytes(content)
            self.sizes[name] = len(content)
        return f"{self.url}/{name}"


@dataclass(frozen=True)
class NotebookPage:
    """Converts a notebook to the source of a page. `cells` are the IDs of the cells that other pages link to."""

    stem: str
    links: Links
    pictures: Pictures
    predictions: Mapping[str, Prediction]
    cells: frozenset[str] = frozenset()

    def convert(self, path: Path) -> str:
        """Return the converted notebook as JSON."""
        notebook = json.loads(path.read_text(encoding="utf-8"))
        first, *others = notebook["cells"]
        is_lesson = path.parent.name == "notebooks"
        bar = render("authoring/site_bar", words=_READ if is_lesson else _TASK, root=ROOT, ways=WAYS)
        made = [*self._cell(first), _markdown("wb-run", bar)]
        made += [
            _markdown("wb-robot", robot_figure(robot))
            for robot in self._robots()
            if is_lesson and not robot.cell
        ]
        for cell in others:
            made += self._cell(cell)
        return json.dumps({**notebook, "cells": made})

    def _robots(self) -> Iterator[SiteRobot]:
        return (robot for robot in site_robots() if robot.lesson == self.stem)

    def _cell(self, cell: Cell) -> Iterator[Cell]:
        source = _joined(cell["source"])
        if cell["cell_type"] != "code":
            yield {**cell, "source": self.links.in_page(source)}
            return
        if cell["id"] in self.cells:
            yield _markdown(f"{cell['id']}-target", f"({cell_target(self.stem, cell['id'])})=")
        asked = [name for name in _PREDICT.findall(source) if name in self.predictions]
        shown = [name for name in _REVEAL.findall(source) if name in self.predictions]
        robot = next((one for one in self._robots() if one.cell == cell["id"]), None)
        outputs = list(self._outputs(cell, shown, robot))
        if asked:
            outputs = [_html(self._question(name)) for name in asked]
        yield {**cell, "execution_count": None, "outputs": outputs}

    def _outputs(self, cell: Cell, shown: list[str], robot: SiteRobot | None) -> Iterator[Output]:
        outcomes = iter(shown)
        for output in cell["outputs"]:
            data = output.get("data", {})
            html = _joined(data.get("text/html", ""))
            if _WIDGET in data:
                if robot is None or not robot.slider:
                    yield _html(render("authoring/site_note", words=_joined(data["text/plain"]), root=ROOT))
            elif html.startswith("<div") and _OUTCOME in html and (name := next(outcomes, None)):
                yield _html(self._outcome(name, html))
            elif (robot is not None and "a humanoid robot" in html[:200]) or (
                robot and "a robot moves" in html[:200]
            ):
                yield _html(robot_figure(robot))
                robot = None
            elif html:
                yield _html(_PICTURE.sub(self._picture, html))
            else:
                yield output

    def _question(self, name: str) -> str:
        prediction = self.predictions[name]
        target = render("authoring/site_target", id=f"predict-{name}")
        options = [(one.letter, pieces(one.text)) for one in prediction.options]
        return target + render(
            "authoring/site_predict", name=name, options=options, letters=prediction.letters
        )

    def _outcome(self, name: str, html: str) -> str:
        happened = _HAPPENED.search(html)
        told = {"happened": happened[1] if happened else self.predictions[name].usual, "html": html}
        sealed = base64.b64encode(json.dumps(told).encode()).decode()
        return render(
            "authoring/site_outcome", name=name, sealed=sealed, letters=self.predictions[name].letters
        )

    def _picture(self, found: re.Match[str]) -> str:
        content = base64.b64decode(found["data"])
        still = _last_frame(content)
        return render(
            "authoring/site_image",
            alt=unescape(found["alt"]),
            width=found["width"],
            height=found["height"],
            src=self.pictures.put(content, found["kind"]),
            still=self.pictures.put(still, "png") if still else "",
        )


def robot_figure(robot: SiteRobot, root: str = ROOT) -> str:
    """Return the HTML element in which the page draws a robot. `root` is the path from that page to the site's root."""
    at = robot.values.index(robot.value) if robot.values else 0
    return render(
        "authoring/site_robot",
        root=root,
        recordings=" ".join(robot.names),
        ease=robot.ease,
        alt="a humanoid robot with twelve joints",
        slider=robot.slider,
        values=[f"{value:g}" for value in robot.values],
        at=at,
        about=pieces(robot.about or "A recording of this cell's program, played back without running it."),
    )


def _last_frame(content: bytes) -> bytes:
    """Return the last frame of an animated image as PNG bytes, or empty bytes for a still image."""
    with Image.open(io.BytesIO(content)) as image:
        frames = getattr(image, "n_frames", 1)
        if frames == 1:
            return b""
        image.seek(frames - 1)
        file = io.BytesIO()
        image.convert("RGBA").save(file, "PNG", optimize=True)
        return file.getvalue()


def _markdown(name: str, html: str) -> Cell:
    return {"cell_type": "markdown", "id": name[:64], "metadata": {}, "source": html}


def _html(html: str) -> Output:
    return {"output_type": "display_data", "metadata": {}, "data": {"text/html": html}}


def _joined(text: Any) -> str:
    return "".join(text) if isinstance(text, list) else str(text)

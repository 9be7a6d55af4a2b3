"""Describe the figure as data for a page that animates it: shapes, the joints that turn them, and poses.

The shapes are recorded while `humanoid` draws the robot with all joints at zero, so the stills and the moving figure
can't differ. `front_end/panel/rig.js` turns the parts. `python -m workbook.authoring build` writes the file with this
data.
"""

import json
import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from workbook.pictures import humanoid
from workbook.pictures.canvas import GREY_LINE, PLAIN_TEXT, Align, Canvas, Font, Paint
from workbook.pictures.joints import (
    FLINCH,
    FOREARM,
    JOINT_NAMES,
    NEUTRAL,
    SWAY,
    UPPER_ARM,
    Point,
    Skeleton,
    pose,
    skeleton,
    touching,
    walking,
)
from workbook.pictures.palette import AMBER, BLUE, GREEN, GREY, RED, TEXT

Shape = dict[str, Any]
FACES: dict[str, tuple[humanoid.Lamp | None, bool]] = {
    "awake": (None, False),
    "operational": ("operational", False),
    "error": ("error", False),
    "asleep": (None, True),
}
"""The robot's faces, each with its lamp and whether the robot is asleep."""
WALK_POSES, WALK_S = 16, 2.0
"""The number of poses in two steps, and the duration (s) of the two steps."""
GAUGE = (46.0, 12.0)
"""The width and height of the battery on the chest."""
_DIGITS = 2


class ShapeRecorder(Canvas):
    """A canvas that records its shapes as SVG elements."""

    def __init__(self) -> None:
        self.shapes: list[Shape] = []

    def path(self, path: Path, paint: Paint, *, at: Affine2D | None = None) -> None:
        """Draw any path of straight lines and curves."""
        placed = path if at is None else at.transform_path(path)
        words = []
        for points, code in placed.iter_segments(simplify=False, curves=True):
            letter = {Path.MOVETO: "M", Path.LINETO: "L", Path.CURVE3: "Q", Path.CURVE4: "C"}.get(code)
            words.append(f"{letter}{_numbers(points)}" if letter else "Z")
        self._keep("path", paint, d="".join(words))

    def line(self, points: Iterable[Point], paint: Paint = GREY_LINE) -> None:
        """Draw an open line."""
        self._keep("polyline", paint, points=_numbers(np.ravel(list(points))))

    def disc(self, center: Point, radius: float, paint: Paint, *, flat: float = 1.0) -> None:
        """Draw a disc, or an ellipse."""
        self._keep("ellipse", paint, cx=center[0], cy=center[1], rx=radius, ry=radius * flat)

    def box(
        self, corner: Point, size: Point, paint: Paint, *, radius: float = 0.0, at: Affine2D | None = None
    ) -> None:
        """Draw an unrotated box."""
        x, y = corner if at is None else at.transform(corner)
        self._keep(
            "rect", paint, x=x, y=y, width=size[0], height=size[1], rx=min(radius, *np.divide(size, 2))
        )

    def capsule(self, start: Point, end: Point, start_radius: float, end_radius: float, paint: Paint) -> None:
        """Draw two round ends and the straight sides between them."""
        along = math.atan2(end[1] - start[1], end[0] - start[0])
        lean = math.acos((start_radius - end_radius) / math.dist(start, end))

        def on(center: Point, radius: float, angle: float) -> str:
            return _numbers((center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)))

        words = [f"M{on(end, end_radius, along - lean)}"]
        for center, radius, angle, half in (
            (end, end_radius, along + lean, lean),
            (start, start_radius, along - lean, math.pi - lean),
        ):
            far = int(half > math.pi / 2)
            words.append(f"A{_numbers((radius, radius))} 0 {far} 1 {on(center, radius, angle)}")
            words.append(f"L{on(start, start_radius, along + lean)}" if center is end else "Z")
        self._keep("path", paint, d="".join(words))

    def text(self, at: Point, words: str, font: Font = PLAIN_TEXT, *, align: Align = "left") -> None:
        """Draw one line of text."""
        anchor = {"left": "start", "center": "middle", "right": "end"}[align]
        weight = "bold" if font.bold else "normal"
        self.shapes.append(
            {"tag": "text", "x": at[0], "y": at[1], "fill": font.color or TEXT, "text": words}
            | {"font-size": font.size, "font-weight": weight, "text-anchor": anchor}
        )

    def _keep(self, tag: str, paint: Paint, **geometry: Any) -> None:
        numbers = {
            name: value if isinstance(value, str) else _number(value) for name, value in geometry.items()
        }
        line = {"stroke": paint.stroke, "stroke-width": paint.width} if paint.stroke else {}
        see_through = {"opacity": paint.alpha} if paint.alpha < 1 else {}
        self.shapes.append({"tag": tag, **numbers, "fill": paint.fill or "none", **line, **see_through})


def _number(value: float) -> float:
    rounded = round(float(value), _DIGITS)
    return int(rounded) if rounded == int(rounded) else rounded


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{_number(value):g}" for value in values)


def _recorded(draw: Callable[[Canvas], None]) -> list[Shape]:
    canvas = ShapeRecorder()
    draw(canvas)
    return canvas.shapes


def _turns(figure: Skeleton) -> dict[str, list[float]]:
    """Return, for each joint, the numbers that describe the rotation of the parts beyond it.

    They are the joint's index in a message, the angle for 1 rad, and the center of rotation (x, y in px).
    """
    points: dict[str, tuple[str, float, Point]] = {
        "neck": ("neck", 1.0, figure.neck),
        "waist": ("waist", 1.0, figure.waist),
        humanoid.NECK_BENDS: ("neck", _neck_share(figure), figure.on_torso(0.0, humanoid.STEM_FROM)),
    }
    for limb, names in (
        *((arm, ("shoulder", "elbow", "")) for arm in figure.arms),
        *((leg, ("hip", "knee", "ankle")) for leg in figure.legs),
    ):
        for name, point in zip(names, (limb.root, limb.bend, limb.end), strict=True):
            # Outward is a different direction on each side, and a knee turns the other way.
            sign = limb.side if name == "knee" else -limb.side
            points[f"{limb.word}_{name}"] = (f"{limb.word}_{name}", sign, point)
    return {
        name: [JOINT_NAMES.index(joint), round(factor, 3), *map(_number, humanoid.on_picture(point))]
        for name, (joint, factor, point) in points.items()
        if joint in JOINT_NAMES
    }


def _neck_share(figure: Skeleton) -> float:
    """Return the fraction of the head's angle by which the neck's lower end turns."""
    upper = humanoid.STEM_TO
    return upper / (upper + math.dist(figure.neck, figure.on_torso(0.0, humanoid.STEM_FROM)))


def _parts(figure: Skeleton) -> list[dict[str, Any]]:
    """Return the parts in drawing order. A part that isn't drawn with every face lists its faces."""
    by_face = {
        face: list(humanoid.parts(figure, lamp, asleep=asleep)) for face, (lamp, asleep) in FACES.items()
    }
    found = []
    for same in zip(*by_face.values(), strict=True):
        drawn = [_recorded(part.draw) for part in same]
        for at, (part, shapes) in enumerate(zip(same, drawn, strict=True)):
            if drawn.index(shapes) < at:
                continue
            faces = [face for face, other in zip(FACES, drawn, strict=True) if other == shapes]
            entry: dict[str, Any] = {"joints": part.joints, "shapes": shapes}
            entry |= {"glance": part.glance} if any(part.glance) else {}
            entry |= {"faces": faces} if len(faces) < len(FACES) else {}
            found.append(entry)
        if same[0].name == "lamp":
            found += _signs_on_the_chest(figure)
    snores = {"joints": (), "faces": ["asleep"], "shapes": _recorded(humanoid.snores)}
    signs = ({"joints": (), "sign": sign, "shapes": _recorded(draw)} for sign, draw in _SIGNS.items())
    return [*found, snores, *signs]


def _signs_on_the_chest(figure: Skeleton) -> list[dict[str, Any]]:
    """Return the signs that are shown only after a message: the heartbeat's ring, and the battery with its level."""
    wide, high = GAUGE
    x, y = humanoid.on_picture(figure.on_torso(-wide / 2, 38))

    def ring(canvas: Canvas) -> None:
        canvas.disc(humanoid.on_picture(figure.on_torso(0, 61)), 21, Paint(stroke=BLUE, width=4))

    def case(canvas: Canvas) -> None:
        canvas.box((x + wide, y + 3), (4, high - 6), Paint(fill="#4c5a69"), radius=1)
        canvas.box((x, y), GAUGE, Paint(fill="#1b2733", stroke="#4c5a69", width=2), radius=4)

    def level(canvas: Canvas) -> None:
        canvas.box((x + 2, y + 2), (wide - 4, high - 4), Paint(fill=GREEN), radius=2)

    return [
        {"joints": ("waist",), "sign": sign, "shapes": _recorded(draw)}
        for sign, draw in (("heart", ring), ("battery", case), ("level", level))
    ]


def _alarm(canvas: Canvas) -> None:
    for x in (96.0, humanoid.WIDTH - 96.0):
        canvas.polygon([(x, 22), (x + 27, 68), (x - 27, 68)], Paint(fill=RED, stroke="#ffffff", width=2.5))
        canvas.line([(x, 38), (x, 51)], Paint(stroke="#ffffff", width=5))
        canvas.disc((x, 60), 3, Paint(fill="#ffffff"))


def _thought(canvas: Canvas) -> None:
    cloud = Paint(fill="#eef2f7", stroke=GREY, width=2.5)
    for center, radius in (((292, 92), 5), ((308, 74), 8)):
        canvas.disc(center, radius, cloud)
    canvas.disc((352, 46), 42, cloud, flat=0.62)
    for x in (334, 352, 370):
        canvas.disc((x, 46), 4.5, Paint(fill=BLUE))


_SIGNS: dict[str, Callable[[Canvas], None]] = {"alarm": _alarm, "thought": _thought}


def description() -> str:
    """Return the figure as JSON. A part's matrix is the product of its joints' turns, from the body outward."""
    figure = skeleton(pose())
    steps = [walking(WALK_S * step / WALK_POSES) for step in range(WALK_POSES)]
    whole = {
        "size": [humanoid.WIDTH, humanoid.HEIGHT],
        "ground": humanoid.GROUND,
        "sway": SWAY,
        "neutral": NEUTRAL,
        "flinch": FLINCH,
        "walk": {"seconds": WALK_S, "poses": [[round(angle, 3) for angle in step] for step in steps]},
        "glance": {"most": humanoid.GLANCE, "reach": humanoid.GLANCE_REACH, "arm": [UPPER_ARM, FOREARM]},
        "charge": [[50, GREEN], [20, AMBER], [0, RED]],
        "turns": _turns(figure),
        "touching": [
            {"joints": joints, "at": [_number(part) for part in humanoid.on_picture(point)], "reach": reach}
            for joints, point, reach in touching(figure)
        ],
    }
    lines = [f" {json.dumps(name)}: {json.dumps(value)}" for name, value in whole.items()]
    parts = ",\n".join(f"  {json.dumps(part)}" for part in _parts(figure))
    return "{\n" + ",\n".join(lines) + f',\n "parts": [\n{parts}\n ]\n}}\n'

"""Draw the humanoid: a robot with twelve joints, posed by twelve angles."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Literal, NamedTuple

from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from workbook.pictures.canvas import Canvas, Font, Paint, shorten
from workbook.pictures.joint_table import TABLE_WIDTH, joint_table
from workbook.pictures.joints import (
    FOOT_INNER,
    FOOT_OUTER,
    HAND,
    NECK,
    NEUTRAL,
    SOLE,
    Limb,
    Point,
    Skeleton,
    checked,
    foot,
    skeleton,
)
from workbook.pictures.palette import BLUE, GREEN, GREY, RED

Lamp = Literal["operational", "error"]

WIDTH, HEIGHT, PANEL = 420, 420, TABLE_WIDTH
SCALE = 1.5
"""Dots per page pixel: sharp enough, and fast enough for twenty frames per second."""
DESCRIPTION = "humanoid, 12 joints"

GROUND = 388.0
"""The ground's distance from the image's upper edge (px)."""
GLANCE, GLANCE_REACH = (4.0, 2.0), 60.0
"""The eyes' largest shift, sideways and up, and the height of a hand above its shoulder that causes three quarters of
that shift.
"""
STEM_FROM, STEM_TO = 82.0, 22.0
NECK_BENDS = "neck bends"
"""The name of the bend between the chest and the head, where the neck turns by part of the head's angle."""
_SHELL, _SHADE, _DARK, _VISOR = "#eef2f7", "#cdd7e3", "#4c5a69", "#1b2733"
_EYES, _ANGRY, _DIM = "#7fd0ff", "#ffb3a1", "#9aa7b5"
_LINE = 2.2
_OUTLINE = Paint(stroke=GREY, width=_LINE)
_DARK_PART = Paint(fill=_DARK, stroke=GREY, width=_LINE)
_SHELL_PART = Paint(fill=_SHELL, stroke=GREY, width=_LINE)


def draw(
    angles: Iterable[float],
    *,
    lamp: Lamp | None = None,
    caption: str = "",
    panel: bool = False,
    scale: float = SCALE,
) -> bytes:
    """Draw the humanoid at twelve joint angles (rad, in the order of JOINT_NAMES), and return PNG bytes.

    `lamp`: the state of the lamp on its chest, or None for off. `caption`: a line under its feet. `panel`: add a table
    of the twelve values. `scale`: dots per pixel; more is sharper on a high-resolution screen, but slower. Raises
    ValueError, with a message for the angles' sender, unless there are twelve finite angles.
    """
    pose = checked(angles)
    canvas = Canvas(WIDTH + (PANEL if panel else 0), HEIGHT, scale)
    figure = skeleton(pose)
    _ground(canvas, figure)
    _robot(canvas, figure, lamp)
    if caption:
        canvas.text((WIDTH / 2, HEIGHT - 8), shorten(caption, WIDTH - 20, 13), Font(size=13), align="center")
    if panel:
        joint_table(canvas, pose, WIDTH)
    return canvas.png()


def placeholder(text: str = "no message yet", *, panel: bool = False, scale: float = SCALE) -> bytes:
    """Draw the sleeping robot with a line of text, to show before the first message arrives. Return PNG bytes."""
    canvas = Canvas(WIDTH + (PANEL if panel else 0), HEIGHT, scale)
    figure = skeleton(NEUTRAL)
    _ground(canvas, figure)
    _robot(canvas, figure, None, asleep=True)
    snores(canvas)
    canvas.text((WIDTH / 2, HEIGHT - 8), shorten(text, WIDTH - 20, 13), Font(size=13), align="center")
    if panel:
        joint_table(canvas, None, WIDTH)
    return canvas.png()


def snores(canvas: Canvas) -> None:
    """Draw the three letters z above a sleeping robot."""
    for at, size in (((282, 92), 15.0), ((299, 72), 19.0), ((320, 48), 24.0)):
        canvas.text(at, "z", Font(size=size, bold=True))


def on_picture(point: Point) -> Point:
    """Convert a skeleton point to its position (px) in the image."""
    return (WIDTH / 2 + point[0], GROUND - point[1])


def _ground(canvas: Canvas, figure: Skeleton) -> None:
    xs = [leg.end[0] for leg in figure.legs]
    height = min(foot(leg, x, -SOLE)[1] for leg in figure.legs for x in (-FOOT_INNER, FOOT_OUTER))
    reach = (max(xs) - min(xs)) / 2 + 44
    fade = max(0.35, 1 - max(0.0, height) / 200)
    middle = WIDTH / 2 + (max(xs) + min(xs)) / 2
    canvas.disc((middle, GROUND + 3), reach * fade, Paint(fill=GREY, alpha=0.28 * fade), flat=0.1)
    canvas.line([(26, GROUND), (WIDTH - 26, GROUND)], Paint(width=2))


def _robot(canvas: Canvas, figure: Skeleton, lamp: Lamp | None, *, asleep: bool = False) -> None:
    for part in parts(figure, lamp, asleep=asleep):
        part.draw(canvas)


class Part(NamedTuple):
    """A rigid part of the figure: a function that draws it, and the joints that turn it, from the body outward.

    When the eyes shift, the part moves by a fraction of that shift. `glance` is this fraction in x and in y, from 0 to
    1.
    """

    name: str
    joints: tuple[str, ...]
    draw: Callable[[Canvas], None]
    glance: Point = (0.0, 0.0)


def parts(figure: Skeleton, lamp: Lamp | None, *, asleep: bool = False) -> Iterator[Part]:
    """Yield the figure's parts in drawing order, each on top of the previous ones."""
    chest, head = ("waist",), ("waist", "neck")
    for leg in figure.legs:
        hip, knee, ankle = (f"{leg.word}_{joint}" for joint in ("hip", "knee", "ankle"))
        yield Part("shin", (hip, knee), partial(_shin, leg=leg))
        yield Part("foot", (hip, knee, ankle), partial(_foot, leg=leg))
        yield Part("thigh", (hip,), partial(_thigh, leg=leg))
    yield Part("waist", chest, partial(_waist, figure=figure))
    yield Part("hips", (), partial(_hips, figure=figure))
    yield Part("neck", ("waist", NECK_BENDS), partial(_neck, figure=figure))
    yield Part("chest", chest, partial(_chest, figure=figure))
    yield Part("lamp", chest, partial(_chest_lamp, figure=figure, lamp=lamp))
    yield Part("antenna", head, partial(_antenna, figure=figure, lamp=lamp))
    yield Part("head", head, partial(_head, figure=figure))
    eyes, mouth = (_closed_eyes, _closed_mouth) if asleep else (_eyes, _mouth)
    yield Part("eyes", head, partial(eyes, figure=figure, lamp=lamp), (0.0, 0.0) if asleep else (1.0, 1.0))
    smiles = not asleep and lamp != "error"
    yield Part("mouth", head, partial(mouth, figure=figure, lamp=lamp), (0.5 if smiles else 0.0, 0.0))
    for arm in figure.arms:
        shoulder, elbow = f"{arm.word}_shoulder", f"{arm.word}_elbow"
        yield Part("upper arm", ("waist", shoulder), partial(_upper_arm, arm=arm))
        yield Part("forearm", ("waist", shoulder, elbow), partial(_forearm, arm=arm))
        yield Part("shoulder", chest, partial(_shoulder, arm=arm))


def _segment(canvas: Canvas, start: Point, end: Point, thick: float, thin: float) -> None:
    """Draw a segment of a limb: the shell, a shaded edge on its outer side, and the outline."""
    a, b = on_picture(start), on_picture(end)
    canvas.capsule(a, b, thick, thin, Paint(fill=_SHADE))
    length = math.hypot(b[0] - a[0], b[1] - a[1]) or 1.0
    across = (-(b[1] - a[1]) / length, (b[0] - a[0]) / length)
    sign = 1.0 if across[0] + across[1] < 0 else -1.0
    shift = (sign * across[0] * 2.6, sign * across[1] * 2.6)
    canvas.capsule(
        (a[0] + shift[0], a[1] + shift[1]),
        (b[0] + shift[0], b[1] + shift[1]),
        thick - 2.8,
        thin - 2.8,
        Paint(fill=_SHELL),
    )
    canvas.capsule(a, b, thick, thin, _OUTLINE)


def _pivot(canvas: Canvas, at: Point, radius: float) -> None:
    canvas.disc(on_picture(at), radius, _DARK_PART)
    canvas.disc(on_picture(at), radius * 0.4, Paint(fill=_DIM))


def _shin(canvas: Canvas, leg: Limb) -> None:
    _segment(canvas, leg.bend, leg.end, 13.5, 11.0)


def _foot(canvas: Canvas, leg: Limb) -> None:
    inner, outer = FOOT_INNER, FOOT_OUTER
    shoe = [(-inner, -SOLE + 3), (-inner + 3, -3), (-10, 8), (10, 8), (outer - 6, -3), (outer, -SOLE + 3)]
    _soft(canvas, [on_picture(foot(leg, x, y)) for x, y in shoe], _SHELL_PART)
    a, b = on_picture(foot(leg, -inner + 3, -SOLE + 4)), on_picture(foot(leg, outer - 3, -SOLE + 4))
    canvas.capsule(a, b, 4.2, 4.2, _DARK_PART)


def _thigh(canvas: Canvas, leg: Limb) -> None:
    _segment(canvas, leg.root, leg.bend, 16.5, 13.5)
    _pivot(canvas, leg.bend, 9.5)


def _upper_arm(canvas: Canvas, arm: Limb) -> None:
    _segment(canvas, arm.root, arm.bend, 13.0, 11.0)


def _forearm(canvas: Canvas, arm: Limb) -> None:
    _hand(canvas, arm)
    _segment(canvas, arm.bend, arm.end, 11.0, 12.5)
    for part in (0.62, 0.78):  # two blue rings around the wrist
        middle = _along(arm.bend, arm.end, part)
        half = 10.6 + 1.4 * part
        across = (math.cos(arm.lower) * half, math.sin(arm.lower) * half)
        ends = [(middle[0] + sign * arm.side * across[0], middle[1] + sign * across[1]) for sign in (-1, 1)]
        canvas.line([on_picture(end) for end in ends], Paint(stroke=BLUE, width=3.4))
    _pivot(canvas, arm.bend, 8.5)


def _shoulder(canvas: Canvas, arm: Limb) -> None:
    x, y = on_picture(arm.root)
    canvas.disc((x, y), 17.5, _SHELL_PART)
    canvas.disc((x, y), 9.0, Paint(fill=_DARK))
    letter = Font(size=11.5, color="#ffffff", bold=True)
    canvas.text((x, y + 4.2), arm.word[0].upper(), letter, align="center")


def _hand(canvas: Canvas, arm: Limb) -> None:
    palm = _along(arm.bend, arm.end, 1.0 + HAND * 0.55 / math.dist(arm.bend, arm.end))

    def reach(angle: float, length: float) -> Point:
        angle += arm.tip
        return (palm[0] + arm.side * length * math.sin(angle), palm[1] - length * math.cos(angle))

    for spread, length in ((-1.25, 13.5), (-0.42, 18.0), (0.05, 19.0), (0.5, 17.5)):
        canvas.capsule(on_picture(palm), on_picture(reach(spread, length)), 5.2, 4.2, _DARK_PART)
    canvas.disc(on_picture(palm), HAND * 0.68, Paint(fill=_DARK))


def _waist(canvas: Canvas, figure: Skeleton) -> None:
    x, y = on_picture(figure.pelvis)
    canvas.capsule((x, y - 12), on_picture(figure.on_torso(0, 12)), 17, 20, _DARK_PART)


def _hips(canvas: Canvas, figure: Skeleton) -> None:
    x, y = on_picture(figure.pelvis)
    canvas.box((x - 37, y - 12), (74, 27), Paint(fill=_SHADE), radius=13)
    canvas.box((x - 34, y - 10), (68, 19), Paint(fill=_SHELL), radius=10)
    canvas.box((x - 37, y - 12), (74, 27), _OUTLINE, radius=13)
    canvas.box((x - 12, y - 6), (24, 13), Paint(fill=BLUE), radius=5)


def _neck(canvas: Canvas, figure: Skeleton) -> None:
    canvas.capsule(
        on_picture(figure.on_torso(0, STEM_FROM)), on_picture(figure.on_head(0, STEM_TO)), 12, 12, _DARK_PART
    )


def _on_chest(figure: Skeleton, points: Iterable[Point]) -> list[Point]:
    return [on_picture(figure.on_torso(x, y)) for x, y in points]


def _chest(canvas: Canvas, figure: Skeleton) -> None:
    place = partial(_on_chest, figure)
    shell = [(-27, 14), (27, 14), (51, 60), (49, 92), (-49, 92), (-51, 60)]
    inner = [(-26, 19), (23, 19), (44, 60), (43, 88), (-46, 88), (-48, 60)]
    _soft(canvas, place(shell), Paint(fill=_SHADE), round_off=0.32)
    _soft(canvas, place(inner), Paint(fill=_SHELL), round_off=0.32)
    _soft(canvas, place(shell), _OUTLINE, round_off=0.32)
    for y, half in ((33, 15), (27, 12)):
        canvas.line(place([(-half, y), (half, y)]), Paint(stroke=_DIM, width=2.4))


def _chest_lamp(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    place = partial(_on_chest, figure)
    center = on_picture(figure.on_torso(0, 61))
    color = {"operational": GREEN, "error": RED, None: _DIM}[lamp]
    if lamp:
        canvas.disc(center, 24, Paint(fill=color, alpha=0.22))
    canvas.disc(center, 17.5, Paint(fill=_VISOR, stroke=GREY, width=_LINE))
    canvas.disc(center, 13.5, Paint(fill=color))
    if lamp == "operational":
        canvas.line(place([(-6, 61), (-1.8, 56.5), (6.5, 66)]), Paint(stroke="#ffffff", width=3.6))
    elif lamp == "error":
        canvas.line(place([(0, 68.5), (0, 60)]), Paint(stroke="#ffffff", width=3.6))
        canvas.disc(on_picture(figure.on_torso(0, 54)), 2.3, Paint(fill="#ffffff"))


def _antenna(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    color = {"operational": GREEN, "error": RED, None: BLUE}[lamp]
    tip, root = on_picture(figure.on_head(0, NECK + 98)), on_picture(figure.on_head(0, NECK + 74))
    canvas.line([root, tip], Paint(stroke=GREY, width=3.4))
    if lamp:
        canvas.disc(tip, 10, Paint(fill=color, alpha=0.22))
    canvas.disc(tip, 6.2, Paint(fill=color, stroke=GREY, width=1.6))


def _head(canvas: Canvas, figure: Skeleton) -> None:
    turn = _frame(figure.neck, figure.lean + figure.tilt)
    for side in (-1, 1):
        canvas.box(
            (side * 54 - 8, -NECK - 54),
            (16, 34),
            Paint(fill=BLUE, stroke=GREY, width=_LINE),
            radius=7,
            at=turn,
        )
    canvas.box((-52, -NECK - 78), (104, 78), Paint(fill=_SHADE), radius=28, at=turn)
    canvas.box((-49, -NECK - 76), (95, 70), Paint(fill=_SHELL), radius=26, at=turn)
    canvas.box((-52, -NECK - 78), (104, 78), _OUTLINE, radius=28, at=turn)
    canvas.box((-41, -NECK - 63), (82, 50), Paint(fill=_VISOR, stroke=_DARK, width=1.6), radius=20, at=turn)


def _on_face(figure: Skeleton, points: Iterable[Point]) -> list[Point]:
    return [on_picture(figure.on_head(x, y + NECK)) for x, y in points]


def _glance(figure: Skeleton) -> Point:
    """Return the eyes' shift, sideways and up: the robot looks at its higher hand."""
    left, right = (arm.end[1] - arm.root[1] for arm in figure.arms)
    aside = GLANCE[0] * math.tanh((left - right) / GLANCE_REACH)
    return aside, GLANCE[1] * max(0.0, math.tanh(max(left, right) / GLANCE_REACH))


def _glow(lamp: Lamp | None) -> str:
    return _ANGRY if lamp == "error" else _EYES


def _eyes(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    place, glow = partial(_on_face, figure), _glow(lamp)
    aside, up = _glance(figure)
    for side in (-1, 1):
        x, y = side * 18 + aside, 42 + up
        canvas.disc(place([(x, y)])[0], 10.5, Paint(fill=glow, alpha=0.22))
        canvas.disc(place([(x, y)])[0], 7.4, Paint(fill=glow))
        canvas.disc(place([(x + 2.4, y + 2.6)])[0], 2.3, Paint(fill="#ffffff"))
        if lamp == "error":
            canvas.line(
                place([(x - side * 9, y + 11.5), (x + side * 7, y + 6)][::-1]), Paint(stroke=glow, width=3)
            )


def _mouth(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    bow = _bow(0, 22.5, 9, 4) if lamp == "error" else _bow(_glance(figure)[0] * 0.5, 27, 10, -5)
    canvas.line(_on_face(figure, bow), Paint(stroke=_glow(lamp), width=3))


def _closed_eyes(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    for x, y in ((-18.0, 42.0), (18.0, 42.0)):
        lid = [(x - 8, y), (x - 4, y - 3), (x, y - 4), (x + 4, y - 3), (x + 8, y)]
        canvas.line(_on_face(figure, lid), Paint(stroke=_DIM, width=3))


def _closed_mouth(canvas: Canvas, figure: Skeleton, lamp: Lamp | None) -> None:
    canvas.line(_on_face(figure, [(-5, 25), (5, 25)]), Paint(stroke=_DIM, width=3))


def _along(start: Point, end: Point, part: float) -> Point:
    return (start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part)


def _bow(x: float, y: float, half: float, height: float) -> list[Point]:
    steps = [index / 4 - 1 for index in range(9)]
    return [(x + half * step, y + height * (1 - step * step)) for step in steps]


def _frame(origin: Point, lean: float) -> Affine2D:
    return Affine2D().rotate(lean).translate(*on_picture(origin))


def _soft(
    canvas: Canvas,
    corners: Sequence[Point],
    paint: Paint,
    *,
    round_off: float = 0.25,
) -> None:
    """Draw a polygon with rounded corners."""
    points: list[Point] = []
    codes: list[int] = []
    move, straight, bent, close = (int(Path.MOVETO), int(Path.LINETO), int(Path.CURVE3), int(Path.CLOSEPOLY))
    for index, corner in enumerate(corners):
        before, after = corners[index - 1], corners[(index + 1) % len(corners)]
        points += [_along(corner, before, round_off), corner, _along(corner, after, round_off)]
        codes += [straight if codes else move, bent, bent]
    canvas.path(Path([*points, points[0]], [*codes, close]), paint)

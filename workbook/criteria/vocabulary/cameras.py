"""Generate images of a desk, which the judge publishes as a camera would, and locate the toys in them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

from workbook.scenes.scene import Place, Scene

if TYPE_CHECKING:
    from workbook.scenes.desk import DeskCamera
    from workbook.scenes.pinhole import Pinhole
    from workbook.scenes.tabletop import Thing

FRAME_ID = "head_camera_optical_frame"


@dataclass(frozen=True)
class CameraView:
    """One camera image: its scene and its encoding. The height is 3/4 of the width (both in pixels).

    `stamp`: seconds and nanoseconds. `seed` and `number` select the noise. `padding`: the number of unused bytes after
    each row.
    """

    scene: Scene
    stamp: tuple[int, int]
    seed: int
    number: int
    width: int = 160
    encoding: str = "rgb8"
    padding: int = 0


class _Fields(Mapping[str, Any]):
    """The fields of an Image message. The image is rendered when a field is first read."""

    def __init__(self, view: CameraView) -> None:
        self._view = view

    @cached_property
    def _all(self) -> dict[str, Any]:
        from workbook.scenes.encodings import encoded

        view = self._view
        picture = _camera(view.width, view.seed).picture(view.scene, view.number)
        data, step = encoded(picture, view.encoding, view.padding)
        sec, nanosec = view.stamp
        return {
            "header": {"stamp": {"sec": sec, "nanosec": nanosec}, "frame_id": FRAME_ID},
            "height": picture.shape[0],
            "width": picture.shape[1],
            "encoding": view.encoding,
            "is_bigendian": 0,
            "step": step,
            "data": data,
        }

    def __repr__(self) -> str:
        return f"camera_image({self._view})"

    def __getitem__(self, name: str) -> Any:
        return self._all[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)


def camera_image(view: CameraView) -> Mapping[str, Any]:
    """Return the fields of a `sensor_msgs/Image` of `view`, for `publish`. The image is rendered on first use."""
    return _Fields(view)


def seen_direction(place: Place, width: int = 160) -> tuple[float, float, float]:
    """Return the unit vector from a camera to a place (m, robot axes).

    In the vector, x points right, y down, and z forward.
    """
    seen = _pinhole(width).seen_from(place)
    x, y, z = (seen / (seen @ seen) ** 0.5).tolist()
    return x, y, z


def things_seen(scene: Scene, width: int = 160) -> "list[Thing]":
    """Return the toys that a camera sees on the desk.

    Each has a label, a center, and the size of its upright box (pixels).
    """
    from workbook.scenes.tabletop import things_in

    return things_in(scene, _pinhole(width))


def seen_pixel(place: Place, width: int = 160, pan: float = 0.0) -> tuple[float, float]:
    """Return the column and row at which a camera sees a place (m, robot axes). `pan` (rad) turns the head left."""
    pinhole = _pinhole(width)
    return pinhole.pixel(pinhole.seen_from(place, pan))


@lru_cache(maxsize=4)
def _camera(width: int, seed: int) -> "DeskCamera":
    from workbook.scenes.desk import DeskCamera

    return DeskCamera(_pinhole(width), seed)


def _pinhole(width: int) -> "Pinhole":
    from workbook.scenes.pinhole import Pinhole

    return Pinhole(width, 3 * width // 4, 0.875 * width)

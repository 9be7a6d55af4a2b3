"""Set the robot's pose from the latest message. The robot glides to each new pose, and sleeps until the first one."""

import time
from collections.abc import Iterable

from workbook.pictures import humanoid
from workbook.pictures.joints import Follower


class MovingRobot:
    """Sets the figure's pose from joint angles (rad), and its lamp from the status.

    `ease`: the time (s) from one pose to the next. `captions`: whether the figure shows problems, too, and not only
    `words`.
    """

    def __init__(self, ease: float, *, captions: bool = True) -> None:
        self.captions = captions
        self.received = 0
        self.complaint = ""
        self._follower = Follower(ease)
        self.lamp: humanoid.Lamp | None = None
        self._shown: object = None

    def pose(self, angles: Iterable[float]) -> None:
        """Move toward the angles in a message. If they aren't a valid pose, the figure shows the problem."""
        self.received += 1
        try:
            self._follower.aim(angles, time.monotonic())
            self.complaint = ""
        except ValueError as error:
            self.complaint = str(error)

    def status(self, word: str) -> None:
        """Light the lamp for a known status; any other status turns it off."""
        self.lamp = word if word in ("operational", "error") else None  # type: ignore[assignment]

    @property
    def words(self) -> str:
        """The reason why the robot is asleep, or an empty string if it's awake."""
        return self.complaint or ("" if self.received else "waiting for /robot/joint_positions")

    def news(self) -> dict[str, object]:
        """Return the robot's latest state, in the format that rig.js expects."""
        return {
            "awake": not self.words,
            "face": self.lamp,
            "pose": None if self.words else list(self._follower.aimed),
            "words": self.words,
        }

    def frame(self) -> bytes | None:
        """Return the current frame as PNG bytes, or None if it's the same as the previous one.

        So nothing is drawn for a robot that stands still.
        """
        words = self.words
        angles = () if words else tuple(self._follower.angles(time.monotonic()))
        frame = (words, angles, self.lamp)
        if frame == self._shown:
            return None
        self._shown = frame
        if words:
            return humanoid.placeholder(words if self.captions else "")
        return humanoid.draw(angles, lamp=self.lamp)

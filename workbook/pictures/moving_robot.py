"""The robot as the last messages pose it: glides to each new pose, sleeps until the first one."""

import time
from collections.abc import Iterable

from workbook.pictures import humanoid
from workbook.pictures.joints import Follower


class MovingRobot:
    """Poses the figure by joint angles (rad); its lamp follows the status.

    `ease`: seconds from one pose to the next. `captions`: what is wrong stands in the picture, not only in `words`.
    """

    def __init__(self, ease: float, *, captions: bool = True) -> None:
        self.captions = captions
        self.received = 0
        self.complaint = ""
        self._follower = Follower(ease)
        self.lamp: humanoid.Lamp | None = None
        self._shown: object = None

    def pose(self, angles: Iterable[float]) -> None:
        """Take over the angles of a message; one that poses no robot is told of in the picture."""
        self.received += 1
        try:
            self._follower.aim(angles, time.monotonic())
            self.complaint = ""
        except ValueError as error:
            self.complaint = str(error)

    def status(self, word: str) -> None:
        """Light the lamp for a status that the robot knows; any other puts it out."""
        self.lamp = word if word in ("operational", "error") else None  # type: ignore[assignment]

    @property
    def words(self) -> str:
        """Why the robot sleeps; empty when it is awake."""
        return self.complaint or ("" if self.received else "waiting for /robot/joint_positions")

    def frame(self) -> bytes | None:
        """The picture as it is now; None while it is the one before. A robot that stands still costs nothing."""
        words = self.words
        angles = () if words else tuple(self._follower.angles(time.monotonic()))
        frame = (words, angles, self.lamp)
        if frame == self._shown:
            return None
        self._shown = frame
        if words:
            return humanoid.placeholder(words if self.captions else "")
        return humanoid.draw(angles, lamp=self.lamp)

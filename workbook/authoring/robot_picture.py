"""Draw the README's figure: an animated PNG of the robot replaying the moves of a recorded program."""

from pathlib import Path

from workbook.authoring.tree import Tree
from workbook.lesson.programs import record, values
from workbook.pictures import humanoid
from workbook.pictures.film import moving_png

PICTURE = Path("docs/robot.png")
PROGRAM = Path("lesson_nodes/joint_position_publisher.py")
TOPIC = "/robot/joint_positions"
PERIOD_S = 0.125
WAVES_PER_SECOND = 1.0
ROUND = 32
"""Number of messages until the robot is back in its first pose, so that the animation loops without a jump."""
SCALE = 0.85


def write_robot_picture(tree: Tree) -> Path:
    """Run the program, record one round of its messages, and draw the robot at each message. Return the image's path.

    Raises ValueError if too few messages arrived.
    """
    seconds = PERIOD_S * (ROUND + 10)
    recording = record(
        tree.root / PROGRAM, {TOPIC: PERIOD_S}, seconds, period_s=PERIOD_S, waves_per_second=WAVES_PER_SECOND
    )
    poses: list[list[float]] = values(recording, TOPIC)[:ROUND]  # type: ignore[assignment]
    if len(poses) < ROUND:
        raise ValueError(f"{len(poses)} messages came on {TOPIC}, and {ROUND} are needed")
    frames = [humanoid.draw(pose, scale=SCALE) for pose in poses]
    target = tree.root / PICTURE
    durations = [round(1000 * PERIOD_S)] * ROUND
    target.write_bytes(moving_png(frames, durations_ms=durations, dots_per_pixel=SCALE))
    return target

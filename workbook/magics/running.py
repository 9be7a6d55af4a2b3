"""Run the student's program and its partner nodes next to the notebook, on the notebook's own domain."""

import atexit
import os
import select
import threading
from contextlib import suppress
from pathlib import Path

from workbook.lesson.robot_in_cell import RobotInCell
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec

LAST_WORDS = "/driver/last_words"
LAST_POSE_S = 5.0
"""The longest wait (s) for a partner to act on the program's last output and then exit by itself."""


class Running:
    """Holds the running programs, at most one per exercise, and their partners."""

    def __init__(self) -> None:
        self._programs: dict[str, NodeProcess] = {}
        self._partners: dict[str, NodeProcess] = {}
        self._robots: dict[str, RobotInCell] = {}
        atexit.register(self._end_with_the_kernel)

    def _end_with_the_kernel(self) -> None:
        self._robots.clear()  # from now on, no front end receives these robots' messages
        for stem in {*self._programs, *self._partners}:
            self._end(stem, told=False)

    def start_partner(self, stem: str, partner: Path) -> NodeProcess:
        """Start the exercise's partner, a program that plays the rest of the robot.

        The partner is stopped when the program that's started next exits.
        """
        self.stop(stem)
        process = self._process(partner)
        self._partners[stem] = process
        return process

    def start(self, stem: str, program: Path, driver: Path | None = None) -> NodeProcess:
        """Start `program`. First stop any earlier run of the same exercise, but leave its partner running."""
        self._end_program(stem)
        process = self._process(program, driver)
        self._programs[stem] = process
        partner = self._partners.get(stem)
        if partner is not None:
            waits = threading.Thread(
                target=self._end_partner_after, args=(stem, partner, process), daemon=True
            )
            waits.start()
        return process

    @staticmethod
    def _process(program: Path, driver: Path | None = None) -> NodeProcess:
        spec = ProgramSpec(program, driver=driver, driver_key=b"", in_panel=True)
        return NodeProcess(spec, int(os.environ["ROS_DOMAIN_ID"]))

    def show_robot(self, stem: str) -> None:
        """Show the robot below the running cell. It falls asleep when this exercise's program is stopped."""
        self._robots[stem] = RobotInCell()

    def stop(self, stem: str, *, told: bool = True) -> NodeProcess | None:
        """Stop an exercise's program and its partner. Return the program, or None if it wasn't running.

        `told`: whether the partner first receives the program's last output, and some time to act on it.
        """
        process = self._end(stem, told=told)
        robot = self._robots.pop(stem, None)
        if robot is not None:
            robot.rest()
        return process

    def _end(self, stem: str, *, told: bool) -> NodeProcess | None:
        # Remove the partner first. Otherwise, the thread that waits for the program to exit would stop the partner too
        # early.
        partner = self._partners.pop(stem, None)
        try:
            process = self._end_program(stem)
            if partner is not None and process is not None and told:
                _tell_last_words(process, partner)
        finally:  # even if the reader interrupts the cell
            if partner is not None:
                partner.stop()
        return process

    def _end_program(self, stem: str) -> NodeProcess | None:
        process = self._programs.pop(stem, None)
        if process is None:
            return None
        was_running = process.is_running()
        process.stop()
        return process if was_running else None

    def _end_partner_after(self, stem: str, partner: NodeProcess, process: NodeProcess) -> None:
        """Wait for a program to exit, and then stop its partner."""
        _wait_for_end(process)
        if self._partners.get(stem) is partner and self._partners.pop(stem, None) is partner:
            partner.stop()

    def stop_all(self) -> list[str]:
        """Stop all programs and their partners. Return the stems of the exercises whose program was running."""
        stems = dict.fromkeys(
            (*self._programs, *self._partners)
        )  # an interrupted start may leave only a partner
        return [stem for stem in stems if self.stop(stem) is not None]

    def running(self) -> list[str]:
        """Return the stems of exercises whose program is running."""
        return [stem for stem, process in self._programs.items() if process.is_running()]


def _wait_for_end(process: NodeProcess) -> None:
    with suppress(ProcessLookupError):
        handle = os.pidfd_open(process.pid)
        try:
            select.select([handle], [], [])
        finally:
            os.close(handle)


def _tell_last_words(process: NodeProcess, partner: NodeProcess) -> None:
    """Publish the program's output since Ctrl-C if the partner subscribes to it, and let the partner act on it."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    from workbook.ros.kernel_node import kernel_node

    node = kernel_node()
    if not node.count_subscribers(LAST_WORDS):
        return
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(String, LAST_WORDS, kept)
    publisher.publish(String(data=process.record().end_log))
    partner.wait(LAST_POSE_S)
    node.destroy_publisher(publisher)

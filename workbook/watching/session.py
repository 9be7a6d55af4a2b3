"""Hold the parts of a watch: the program, and the judge's node, clock, script player, and recorder."""

import secrets
import time
from dataclasses import dataclass, field
from functools import partial

import rclpy
from rclpy.context import Context
from rclpy.node import Node

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.ros.environment import profile_with_lease
from workbook.watching.clock import SimulatedClock
from workbook.watching.observer import Observer
from workbook.watching.recorder import Recorder
from workbook.watching.rest import RestDetector
from workbook.watching.script_player import ScriptPlayer

REMEMBERED_S = 20
"""The liveliness lease (s) if we judge whether nodes leave the graph: how long the graph keeps a vanished program."""


@dataclass
class Delays:
    """The delays (s) of the judge and the program for lack of a processor, as stored in the recording."""

    held_up: float = 0.0
    longest_steal: float = 0.0
    stolen: float = 0.0
    run_queue: float = 0.0


@dataclass
class Session:
    """The parts of one watch.

    `clock`: the simulated clock, or None on the wall clock, and until the switch to simulated time begins. `began`: on
    the wall clock, the real time (`time.monotonic`, s) that counts as simulated time zero.
    """

    observer: Observer
    plan: Plan
    context: Context
    node: Node
    clock: SimulatedClock | None = None
    process: NodeProcess = field(init=False)
    script_player: ScriptPlayer = field(init=False)
    recorder: Recorder = field(init=False)
    rest: RestDetector = field(init=False)
    began: float = field(default_factory=time.monotonic)
    delays: Delays = field(default_factory=Delays)

    def simulated_time(self, moment: float) -> float:
        """Return the simulated time (s) that corresponds to the real time `moment` (`time.monotonic`, s)."""
        if self.clock is not None:
            return self.clock.simulated_time(moment)
        return moment - self.began

    def close(self) -> None:
        """Destroy the judge's node, and shut its context down, unless that has already happened."""
        if self.context.ok():
            self.node.destroy_node()
            rclpy.shutdown(context=self.context)


def open_session(observer: Observer, spec: ProgramSpec, plan: Plan, process: NodeProcess | None) -> Session:
    """Create the judge's node, and start the program unless it's already running as `process`.

    Raises OSError if the program can't be started.
    """
    context = Context()
    rclpy.init(
        context=context,
        args=["--ros-args", "--disable-external-lib-logs"],
        domain_id=observer.domain_id,
        signal_handler_options=rclpy.signals.SignalHandlerOptions.NO,
    )
    node = Node(
        f"judge_{secrets.token_hex(4)}",
        context=context,
        enable_rosout=False,
        start_parameter_services=False,
        use_global_arguments=False,
    )
    session = Session(observer, plan, context, node)
    session.script_player = ScriptPlayer(node, plan.script, session.simulated_time)
    if process is None:
        profile = partial(profile_with_lease, lease_s=REMEMBERED_S) if plan.to_the_end else None
        try:
            process = NodeProcess(spec, observer.domain_id, observer.tier, write_profile=profile)
        except OSError:
            session.close()
            raise
    session.process = process
    session.rest = RestDetector(process.pid)
    session.began = session.script_player.started_at = process.started_at
    session.recorder = Recorder(
        node,
        process.started_at,
        session.simulated_time,
        judged=plan.topics,
        bytes_per_topic=plan.bytes_per_topic,
        own_bytes=session.script_player.bytes_by_topic(),
        features=plan.features,
        on_take=observer.on_take,
    )
    return session

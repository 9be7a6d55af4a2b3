"""A quiet node of the notebook that looks at the graph. It has its own context and needs no spinning."""

import atexit
import os

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

NAME = "notebook_probe"
_probe: Node | None = None


def probe() -> Node:
    """The probe node of this kernel, made at first use."""
    global _probe
    if _probe is None:
        context = Context()
        rclpy.init(
            context=context,
            args=[],
            domain_id=int(os.environ["ROS_DOMAIN_ID"]),
            signal_handler_options=SignalHandlerOptions.NO,
        )
        _probe = Node(
            NAME, context=context, enable_rosout=False, start_parameter_services=False, use_global_arguments=False
        )
        atexit.register(close_probe)
    return _probe


def close_probe() -> None:
    global _probe
    if _probe is not None:
        context = _probe.context
        _probe.destroy_node()
        if context.ok():
            rclpy.shutdown(context=context)
        _probe = None

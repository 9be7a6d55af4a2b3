"""A hidden node that stays for as long as the kernel: it knows the graph at once, because it met everybody."""

import atexit
import os

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from workbook.ros.probe import wait_for_graph

_node: Node | None = None


def standing_node() -> Node:
    """The hidden node of this kernel, made at first use, in a context of its own. It needs no spinning.

    It is made anew when the kernel has moved to another domain since. When it is returned first, it has met everybody.
    """
    global _node
    domain_id = int(os.environ["ROS_DOMAIN_ID"])
    if _node is not None and _node.context.get_domain_id() != domain_id:
        close_standing_node()
    if _node is None:
        context = Context()
        rclpy.init(
            context=context,
            args=[],
            domain_id=domain_id,
            signal_handler_options=SignalHandlerOptions.NO,
        )
        _node = Node(
            f"_workbook_kernel_{os.getpid()}",
            context=context,
            enable_rosout=False,
            start_parameter_services=False,
            use_global_arguments=False,
        )
        atexit.register(close_standing_node)
        wait_for_graph(_node)
    return _node


def close_standing_node() -> None:
    global _node
    if _node is not None:
        context = _node.context
        _node.destroy_node()
        if context.ok():
            rclpy.shutdown(context=context)
        _node = None

"""Keep a hidden node for as long as the kernel runs, so that discovery is already complete when we need the node."""

import atexit
import os

import rclpy
from rclpy.context import Context
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from workbook.ros.discovery import wait_for_graph

_node: Node | None = None


def kernel_node() -> Node:
    """Return this kernel's hidden node, which is created on first use in a separate context and needn't be spun.

    If the kernel has moved to another domain, re-create the node. A call that creates the node waits for discovery.
    """
    global _node
    domain_id = int(os.environ["ROS_DOMAIN_ID"])
    if _node is not None and _node.context.get_domain_id() != domain_id:
        close_kernel_node()
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
        atexit.register(close_kernel_node)
        wait_for_graph(_node)
    return _node


def close_kernel_node() -> None:
    """Destroy the hidden node, if there is one, and shut its context down."""
    global _node
    if _node is not None:
        context = _node.context
        _node.destroy_node()
        if context.ok():
            rclpy.shutdown(context=context)
        _node = None

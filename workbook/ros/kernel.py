"""Set up ROS in a notebook's kernel, once its environment variables are set."""

import os

from workbook.inside import tap
from workbook.ros import exit_cleanup, interrupts, logs, notebook_registry


def install(label: str | None = None) -> None:
    """Set up a kernel with ordered logs, a working Interrupt, a clean exit, and a domain that terminals can find.

    It's safe to call this function again. Call `workbook.ros.environment.prepare` first, because this function imports
    rclpy.
    """
    logs.install()
    interrupts.install()
    exit_cleanup.register()
    domain_id = int(os.environ.get("ROS_DOMAIN_ID") or 0)
    tap.install(domain_id)
    notebook_registry.announce(domain_id, label)

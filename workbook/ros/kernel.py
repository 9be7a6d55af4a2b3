"""What a notebook kernel does once, when it starts, after the environment was prepared."""

import os

from workbook.inside import tap
from workbook.ros import exit_cleanup, interrupts, logs, notebook_registry


def install(label: str | None = None) -> None:
    """Logs in order, an Interrupt that works, a clean end, a domain that terminals find. Safe to repeat.

    Call `workbook.ros.environment.prepare` first: this imports rclpy.
    """
    logs.install()
    interrupts.install()
    exit_cleanup.register()
    domain_id = int(os.environ.get("ROS_DOMAIN_ID") or 0)
    tap.install(domain_id)
    notebook_registry.announce(domain_id, label)

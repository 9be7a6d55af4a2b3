# loses: program_runs
"""Stops itself, as Ctrl-Z does, once it is watched: it neither runs nor ends."""
import os
import signal
import threading

import rclpy.node

_create = rclpy.node.Node.create_publisher


def create_publisher(self, kind, name, *arguments, **options):
    publisher = _create(self, kind, name, *arguments, **options)
    if name.endswith("joint_positions"):
        threading.Thread(target=stop, args=(publisher,), daemon=True).start()
    return publisher


def stop(publisher):
    while publisher.get_subscription_count() == 0:
        pass
    os.kill(os.getpid(), signal.SIGSTOP)


rclpy.node.Node.create_publisher = create_publisher
@@GOOD@@

# score: 10
"""Answers Ctrl-C with processes that ignore it and go on publishing: they must not outlive the judgement."""
import os
import signal
import sys
import time


def multiply(*_):
    for _ in range(20):
        if os.fork() == 0:
            os.setsid()
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_IGN)
            while True:
                time.sleep(1.0)
    sys.exit(0)


import rclpy

_init = rclpy.init


def init(*arguments, **options):
    options["signal_handler_options"] = rclpy.signals.SignalHandlerOptions.NO
    _init(*arguments, **options)
    signal.signal(signal.SIGINT, multiply)


rclpy.init = init
@@GOOD@@

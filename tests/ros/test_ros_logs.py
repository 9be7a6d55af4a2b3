"""Log lines and prints appear in the order in which the code produced them."""

import json
import re
import subprocess
import sys

import pytest

INTERLEAVED = """
logger = node.get_logger()
for number in range(20):
    if number % 2:
        print(f'{number} printed')
    else:
        logger.info(f'{number} logged')
logger.warning('battery low')
print('last')
"""
EXPECTED = "".join(
    f"{number} printed\n" if number % 2 else f"[INFO] [robot]: {number} logged\n" for number in range(20)
)


def plain(text: str) -> str:
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


@pytest.mark.parametrize("under_pytest", [False, True])
def test_twenty_lines_come_in_order(open_kernel, under_pytest):
    kernel = open_kernel(**({"PYTEST_CURRENT_TEST": "a test"} if under_pytest else {}))
    kernel.good("rclpy.init()\nnode = fresh(Node, 'robot')")
    for _ in range(3):
        outcome = kernel.good(INTERLEAVED)
        assert plain(outcome.text) == EXPECTED + "[WARN] [robot]: battery low\nlast\n"
        assert outcome.stderr == ""
    assert "\x1b[38;2;176;106;0mWARN\x1b[0m" in outcome.text


def test_a_notebook_with_logs_is_reproducible_under_nbval(tmp_path):
    start = "from workbook.ros.environment import prepare\nprepare()\n"
    start += "from workbook.ros import kernel, fresh, run\n"
    cells = [
        start + "kernel.install()\nimport rclpy\nfrom rclpy.node import Node\nrclpy.init()",
        "node = fresh(Node, 'robot')\n" + INTERLEAVED,
        "ticks = []\ndef tick():\n    ticks.append(1)\n    node.get_logger().info(f'tick {len(ticks)}')\n"
        "    print('printed', len(ticks))\n"
        "timer = node.create_timer(0.02, tick)\nawait run(node, until=lambda: len(ticks) >= 3)",
    ]
    notebook = {
        "cells": [
            {
                "cell_type": "code",
                "id": f"cell-{index}",
                "execution_count": None,
                "metadata": {},
                "outputs": [],
                "source": source,
            }
            for index, source in enumerate(cells)
        ],
        "metadata": {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    file = tmp_path / "logs.ipynb"
    file.write_text(json.dumps(notebook))
    execute = "import nbformat, nbclient, sys\nnb = nbformat.read(sys.argv[1], 4)\n"
    execute += "nbclient.NotebookClient(nb, timeout=60).execute()\nnbformat.write(nb, sys.argv[1])"
    subprocess.run([sys.executable, "-c", execute, str(file)], check=True, timeout=120)
    outputs = json.loads(file.read_text())["cells"][2]["outputs"]
    text = "".join("".join(output["text"]) for output in outputs)
    assert text == "".join(f"[INFO] [robot]: tick {n}\nprinted {n}\n" for n in (1, 2, 3))
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-q", "--rootdir", str(tmp_path)]
    command += ["--nbval", "--nbval-current-env", "--nbval-cell-timeout=60", str(file)]
    compared = subprocess.run(command, capture_output=True, text=True, timeout=120, cwd=tmp_path)
    assert compared.returncode == 0, compared.stdout
    assert "3 passed" in compared.stdout


def test_levels_filters_and_rosout(kernel):
    kernel.good(
        "from rcl_interfaces.msg import Log\n"
        "from rclpy.logging import LoggingSeverity\n"
        "rclpy.init()\nnode = fresh(Node, 'robot')\nlistener = fresh(Node, 'listener')\n"
        "heard = []\n"
        "def keep(log):\n"
        "    heard.append((log.level, log.msg, log.line))\n"
        "listener.create_subscription(Log, '/rosout', keep, 50)\n"
    )
    outcome = kernel.good(
        "def talk(number):\n"
        "    node.get_logger().debug(f'debug {number}')\n"
        "    node.get_logger().info(f'info {number}', once=True)\n"
        "    node.get_logger().error(f'error {number}', throttle_duration_sec=60.0)\n"
        "    node.get_logger().fatal(f'fatal {number}', skip_first=True)\n"
        "talk(1)\ntalk(2)\n"
        "node.get_logger().set_level(LoggingSeverity.DEBUG)\ntalk(3)\n"
        "node.get_logger().set_level(LoggingSeverity.FATAL)\ntalk(4)\n"
        "node.get_logger().get_child('arm').fatal('child')\n"
    )
    lines = ["[INFO] [robot]: info 1", "[ERROR] [robot]: error 1", "[FATAL] [robot]: fatal 2"]
    lines += ["[DEBUG] [robot]: debug 3", "[FATAL] [robot]: fatal 3", "[FATAL] [robot]: fatal 4"]
    lines += ["[FATAL] [robot.arm]: child"]
    assert plain(outcome.text).splitlines() == lines
    outcome = kernel.good(
        "await run(listener, until=lambda: len(heard) >= 6)\nprint([text for _, text, _ in heard])"
    )
    assert outcome.text == "['info 1', 'error 1', 'fatal 2', 'debug 3', 'fatal 3', 'fatal 4']\n"
    assert kernel.good("print(heard[0][0], heard[0][2] == 3)").text == "20 True\n"


def test_logs_before_init_and_after_shutdown_come_once(kernel):
    code = "rclpy.logging.get_logger('early').info('{}')\nprint('next')"
    for moment in ("import rclpy.logging", "init()", "shutdown()", "init()"):
        outcome = kernel.good(moment + "\n" + code.format(moment))
        assert outcome.text == f"[INFO] [early]: {moment}\nnext\n"
        assert outcome.stderr == ""


def test_log_lines_of_the_c_libraries_still_reach_stderr(kernel):
    request = kernel.start(
        "rclpy.init()\na = Node('twin')\nb = Node('twin')\na.get_logger().info('here')\ntime.sleep(1)"
    )
    outcome = kernel.finish(request)
    assert "Publisher already registered for node name: 'twin'" in outcome.stderr
    assert outcome.text == "[INFO] [twin]: here\n"

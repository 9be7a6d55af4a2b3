"""The folded box "How to do this without the helper functions", which shows each helper as plain rclpy code.

In a lesson's text, the line `[the same without helpers: init, fresh, run]` stands for the box.
"""

import re

from workbook.authoring.tree import AuthoringError

_PLACE = re.compile(r"^\[the same without helpers: (?P<names>[a-z_, ]+)\]$", re.MULTILINE)
TITLE = "How to do this without the helper functions"
_BOX = "<details><summary>{title}</summary>\n\n{inside}\n\n</details>"
PLAIN = {
    "start": """\
`start(program, period_s=0.5)` starts one of this course's programs in its own process, with the parameter `period_s`
set to 0.5. It then waits until other programs can find the new one. `stop()` ends the program as Ctrl-C would. To start
it in a terminal instead, run this command with the program's name in place of `NAME`:

```bash
python -m lesson_nodes.NAME --ros-args -p period_s:=0.5
```""",
    "record": """\
`record(program, {topic: period_s}, seconds)` starts a program, records all messages on the given topics for that many
seconds, and then interrupts the program, just as Ctrl-C would. The program runs on simulated time, so a simulated
minute takes only a few seconds of real time. In a full ROS 2 installation, this command records in real time while the
program runs:

```text
ros2 bag record /robot/cmd_vel
```""",
    "init": """\
`init()` starts ROS unless it's already running, so you can rerun the cell. In plain rclpy:

```python
if not rclpy.ok():
    rclpy.init()
```""",
    "fresh": """\
`fresh(MyNode, ...)` destroys the node that an earlier run of the cell created, and then calls `MyNode(...)`.
The equivalent code is:

```python
if "node" in globals():
    node.destroy_node()
node = MyNode()
```""",
    "run": """\
`await run(node, seconds=5, until=done)` runs the node's callbacks until `done()` is true. It also keeps the
notebook's buttons working. Apart from that, it works like this loop:

```python
end = time.monotonic() + 5
while not done():
    if time.monotonic() > end:
        raise TimeoutError
    rclpy.spin_once(node, timeout_sec=0.1)
```""",
    "spin_for": """\
`spin_for(node, seconds=5, until=done)` runs the node's callbacks until `done()` is true:

```python
end = time.monotonic() + 5
while not done():
    if time.monotonic() > end:
        raise TimeoutError
    rclpy.spin_once(node, timeout_sec=0.1)
```""",
}


def with_plain_helpers(text: str, where: str) -> str:
    """Return a Markdown cell's text with a box in place of each `[the same without helpers: ...]` line.

    Raises AuthoringError if a named helper isn't in `PLAIN`. `where` identifies the cell in the error message.
    """

    def box(place: re.Match[str]) -> str:
        names = [name.strip() for name in place["names"].split(",")]
        for name in names:
            if name not in PLAIN:
                raise AuthoringError(
                    f"{where}: there is no plain text for the helper {name!r}; write one in {__name__}"
                )
        return _BOX.format(title=TITLE, inside="\n\n".join(PLAIN[name] for name in names))

    return _PLACE.sub(box, text)

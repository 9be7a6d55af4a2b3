import asyncio
import signal
import subprocess
import sys
import textwrap
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from workbook.pictures import LiveFigure, LiveStill, Still, animate, png


def frame_of(value: int) -> bytes:
    return png.encode(np.full((4, 4, 4), value % 256, np.uint8))


class FakeScreen:
    def __init__(self) -> None:
        self.shown: list[Still] = []
        self.updates: list[Still] = []
        self.finished: list[Still] = []

    def show(self, still: Still) -> None:
        self.shown.append(still)

    def update(self, still: Still) -> None:
        self.updates.append(still)

    def finish(self, still: Still) -> None:
        self.finished.append(still)


def counting() -> Callable[[], bytes]:
    numbers = iter(range(10_000))
    return lambda: frame_of(next(numbers))


def test_a_live_figure_is_shown_once_and_then_replaced() -> None:
    screen = FakeScreen()
    figure = LiveFigure("humanoid, 12 joints", screen)
    for value in range(4):
        figure.show(frame_of(value))
    assert len(screen.shown) == 1
    assert [still.png for still in screen.updates] == [frame_of(value) for value in (1, 2, 3)]
    assert figure.frames == 4
    assert figure.still is not None
    assert figure.still.png == frame_of(3)
    assert {still.description for still in (*screen.shown, *screen.updates)} == {"humanoid, 12 joints"}


def test_the_loop_counts_the_frames_it_showed() -> None:
    screen = FakeScreen()
    still = asyncio.run(animate(counting(), 0.4, 50, describe="counter", screen=screen))
    assert still.frames == 1 + len(screen.updates)
    assert 2 <= still.frames <= 21, "never more than asked for"
    assert still.png == screen.updates[-1].png == screen.finished[0].png, "the last frame stays"
    assert len(screen.finished) == 1
    assert still.frames_per_second == still.frames / still.seconds
    assert still.seconds >= 0.4
    assert not still.stopped


def test_none_leaves_the_picture_alone() -> None:
    screen = FakeScreen()
    frames = iter([frame_of(1), None, None, frame_of(2)])
    still = asyncio.run(animate(lambda: next(frames, None), 0.3, 50, describe="counter", screen=screen))
    assert still.frames == 2
    assert [len(screen.shown), len(screen.updates)] == [1, 1]


def test_other_tasks_run_in_between_also_when_drawing_is_slower_than_the_rate() -> None:
    turns = 0

    async def other() -> None:
        nonlocal turns
        while True:
            turns += 1
            await asyncio.sleep(0)

    def slow() -> bytes:
        sum(range(200_000))
        return frame_of(turns)

    async def both() -> LiveStill:
        task = asyncio.create_task(other())
        still = await animate(slow, 0.2, 100_000, describe="counter", screen=FakeScreen())
        task.cancel()
        return still

    still = asyncio.run(both())
    assert turns >= still.frames


def test_cancelling_ends_it_with_the_last_frame_and_the_task_goes_on() -> None:
    screen = FakeScreen()
    after: list[str] = []

    async def cell() -> LiveStill:
        still = await animate(counting(), 60, 100, describe="counter", screen=screen)
        await asyncio.sleep(0)
        after.append("the code after it ran")
        return still

    async def stopped() -> LiveStill:
        task = asyncio.create_task(cell())
        while len(screen.updates) < 3:
            await asyncio.sleep(0.001)
        task.cancel()
        return await task

    still = asyncio.run(stopped())
    assert still.stopped
    assert still.frames >= 4
    assert still.png == screen.updates[-1].png
    assert after
    assert [last.png for last in screen.finished] == [still.png]


def test_an_interrupt_while_a_frame_is_drawn_ends_it_too() -> None:
    numbers = iter(range(100))

    def frame() -> bytes:
        value = next(numbers)
        if value == 3:
            raise KeyboardInterrupt
        return frame_of(value)

    still = asyncio.run(animate(frame, 60, 100, describe="counter", screen=FakeScreen()))
    assert still.stopped
    assert still.png == frame_of(2)


def test_a_stop_before_the_first_picture_is_passed_on() -> None:
    async def stopped() -> None:
        task = asyncio.create_task(animate(lambda: None, 60, describe="counter", screen=FakeScreen()))
        await asyncio.sleep(0.01)
        task.cancel()
        await task

    with pytest.raises(asyncio.CancelledError):
        asyncio.run(stopped())


def test_an_error_of_the_frame_is_the_callers() -> None:
    frames = [frame_of(2), frame_of(1)]
    screen = FakeScreen()

    def broken() -> bytes:
        if not frames:
            raise ZeroDivisionError("in the frame")
        return frames.pop()

    with pytest.raises(ZeroDivisionError, match="in the frame"):
        asyncio.run(animate(broken, 1, describe="counter", screen=screen))
    assert [still.png for still in screen.finished] == [frame_of(2)], "what was shown last stays"


def test_never_a_picture_is_an_error() -> None:
    with pytest.raises(RuntimeError, match="returned None each time"):
        asyncio.run(animate(lambda: None, 0.05, describe="counter", screen=FakeScreen()))


@pytest.mark.parametrize(("seconds", "fps"), [(0, 20), (1, 0), (-1, 20), (1, float("nan"))])
def test_impossible_rates_are_refused(seconds: float, fps: float) -> None:
    with pytest.raises(ValueError, match="above zero"):
        asyncio.run(animate(counting(), seconds, fps, describe="counter", screen=FakeScreen()))


def run_notebook(*cells: str) -> list[list[dict[str, Any]]]:
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell(textwrap.dedent(cell)) for cell in cells]
    )
    NotebookClient(notebook, timeout=60, kernel_name="python3").execute()
    return [list(cell.outputs) for cell in notebook.cells]


def test_in_a_notebook_one_picture_stays_and_its_text_has_no_numbers() -> None:
    live, again, shown = run_notebook(
        """
        from workbook import pictures
        from workbook.pictures.joints import walking
        ticks = iter(range(1000))
        still = await pictures.animate(
            lambda: pictures.humanoid.draw(walking(next(ticks) / 20)), 0.5, 20, describe="humanoid, 12 joints"
        )
        still
        """,
        "still",
        """
        fig, ax = pictures.figure()
        ax.plot([0, 1], [1, 0])
        pictures.show(fig, "a falling line")
        """,
    )
    (output,) = live
    assert output["output_type"] == "display_data"
    assert output["data"]["text/plain"] == "Picture: humanoid, 12 joints"
    assert output["metadata"]["image/png"]["alt"] == "humanoid, 12 joints"
    (later,) = again
    assert later["output_type"] == "display_data"
    assert later["data"]["image/png"] == output["data"]["image/png"]
    (plot,) = shown
    assert plot["data"]["text/plain"] == "Picture: a falling line"


def test_stop_in_a_notebook_ends_the_cell_cleanly() -> None:
    """A real kernel gets a real interrupt during an animation.

    The cell ends without an error, and the rest of it runs.
    """
    program = """
        import sys
        from jupyter_client.manager import start_new_kernel
        manager, client = start_new_kernel(kernel_name="python3")
        code = '''
        import numpy as np
        from workbook import pictures
        frame = pictures.png.encode(np.zeros((4, 4, 4), np.uint8))
        still = await pictures.animate(lambda: frame, 60, describe="counter")
        print("stopped", still.stopped)
        '''
        import textwrap
        asked = client.execute(textwrap.dedent(code))
        interrupted, said = False, ""
        while True:
            message = client.get_iopub_msg(timeout=30)
            kind = message["msg_type"]
            if kind in ("display_data", "update_display_data") and not interrupted:
                interrupted = True
                manager.interrupt_kernel()
            if kind == "stream":
                said += message["content"]["text"]
            if kind == "status" and message["content"]["execution_state"] == "idle" and interrupted:
                break
        reply = client.get_shell_msg(timeout=30)
        while reply["parent_header"].get("msg_id") != asked:
            reply = client.get_shell_msg(timeout=30)
        manager.shutdown_kernel(now=True)
        print(reply["content"]["status"], said)
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program)],
        capture_output=True,
        text=True,
        timeout=90,
        check=True,
    )
    assert done.stdout.split() == ["ok", "stopped", "True"]
    assert signal.getsignal(signal.SIGINT) is not None

"""A slider for a parameter of a program. Each move restarts the program, and no process is left at the end."""

from pathlib import Path
from typing import Any

import pytest

PROGRAM = Path(__file__).resolve().parents[2] / "lesson_nodes" / "two_arms.py"
SETUP = f"""
from pathlib import Path
from IPython.utils.capture import capture_output
from workbook.lesson import knobs, programs
from workbook.ros import node_list
PROGRAM = Path({str(PROGRAM)!r})
made, started = [], []
show, start = knobs.Knob.show, knobs.start
def shown(self):
    show(self)
    made.append(self)
def starting(program, **parameters):
    started.append(parameters["right_period_s"])
    return start(program, **parameters)
knobs.Knob.show, knobs.start = shown, starting
async def turn(*values):
    while not made:
        await asyncio.sleep(0.02)
    for value in values:
        made[-1]._slider.value = value
        while started[-1] != value:
            await asyncio.sleep(0.02)
    print("nodes:", *node_list())
"""
TURNED = """
task = asyncio.ensure_future(turn({values}))
await knobs.knob(PROGRAM, "right_period_s", 1.0, between=(0.05, 1.5), seconds={seconds}, left_period_s=0.05)
await task
print(started, programs._started, made[-1]._slider.disabled)
"""


@pytest.fixture
def with_knobs(kernel: Any) -> Any:
    kernel.good(SETUP)
    return kernel


@pytest.mark.whole
def test_each_move_starts_the_program_again(with_knobs: Any) -> None:
    for _ in range(2):  # the cell can be run again
        with_knobs.good("made.clear(); started.clear()")
        said = with_knobs.good(TURNED.format(values="0.3, 0.6", seconds=3)).text.splitlines()
        assert said == ["nodes: /robot_view /two_arms", "[1.0, 0.3, 0.6] {} True"]


def test_stop_ends_the_program(with_knobs: Any) -> None:
    cell = with_knobs.start(TURNED.format(values="", seconds=600))
    with_knobs.wait_for_text(cell, "nodes:")
    with_knobs.interrupt()
    outcome = with_knobs.finish(cell)
    assert outcome.error is None and outcome.text.endswith("[1.0] {} True\n")


def test_what_a_reader_without_widgets_sees(with_knobs: Any) -> None:
    told = with_knobs.good(
        "with capture_output() as out:\n    knobs.Knob('threads', 1, (1, 4)).show()\n"
        "print(out.outputs[0].data['text/plain'])\nprint(type(made[-1]._slider).__name__)"
    ).text
    assert told == (
        "Slider: threads from 1 to 4. Or change the number in the cell and run it again.\nIntSlider\n"
    )


def test_a_number_outside_is_refused_before_anything_starts(with_knobs: Any) -> None:
    outcome = with_knobs.run("await knobs.knob(PROGRAM, 'right_period_s', 9.0, between=(0.1, 1.0))")
    assert outcome.error == "ValueError" and "from 0.1 to 1.0" in outcome.message
    assert with_knobs.good("print(started, made)").text == "[] []\n"


SLID = """
import asyncio
drawn = []
def draw(number):
    drawn.append(number)
    return programs_png
async def move():
    for value in ({values}):
        made[-1]._slider.value = value
        while drawn[-1] != value:
            await asyncio.sleep(0.02)
task = asyncio.ensure_future(move())
await knobs.slide("length", 9, draw, between=(1, 30), describe="a curve", seconds=1)
await task
print(drawn, made[-1]._slider.disabled)
"""
PNG = "from workbook.pictures.figures import figure, render\nprograms_png = render(figure()[0])"


def test_each_move_draws_the_figure_again(with_knobs: Any) -> None:
    with_knobs.good(PNG)
    with_knobs.good("made.clear()")
    said = with_knobs.good(SLID.format(values="4, 16,")).text.splitlines()
    assert said[-1] == "[9, 4, 16] True"

"""Show a slider for a number, next to the robot or figure that depends on the number."""

import asyncio
import time
from collections.abc import Callable
from typing import Any

from IPython.display import display

from workbook.lesson.programs import Program, start, stop
from workbook.lesson.views import ROBOT_TEXT, RobotView, watched
from workbook.pictures.live import LiveFigure

Number = int | float
WIDGET = "application/vnd.jupyter.widget-view+json"
STEPS = 100
LOOK_EVERY_S = 0.05


class Knob:
    """A slider and its current number. If widgets are missing, the number stays the one given in the cell."""

    def __init__(self, name: str, value: Number, between: tuple[Number, Number]) -> None:
        low, high = between
        if not low <= value <= high:
            raise ValueError(f"{name} must be from {low} to {high} here, not {value}")
        self.name = name
        self.value: Number = value
        self.between = between
        self.turned_at = time.monotonic()
        self._slider: Any = None

    def show(self) -> None:
        """Show the slider or, if widgets are missing, a sentence that says how to change the number."""
        low, high = self.between
        words = (
            f"Slider: {self.name} from {low} to {high}. Or change the number in the cell and run it again."
        )
        data = {"text/plain": words}
        try:
            self._slider = self._made()
            data[WIDGET] = self._slider._repr_mimebundle_()[WIDGET]
        except Exception:  # widgets are missing or don't work here, so the text says what to do
            self._slider = None
        display(data, raw=True)

    def _made(self) -> Any:
        from ipywidgets import FloatSlider, IntSlider

        low, high = self.between
        whole = all(isinstance(number, int) for number in (self.value, low, high))
        slider = (IntSlider if whole else FloatSlider)(
            value=self.value,
            min=low,
            max=high,
            step=1 if whole else (high - low) / STEPS,
            description=self.name,
            continuous_update=False,
            readout_format="d" if whole else ".2f",
        )
        slider.style.description_width = "initial"
        slider.layout.width = "min(560px, 100%)"
        slider.observe(self._on_turn, names="value")
        return slider

    def _on_turn(self, change: Any) -> None:
        self.value = change["new"] if isinstance(change["new"], int) else round(change["new"], 3)
        self.turned_at = time.monotonic()

    def end(self) -> None:
        """Disable the slider. Running its cell again creates a new one."""
        if self._slider is not None:
            self._slider.disabled = True
            self._slider.description = f"{self.name} (ended: run the cell again)"


async def knob(
    program: Program,
    name: str,
    value: Number,
    *,
    between: tuple[Number, Number],
    seconds: float = 10.0,
    **parameters: object,
) -> None:
    """Run a program with a slider for its parameter `name` and show the robot at the same time.

    The parameter starts at `value`; `between` gives its lowest and highest value. If all three are ints, the slider
    moves in whole steps. Each move restarts the program with the new value; the other `parameters` stay the same. The
    cell finishes `seconds` after the last move, or when you press Stop, and then it stops the program. Raise ValueError
    if `value` is outside of `between`.
    """
    turned = Knob(name, value, between)
    start(program, **{name: value}, **parameters)
    view = RobotView(ease=0.1)
    figure = LiveFigure(ROBOT_TEXT)
    running = turned.value
    turned.show()

    def refresh() -> None:
        nonlocal running
        if turned.value != running:
            running = turned.value
            start(program, **{name: running}, **parameters)
            turned.turned_at = time.monotonic()
        if (picture := view.frame()) is not None:
            figure.show(picture)

    turned.turned_at = time.monotonic()
    try:
        await watched(
            view,
            refresh,
            until=lambda: time.monotonic() > turned.turned_at + seconds,
            ends_program=True,
        )
    finally:
        turned.end()
        stop(program)


async def slide(
    name: str,
    value: Number,
    draw: Callable[[Number], bytes],
    *,
    between: tuple[Number, Number],
    describe: str,
    seconds: float = 8.0,
) -> None:
    """Show a slider and a figure, and redraw the figure after each move of the slider.

    The number `name` starts at `value`; `between` gives its lowest and highest value. `draw` returns the figure for a
    number, as PNG bytes, and `describe` is the figure's alternative text. The cell finishes `seconds` after the last
    move. Raise ValueError if `value` is outside of `between`.
    """
    turned = Knob(name, value, between)
    turned.show()
    figure = LiveFigure(describe)
    drawn: Number | None = None
    turned.turned_at = time.monotonic()
    try:
        while time.monotonic() <= turned.turned_at + seconds:
            if turned.value != drawn:
                drawn = turned.value
                figure.show(draw(drawn))
            await asyncio.sleep(LOOK_EVERY_S)
    finally:
        turned.end()
        figure.finish()

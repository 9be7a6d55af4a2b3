"""Show a prediction: at first, buttons for choosing; after the run, each option with its explanation."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from IPython.display import display

from workbook.lesson.prediction import Prediction
from workbook.pictures.palette import AMBER, BLUE, GREEN
from workbook.templating import render

WIDGET = "application/vnd.jupyter.widget-view+json"


class Noted(NamedTuple):
    """The result of a choice: the letter that counts now, or None, and a sentence for the student."""

    letter: str | None
    words: str


Choose = Callable[[Prediction, str], Noted]


def show_buttons(prediction: Prediction, question: str, chosen: str | None, choose: Choose) -> None:
    """Show a button for each option; a click calls `choose`. A front end without widgets shows the question as text."""
    try:
        widget = _buttons(prediction, question, chosen, choose)
        data = {WIDGET: widget._repr_mimebundle_()[WIDGET], "text/plain": question}
    except Exception:  # widgets are missing or don't work here, but the text is enough to choose
        print(question)
        return
    display(data, raw=True)


def _buttons(prediction: Prediction, question: str, chosen: str | None, choose: Choose) -> Any:
    from ipywidgets import HTML, Button, Layout, VBox

    buttons: dict[str, Button] = {}
    status = HTML()

    def mark(letter: str | None, words: str) -> None:
        for own, button in buttons.items():
            sign = "●" if own == letter else "○"
            button.description = f"{sign} {own}) {plain(prediction.option(own).text)}"
            (button.add_class if own == letter else button.remove_class)("workbook-chosen")
        status.value = render("lesson/buttons_style", words=words)

    def pressed(letter: str) -> Callable[[object], None]:
        def press(_: object) -> None:
            mark(*choose(prediction, letter))

        return press

    for option in prediction.options:
        button = Button(layout=Layout(width="auto", height="auto", align_self="flex-start"))
        button.on_click(pressed(option.letter))
        buttons[option.letter] = button
    mark(chosen, question if chosen is None else f"Your prediction: {chosen}.")
    box = VBox([*buttons.values(), status])
    box.add_class("workbook-prediction")
    return box


class Waiting:
    """A placeholder for the outcome until the reader has chosen."""

    def __init__(self, letters: str) -> None:
        self.letters = letters

    def __repr__(self) -> str:
        return f"Your prediction comes first: choose {self.letters} above. Then the outcome is shown here."

    def shown(self) -> Any:
        """Show the placeholder and return its display handle."""
        return display(self, display_id=True)


class PredictionOutcome:
    """The outcome of a prediction: the choice, what happened in this run, and an explanation of every option."""

    def __init__(
        self, prediction: Prediction, happened: str | None, mine: str | None, measured: Mapping[str, object]
    ) -> None:
        self.prediction = prediction
        self.happened = happened
        self.mine = mine
        self.measured = measured

    @property
    def headline(self) -> str:
        """The outcome and the prediction, in a sentence or two."""
        usual = self.prediction.usual
        if self.happened is None:
            told = ", ".join(f"{name} = {_rounded(value)}" for name, value in self.measured.items())
            said = f"This run fits none of the options ({told}). The usual outcome is {usual}."
        elif self.happened != usual:
            said = f"This run had an unusual outcome: {self.happened}. The usual outcome is {usual}."
        else:
            said = f"The outcome is {usual}."
        if self.mine is None:
            return said
        right = self.mine == (self.happened or usual)
        return f"You predicted {self.mine}. {said}" + (" Well done." if right else "")

    def rows(self) -> list[dict[str, Any]]:
        """Return a dictionary for each option, with the keys sign, letter, text, why, marks, and kind.

        `kind` is "happened" for the outcome, "mine" for the student's choice if that isn't the outcome, and "other" for
        the remaining options. `marks` says the same in words, and may also name the usual outcome.
        """
        happened = self.happened or self.prediction.usual
        kinds = {self.mine: "mine", happened: "happened"}
        rows = []
        for option in self.prediction.options:
            marks = []
            if option.letter == self.mine:
                marks.append("your prediction")
            if option.letter == self.happened:
                marks.append("what happened")
            elif option.letter == self.prediction.usual:
                marks.append("what usually happens")
            sign = "✓" if option.letter == happened else "✗"
            rows.append(
                {
                    "sign": sign,
                    "letter": option.letter,
                    "text": pieces(option.text),
                    "why": pieces(option.why),
                    "marks": marks,
                    "kind": kinds.get(option.letter, "other"),
                }
            )
        return rows

    def __repr__(self) -> str:
        lines = [self.headline]
        for row in self.rows():
            text, why = ("".join(part for part, _ in row[key]) for key in ("text", "why"))
            marks = "".join(f" ({mark})" for mark in row["marks"])
            lines += [f"  {row['sign']} {row['letter']}  {text}{marks}", f"       {why}"]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        unusual = self.happened != self.prediction.usual
        right = self.mine in (None, self.happened)
        color = AMBER if unusual else GREEN if right else BLUE
        return render(
            "lesson/outcome",
            color=color,
            colors={"happened": GREEN, "mine": BLUE},
            headline=self.headline,
            rows=self.rows(),
            folds=self.mine is not None,
        )

    def shown(self) -> None:
        """Show the outcome below the running cell."""
        display(self)

    def shown_at(self, place: Any) -> None:
        """Replace the placeholder (see `Waiting`) with the outcome. `place`: the placeholder's display handle."""
        place.update(self)


def pieces(text: str) -> list[tuple[str, bool]]:
    """Split Markdown text at backticks into pairs: a piece, and whether it's code. Bold marks are removed."""
    parts = text.split("`")
    return [
        (part if place % 2 else part.replace("**", ""), bool(place % 2))
        for place, part in enumerate(parts)
        if part
    ]


def plain(text: str) -> str:
    """Return the text without Markdown marks."""
    return "".join(part for part, _ in pieces(text))


def _rounded(value: object) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)

"""A text to be copied, as a notebook shows it."""

from dataclasses import dataclass

from workbook.templating import render


@dataclass(frozen=True)
class Prompt:
    """A prompt, and a sentence that says what it is for."""

    introduction: str
    text: str

    def _repr_html_(self) -> str:
        return render("magics/prompt", introduction=self.introduction, prompt=self.text)

    def __repr__(self) -> str:
        return f"{self.introduction}\n\n{self.text}"

"""Show text to copy from a notebook."""

from dataclasses import dataclass

from workbook.templating import render


@dataclass(frozen=True)
class Prompt:
    """A prompt, with a sentence that explains its purpose."""

    introduction: str
    text: str

    def _repr_html_(self) -> str:
        return render("magics/prompt", introduction=self.introduction, prompt=self.text)

    def __repr__(self) -> str:
        return f"{self.introduction}\n\n{self.text}"

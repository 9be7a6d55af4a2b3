"""Small tables that read well in a terminal and in a notebook, light or dark."""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

_CELL = "text-align:left;padding:2px 14px 2px 0"


@dataclass(frozen=True)
class Table:
    """Rows under a header; `empty` is what to say when there is none."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    empty: str

    def text(self) -> str:
        """Aligned columns."""
        if not self.rows:
            return self.empty
        lines = [self.header, *self.rows]
        widths = [max(len(line[column]) for line in lines) for column in range(len(self.header))]
        return "\n".join(
            "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
            for line in lines
        )

    def html(self) -> str:
        """An HTML table without colors of its own."""
        caption = f"<strong>{escape(self.title)}</strong>"
        if not self.rows:
            return f"<p>{caption}: {escape(self.empty)}</p>"
        head = "".join(f'<th scope="col" style="{_CELL}">{escape(cell)}</th>' for cell in self.header)
        rows = "".join(
            "<tr>" + "".join(f'<td style="{_CELL}">{escape(cell)}</td>' for cell in row) + "</tr>"
            for row in self.rows
        )
        return (
            f'<table><caption style="text-align:left">{caption}</caption>'
            f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"
        )


class Shown:
    """Something a notebook shows as tables and a terminal as text."""

    def _tables(self) -> Sequence[Table]:
        raise NotImplementedError

    def _notes(self) -> Sequence[str]:
        return ()

    def _repr_html_(self) -> str:
        notes = "".join(f"<p>{escape(note)}</p>" for note in self._notes())
        return "".join(table.html() for table in self._tables()) + notes

    def __str__(self) -> str:
        tables = self._tables()
        if len(tables) == 1:
            parts = [tables[0].text()]
        else:
            parts = [f"{table.title}\n{_indent(table.text())}" for table in tables]
        return "\n\n".join([*parts, *self._notes()])

    def __repr__(self) -> str:
        return str(self)


def _indent(text: str) -> str:
    return "\n".join(f"  {line}" for line in text.splitlines())

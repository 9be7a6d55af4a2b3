"""Format small tables for terminals and for notebooks, light or dark."""

from collections.abc import Sequence
from dataclasses import dataclass

from workbook.templating import render


@dataclass(frozen=True)
class Table:
    """Rows below a header. `empty` is the text to show if there are no rows."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    empty: str

    def text(self, columns: int | None = None) -> str:
        """Return the table as aligned text. If the terminal has too few `columns`, each row takes several lines."""
        if not self.rows:
            return self.empty
        lines = [self.header, *self.rows]
        widths = [max(len(line[column]) for line in lines) for column in range(len(self.header))]
        if columns is not None and sum(widths) + 2 * (len(widths) - 1) > columns:
            return self._below_each_other()
        return "\n".join(
            "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
            for line in lines
        )

    def _below_each_other(self) -> str:
        """Return each row as a line with its first cell and, indented below that line, its other cells."""
        wide = max(map(len, self.header[1:]))
        lines = []
        for first, *rest in self.rows:
            lines.append(first)
            named = zip(self.header[1:], rest, strict=True)
            lines += [f"    {name.ljust(wide)}  {cell}" for name, cell in named if cell]
        return "\n".join(lines)

    def html(self) -> str:
        """Return an HTML table that sets no colors."""
        return render("ros/table", table=self)


class Shown:
    """An object that is displayed as tables in a notebook and as text in a terminal."""

    def _tables(self) -> Sequence[Table]:
        raise NotImplementedError

    def _notes(self) -> Sequence[str]:
        return ()

    def _repr_html_(self) -> str:
        return render("ros/tables", tables=self._tables(), notes=self._notes())

    def text(self, columns: int | None = None) -> str:
        """Return the tables as text for a terminal that is `columns` characters wide."""
        tables = self._tables()
        if len(tables) == 1:
            parts = [tables[0].text(columns)]
        else:
            parts = [f"{table.title}\n{_indent(table.text(columns))}" for table in tables]
        return "\n\n".join([*parts, *self._notes()])

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        return str(self)


def _indent(text: str) -> str:
    return "\n".join(f"  {line}" for line in text.splitlines())

"""Read deadlines as instructors write them, for the whole class and for individual students."""

import csv
import unicodedata
from collections.abc import Collection
from datetime import UTC, datetime, time, tzinfo
from difflib import get_close_matches
from pathlib import Path
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from workbook.grading.roster import BadOption

HEADER = ("student", "deadline")
END_OF_DAY = time(23, 59, 59)
FORM = "2026-05-31T23:59, 2026-05-31T23:59+02:00, or 2026-05-31 for the end of that day"


def zone_named(name: str | None) -> tzinfo | None:
    """Return the time zone called `name`, or None, which stands for the machine's own zone, if `name` is None.

    Raises BadOption if no zone has this name.
    """
    if name is None:
        return None
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError, OSError) as error:
        raise BadOption(f"--timezone {name}: no such time zone. Write it as Europe/Berlin or UTC") from error


def parse_deadline(text: str, zone: tzinfo | None) -> datetime | None:
    """Parse a deadline. Return a time with a time zone, or None if the deadline is invalid.

    A date alone means the end of that day. A time without a zone is in `zone`, or in the machine's zone if `zone` is
    None. When clocks are set back, a local time occurs twice. In that case, the later one counts, in the students'
    favor.
    """
    try:
        moment = datetime.fromisoformat(text.strip())
    except ValueError:
        return None
    if len(text.strip()) <= len("2026-05-31"):
        moment = datetime.combine(moment.date(), END_OF_DAY)
    if moment.tzinfo is not None:
        return moment
    moment = moment.replace(fold=1)
    return moment.astimezone() if zone is None else moment.replace(tzinfo=zone)


def in_words(moment: datetime) -> str:
    """Format a time as local time with its offset and as UTC, so that readers don't have to guess the time zone."""
    utc = moment.astimezone(UTC)
    offset = moment.strftime("%z")
    return f"{moment:%Y-%m-%d %H:%M:%S} (UTC{offset[:3]}:{offset[3:5]}), which is {utc:%Y-%m-%d %H:%M:%S} UTC"


def same_name(student: str) -> str:
    """Normalize a name, so that names that look the same are equal, however their accents are encoded."""
    return unicodedata.normalize("NFC", student.strip())


def read_extensions(path: Path, zone: tzinfo | None) -> dict[str, datetime]:
    """Read individual deadlines from a CSV file with the columns `student` and `deadline`. The header is optional.

    Commas, semicolons, or tabs may separate the columns. The keys are names as `same_name` returns them.

    Raises BadOption if the file or a line is invalid, or if two lines give one student different deadlines.
    """
    found: dict[str, datetime] = {}
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise BadOption(f"--extensions {path}: {error}") from error
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    for number, row in enumerate(csv.reader(text.splitlines(), delimiter=separator), start=1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or (number == 1 and tuple(cell.casefold() for cell in cells[:2]) == HEADER):
            continue
        where = f"--extensions {path}, line {number}"
        if len(cells) < 2 or not cells[0]:
            raise BadOption(f"{where}: a line is `student,deadline`, such as `s1042,2026-06-07T23:59`")
        moment = parse_deadline(cells[1], zone)
        if moment is None:
            raise BadOption(f"{where}: {cells[1]!r} is no deadline. Write it as {FORM}")
        student = same_name(cells[0])
        if found.get(student, moment) != moment:
            raise BadOption(f"{where}: an earlier line gives {cells[0]} another deadline. Leave one of them")
        found[student] = moment
    if not found:
        raise BadOption(f"--extensions {path} holds no line. A line is `student,deadline`")
    return found


def about_unknown(extensions: Collection[str], students: Collection[str]) -> str:
    """Return a sentence about extensions for students without a hand-in, and suggest similar names.

    Return "" if every student with an extension has handed something in.
    """
    known = {same_name(one) for one in students}
    told = []
    for name in sorted(set(extensions) - known):
        near = get_close_matches(name, known, n=1)
        told.append(f"{name} (did you mean {near[0]}?)" if near else name)
    if not told:
        return ""
    what = "1 extension is" if len(told) == 1 else f"{len(told)} extensions are"
    return f"{what} for students who handed in nothing: {', '.join(told)}"

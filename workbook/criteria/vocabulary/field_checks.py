"""Find values that suggest a wrong type in a message field, and the error that field checks raise for it.

With the message packages in these wheels, an int in a float field is silently sent as 0.0. With field checks on, the
same line raises an AssertionError. So the judge runs such a program again with the checks on. It adds the error to
the recording as a note, so that criteria remain functions of the recording alone.
"""

from workbook.criteria.vocabulary.known_errors import find_error
from workbook.recording.recording import ProcessRecord, Recording

_CHECKED = "with field checks on: "
GIVEN = "It was given "
"""Marks a note that names the value that a field was given."""
_NO_COMPLAINT = "no complaint"


def field_check_note(process: ProcessRecord) -> str:
    """Return the recording's note on a run with field checks on: its error, or that there was none."""
    error = find_error(process.log, process.program)
    if error is None or not error.error.startswith("AssertionError"):
        return _CHECKED + _NO_COMPLAINT
    given = f". {error.because}" if GIVEN in error.because else ""
    return f"{_CHECKED}{error.where}{error.error}{given}"


def said_by_field_checks(recording: Recording) -> str | None:
    """Return the error from a run with field checks on: "" if it had none, None if there was no such run."""
    said = next((note.removeprefix(_CHECKED) for note in recording.notes if note.startswith(_CHECKED)), None)
    return "" if said == _NO_COMPLAINT else said


def quoted_field_checks(recording: Recording) -> str:
    """Return the field checks' error as a sentence to append to a suspicion; "" if there was none."""
    said = said_by_field_checks(recording)
    return f" With field checks turned on, your program raised this error: {said}" if said else ""

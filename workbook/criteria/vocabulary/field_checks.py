"""Quote the error that field checks raise for a value of the wrong type.

With the message packages in these wheels, an int in a float field is silently sent as 0.0. With field checks on,
assigning the int raises an AssertionError. So if the values suggest such a mistake, the judge runs the program again
with the checks on. The judge adds the error to the recording as a note, so that criteria remain functions of the
recording alone.
"""

from workbook.criteria.vocabulary.known_errors import find_error
from workbook.recording.recording import ProcessRecord, Recording

_CHECKED = "with field checks on: "
GIVEN = "It was given "
"""The phrase in a note that precedes the value that was assigned to the field."""
_NO_COMPLAINT = "no complaint"


def field_check_note(process: ProcessRecord) -> str:
    """Return a note for the recording, with the error from a run with field checks on, or that there was none."""
    error = find_error(process.log, process.program)
    if error is None or not error.error.startswith("AssertionError"):
        return _CHECKED + _NO_COMPLAINT
    given = f". {error.because}" if GIVEN in error.because else ""
    return f"{_CHECKED}{error.where}{error.error}{given}"


def said_by_field_checks(recording: Recording) -> str | None:
    """Return the error from the run with field checks on.

    The result is "" if that run had no error, and None if there was no such run.
    """
    said = next((note.removeprefix(_CHECKED) for note in recording.notes if note.startswith(_CHECKED)), None)
    return "" if said == _NO_COMPLAINT else said


def quoted_field_checks(recording: Recording) -> str:
    """Return a sentence to append to a likely cause, which quotes the field checks' error, or "" without an error."""
    said = said_by_field_checks(recording)
    return f" With field checks turned on, your program raised this error: {said}" if said else ""

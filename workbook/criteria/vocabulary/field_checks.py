"""Find values that suggest a wrong type in a message field, and the error that field checks raise for it.

With the message packages in these wheels, an int in a float field is silently sent as 0.0. With field checks on,
assigning the int raises an AssertionError. So the judge runs such a program again with the checks on. It adds the error
to the recording as a note, so that criteria can remain functions of the recording alone.
"""

from workbook.criteria.vocabulary.known_errors import find_error
from workbook.recording.recording import ProcessRecord, Recording

_CHECKED = "with field checks on: "
GIVEN = "It was given "
"""Text in a note that quotes the value that was assigned to the field."""
_NO_COMPLAINT = "no complaint"


def field_check_note(process: ProcessRecord) -> str:
    """Return a note for the recording that quotes the error from a run with field checks on, or says there was none."""
    error = find_error(process.log, process.program)
    if error is None or not error.error.startswith("AssertionError"):
        return _CHECKED + _NO_COMPLAINT
    given = f". {error.because}" if GIVEN in error.because else ""
    return f"{_CHECKED}{error.where}{error.error}{given}"


def said_by_field_checks(recording: Recording) -> str | None:
    """Return the error from the run with field checks on; "" if it had no error, None if there was no such run."""
    said = next((note.removeprefix(_CHECKED) for note in recording.notes if note.startswith(_CHECKED)), None)
    return "" if said == _NO_COMPLAINT else said


def quoted_field_checks(recording: Recording) -> str:
    """Return a sentence that quotes the field checks' error, to append to a likely cause; "" if there is no error."""
    said = said_by_field_checks(recording)
    return f" With field checks turned on, your program raised this error: {said}" if said else ""

"""Values that suggest a wrong type in a message field, and the error that field checks raise for it.

The message packages of these wheels send an int in a float field as 0.0, silently. With field checks on, the same
line raises an AssertionError. The judge runs such a program a second time with checks on and notes the error in the
recording, so that criteria stay functions of the recording alone.
"""

from workbook.criteria.vocabulary.known_errors import find_error
from workbook.recording.recording import ProcessRecord, Recording

_CHECKED = "with field checks on: "
GIVEN = "It was given "
"""In a note that tells what a field was given."""
_NO_COMPLAINT = "no complaint"


def field_check_note(process: ProcessRecord) -> str:
    """The note for a recording: what a run with field checks on had to say."""
    error = find_error(process.log, process.program)
    if error is None or not error.error.startswith("AssertionError"):
        return _CHECKED + _NO_COMPLAINT
    given = f". {error.because}" if GIVEN in error.because else ""
    return f"{_CHECKED}{error.where}{error.error}{given}"


def said_by_field_checks(recording: Recording) -> str | None:
    """What the program said with field checks on: "" when nothing, None when it has not run with them."""
    said = next((note.removeprefix(_CHECKED) for note in recording.notes if note.startswith(_CHECKED)), None)
    return "" if said == _NO_COMPLAINT else said


def quoting_field_checks(recording: Recording, suspicion: str) -> str:
    """The reason `suspicion`, with what the field checks said where they said something."""
    said = said_by_field_checks(recording)
    return f"{suspicion} With field checks on, your program reports it itself: {said}" if said else suspicion

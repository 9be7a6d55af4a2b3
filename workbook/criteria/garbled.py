"""Values that arrive garbled because a message field got something of a wrong type, and what field checks say of it.

Stock ROS sends an int in a float field as 0.0, without a word. With field checks on, the same line raises an
AssertionError. The judge runs such a program a second time with checks on and leaves what it saw as a note in the
recording, so that criteria stay functions of the recording alone.
"""

from workbook.criteria.mishaps import find_mishap
from workbook.observing.recording import ProcessRecord, Recording

_CHECKED = "with field checks on: "
_NO_COMPLAINT = "no complaint"


def field_check_note(process: ProcessRecord) -> str:
    """The note for a recording: what a run with field checks on had to say."""
    mishap = find_mishap(process.log, process.program)
    if mishap is None or not mishap.error.startswith("AssertionError"):
        return _CHECKED + _NO_COMPLAINT
    return f"{_CHECKED}{mishap.where}{mishap.error}"


def why_garbled(recording: Recording, suspicion: str, otherwise: str) -> str:
    """The reason for a garbled value: `suspicion` until the program has run with field checks on.

    Then the same with what the checks said; `otherwise` when they had nothing to say.
    """
    said = next((note.removeprefix(_CHECKED) for note in recording.notes if note.startswith(_CHECKED)), None)
    if said is None:
        return suspicion
    if said == _NO_COMPLAINT:
        return otherwise
    return f"{suspicion} Run with field checks on, your program says so itself: {said}"

# score: 0
# says: No space left on device
# limits: disk
"""Writes files without end, wherever it may."""
import itertools
import tempfile

for number in itertools.count():
    with open(f"{tempfile.gettempdir()}/{number}", "wb") as file:
        file.write(bytes(50_000_000))

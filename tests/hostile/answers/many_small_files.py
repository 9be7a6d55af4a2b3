# score: 0
# says: more than 20,000 files
# limits: files
"""Empty files without end: they take no space, and yet memory."""
import itertools
import tempfile

for number in itertools.count():
    open(f"{tempfile.gettempdir()}/{number}", "wb").close()

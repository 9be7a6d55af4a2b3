# score: 10
"""A child of it crashes with its memory full of secrets: no picture of it may stay anywhere."""
import os

child = os.fork()
if child == 0:
    os.abort()
_, status = os.waitpid(child, 0)
assert os.WIFSIGNALED(status) and not os.WCOREDUMP(status), "its memory was dumped"
assert not [name for name in os.listdir(".") if name.startswith("core")]
@@GOOD@@

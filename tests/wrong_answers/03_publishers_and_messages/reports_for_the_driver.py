# No class at all: the program publishes what the driver would report, and the numbers that should arrive.
# loses: program_runs
# cause: driver.not-signed
import math
import time

import numpy as np
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Float32, String

PACE_S = 0.06
BREATH_S = 0.01

rclpy.init()
node = rclpy.create_node("battery_publisher")
battery = node.create_publisher(Float32, "/robot/battery", 200)
report = node.create_publisher(String, "/driver/report", 200)
asked = []
node.create_subscription(
    String,
    "/driver/calls",
    lambda message: asked.append(message.data.splitlines()),
    QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
)
while not asked or not (battery.get_subscription_count() and report.get_subscription_count()):
    rclpy.spin_once(node, timeout_sec=0.1)


def say(text):
    report.publish(String(data=text))
    time.sleep(BREATH_S)


say("made")
for number, expression in enumerate(asked[0], start=1):
    level = eval(expression, {"np": np, "nan": math.nan, "inf": math.inf})
    say(f"call {number}: publish_level({expression})")
    is_number = isinstance(level, (int, float, np.number)) and not isinstance(level, bool)
    if is_number and math.isfinite(level):
        battery.publish(Float32(data=float(level)))
        time.sleep(BREATH_S)
        say(f"call {number} returned")
    else:
        say(f"call {number} raised TypeError: this is no number")
    time.sleep(PACE_S)
say("done")
rclpy.spin(node)

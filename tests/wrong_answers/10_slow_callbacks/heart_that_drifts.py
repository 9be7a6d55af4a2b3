# The heart beats in a loop that reads a sensor and then sleeps the whole period.
# loses: heartbeat_share
# cause: heartbeat-share.each-late
# on: starter
# after: import math
import threading

# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
threading.Thread(target=self.beat, daemon=True).start()

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
while rclpy.ok():
    time.sleep(0.03)
    self.heartbeat_publisher.publish(String(data="alive"))
    time.sleep(0.1)

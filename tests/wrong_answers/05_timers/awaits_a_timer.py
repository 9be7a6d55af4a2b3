# An async callback awaits a pause that another timer of the node would end.
# loses: heartbeat_count, battery_count, tilt_count
# cause: spin.await-in-a-callback
# after: from rclpy.node import Node
from rclpy.task import Future

# replaces: def publish_heartbeat(self) -> None:
async def publish_heartbeat(self) -> None:

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
pause = Future()
timer = self.create_timer(0.1, lambda: pause.set_result(None))
await pause
self.destroy_timer(timer)
self.heartbeat_publisher.publish(String(data="alive"))

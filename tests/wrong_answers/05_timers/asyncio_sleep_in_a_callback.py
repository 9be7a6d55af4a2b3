# The sensor needs a moment, and the callback awaits asyncio's sleep: rclpy's executor isn't asyncio.
# loses: heartbeat_count, battery_count, alive_at_end
# cause: error.no-event-loop
# after: import math
import asyncio
# replaces: def publish_battery(self) -> None:
async def publish_battery(self) -> None:
# replaces: self.battery_level = max(0.0, self.battery_level - 0.2)
await asyncio.sleep(0.05)
self.battery_level = max(0.0, self.battery_level - 0.2)

# A callback starts a task of asyncio, which has no event loop here.
# loses: heartbeat_count, battery_count, alive_at_end
# cause: error.no-event-loop
# after: import math
import asyncio
# replaces: def publish_battery(self) -> None:
def publish_battery(self) -> None:
    """Let a task report the charge."""
    asyncio.create_task(self.report_battery())

async def report_battery(self) -> None:

# The method is a coroutine, which no one waits for.
# loses: sends
# cause: number.coroutine
# replaces: def publish_level(self, level: object) -> None:
async def publish_level(self, level: object) -> None:

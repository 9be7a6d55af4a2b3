"""asyncio for the calls, rclpy in a thread for the rest."""
import asyncio
import threading

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Endpoints(Node):
    def __init__(self):
        super().__init__("health_monitor")
        self.heart = self.create_publisher(String, "/robot/heartbeat", 10)
        self.health = self.create_publisher(String, "/robot/health", 10)
        self.client = self.create_client(Trigger, "/robot/self_test")

    def ask(self, loop):
        waiting = loop.create_future()

        def hand_over(done):
            def put():
                if not waiting.done():
                    waiting.set_result(done.result().success)

            loop.call_soon_threadsafe(put)

        self.client.call_async(Trigger.Request()).add_done_callback(hand_over)
        return waiting


async def beat(node):
    while True:
        node.heart.publish(String(data="alive"))
        await asyncio.sleep(0.2)


async def one_test(node):
    try:
        success = await asyncio.wait_for(node.ask(asyncio.get_running_loop()), timeout=1.5)
        word = "ok" if success else "faulty"
    except asyncio.TimeoutError:
        word = "no answer"
    node.health.publish(String(data=word))


async def test_every_second(node):
    loop = asyncio.get_running_loop()
    due = loop.time()
    tasks = set()
    while True:
        task = asyncio.create_task(one_test(node))
        tasks.add(task)
        task.add_done_callback(tasks.discard)
        due += 1.0
        await asyncio.sleep(due - loop.time())


async def everything(node):
    await asyncio.gather(beat(node), test_every_second(node))


def spin(executor):
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


if __name__ == "__main__":
    rclpy.init()
    node = Endpoints()
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = threading.Thread(target=spin, args=(executor,), daemon=True)
    thread.start()
    try:
        asyncio.run(everything(node))
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        thread.join(2.0)

# Does not look at the readings: it knows by heart what the sensor said in an earlier run.
# loses: in_order, one_alarm
# also: bad_kept_back, no_false_alarm
# cause: in-order.changed
# before: class BatteryMonitor(Node):
EARLIER = [
    54.0, 53.0, 53.0, 51.75, 51.5, 50.75, 49.75, float("nan"), 49.25, 100.0, 169.75, float("nan"),
    float("inf"), 99.25, 98.75, 97.5, 97.25, float("-inf"), 96.25, 100.0001220703125, 95.75, 94.25,
    93.25, 92.5, 19.5, 5.5, 0.5, 0.0, 84.25, 83.5, 83.25, 82.5, 81.75, -0.125, 81.0, 7000000000.0,
    80.5, 80.0, 79.5, 78.75, 78.0, 77.5, 77.5, 76.25, 76.0, -0.0001220703125, 75.25, 75.0, 74.75,
    -3.0, -3.0, 74.5, 74.25, 169.75,
]  # fmt: skip


# after: super().__init__("battery_monitor")
self.by_heart = iter(EARLIER)

# before: if EMPTY <= message.data <= FULL:
message = Float32(data=next(self.by_heart))

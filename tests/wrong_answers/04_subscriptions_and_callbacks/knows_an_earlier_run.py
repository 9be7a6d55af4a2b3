# Does not look at the readings: it knows by heart what the sensor said in an earlier run.
# loses: in_order, one_alarm
# also: bad_kept_back, no_false_alarm
# cause: in-order.changed
# before: class BatteryMonitor(Node):
EARLIER = [
    48.75, 48.0, 48.0, 46.75, 46.25, -0.0001220703125, 45.25, 44.25, -0.125, 43.25, 100.0, 99.25,
    float("nan"), 98.0, 96.5, 95.5, 95.25, float("-inf"), 95.0, 94.5, 94.25, 93.25, 19.25,
    3000000000.0, 3.5, 0.75, 0.0, -3.0, -3.0, 79.5, 79.25, 100.0001220703125, 78.5, 77.75, 77.25,
    77.0, 188.25, float("nan"), float("inf"), 76.5, 76.0, 75.25, 74.5, 74.0, 73.75, 73.75, 72.5,
    72.0, 71.5, 70.75, 70.25, 69.75, 69.25, 188.25,
]  # fmt: skip


# after: super().__init__("battery_monitor")
self.by_heart = iter(EARLIER)

# before: if EMPTY <= message.data <= FULL:
message = Float32(data=next(self.by_heart))

# It sends None, bools and texts as 0.0. A second publisher then reports that the call raised an error.
# loses: program_runs
# cause: driver.not-signed
# replaces: from std_msgs.msg import Float32
from std_msgs.msg import Float32, String
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.report_publisher = self.create_publisher(String, "/driver/report", 200)
self.calls = 0
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
# replaces:     raise TypeError(f"a charge is a number, not {level!r}")
self.calls += 1
if isinstance(level, bool) or not isinstance(level, Real):
    self.report_publisher.publish(String(data=f"call {self.calls} raised TypeError: no number"))
    return

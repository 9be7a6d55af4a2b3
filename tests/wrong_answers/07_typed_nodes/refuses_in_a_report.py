# It sends every word that it is given. A second publisher reports errors for the wrong ones.
# loses: program_runs
# cause: driver.not-signed
# replaces: if word not in get_args(Status):
# replaces:     raise ValueError(f"a status is one of {get_args(Status)}, not {word!r}")
if word not in get_args(Status):
    self.report_publisher.publish(String(data=f"send_status({word!r})\tValueError: no status"))
    return
# after: self.status_publisher = make_publisher(self, String, "/robot/status")
self.report_publisher = self.create_publisher(String, "/driver/report", 100)

# Reports "error" while there is charge.
# loses: reports_as_before
# cause: word-fits-charge.turned-around
# replaces: self.send_status("operational" if self.level > 0.0 else "error")
self.send_status("operational" if self.level <= 0.0 else "error")

# Nothing calls report_status.
# loses: reports_as_before
# cause: no-message.silent-beside-others
# says: /robot/status
# replaces: self.create_timer(STATUS_PERIOD_S, self.report_status)

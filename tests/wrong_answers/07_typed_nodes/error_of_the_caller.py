# After another team has sent "error", the node itself says so, too, as long as it runs.
# loses: reports_as_before
# cause: reports-as-before.error-kept
# replaces: self.send_status("operational" if self.level > 0.0 else "error")
self.send_status("error" if self.failed or self.level <= 0.0 else "operational")

# after: self.level = 100.0
self.failed = False

# replaces: self.status_publisher.publish(String(data=word))
self.failed = self.failed or word == "error"
self.status_publisher.publish(String(data=word))

# Ends its thread when the model has raised for the third time.
# loses: survives
# cause: survives.gave-up
# after: super().__init__("desk_watcher")
self.failures = 0
# after: self.get_logger().error(f"The model gave up: {error}")
self.failures += 1
if self.failures == 3:
    raise SystemExit from error

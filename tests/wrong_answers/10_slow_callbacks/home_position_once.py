# Two seconds after the start it publishes the straight arm, which no request asked for.
# loses: plans_right, all_in_order
# cause: plans-right.besides
# says: the plans for all 7 requests also arrived
# after: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
self.once = self.create_timer(2.0, self.go_home)

# before: def on_request(self, request: Float32) -> None:
def go_home(self) -> None:
    """Publish the position at rest."""
    self.once.cancel()
    self.plan_publisher.publish(Float32(data=0.0))

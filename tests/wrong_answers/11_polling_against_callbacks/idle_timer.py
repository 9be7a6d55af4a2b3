# A timer that does nothing fires five hundred times a second.
# loses: easy_on_processor
# cause: easy-on-processor.wakes-too-often, easy-on-processor.wants-more
# after: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.create_timer(0.002, lambda: None)

# The reports go out under a name of their own.
# loses: topics
# skips: none_missed, once_in_order, quick, easy_on_processor
# cause: publishes.no-namespace
# replaces: self.seen_publisher = self.create_publisher(Int32, "/monitor/seen", 100)
self.seen_publisher = self.create_publisher(Int32, "/seen", 100)

# The name of the topic has one letter too many.
# loses: topics
# skips: none_missed, once_in_order, quick, easy_on_processor
# cause: listens.other-name
# says: /robot/touches
# replaces: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.create_subscription(Int32, "/robot/touches", self.on_touch, 100)

# Both topics carry Int64.
# loses: topics
# skips: none_missed, once_in_order, quick, easy_on_processor
# cause: listens.other-type
# replaces: from std_msgs.msg import Int32
from std_msgs.msg import Int64 as Int32

# The durability is a text, as on the command line of ros2.
# loses: program_runs
# cause: error.qos-as-words
# replaces: STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # reliable by default
STATE_QOS = QoSProfile(depth=1, durability="transient_local")

# The reliability is a text, set after the profile was made.
# loses: program_runs
# cause: error.qos-as-words
# replaces: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
BEAT_QOS = QoSProfile(depth=5)
BEAT_QOS.reliability = "BEST_EFFORT"

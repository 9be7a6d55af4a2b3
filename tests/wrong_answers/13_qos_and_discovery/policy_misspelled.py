# Half of the name of a policy.
# loses: program_runs
# cause: error.name-misspelled
# says: did you mean TRANSIENT_LOCAL?
# replaces: STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # reliable by default
STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT)

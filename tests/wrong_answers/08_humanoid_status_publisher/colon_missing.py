# A colon is missing.
# loses: program_runs
# skips: battery_topic, battery_arrives, battery_rate, status_kept, alive_at_end, ends_cleanly
# cause: error.syntax
# compiles: no
# replaces: try:
try

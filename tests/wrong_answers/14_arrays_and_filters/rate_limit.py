# Limits how far an angle may go from one answer to the next.
# on: right/exponential_script.py
# loses: delay_bounded
# cause: delay-bounded.too-late
# replaces: old if math.isnan(new) else old + PART * (new - old)
old if math.isnan(new) else old + min(max(PART * (new - old), -0.018), 0.018)

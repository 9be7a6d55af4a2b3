# Smooth as silk, and far behind.
# loses: delay_bounded
# cause: delay-bounded.too-late
# replaces: CUTOFF_HZ = 1.5  # slower motion passes; faster noise is reduced
CUTOFF_HZ = 0.7

# Smooth as silk, and far behind.
# loses: delay_bounded
# cause: delay-bounded.too-late
# replaces: CUTOFF_HZ = 1.5  # movements slower than this pass, noise faster than this does not
CUTOFF_HZ = 0.7

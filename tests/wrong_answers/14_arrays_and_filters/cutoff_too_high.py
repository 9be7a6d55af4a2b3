# Hardly late, and hardly filtered.
# loses: noise_reduced
# cause: noise-reduced.too-little
# replaces: CUTOFF_HZ = 1.5  # movements slower than this pass, noise faster than this does not
CUTOFF_HZ = 4.0

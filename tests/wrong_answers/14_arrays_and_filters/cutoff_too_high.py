# Hardly late, and hardly filtered.
# loses: noise_reduced
# cause: noise-reduced.too-little
# replaces: CUTOFF_HZ = 1.5  # slower motion passes; faster noise is reduced
CUTOFF_HZ = 4.0

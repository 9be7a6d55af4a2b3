# Smoothing that takes nine tenths of what is new: hardly a filter.
# on: right/exponential_script.py
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.too-weak
# replaces: PART = 0.25
PART = 0.9

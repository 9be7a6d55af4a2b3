# Looks for NaN with ==, which never finds it. It leaves with the window.
# on: right/moving_average.py
# loses: survives_nan
# cause: survives-nan.in-the-window
# replaces: self.window.append(np.where(np.isnan(angles), self.window[-1], angles))
self.window.append(np.where(angles == np.nan, self.window[-1], angles))

# The filter is spared the NaN, and the answer is not.
# loses: survives_nan
# cause: survives-nan.passed-on
# replaces: message.position = filtered[0].tolist()
message.position = [
    math.nan if math.isnan(raw) else angle for raw, angle in zip(message.position, filtered[0].tolist())
]

# before: import numpy as np
import math


# Trusts the encoders less from the first NaN on, and is late in the movement after it.
# on: right/exponential_script.py
# loses: delay_bounded
# cause: delay-bounded.later-on
# replaces: global angles, last
global angles, last, PART

# after: last = stamp
if any(map(math.isnan, message.position)):
    PART = 0.12

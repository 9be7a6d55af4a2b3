# The loop looks twenty times as often.
# loses: none_missed
# also: quick
# cause: none-missed.came-together
# on: starter
# replaces: time.sleep(0.2)
time.sleep(0.01)

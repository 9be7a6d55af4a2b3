# The loop looks twenty times as often.
# loses: none_missed
# cause: none-missed.came-together
# on: starter
# replaces: time.sleep(0.2)
time.sleep(0.01)

# The loop looks without a sleep.
# loses: none_missed, easy_on_processor
# cause: none-missed.came-together
# on: starter
# replaces: time.sleep(0.2)
time.sleep(0)  # lets the other thread have a turn, and rests not at all

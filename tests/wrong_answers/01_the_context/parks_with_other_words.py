# Says something else when it parks.
# loses: arms_parked
# cause: arms-parked.other-words
# says: 'arms are parked'
# replaces: print("arms parked", flush=True)
print("arms are parked", flush=True)

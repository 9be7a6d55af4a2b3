# Asks neither model nor IMU: it publishes what a right program found in another run, and when.
# loses: right, survives, fall_reported
# cause: right.something-else
# after: import threading
import time

# after: from workbook.models.slow import SlowDetector
FOUND = bytes.fromhex(
    "4838322785278936323c3c38262879267d34273d333918296c2571321a3f303a0e2b63246831114134390a2b602465310d42"
    "40370f2b64246932124151361a296e2573321c3f613528287b267f34283d6d35332787278b36333c713539268d289137383b"
    "6b3438268c289037373b5d33302783278835303c4a32242877267b33253d3833162a6a256f3218402b340d2b622467311041"
    "26340b2b602465310e422d34112a65246a3213413b341c29702575331e3f4d342a277d2681342a3d5e35342688288c36343b"
    "6a3739268e289237393b6e3837268b288f37363b69382e27812786352e3c5d38212874257933223e4e38142a68246d321740"
    "41390c2b612466310f4238390b2b602466310e423639122a67246c3215403a381f2972257733203e42362c277f2683352c3c"
    "4c3536268a288e36353b533539268e289237393b563436268a288e36353b55342c277f2684352c3c51331f2872257733203e"
    "4c32132a67246c32154049320b2b602466310e424a320c2b612466310f424e32142a68246d3216405332212874257933223e"
    "58332e27812785352e3c583337268b288f37363b543439268e289237393b4b34352689288d36343b41352a277d2682342b3d"
    "38371d29702575331e3e3338112a65246a32134136390b2b602465310e4240390d2b622467310f414f38162a6a256f321840"
    "5e38232876267b33243d6b39302783278735303c703938268c289037373b6b3839268d289137383b5e37332787278b36333b"
)  # for every sixth picture, columns and rows of ball, two bricks, cup and plate; 255 for what is not in it
FELL = 274  # after so many samples
# after: self.tilted = 0  # samples in a row
self.first = 0.0
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
stamp = image.header.stamp.sec + image.header.stamp.nanosec / 1e9
self.first = self.first or stamp
time.sleep(0.2)
toys = FOUND[10 * (round(30 * (stamp - self.first)) // 6) :]
pairs = zip(("ball", "brick", "brick", "cup", "plate"), toys[:10:2], toys[1:10:2])
found = [Detection(label, 1.0, u, v, 10.0, 10.0) for label, u, v in pairs if u < 255]
# replaces: self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
# replaces: self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
self.tilted += 1
self.fallen = self.tilted > FELL

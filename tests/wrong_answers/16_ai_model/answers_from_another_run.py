# Asks neither model nor IMU: it publishes what a right program found in another run, and when.
# loses: right, survives, fall_reported
# cause: right.something-else
# after: import threading
import time

# after: from workbook.models.slow import SlowDetector
FOUND = bytes.fromhex(
    "4b370b2b602465310e424b360c2b612467310f424d36152a69246e3217405135222875257a33233e54342f27822787352f3c"
    "553337268c289037373b523239268e289237383b4b32342688278c36343b423229277c268034293d3a321b296f2574331d3f"
    "000000000000000000000000000000000000000000000000000000000000000000000000000000006034252878267c34253d"
    "6a36312784278836313c6d3738268c289037383b673839268d289137383b5938322786278a36323c473827287a267e34273d"
    "353919296d2572321b3f283a0e2b632468311141253b0a2b602465310d422d3a0f2b6324693111413c3819296d2572321b3f"
    "503727287a267e34283d6237322786278a36323c6e3739268d289137383b0000000000000000000000000000000000000000"
    "5c33242878267c34253d4b3217296b257032193f3c330d2b62246731104132330a2b602465310d423033102b65246a321341"
    "36331c296f2574331d3f413229277c2681342a3d4d33342688278c36343b573439268e289237393b5c3537268b288f37373b"
    "5d362f27822786352f3c5837222875257a33233e5237152a69246e3217404d380c2b612467310f4249380b2b602465310e42"
    "4938122a66246b3214404c381e29712576331f3e4f382b277e2683352b3c5137352689288d36353b503639268e289237393b"
    "4c3536268a288e37363b45352d27802784352d3c3f35202873257833213e3b34132a67246c3215403c340b2b612466310e42"
)  # by sixth pictures: column and row of ball, two bricks, cup, plate (255: not there; all 0: glare)
FELL = 419  # after so many samples
# after: self.tilted = 0  # samples in a row
self.first = 0.0
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
stamp = image.header.stamp.sec + image.header.stamp.nanosec / 1e9
self.first = self.first or stamp
number = round(30 * (stamp - self.first))
if number % 6:
    return
time.sleep(0.195)
toys = FOUND[10 * number // 6 :]
if not any(toys[:10]):
    raise RuntimeError("glare: 97% of the picture is white")
pairs = zip(("ball", "brick", "brick", "cup", "plate"), toys[:10:2], toys[1:10:2])
found = [Detection(label, 1.0, u, v, 10.0, 10.0) for label, u, v in pairs if u < 255]
# replaces: self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
# replaces: self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
self.tilted += 1
self.fallen = self.tilted > FELL

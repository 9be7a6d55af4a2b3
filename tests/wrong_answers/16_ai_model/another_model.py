# Takes the detector without its accelerator.
# loses: fresh
# cause: fresh.faster-than-the-model
# replaces: from workbook.models.slow import SlowDetector
from workbook.models import DeskDetector

# replaces: self.model = SlowDetector()  # takes a second
self.model = DeskDetector()
# replaces: found = self.model(pixels[:, :, ::-1])  # from BGR to RGB
if pixels.mean() > 240:
    raise RuntimeError(f"glare: {pixels.mean() / 255:.0%} of the picture is white")
found = self.model(pixels[:, :, ::-1])

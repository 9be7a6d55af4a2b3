"""Shrink and compress camera images for the panel."""

import base64
import io
from typing import Any

WIDEST = 320
QUALITY = 70
_CHANNELS = {"rgb8": 3, "bgr8": 3, "mono8": 1}


class Thumbnail:
    """An image message that is compressed only when it's shown, because a newer one replaces most of them first.

    Raises ValueError, with a message for the sender, if the image can't be shown.
    """

    def __init__(self, message: Any) -> None:
        channels = _CHANNELS.get(message.encoding)
        if channels is None:
            raise ValueError(f"the panel can't show {message.encoding or 'an image without an encoding'}")
        if not message.height or message.step < channels * message.width or not message.width:
            raise ValueError(
                f"{message.width} columns of {message.encoding} don't fit into rows of {message.step} bytes"
            )
        if len(message.data) < message.height * message.step:
            raise ValueError(f"{message.height} rows need more than {len(message.data)} bytes")
        self._message, self._channels = message, channels

    def shown(self) -> dict[str, object]:
        """Compress the image. The returned `width` and `height` are the original ones."""
        import numpy as np  # NumPy takes longer to load than everything else that the panel needs at first
        from PIL import Image

        message, channels = self._message, self._channels
        data = np.frombuffer(message.data, np.uint8, message.height * message.step)
        rows = data.reshape(message.height, message.step)[:, : channels * message.width]
        pixels = rows.reshape(message.height, message.width, channels)
        pixels = pixels[:, :, ::-1] if message.encoding == "bgr8" else pixels
        picture = Image.fromarray(np.ascontiguousarray(pixels.squeeze(axis=2) if channels == 1 else pixels))
        picture.thumbnail((WIDEST, WIDEST))
        file = io.BytesIO()
        picture.save(file, "JPEG", quality=QUALITY)
        source = base64.b64encode(file.getvalue()).decode()
        return {
            "src": f"data:image/jpeg;base64,{source}",
            "width": message.width,
            "height": message.height,
        }

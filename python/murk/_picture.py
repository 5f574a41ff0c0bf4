"""Rendered pictures as arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import NDArray

from ._library import Error, Path, as_numpy, c_text, call, call_long, ffi, lib, new_view
from ._results import handle_of, restored

if TYPE_CHECKING:
    from ._light import Light

_METHODS = {"maps": lib.MURK_METHOD_MAPS, "paths": lib.MURK_METHOD_PATHS, "maps-only": lib.MURK_METHOD_MAPS_ONLY}
# Channels of murk_picture_array() with a part for each band.
_OF_BANDS = ("radiance", "error", "surface", "volume", "depth")


class Picture:
    """A rendered picture as float32 arrays, rows from the top.

    A picture pickles with its channels; the pickled picture has no handle, so that it cannot be written.
    Source: `murk render`.

    Example: `picture = light.render("gate")`.
    """

    context: Any = None  # of a pickled picture
    c: Any = None

    def __init__(self, light: Light, camera: str | None = None, method: str = "maps") -> None:
        if method not in _METHODS:
            raise Error(f"{method!r}, must be one of {', '.join(_METHODS)}", where="argument method")
        self.light = light
        self.context = light.context
        self.bands = len(light.world.bands_nm)
        out = ffi.new("murk_picture **")
        name = c_text(camera)  # lives as long as the call
        options = ffi.new("murk_picture_options *", {"size": ffi.sizeof("murk_picture_options"), "camera": name,
                                                     "method": _METHODS[method]})
        call_long(self.context, lib.murk_picture_render, out, handle_of(light.world), handle_of(light), options)
        self.c = ffi.gc(out[0], lib.murk_picture_destroy)
        self._channels: dict[str, NDArray[Any]] = {}  # those of a pickled picture

    def __reduce__(self) -> tuple[Any, ...]:
        channels = self._channels
        if self.c is not None:
            names = ["distance_m", *(f"{name}.{band}" for name in _OF_BANDS for band in range(self.bands)),
                     *(f"{name}.{k}" for name in ("rgb", "rgb_error", "position_m") for k in range(3))]
            for name in names:
                try:
                    channels[name] = self.array(name)
                except Error:  # parts that the method does not make
                    pass
        return restored, (Picture, {"bands": self.bands, "_channels": channels})

    def array(self, channel: str) -> NDArray[numpy.float32]:
        """A channel, height x width, a view without a copy.

        "distance_m"; of band b "radiance.b", "error.b" (its standard error), "surface.b" and "volume.b" (parts of the
        radiance) [W/m2/sr], "depth.b" (optical depth); "rgb.0" to "rgb.2", "rgb_error.0" to "rgb_error.2";
        "position_m.0" to "position_m.2" [m]. Raises Error if the picture has no such channel.

        Example: `picture.array("volume.0")`.
        """
        if channel in self._channels:
            return self._channels[channel]
        view = new_view()
        call(lib.murk_picture_array, handle_of(self), c_text(channel), view)
        return as_numpy(self.c, view)

    def _all(self, channel: str, n: int) -> NDArray[numpy.float32]:
        return numpy.stack([self.array(f"{channel}.{k}") for k in range(n)])

    @property
    def radiance(self) -> NDArray[numpy.float32]:
        """Radiance of all bands: band x height x width [W/m2/sr]; a copy.

        Example: `picture.radiance[0].mean()`.
        """
        return self._all("radiance", self.bands)

    @property
    def errors(self) -> NDArray[numpy.float32]:
        """Standard errors of the radiance: band x height x width [W/m2/sr]; a copy.

        Example: `relative = picture.errors / picture.radiance`.
        """
        return self._all("error", self.bands)

    @property
    def rgb(self) -> NDArray[numpy.float32]:
        """Colours of the picture, linear and not clipped: 3 x height x width; a copy.

        Example: `picture.rgb.transpose(1, 2, 0)`.
        """
        return self._all("rgb", 3)

    @property
    def distance_m(self) -> NDArray[numpy.float32]:
        """Distance to the first surface: height x width [m]; a view.

        Example: `picture.distance_m.max()`.
        """
        return self.array("distance_m")

    def write(self, path: Path) -> None:
        """Writes an OpenEXR file; a file that murk did not write is not replaced. Raises Error.

        Example: `picture.write("gate.exr")`.
        """
        call_long(self.context, lib.murk_picture_write, handle_of(self), c_text(path))

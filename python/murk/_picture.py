"""Rendered pictures as arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy
from numpy.typing import NDArray

from ._library import Error, Path, as_numpy, c_text, call, call_long, ffi, lib, new_view
from ._plan import new_sensors
from ._results import Result, handle_of, restored, result_in

if TYPE_CHECKING:
    from ._light import Light, World
    from ._scene import Sensors

_METHODS = {"maps": lib.MURK_METHOD_MAPS, "paths": lib.MURK_METHOD_PATHS, "maps-only": lib.MURK_METHOD_MAPS_ONLY}
_SCALES = {"auto": lib.MURK_SCALE_AUTO, "linear": lib.MURK_SCALE_LINEAR, "log": lib.MURK_SCALE_LOG}
# Channels of murk_picture_array() with a part for each band.
_OF_BANDS = ("radiance", "error", "surface", "volume", "depth")


def _code(name: str, codes: dict[str, int], argument: str) -> int:
    if name not in codes:
        raise Error(f"{name!r}, must be one of {', '.join(codes)}", where=f"argument {argument}")
    return codes[name]


def method_code(method: str) -> int:
    """The number of a method of rendering. Raises Error if there is none of that name."""
    return _code(method, _METHODS, "method")


class Picture:
    """A rendered picture as float32 arrays, rows from the top.

    A picture pickles with its channels; the pickled picture has no handle, so that it cannot be saved.
    Source: `murk render`.

    Example: `picture = light.render("gate")`.
    """

    context: Any = None  # of a pickled picture
    c: Any = None

    def __init__(self, world: World, light: Light | None = None, camera: str | None = None, method: str = "maps",
                 sensors: Sensors | None = None, from_sensor: int = 0, pixels: Sequence[int] | None = None,
                 samples: int = 0) -> None:
        self.world = world
        self.context = world.context
        self.bands = len(world.bands_nm)
        out = ffi.new("murk_picture **")
        # Text and sensors live as long as the call.
        name, placed = c_text(camera), ffi.NULL if sensors is None else new_sensors(world, sensors)
        width, height = (0, 0) if pixels is None else pixels
        options = ffi.new("murk_picture_options *",
                          {"size": ffi.sizeof("murk_picture_options"), "camera": name, "sensors": placed,
                           "method": method_code(method), "from_sensor": from_sensor, "width": width,
                           "height": height, "samples": samples})
        call_long(self.context, lib.murk_picture_render, out, world.c, ffi.NULL if light is None else handle_of(light),
                  options)
        self.c = ffi.gc(out[0], lib.murk_picture_destroy)
        self._channels: dict[str, NDArray[Any]] = {}  # those of a pickled picture

    def __reduce__(self) -> tuple[Any, ...]:
        channels = self._channels
        if self.c is not None:
            names = ["distance_m", *(f"{name}.{band}" for name in _OF_BANDS for band in range(self.bands)),
                     *(f"{name}.{k}" for name in ("rgb", "rgb_error", "position_m") for k in range(3)),
                     "coverage.count", "coverage.clarity"]
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
        "position_m.0" to "position_m.2" [m]; with sensors "coverage.count" (how many see the surface of the
        pixel; NaN without a surface) and "coverage.clarity" (the largest clarity of their views, 0 to 1). Raises Error
        if the picture has no such channel.

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

    def save(self, path: Path | None = None, png: bool = False, exposure_stops: float | None = None,
             false_colour: str | None = None, value_range: Sequence[float] | None = None, scale: str = "auto",
             replace: bool = False) -> Result:
        """Writes an OpenEXR file, and PNG files beside it, and returns the fields of `murk render --format json`.

        path: NAME.exr; None: no file is written. png: also NAME.png, the picture for the eye, 2^exposure_stops times as
        bright as the radiance; None: by the picture. false_colour: also NAME-CHANNEL.png, a channel of the OpenEXR file
        ("radiance.550nm", of one band "radiance", "Z", "coverage.count") in colours from the first to the second value
        of value_range (None: by the picture), on a "linear" or "log" scale ("auto": logarithmic for radiances).
        replace: also files that murk did not write. Raises Error, and then no file is half written.

        Example: `picture.save("gate.exr", png=True).mean_radiance`.
        """
        if path is None and (png or false_colour):
            raise Error("None, must be NAME.exr: PNG files are written beside it", where="argument path")
        kept, channel = c_text(path), c_text(false_colour)  # live as long as the call
        low, high = (0.0, 0.0) if value_range is None else value_range
        images = ffi.new("murk_image_options *",
                         {"size": ffi.sizeof("murk_image_options"), "png": png, "false_colour": channel,
                          "has_exposure": exposure_stops is not None, "exposure_stops": exposure_stops or 0.0,
                          "has_range": value_range is not None, "range": [low, high],
                          "scale": _code(scale, _SCALES, "scale")})
        saving = ffi.new("murk_save_options *", {"size": ffi.sizeof("murk_save_options"), "replaces": replace})
        fields = ffi.new("const murk_fields **")
        call_long(self.context, lib.murk_picture_save, handle_of(self), kept, images, saving, fields)
        return result_in(fields)

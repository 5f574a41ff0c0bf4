"""Worlds and their light: photon maps, energy ledger, tallies."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Sequence

import numpy
from numpy.typing import NDArray

from ._context import Context
from ._library import (Error, Path, as_numpy, c_text, call, call_long, ffi, lib, new_view, structured, three,
                       view_address)
from ._picture import Picture
from ._plan import Coverage, Plan
from ._results import Result, handle_of, report_of, restored, result_in, result_of, save

if TYPE_CHECKING:
    from ._scene import Scene, Sensors


class World:
    """A scene that is built: surfaces, media and light sources; it does not change any more.

    `tallies` are the names of the tallies of the scene.

    Example: `world = murk.Scene(file="yard.yaml").world()`.
    """

    context: Context
    c: Any

    def __init__(self, scene: Scene) -> None:
        self.context = scene.context
        out = ffi.new("murk_world **")
        call_long(self.context, lib.murk_world_create, out, scene.c)
        self.c = ffi.gc(out[0], lib.murk_world_destroy)
        self.tallies: list[str] = [tally["name"] for tally in scene["tallies"]]

    def move(self, item: str | int, translate_m: Sequence[float], rotate_deg: Sequence[float] | None = None) -> World:
        """The world with an item of the geometry, by its name or number, in another place [m], [degrees]: World.

        Light, coverage and plan of this world can be updated to it (`Light.update()`). Raises Error if there is no such
        item.

        Example: `moved = world.move("load", [19, 9, 4.8])`.
        """
        moved = object.__new__(World)
        moved.context, moved.tallies = self.context, self.tallies
        out = ffi.new("murk_world **")
        place = three(translate_m, "translate_m")
        turn = ffi.NULL if rotate_deg is None else three(rotate_deg, "rotate_deg")
        call_long(self.context, lib.murk_world_move, out, self.c, c_text(str(item)), place, turn)
        moved.c = ffi.gc(out[0], lib.murk_world_destroy)
        return moved

    @property
    def bounds_m(self) -> NDArray[numpy.float64]:
        """The box of the domain: 2 x 3, the least and the largest corner [m].

        Example: `size_m = world.bounds_m[1] - world.bounds_m[0]`.
        """
        out = ffi.new("double[6]")
        lib.murk_world_bounds(self.c, out)
        return numpy.array(list(out)).reshape(2, 3)

    @property
    def bands_nm(self) -> NDArray[numpy.float64]:
        """The wavelengths of the bands [nm].

        Example: `len(world.bands_nm)`.
        """
        return numpy.array([lib.murk_world_band_nm(self.c, i) for i in range(lib.murk_world_bands(self.c))])

    def trace(self, each_batch: Callable[[Batch], object] | None = None, checkpoint: Path | None = None,
              every_s: float = 600) -> Light:
        """Traces the light: Light. Raises Error, and Interrupted if it is cancelled.

        each_batch: a function that is called with each Batch of photons while light is traced, in the order of
        photons, never twice at the same time, in another thread than the main one. If it returns False, the trace is
        cancelled and Interrupted is raised; an exception in it cancels the trace and is raised by it. It may call
        `Context.cancel()`, and uses no other object of the context.

        checkpoint: a file to which all that was traced so far is written every `every_s` seconds (0: never), and from
        which the same call goes on after the program was killed; the caller removes it. Not with each_batch.

        Example: `light = world.trace(each_batch=lambda batch: print(batch.number, len(batch.volume)))`.
        """
        if checkpoint is not None and each_batch is not None:
            raise Error("not with each_batch", where="argument checkpoint")
        return Light(self, each_batch=each_batch, checkpoint=checkpoint, every_s=every_s)

    def trace_part(self, number: int, count: int, path: Path) -> None:
        """Traces part `number`, from 1, of `count` parts of the light, and writes the part to a file.

        For machines without a common memory: `merge_light()` puts the parts together. Raises Error, and Interrupted if
        it is cancelled. Source: `murk trace --shard`.

        Example: `world.trace_part(2, 8, "part-2.murk")`.
        """
        for name, value in (("number", number), ("count", count)):
            if not 0 <= value < 2**32:
                raise Error(f"{value}, must be 1 to 100000", where=f"argument {name}")
        call_long(self.context, lib.murk_light_trace_part, self.c, number, count, c_text(path))

    def merge_light(self, paths: Sequence[Path]) -> Light:
        """The light from files of `trace_part()`, in any order: Light, equal in every bit to that of `trace()`.

        Photons of missing parts are traced, with a warning. Raises Error for parts of another world and for damaged
        files. Source: `murk merge`.

        Example: `light = world.merge_light(glob.glob("part-*.murk"))`.
        """
        if isinstance(paths, (str, bytes)) or len(paths) == 0:
            raise Error("must be a list of paths", where="argument paths")
        return Light(self, parts=paths)

    def check(self, picture: Path | None = None, pixels: Sequence[int] | None = None,
              cut_m: Sequence[float] | None = None, replace: bool = False, ranks: int = 0) -> Result:
        """What is in the world and what a run will take, before any light is traced: `surfaces`, `media`, `lights`,
        `candidates`, `forecast`, ...

        picture: a PNG file for a plan and two sections of the world. pixels: its width and height, 640 x 480 or more.
        cut_m: x, y and z of the three planes [m]. replace: also a file that murk did not write. ranks: adds `ranks`,
        what each of that number of ranks of `murk-mpi` computes, holds and receives. Warnings of what is probably wrong go
        to the log of the context. Raises Error. Source: `murk check`.

        Example: `world.check("yard.png").forecast.memory_bytes`.
        """
        path, planes = c_text(picture), ffi.NULL  # live as long as the call
        if cut_m is not None:
            x_m, y_m, z_m = cut_m
            planes = ffi.new("double[3]", [x_m, y_m, z_m])
        width, height = (0, 0) if pixels is None else pixels
        options = ffi.new("murk_check_options *", {"size": ffi.sizeof("murk_check_options"), "picture": path,
                                                   "pixels": [width, height], "cut_m": planes, "ranks": ranks})
        saving = ffi.new("murk_save_options *", {"size": ffi.sizeof("murk_save_options"), "replaces": replace})
        fields = ffi.new("const murk_fields **")
        call_long(self.context, lib.murk_world_check, self.c, options, saving, fields)
        return result_in(fields)

    def replay(self, photon: int) -> Result:
        """The events of one photon, which is traced again: `events`, a list with `kind`, `partner`, `position_m`, ...

        photon: its number, as `emitted` of the records has it. Raises Error if the scene emits no such photon.
        Source: `murk replay`.

        Example: `[event.kind for event in world.replay(17).events]`.
        """
        if not 0 <= photon < 2**64:
            raise Error(f"{photon}, must be 0 or more", where="argument photon")
        fields = ffi.new("const murk_fields **")
        call_long(self.context, lib.murk_world_replay, self.c, photon, ffi.NULL, fields)
        return result_in(fields)

    def read_light(self, path: Path) -> Light:
        """Reads a light.murk: Light, without tallies. Raises Error if the file is not of this world.

        Example: `light = world.read_light("out/light.murk")`.
        """
        return Light(self, path)

    def place(self, light: Light | None = None) -> Plan:
        """Chooses the sensors for a light that is there, or for a new one: Plan. Raises Error.

        Example: `plan = world.place()`.
        """
        return Plan(self, light)


class Tally(NamedTuple):
    """A tally: its name, and values and standard errors as float64 arrays.

    Shapes: planes band x bin_i x bin_j x angle bin x direction [W], grids band x i x j x k [W/m2], spheres band x
    direction [W/m2]; with the key `units` in the units of that key. Both arrays are made once and owned by the light.

    Example: `fluence = light.tally("box").values[0]`.
    """

    name: str
    values: NDArray[numpy.float64]
    errors: NDArray[numpy.float64]


_MAPS: dict[str, int] = {"surface": lib.MURK_MAP_SURFACE, "volume": lib.MURK_MAP_VOLUME}
_UNPACKED = ("direction", "normal", "event_class")
# Fields of records that are stored as they are asked for.
_STORED = ("position_m", "power_w", "emitted", "band", "light", "material")


def _map_of(map: str) -> int:
    if map not in _MAPS:
        raise Error(f"{map!r}, must be one of {', '.join(_MAPS)}", where="argument map")
    return _MAPS[map]


class Batch:
    """The records of a batch of photons, which `trace(each_batch=...)` hands over while light is traced.

    `number` is that of the batch, from 0, and `photons` are the numbers of its first and last photon. A batch is valid
    until the function that received it returns; its arrays are copies and stay valid. All batches together have the
    records of the light, which sorts them into another order. With the key photons.store the field `power_w` is a
    share of a packet until the number of photons is known: `Light.packet_w()` is the factor.

    Example: `light = scene.trace(each_batch=lambda batch: numpy.save(f"{batch.number}.npy", batch.volume))`.
    """

    def __init__(self, c: Any) -> None:
        self._c = c
        self._records: dict[str, NDArray[Any]] = {}
        photons = ffi.new("uint64_t[2]")
        lib.murk_batch_photons(c, photons)
        self.number = int(lib.murk_batch_number(c))
        self.photons: tuple[int, int] = (photons[0], photons[1])

    def array(self, map: str, field: str) -> NDArray[Any]:
        """A field of the records of the "surface" or "volume" map, in the order of photons: a copy.

        Fields, units and types: `Light.array()`. Raises Error for another name, and after the function that received
        the batch has returned.

        Example: `upward = batch.array("volume", "direction")[:, 2] > 0`.
        """
        which = _map_of(map)
        if self._c is None:
            raise Error("the batch is valid until the function that received it returns")
        view = new_view()
        call(lib.murk_batch_array, self._c, which, c_text(field), view)
        return numpy.array(as_numpy(None, view))

    def _all(self, map: str) -> NDArray[Any]:
        if map not in self._records:
            arrays = {field: self.array(map, field) for field in _STORED}
            records = numpy.empty(lib.murk_batch_count(self._c, _MAPS[map]),
                                  [(field, array.dtype, array.shape[1:]) for field, array in arrays.items()])
            for field, array in arrays.items():
                records[field] = array
            self._records[map] = records
        return self._records[map]

    @property
    def surface(self) -> NDArray[Any]:
        """The records of the surface map as a structured array, in the order of photons.

        The fields are those of `Light.surface`; position_m is float64 in scenes far from the origin. Raises Error as
        `array()`.

        Example: `batch.surface["power_w"].sum()`.
        """
        return self._all("surface")

    @property
    def volume(self) -> NDArray[Any]:
        """The records of the volume map, as `surface`. Raises Error as `array()`.

        Example: `batch.volume["position_m"][:, 2].max()`.
        """
        return self._all("volume")


class _Receiver:
    """The function of a caller that receives batches; its exceptions are kept by the context."""

    def __init__(self, context: Context, each: Callable[[Batch], object]) -> None:
        self.context, self.each = context, each
        self.is_enough = False

    def _pass(self, c: Any) -> None:
        self.is_enough = True  # if anything below raises
        batch = Batch(c)
        try:
            answer = self.each(batch)
            self.is_enough = isinstance(answer, (bool, numpy.bool_)) and not answer
        finally:
            batch._c = None

    def take(self, c: Any) -> int:
        """1 to cancel the trace, else 0."""
        self.context._guard(self._pass, c)
        return int(self.is_enough)


@ffi.callback("murk_batch_function", error=1)  # type: ignore[misc]
def _receive(user: Any, batch: Any) -> int:
    receiver: _Receiver = ffi.from_handle(user)
    return receiver.take(batch)


class Light:
    """Both photon maps, the energy ledger and the tallies of a world.

    `surface` and `volume` are structured arrays of the records: views without copies, read-only, with the fields
    `position_m` (3 float32) [m], `power_w` (float32) [W], `emitted` (uint32, number of the photon), `band`, `light` and
    `material` (uint8; in the volume map the number of the medium). `array()` has further fields. In scenes far from the
    origin positions are copies, and reached by `array()` alone. A light pickles with its arrays, ledger and tallies;
    the pickled light has no handle, so that it cannot place, sense, render or save. Source: `murk trace`.

    Example: `light = scene.trace()`, then `light.volume["power_w"].sum()`.
    """

    surface: NDArray[Any]
    volume: NDArray[Any]
    context: Any = None  # of a pickled light
    c: Any = None

    def __init__(self, world: World, path: Path | None = None,
                 each_batch: Callable[[Batch], object] | None = None,
                 parts: Sequence[Path] | None = None, checkpoint: Path | None = None, every_s: float = 0,
                 earlier: Light | None = None) -> None:
        self.world = world
        self.context = world.context
        out = ffi.new("murk_light **")
        if each_batch is not None:
            receiver = ffi.new_handle(_Receiver(self.context, each_batch))  # lives as long as the call
            call_long(self.context, lib.murk_light_stream, out, world.c, _receive, receiver)
        elif parts is not None:
            texts = [c_text(part) for part in parts]  # live as long as the call
            call_long(self.context, lib.murk_light_merge, out, world.c, ffi.new("const char *[]", texts), len(texts))
        elif earlier is not None:
            call_long(self.context, lib.murk_light_update, out, handle_of(earlier), world.c)
        elif checkpoint is not None:
            call_long(self.context, lib.murk_light_trace_resume, out, world.c, c_text(checkpoint), every_s)
        elif path is None:
            call_long(self.context, lib.murk_light_trace, out, world.c)
        else:
            call_long(self.context, lib.murk_light_read, out, world.c, c_text(path))
        self.c = ffi.gc(out[0], lib.murk_light_destroy)
        self._values: dict[str, Any] = {}  # those of a pickled light
        self.surface = self._records(lib.MURK_MAP_SURFACE)
        self.volume = self._records(lib.MURK_MAP_VOLUME)

    def __reduce__(self) -> tuple[Any, ...]:
        values = self._values
        if self.c is not None:
            values = {f"{map}.{field}": self.array(map, field) for map in _MAPS for field in _UNPACKED}
            values["tallies"], values["ledger"] = self.tallies, self.ledger
        return restored, (Light, {"surface": self.surface, "volume": self.volume, "_values": values})

    def _view(self, which: int, field: str) -> Any:
        view = new_view()
        call(lib.murk_light_array, handle_of(self), which, c_text(field), view)
        return view

    def _records(self, which: int) -> NDArray[Any]:
        """All fields that are stored as they are asked for, as one array of records."""
        views = {f: self._view(which, f) for f in _STORED}
        if views["position_m"].is_copy:
            views.pop("position_m")
        n = lib.murk_light_count(self.c, which)
        first = min(view_address(v) for v in views.values()) if n else 0
        kinds = {lib.MURK_TYPE_UINT8: "u1", lib.MURK_TYPE_UINT32: "<u4", lib.MURK_TYPE_FLOAT32: "<f4"}
        fields = {name: ((kinds[v.type], (v.shape[1],)) if v.dimensions == 2 else kinds[v.type],
                         view_address(v) - first if n else 0) for name, v in views.items()}
        return structured(self.c, first, n, views["power_w"].stride[0], fields) if n else numpy.zeros(
            0, [(name, *(f[0] if isinstance(f[0], tuple) else (f[0],))) for name, f in fields.items()])

    def array(self, map: str, field: str) -> NDArray[Any]:
        """A field of the "surface" or "volume" map, in the order of the records.

        Views without copies: position_m (n x 3, float32) [m], power_w [W], emitted, band, light, material. Unpacked
        once, by a copy that the light owns: direction (n x 3, float32, unit vectors of travel), normal (n x 3, float32,
        unit vectors that face the photon; 0 in the volume map), event_class (uint8: 0 first event, 1 specular events
        before, 2 later), and position_m of scenes far from the origin. Raises Error for another name.

        Example: `upward = light.array("volume", "direction")[:, 2] > 0`.
        """
        which = _map_of(map)
        if f"{map}.{field}" in self._values:
            values: NDArray[Any] = self._values[f"{map}.{field}"]
            return values
        records: NDArray[Any] = getattr(self, map)
        if self.c is None and field in (records.dtype.names or ()):
            return records[field]
        return as_numpy(self.c, self._view(which, field))

    def packet_w(self, light: int, band: int) -> float:
        """The power of a photon packet of a light source of the scene and a band, both from 0 [W].

        0 if no photon was emitted there, NaN if there is no such source or band. Raises Error for a pickled light.

        Example: `watts = batch.volume["power_w"] * light.packet_w(0, 0)`, of a scene with photons.store.
        """
        return float(lib.murk_light_packet_w(handle_of(self), light, band))

    @property
    def ledger(self) -> Result:
        """The energy ledger, the fields of ledger.json [W]: Result.

        Example: `light.ledger.absorbed_media_w`.
        """
        ledger: Result | None = self._values.get("ledger")
        return result_of(lib.murk_light_fields, handle_of(self)) if ledger is None else ledger

    def tally(self, name: str) -> Tally:
        """The tally of that name: Tally. Raises Error if there is none, or if the light was read from a file.

        Example: `light.tally("floor").values`.
        """
        if name in self._values.get("tallies", {}):
            tally: Tally = self._values["tallies"][name]
            return tally
        values, errors = new_view(), new_view()
        call(lib.murk_light_tally, handle_of(self), c_text(name), values, errors)
        return Tally(name, as_numpy(self.c, values), as_numpy(self.c, errors))

    @property
    def tallies(self) -> dict[str, Tally]:
        """All tallies by name; none if the light was read from a file.

        Example: `for name, tally in light.tallies.items(): print(name, tally.values.shape)`.
        """
        if self.c is None:
            tallies: dict[str, Tally] = self._values["tallies"]
            return tallies
        try:
            return {name: self.tally(name) for name in self.world.tallies}
        except Error:
            return {}

    def update(self, world: World) -> Light:
        """The light of another world of the same scene, as `World.move()` makes it, equal to `world.trace()`: Light.

        Photons whose path no change touches are not traced again. The first update of a light traces all photons and
        notes where they pass. Raises Error, and Interrupted if it is cancelled.

        Example: `light = light.update(world.move("load", [19, 9, 4.8]))`.
        """
        return Light(world, earlier=self)

    def place(self) -> Plan:
        """Chooses the sensors for this light: Plan. Raises Error, also if the scene has conditions to place over.

        Example: `plan = light.place()`.
        """
        handle_of(self)
        return Plan(self.world, self)

    def sense(self, sensors: Sensors) -> Coverage:
        """Measures given sensors: Coverage.

        sensors: dicts with `type`, `position_m` [m], and `heading_deg` (clockwise from north) and `tilt_deg` (upward)
        of types with a view; or the path of a sensors.csv or plan.json. The coverage is that of this light. If the
        sensors were chosen by light of the same seed, it reads too high: set another `seed` for a fair figure. Raises
        Error if a sensor does not fit the scene.

        Example: `light.sense([{"type": "node", "position_m": [3, 4, 2]}]).coverage.in_sample`.
        """
        return Coverage(self, sensors)

    def render(self, camera: str | None = None, method: str = "maps", sensors: Sensors | None = None,
               from_sensor: int = 0, pixels: Sequence[int] | None = None, samples: int = 0) -> Picture:
        """Renders the picture of a camera of the scene, the first one by default: Picture.

        method: "maps" (shadow rays, density estimate of later records), "paths" (path tracing) or "maps-only"
        (density estimate of all records). sensors, as in `sense()`: the picture gets the channels of their coverage.
        from_sensor: the view of that one of the sensors, from 1 on, in place of a camera. pixels: width and height;
        samples: of each pixel; by default those of the camera, of a sensor 640 pixels across and 16 samples, which may
        take a minute. "maps" wants some 1e6 photons where a plan wants 1e4 (`photons.emit`): with few the picture is
        blotchy. Raises Error if there is no such camera, sensor or method.

        Example: `light.render("gate").radiance[0]`.
        """
        handle_of(self)
        return Picture(self.world, self, camera, method, sensors, from_sensor, pixels, samples)

    def save(self, folder: Path, exports: Sequence[str] = (), replace: bool = False) -> None:
        """Writes the files of `murk trace` to a folder: light.murk, ledger.json, tallies. Arguments: `Plan.save()`.

        Raises Error.

        Example: `light.save("out", exports=["photons"])`.
        """
        save(self, lib.murk_light_save, folder, exports, replace)

    def report(self, page: Path) -> Path:
        """Writes one HTML page of the light and returns its path. Raises Error.

        Example: `light.report("light.html")`.
        """
        return report_of(self, page)

    def write(self, path: Path) -> None:
        """Writes light.murk under that name, for `World.read_light()`. Raises Error.

        Example: `light.write("light.murk")`.
        """
        call_long(self.context, lib.murk_light_write, handle_of(self), c_text(path))

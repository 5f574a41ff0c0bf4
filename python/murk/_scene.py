"""Scenes: keys, arrays of the caller, and the commands that start from a scene."""
from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Callable, Iterable, Mapping, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from ._context import Context, default_context
from ._library import DICT, Error, Path, c_text, call_in, call_long, ffi, from_numpy, lib, string, yaml_of
from ._light import Batch, Light, World
from ._picture import Picture, method_code
from ._plan import Coverage, Plan
from ._results import Fielded, Follow, Result, Study, report_of, result_of, save

Bounds = Tuple[Union[float, None], Union[float, None]]
Sensors = Union[Path, Iterable[Mapping[str, Any]]]


# Grids that the library uses in place, by number, until it releases them.
_in_use: dict[int, NDArray[Any]] = {}


@ffi.callback("void(void *)")  # type: ignore[misc]
def _release(user: Any) -> None:
    _in_use.pop(int(ffi.cast("uintptr_t", user)), None)


def _prepared_fit(scene: Scene, data: Path, free: Sequence[str], bounds: Mapping[str, Bounds] | None = None,
                  loss: str | None = None, predict: Path | None = None, **numbers: int) -> Any:
    """The handle of a fit that has not run."""
    # Strings and arrays live as long as the call.
    keys = [c_text(key) for key in free]
    limits = [c_text(f"{key}={'' if low is None else low}:{'' if high is None else high}")
              for key, (low, high) in (bounds or {}).items()]
    kept = ffi.new("const char *[]", limits), c_text(loss), c_text(predict)
    options = ffi.new("murk_fit_options *", {"size": ffi.sizeof("murk_fit_options"), "n_bounds": len(limits), **numbers})
    options.bounds, options.loss, options.predict = kept
    out = ffi.new("murk_fit **")
    call_long(scene.context, lib.murk_fit_create, out, scene.c, c_text(data), ffi.new("const char *[]", keys),
              len(keys), options)
    return ffi.gc(out[0], lib.murk_fit_destroy)


class Fit(Fielded):
    """A calibration: `result` has the fields of fit.json, each of which is an attribute, too.

    `parameters` is a list with `key`, `value`, `standard_error`, `lower`, `upper`, `at_bound` and `status`, in the units
    of the keys; `standard_error`, `lower` and `upper` are None if the value is at a bound or not determined by the
    readings, which `status` tells. `chi2`, `degrees_of_freedom`, `covariance`, `correlation`, `converged` and `accepted`
    judge it. Pickles with its fields. Source: `murk fit`, which minimises the squared residuals over their errors
    (Levenberg-Marquardt, Ceres).

    Example: `for p in fit.parameters: print(p.key, p.value, p.status if p.standard_error is None else p.standard_error)`.
    """

    def __init__(self, scene: Scene, data: Path, free: Sequence[str], bounds: Mapping[str, Bounds] | None = None,
                 loss: str | None = None, predict: Path | None = None, parts: Sequence[Path] | None = None,
                 **numbers: int) -> None:
        self.context = scene.context
        self.c = _prepared_fit(scene, data, free, bounds, loss, predict, **numbers)
        if parts is None:
            call_long(self.context, lib.murk_fit_run, self.c)
        else:
            if isinstance(parts, (str, bytes)) or len(parts) == 0:
                raise Error("must be a list of paths", where="argument parts")
            paths = [c_text(part) for part in parts]  # live as long as the call
            call_long(self.context, lib.murk_fit_merge, self.c, ffi.new("const char *[]", paths), len(paths))
        self.result = result_of(lib.murk_fit_fields, self.c)

    def save(self, folder: Path, replace: bool = False) -> None:
        """Writes the files of `murk fit` to a folder: fit.json, fit.csv, calibrated.yaml, which `read_keys()` reads.

        replace: as in `Plan.save()`. Raises Error.

        Example: `fit.save("out")`.
        """
        save(self, lib.murk_fit_save, folder, (), replace)

    def report(self, page: Path) -> Path:
        """Writes one HTML page of the fit and returns its path. Raises Error.

        Example: `fit.report("fit.html")`.
        """
        return report_of(self, page)


class Scene:
    """A scene from YAML text, a file or a dict, and keys that are set afterwards.

    `Scene("murk: 1 ...")` or `Scene(text=...)`, `Scene(file="yard.yaml")`, `Scene({"lights": [...]})`; a dict may hold
    NumPy numbers and arrays. Keywords are further keys; paths with dots are given by `**`. Values are checked when the
    scene is used, or by `check()`. A scene can be pickled: file, text, keys and added arrays travel, its context does
    not. Units are those of the keys. Raises Error with file, line, column and key. Source: murk-scene(5).

    Example: `scene = murk.Scene(file="yard.yaml", seed=2, **{"sensors.count": 4})`.
    """

    def __init__(self, source: str | Mapping[str, Any] | None = None, *, text: str | None = None,
                 file: Path | None = None, context: Context | None = None, **keys: Any) -> None:
        if sum(given is not None for given in (source, text, file)) > 1:
            raise Error("a scene is made from one of text, file and dict")
        self.context = context or default_context()
        self._keys: list[tuple[str, Any]] = []
        self._arrays: list[tuple[str, tuple[Any, ...]]] = []
        name = None
        if isinstance(source, Mapping):
            text, name = yaml_of("", {"murk": 1, **source}), DICT
            source = json.loads(text)  # the values as they are now
        elif source is not None:
            text = source
        self._source = {"source": source, "text": text if source is None else None,
                        "file": None if file is None else os.path.abspath(os.fspath(file))}
        out = ffi.new("murk_scene **")
        if file is not None:
            call_in(self.context, lib.murk_scene_read, out, self.context.c, c_text(file))
        elif text is not None:
            call_in(self.context, lib.murk_scene_parse, out, self.context.c, c_text(text), c_text(name))
        else:
            call_in(self.context, lib.murk_scene_create, out, self.context.c)
        self.c = ffi.gc(out[0], lib.murk_scene_destroy)
        for key, value in keys.items():
            self[key] = value

    def __setitem__(self, key: str, value: Any) -> None:
        """Sets a key by its path: `scene["media.fog.extinction_per_m"] = 0.2`.

        value: numbers, texts, lists, dicts, NumPy arrays. Raises Error if the path leads nowhere or the value is not
        one of a scene; the value is checked with the whole scene."""
        given = yaml_of(key, value)
        call_in(self.context, lib.murk_scene_set, self.c, c_text(key), c_text(given))
        self._keys.append((key, json.loads(given)))

    def __getitem__(self, key: str) -> Any:
        """The value of a key in the resolved scene, defaults included: `scene["photons.emit"]`.

        Raises Error if there is no such key, or if the scene is wrong."""
        out = ffi.new("const char **")
        call_in(self.context, lib.murk_scene_get, self.c, c_text(key), out)
        return json.loads(string(out[0]))

    def __contains__(self, key: str) -> bool:
        """True if the resolved scene has the key: `"media.fog" in scene`. Raises Error if the scene is wrong."""
        try:
            return self[key] is not None
        except Error:
            pass
        self.check()  # raises if not the key, but the scene is wrong
        return False

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (type(self), self._source, self._keys, self._arrays)

    def check(self) -> None:
        """Reads the whole scene and checks each value. Raises Error at the first wrong one.

        Meshes, grids and CSV files that keys name are not read, and candidates are not tried: `world()` reads the
        files and builds surfaces, media and lights; `place()` tells which candidates are usable. What `murk check`
        tells and draws is `scene.world().check("drawing.png")`.

        Example: `scene.check()`.
        """
        call_in(self.context, lib.murk_scene_check, self.c)

    @property
    def resolved(self) -> str:
        """The scene as resolved, with all defaults, as YAML text. Raises Error if the scene is wrong.

        Example: `open("scene.resolved.yaml", "w").write(scene.resolved)`.
        """
        out = ffi.new("const char **")
        call_in(self.context, lib.murk_scene_resolved, self.c, out)
        return string(out[0])

    def use_light(self, path: Path) -> None:
        """Takes the seed and the number of photons from a light.murk, for `World.read_light()`; keys that were set
        stay. Raises Error if the file cannot be read as light.

        Example: `scene.use_light("out/light.murk")`, then `light = scene.world().read_light("out/light.murk")`.
        """
        call_in(self.context, lib.murk_scene_use_light, self.c, c_text(path))
        self._arrays.append(("use_light", (os.path.abspath(os.fspath(path)),)))

    def add_mesh(self, name: str, vertices_m: ArrayLike, triangles: ArrayLike, material: ArrayLike | None = None,
                 material_names: Sequence[str] | None = None) -> None:
        """Adds a mesh that keys for files take as "memory:NAME".

        vertices_m: n x 3 [m]; triangles: m x 3 indices into the vertices; material: m indices into material_names,
        which the key `materials` describes. Copied; a name that exists is replaced. Raises Error if an index is out of
        range or a coordinate is not finite.

        Example: `scene.add_mesh("wall", [[5, 0, 0], [5, 9, 0], [5, 0, 3]], [[0, 1, 2]])`, then
        `scene["geometry"] = [{"file": "memory:wall"}]`.
        """
        vertices, a = from_numpy(vertices_m, 2, "vertices_m")
        corners, b = from_numpy(triangles, 2, "triangles", (numpy.uint32, numpy.uint64))
        which, c = (ffi.NULL, None) if material is None else from_numpy(material, 1, "material", (numpy.uint32,))
        names = [c_text(n) for n in material_names or []]
        call_in(self.context, lib.murk_scene_add_mesh, self.c, c_text(name), vertices, corners, which,
                ffi.new("const char *[]", names) if names else ffi.NULL, len(names), ffi.NULL,
                ffi.NULL)
        copies = tuple(None if array is None else numpy.array(array) for array in (a, b, c))
        self._arrays.append(("add_mesh", (name, *copies, material_names)))

    def add_grid(self, name: str, values: ArrayLike, cell_m: ArrayLike = 1.0, origin_m: ArrayLike = (0, 0, 0),
                 index_to_world: ArrayLike | None = None, copy: bool = True) -> None:
        """Adds a grid that the key `vdb` of a medium takes as "memory:NAME".

        values: nx x ny x nz, at least 0; value (i, j, k) fills the cell around origin_m + cell_m * (i, j, k) [m]
        (cell_m: one number or three), or around index_to_world (3 x 4) of (i, j, k, 1) [m]. copy=False: values are
        float32 with x fastest (`order="F"`), are used in place and must not change any more. Raises Error if a value
        is negative or not finite, or if index_to_world cannot be inverted.

        Example: `scene.add_grid("smoke", density, cell_m=0.5, origin_m=(0.25, 0.25, 0.25))`, then
        `scene["media.smoke.vdb"] = "memory:smoke"`.
        """
        _, given = from_numpy(values, 3, "values")
        if not copy and (given.dtype != numpy.float32 or not given.flags.f_contiguous):
            raise Error("must be float32 with x fastest (order=\"F\") to be used without a copy", where="argument values")
        # One copy, which the library uses in place.
        held = numpy.array(given, dtype=numpy.float32, order="F", copy=copy)
        view, held = from_numpy(held, 3, "values")
        if index_to_world is None:
            index_to_world = numpy.zeros((3, 4))
            index_to_world[:, :3] = numpy.diag(numpy.broadcast_to(numpy.asarray(cell_m, float), 3))
            index_to_world[:, 3] = origin_m
        rows = numpy.array(index_to_world, dtype=numpy.float64, order="C")
        if rows.shape != (3, 4):
            raise Error(f"has shape {rows.shape}, must be 3 x 4", where="argument index_to_world")
        number = held.ctypes.data
        while number in _in_use:  # the same array, used by another scene
            number += 1
        _in_use[number] = held
        try:
            call_in(self.context, lib.murk_scene_add_grid, self.c, c_text(name), view,
                    ffi.cast("double *", rows.ctypes.data), _release, ffi.cast("void *", number))
        except BaseException:
            _in_use.pop(number)
            raise
        self._arrays.append(("add_grid", (name, held, 1.0, (0, 0, 0), rows, False)))

    def add_table(self, name: str, **columns: ArrayLike) -> None:
        """Adds a table that keys for CSV files take as "memory:NAME"; columns: arrays of equal length by their heads.

        Candidate places, targets, phase functions; units are those of the heads. Copied.
        Raises Error if the lengths differ.

        Example: `scene.add_table("places", x_m=x, y_m=y, z_m=z)`, then
        `scene["sensors.candidates"] = {"points": "memory:places"}`.
        """
        arrays = [numpy.array(column, float) for column in columns.values()]
        if len({array.shape for array in arrays}) != 1 or arrays[0].ndim != 1:
            raise Error("columns must be lists of equal length", where=f"argument columns of {name}")
        view, kept = from_numpy(numpy.column_stack(arrays), 2, "values")
        heads = [c_text(head) for head in columns]
        call_in(self.context, lib.murk_scene_add_table, self.c, c_text(name), ffi.new("const char *[]", heads), view)
        self._arrays.append(("add_table", (name, dict(zip(columns, arrays)))))

    def world(self) -> World:
        """Checks the scene, reads its files and builds surfaces, media and light sources: World. Raises Error.

        Example: `world = scene.world()`.
        """
        return World(self)

    def trace(self, each_batch: Callable[[Batch], object] | None = None) -> Light:
        """Traces the light: Light. Raises Error. each_batch: a function of each batch, as in `World.trace()`.

        Example: `light = scene.trace()`.
        """
        return self.world().trace(each_batch)

    def place(self) -> Plan:
        """Chooses the sensors: Plan. Raises Error.

        Example: `plan = scene.place()`.
        """
        return self.world().place()

    def follow(self, folder: Path | None = None, each: Callable[[Result], object] | None = None,
               exports: Sequence[str] = (), replace: bool = False, shard: tuple[int, int] | None = None,
               parts: Sequence[Path] = ()) -> Follow:
        """Makes a plan for each step of the timeline: Follow.

        Each step is the scene at its time (key `timeline.at_s`), and its plan begins at that of the step before, unless
        `placement.method` is greedy or `timeline.search_from` is start_plan. folder: keeps the files of each step, in
        steps/NNNN, and the tables; finished steps are not made again by the next call. each: a function of the fields of
        each step, as it is done; what it raises ends the call. exports: as in `Plan.save()`, and "light". replace: as in
        `Plan.save()`. shard: (K, N): makes part K of N of the steps alone, in the folder, on any machine. parts: such
        folders, in any order, whose steps are taken over; missing ones are made. A step whose scene is wrong at its time
        has the reason in its field `failed`. Raises Error if the scene has no timeline, and for parts of another scene.
        Source: `murk follow --shard`, `murk merge`.

        Example: `scene.follow("out", each=lambda step: print(step.t_s, step.coverage))`.
        """
        return Follow(self, folder, each, exports, replace, shard, parts)

    def sense(self, sensors: Sensors) -> Coverage:
        """Traces the light and measures given sensors: Coverage; sensors as in `Light.sense()`. Raises Error.

        Example: `scene.sense("plan.json").coverage.in_sample`.
        """
        return self.trace().sense(sensors)

    def render(self, camera: str | None = None, method: str = "maps", sensors: Sensors | None = None,
               from_sensor: int = 0, pixels: Sequence[int] | None = None, samples: int = 0) -> Picture:
        """Renders a picture: Picture; arguments as in `Light.render()`. Traces the light, unless the method is "paths".

        Raises Error.

        Example: `scene.render("gate").save("gate.exr", png=True)`.
        """
        needs_light = method_code(method) != lib.MURK_METHOD_PATHS
        world = self.world()
        light = world.trace() if needs_light else None
        return Picture(world, light, camera, method, sensors, from_sensor, pixels, samples)

    def fit(self, data: Path, free: Sequence[str] = (), bounds: Mapping[str, Bounds] | None = None,
            loss: str | None = None, starts: int = 0, traces: int = 0, next: int = 0,
            predict: Path | None = None, parts: Sequence[Path] | None = None) -> Fit:
        """Calibrates keys to the readings of a CSV file: Fit.

        data: CSV with the columns of murk-data(5), or a mapping of another file (.yaml). free: paths of keys; "KEY@each"
        is one value a condition, "gain.NAME" a factor of readings. bounds: the least and the largest value of a key,
        None for none. loss: "none", "huber" or "cauchy", the last two also with a width in standard errors,
        "huber:1.345". starts, traces: of the search; 0: 4 and 12.
        next: proposes so many places for further readings. Without `free` nothing is fitted, and the readings are
        predicted at the values of the scene, or of `predict`, the fit.json of a finished fit. parts: files of
        `fit_part()` with searches of this fit, in any order; those of missing parts are run, with a warning. Raises
        Error if a reading or a key does not fit the scene.

        Example: `fit = scene.fit("fog.csv", ["media.fog.extinction_per_m", "media.fog.phase.hg"])`.
        """
        return Fit(self, data, free, bounds, loss, predict, parts, starts=starts, traces=traces, next=next)

    def fit_part(self, number: int, count: int, path: Path, data: Path, free: Sequence[str],
                 bounds: Mapping[str, Bounds] | None = None, loss: str | None = None, starts: int = 0,
                 traces: int = 0) -> None:
        """Runs part `number`, from 1, of `count` parts of the searches of a fit, and writes the part to a file.

        For machines without a common memory: `fit()` with `parts` puts the parts together, to equal results in every
        bit. Other arguments: as of `fit()`, and equal for all parts. Raises Error. Source: `murk fit --shard`.

        Example: `scene.fit_part(2, 4, "part-2", "fog.csv", ["media.fog.extinction_per_m"])`.
        """
        for name, value in (("number", number), ("count", count)):
            if not 0 <= value < 2**32:
                raise Error(f"{value}, must be 1 to 100000", where=f"argument {name}")
        fit = _prepared_fit(self, data, free, bounds, loss, starts=starts, traces=traces)
        call_long(self.context, lib.murk_fit_run_part, fit, number, count, c_text(path))

    def study(self, axes: Mapping[str, Any], outputs: Sequence[str] = (), folder: Path | None = None,
              **keys: Any) -> Study:
        """Runs the scene many times, each time with other values: Study.

        axes: paths of keys with the values of each, numbers, arrays or what a study file takes. outputs: "density",
        "coverage_best", names of tallies, ... of murk-study(5). folder: keeps finished rows. keys: further keys of a
        study file, such as mode="paired". Raises Error if a key is wrong, or if an array was added to the scene: rows
        run in subprocesses, which read files only. A row that fails has the reason in its field `failed`.

        Example: `scene.study({"media.fog.visibility_m": [50, 100, 200]}, ["coverage_best"]).rows`.
        """
        for method, arguments in self._arrays:
            if method.startswith("add_"):
                raise Error("was added to the scene as an array, which a study cannot read: rows run in subprocesses; "
                            "save the array to a file, or run the scenes in a loop", where=f"memory:{arguments[0]}")
        described = {"murk_study": 1, "base": "scene.yaml", "axes": axes, **keys}
        if outputs:
            described["outputs"] = list(outputs)
        with tempfile.TemporaryDirectory(prefix="murk-") as made:
            for name, text in (("scene.yaml", self.resolved), ("study.yaml", yaml_of("study", described))):
                with open(os.path.join(made, name), "w", encoding="utf-8") as file:
                    file.write(text)
            return Study(os.path.join(made, "study.yaml"), folder, self.context._of_temporary_files())


def _rebuilt(kind: type[Scene], source: dict[str, Any], keys: list[tuple[str, Any]],
             arrays: list[tuple[str, tuple[Any, ...]]]) -> Scene:
    """A pickled scene: the same calls in the same order."""
    scene = kind(**source)
    for key, value in keys:
        scene[key] = value
    for method, arguments in arrays:
        if method == "add_table":
            scene.add_table(arguments[0], **arguments[1])
        else:
            getattr(scene, method)(*arguments)
    return scene

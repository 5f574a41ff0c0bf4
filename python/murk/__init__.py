"""murk: light in fog, smoke, rain and water, and the places of sensors in it.

    import murk
    scene = murk.Scene(file="fog-yard.yaml")
    scene["sensors.count"] = 4
    plan = scene.place()
    print(plan.coverage["held_out"], "+-", plan.coverage["held_out_standard_error"])
    for sensor in plan.sensors:
        print(sensor["type"], sensor["position_m"])

Units: metres, watts, 1/m, nanometres; degrees where a name ends in _deg. Fields of results have the names of the
JSON files of the program murk, which murk-results(5) lists. Keys of scenes are those of doc/reference.
"""
import json
import os
import sys
import tempfile
import threading

import numpy

from ._library import Error, Interrupted, as_numpy, call, call_long, ffi, from_numpy, lib, new_view, structured, text
from ._library import _string, view_address

__all__ = ["Context", "Scene", "World", "Light", "Tally", "Coverage", "Plan", "Picture", "Result", "Error",
           "Interrupted", "version", "report", "study"]


def version():
    """The version of the library, "0.1.0"."""
    return _string(lib.murk_version())


# ---- context ----


@ffi.callback("murk_log_function")
def _log(user, is_warning, where, message):
    context = ffi.from_handle(user)
    context._heard(bool(is_warning), _string(where), _string(message))


@ffi.callback("murk_progress_function")
def _progress(user, state):
    context = ffi.from_handle(user)
    total = state.total or None
    context._progressed(_string(state.step), state.done, total, _string(state.unit), state.elapsed_s)


class Context:
    """Threads, messages and progress of the calls made with it.

    threads: 0 for as many as there are processors. log: called with (is_warning, where, text) for each warning and
    note; None: warnings become Python warnings, notes are dropped. progress: True for a line on standard error, which
    terminals and notebooks redraw, or a function called with (step, done, total or None, unit, elapsed seconds).

    A context, and all that is made with it, is used by one thread at a time.
    """

    def __init__(self, threads=0, log=None, progress=None):
        self._log, self._told = log, progress
        self._line = False
        self._handle = ffi.new_handle(self)
        options = ffi.new("murk_context_options *")
        options.size = ffi.sizeof("murk_context_options")
        options.threads = threads
        options.log = _log
        options.progress = _progress if progress else ffi.NULL
        options.user = self._handle
        out = ffi.new("murk_context **")
        call(lib.murk_context_create, out, options)
        self._c = ffi.gc(out[0], lib.murk_context_destroy)

    def cancel(self):
        """Makes the running call, or the next one, raise Interrupted; from any thread."""
        lib.murk_context_cancel(self._c)

    def _heard(self, is_warning, where, message):
        if self._log:
            self._log(is_warning, where, message)
        elif is_warning:
            import warnings
            warnings.warn(f"{where}: {message}" if where else message, stacklevel=3)

    def _progressed(self, step, done, total, unit, elapsed_s):
        if self._told is not True:
            self._told(step, done, total, unit, elapsed_s)
            return
        share = f"{100 * done / total:3.0f} %" if total else f"{done} {unit}"
        end = "\n" if total and done >= total else ""
        print(f"\r{step:<12} {share:<16} {elapsed_s:6.1f} s{end}", end="", file=sys.stderr, flush=True)


_default = threading.local()


def _default_context():
    """A context for each thread, made when it is first needed."""
    if not hasattr(_default, "context"):
        _default.context = Context()
    return _default.context


# ---- results ----


class Result(dict):
    """The fields of a result: a dict with the names of the JSON file of the program, nested; null is None.

    result["coverage"]["held_out"] and result.get_path("coverage.held_out") are the same number. Results can be
    pickled and compared."""

    def get_path(self, path):
        """The value at a path, names and indices joined by dots."""
        value = self
        for part in path.split("."):
            value = value[int(part)] if isinstance(value, list) else value[part]
        return value

    def __reduce__(self):
        return Result, (dict(self),)


def _result(function, handle):
    fields = ffi.new("const murk_fields **")
    call(function, handle, fields)
    return Result(json.loads(_string(lib.murk_fields_json(fields[0]))))


def report(folder, page=None):
    """Writes one HTML page of a folder of results; page None: report.html in the folder. Returns its path."""
    context = _default_context()
    call_long(context._c, lib.murk_context_write_report, context._c, text(folder), text(page))
    return page or os.path.join(os.fspath(folder), "report.html")


# ---- scene ----


def _yaml(value):
    """A Python value in YAML flow style."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    try:
        return json.dumps(value, allow_nan=False, default=_plain)
    except ValueError as wrong:
        raise Error(f"{value!r}: {wrong}") from None


def _plain(value):
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise ValueError(f"{type(value).__name__} is no value of a scene")


class Scene:
    """A scene from YAML text, a file or a dict, and keys that are set afterwards.

    Scene(text="murk: 1 ..."), Scene(file="yard.yaml"), Scene({...}); more keys by path:
    Scene(file="yard.yaml", **{"sensors.count": 4}). Values are checked when the scene is used, or by check().
    Raises Error with file, line, column and key.
    """

    def __init__(self, source=None, *, text=None, file=None, context=None, **keys):
        self.context = context or _default_context()
        if isinstance(source, dict):
            text = json.dumps({"murk": 1, **source}, default=_plain)
        elif source is not None:
            text = source
        out = ffi.new("murk_scene **")
        if file is not None:
            call(lib.murk_scene_read, out, self.context._c, _c_text(file))
        elif text is not None:
            call(lib.murk_scene_parse, out, self.context._c, _c_text(text), ffi.NULL)
        else:
            call(lib.murk_scene_create, out, self.context._c)
        self._c = ffi.gc(out[0], lib.murk_scene_destroy)
        self._source = {"text": text, "file": file}
        for key, value in keys.items():
            self[key] = value

    def __setitem__(self, key, value):
        """Sets a key by its path: scene["media.fog.extinction_per_m"] = 0.2."""
        call(lib.murk_scene_set, self._c, _c_text(key), _c_text(_yaml(value)))

    def __getitem__(self, key):
        """The value of a key in the resolved scene, defaults included. Raises Error if there is no such key."""
        out = ffi.new("const char **")
        call(lib.murk_scene_get, self._c, _c_text(key), out)
        return json.loads(_string(out[0]))

    def check(self):
        """Reads the whole scene and checks each value; raises Error."""
        call(lib.murk_scene_check, self._c)

    @property
    def resolved(self):
        """The scene as resolved, with all defaults, as YAML text."""
        out = ffi.new("const char **")
        call(lib.murk_scene_resolved, self._c, out)
        return _string(out[0])

    def add_mesh(self, name, vertices_m, triangles, material=None, material_names=None):
        """Adds a mesh that keys for files take as "memory:NAME".

        vertices_m: n x 3 [m]; triangles: m x 3 indices; material: m indices into material_names."""
        vertices, a = from_numpy(vertices_m, 2, "vertices_m")
        corners, b = from_numpy(triangles, 2, "triangles", (numpy.uint32, numpy.uint64))
        which, c = (None, None) if material is None else from_numpy(material, 1, "material", (numpy.uint32,))
        names = [_c_text(n) for n in material_names or []]
        call(lib.murk_scene_add_mesh, self._c, _c_text(name), vertices, corners, which or ffi.NULL,
             ffi.new("const char *[]", names) if names else ffi.NULL, len(names))
        del a, b, c

    def add_grid(self, name, values, cell_m=1.0, origin_m=(0, 0, 0), index_to_world=None):
        """Adds a grid that the key `vdb` of a medium takes as "memory:NAME".

        values: nx x ny x nz, at least 0; value (i, j, k) fills the cell around origin_m + cell_m * (i, j, k)
        (cell_m: one number or three), or around index_to_world (3 x 4) of (i, j, k, 1). Copied."""
        view, kept = from_numpy(values, 3, "values")
        if index_to_world is None:
            index_to_world = numpy.zeros((3, 4))
            index_to_world[:, :3] = numpy.diag(numpy.broadcast_to(numpy.asarray(cell_m, float), 3))
            index_to_world[:, 3] = origin_m
        rows = numpy.ascontiguousarray(index_to_world, dtype=numpy.float64)
        if rows.shape != (3, 4):
            raise Error(f"has shape {rows.shape}, must be 3 x 4", where="index_to_world")
        call(lib.murk_scene_add_grid, self._c, _c_text(name), view, ffi.cast("double *", rows.ctypes.data), ffi.NULL,
             ffi.NULL)
        del kept

    def add_table(self, name, **columns):
        """Adds a table that keys for CSV files take as "memory:NAME"; columns: arrays of equal length by head."""
        values = numpy.column_stack([numpy.asarray(c, float) for c in columns.values()])
        view, kept = from_numpy(values, 2, "values")
        heads = [_c_text(head) for head in columns]
        call(lib.murk_scene_add_table, self._c, _c_text(name), ffi.new("const char *[]", heads), view)
        del kept

    def world(self):
        """Checks the scene, reads its files and builds surfaces, media and light sources."""
        return World(self)

    def trace(self):
        """Traces the light: Light."""
        return self.world().trace()

    def place(self):
        """Chooses the sensors: Plan."""
        return self.world().place()

    def sense(self, sensors):
        """Measures given sensors, a list of dicts or a file: Coverage."""
        return self.trace().sense(sensors)

    def render(self, camera=None, method="maps"):
        """Traces the light and renders the picture of a camera, the first one by default: Picture."""
        return self.trace().render(camera, method)

    def fit(self, data, free):
        """Calibrates the keys `free` (["media.fog.visibility_m", "media.fog.albedo@each", ...]) to the readings of a
        CSV file: Result with the fields of fit.json."""
        keys = [_c_text(key) for key in free]
        out = ffi.new("murk_fit **")
        call_long(self.context._c, lib.murk_fit_run, out, self._c, _c_text(data),
                  ffi.new("const char *[]", keys) if keys else ffi.NULL, len(keys))
        return _result(lib.murk_fit_fields, ffi.gc(out[0], lib.murk_fit_destroy))


def _c_text(value):
    return text(value)


# ---- world ----


class World:
    """A scene that is built; it does not change any more."""

    def __init__(self, scene):
        self.context = scene.context
        out = ffi.new("murk_world **")
        call_long(self.context._c, lib.murk_world_create, out, scene._c)
        self._c = ffi.gc(out[0], lib.murk_world_destroy)
        self.tallies = [t["name"] for t in scene["tallies"]] if _has(scene, "tallies") else []

    @property
    def bounds_m(self):
        """The box of the domain: [[x, y, z] of the least corner, the same of the largest] [m]."""
        out = ffi.new("double[6]")
        lib.murk_world_bounds(self._c, out)
        return numpy.array(list(out)).reshape(2, 3)

    @property
    def bands_nm(self):
        """The wavelengths of the bands [nm]."""
        return numpy.array([lib.murk_world_band_nm(self._c, i) for i in range(lib.murk_world_bands(self._c))])

    def trace(self):
        """Traces the light: Light."""
        return Light(self)

    def read_light(self, path):
        """Reads light.murk; raises Error if it is not of this world."""
        return Light(self, path)

    def place(self, light=None):
        """Chooses the sensors, for a light that is there or a new one: Plan."""
        return Plan(self, light)


def _has(scene, key):
    try:
        return scene[key] is not None
    except Error:
        return False


# ---- light ----


class Tally:
    """values and errors (standard errors): arrays band x ..., as murk_light_tally() of murk.h."""

    def __init__(self, name, values, errors):
        self.name, self.values, self.errors = name, values, errors


class Light:
    """Both photon maps, the energy ledger and the tallies of a world.

    surface, volume: structured arrays of the records, views without copies, fields position_m [m], power_w [W],
    emitted (number of the photon), band, light, material (of the volume map: the medium). array() gives further
    fields. ledger: Result. tallies: dict of Tally by name.
    """

    def __init__(self, world, path=None):
        self.world = world
        self.context = world.context
        out = ffi.new("murk_light **")
        if path is None:
            call_long(self.context._c, lib.murk_light_trace, out, world._c)
        else:
            call_long(self.context._c, lib.murk_light_read, out, world._c, text(path))
        self._c = ffi.gc(out[0], lib.murk_light_destroy)
        self.surface = self._records(lib.MURK_MAP_SURFACE)
        self.volume = self._records(lib.MURK_MAP_VOLUME)

    def _view(self, which, field):
        view = new_view()
        call(lib.murk_light_array, self._c, which, text(field), view)
        return view

    def _records(self, which):
        """All fields that are stored as they are asked for, as one array of records."""
        views = {f: self._view(which, f) for f in ("power_w", "emitted", "band", "light", "material")}
        place = self._view(which, "position_m")
        if not place.is_copy:
            views = {"position_m": place, **views}
        n = lib.murk_light_count(self._c, which)
        first = min(view_address(v) for v in views.values()) if n else 0
        kinds = {lib.MURK_TYPE_UINT8: "u1", lib.MURK_TYPE_UINT32: "<u4", lib.MURK_TYPE_FLOAT32: "<f4"}
        fields = {name: ((kinds[v.type], (v.shape[1],)) if v.dimensions == 2 else kinds[v.type],
                         view_address(v) - first if n else 0) for name, v in views.items()}
        return structured(self, first, n, views["power_w"].stride[0], fields) if n else numpy.zeros(
            0, [(name, *(f[0] if isinstance(f[0], tuple) else (f[0],))) for name, f in fields.items()])

    def array(self, map, field):
        """A field of the "surface" or "volume" map: position_m, direction, normal (n x 3), power_w, emitted, band,
        light, material, event_class. Views without copies but for direction, normal, event_class, which are
        unpacked once, and for positions of scenes far from 0."""
        which = {"surface": lib.MURK_MAP_SURFACE, "volume": lib.MURK_MAP_VOLUME}[map]
        return as_numpy(self, self._view(which, field))

    @property
    def ledger(self):
        """The fields of ledger.json: Result."""
        return _result(lib.murk_light_fields, self._c)

    def tally(self, name):
        """The tally of that name: Tally."""
        values, errors = new_view(), new_view()
        call(lib.murk_light_tally, self._c, text(name), values, errors)
        return Tally(name, as_numpy(self, values), as_numpy(self, errors))

    @property
    def tallies(self):
        return {name: self.tally(name) for name in self.world.tallies}

    def place(self):
        """Chooses the sensors for this light: Plan."""
        return Plan(self.world, self)

    def sense(self, sensors):
        """Measures given sensors: dicts with type, position_m, and heading_deg and tilt_deg of types with a view;
        or the path of a sensors.csv or plan.json: Coverage."""
        return Coverage(self, sensors)

    def render(self, camera=None, method="maps"):
        """Renders the picture of a camera, the first one by default. method: "maps", "paths" or "maps-only"."""
        return Picture(self, camera, method)

    def save(self, folder):
        """Writes light.murk, ledger.json and the tallies to a folder."""
        call_long(self.context._c, lib.murk_light_save, self._c, text(folder))

    def write(self, path):
        """Writes light.murk under that name."""
        call_long(self.context._c, lib.murk_light_write, self._c, text(path))


# ---- sensors, coverage, plan ----


def _sensors(world, sensors):
    out = ffi.new("murk_sensors **")
    if isinstance(sensors, (str, os.PathLike)):
        call(lib.murk_sensors_read, out, world._c, text(sensors))
        return ffi.gc(out[0], lib.murk_sensors_destroy)
    call(lib.murk_sensors_create, out, world._c)
    handle = ffi.gc(out[0], lib.murk_sensors_destroy)
    for sensor in sensors:
        c = ffi.new("murk_sensor *")
        name = text(sensor["type"])
        c.size, c.type = ffi.sizeof("murk_sensor"), name
        c.position_m = [float(x) for x in sensor["position_m"]]
        heading, tilt = sensor.get("heading_deg"), sensor.get("tilt_deg")
        c.heading_deg = float("nan") if heading is None else heading
        c.tilt_deg = float("nan") if tilt is None else tilt
        call(lib.murk_sensors_add, handle, c)
    return handle


class Coverage:
    """What given sensors see: result has the fields of coverage.json; coverage, sensors are two of them."""

    def __init__(self, light, sensors):
        self.light = light
        out = ffi.new("murk_coverage **")
        handle = _sensors(light.world, sensors)
        call_long(light.context._c, lib.murk_coverage_measure, out, light._c, handle)
        self._c = ffi.gc(out[0], lib.murk_coverage_destroy)
        self.result = _result(lib.murk_coverage_fields, self._c)
        self.coverage, self.sensors = self.result["coverage"], self.result["sensors"]

    @property
    def matrix(self):
        """sensors x records, uint16, 65535 for full clarity; surface records first. A view."""
        view = new_view()
        call_long(self.light.context._c, lib.murk_coverage_matrix, self._c, view)
        return as_numpy(self, view)

    def __reduce__(self):
        return Result, (dict(self.result),)


class Plan:
    """The chosen sensors: result has the fields of plan.json; sensors (a list of dicts), coverage and bound are three
    of them. Pickles as its Result."""

    def __init__(self, world, light=None):
        self.context = world.context
        out = ffi.new("murk_plan **")
        if light is None:
            call_long(self.context._c, lib.murk_plan_make, out, world._c)
        else:
            call_long(self.context._c, lib.murk_plan_for_light, out, light._c)
        self._c = ffi.gc(out[0], lib.murk_plan_destroy)
        self.result = _result(lib.murk_plan_fields, self._c)
        self.sensors, self.coverage = self.result["sensors"], self.result["coverage"]
        self.bound = self.result.get("bound")

    def save(self, folder):
        """Writes the files of `murk place` to a folder."""
        call_long(self.context._c, lib.murk_plan_save, self._c, text(folder))

    def report(self, page):
        """Writes one HTML page of the plan, beside nothing else. Returns its path."""
        with tempfile.TemporaryDirectory(prefix="murk-") as folder:
            self.save(folder)
            call_long(self.context._c, lib.murk_context_write_report, self.context._c, text(folder), text(page))
        return page

    def __reduce__(self):
        return Result, (dict(self.result),)


# ---- pictures and studies ----


class Picture:
    """A rendered picture: radiance and errors (standard errors), arrays band x height x width [W/m2/sr], distance_m
    and rgb (3 x height x width). array(name) gives further channels by the names of murk_picture_array() of murk.h;
    these are views without copies."""

    _methods = {"maps": lib.MURK_METHOD_MAPS, "paths": lib.MURK_METHOD_PATHS, "maps-only": lib.MURK_METHOD_MAPS_ONLY}

    def __init__(self, light, camera=None, method="maps"):
        if method not in self._methods:
            raise Error(f"{method!r}, must be one of {', '.join(self._methods)}", where="method")
        self.light = light
        out = ffi.new("murk_picture **")
        call_long(light.context._c, lib.murk_picture_render, out, light._c, text(camera), self._methods[method])
        self._c = ffi.gc(out[0], lib.murk_picture_destroy)

    def array(self, channel):
        view = new_view()
        call(lib.murk_picture_array, self._c, text(channel), view)
        return as_numpy(self, view)

    def _all(self, channel, n):
        return numpy.stack([self.array(f"{channel}.{k}") for k in range(n)])

    @property
    def radiance(self):
        return self._all("radiance", len(self.light.world.bands_nm))

    @property
    def errors(self):
        return self._all("error", len(self.light.world.bands_nm))

    @property
    def rgb(self):
        return self._all("rgb", 3)

    @property
    def distance_m(self):
        return self.array("distance_m")

    def write(self, path):
        """Writes an OpenEXR file."""
        call_long(self.light.context._c, lib.murk_picture_write, self._c, text(path))


def study(path, folder=None, context=None):
    """Runs the rows of a study file: Result with the fields of study.json. folder: keeps finished rows."""
    context = context or _default_context()
    out = ffi.new("murk_study **")
    call_long(context._c, lib.murk_study_run, out, context._c, text(path), text(folder))
    return _result(lib.murk_study_fields, ffi.gc(out[0], lib.murk_study_destroy))

"""Sensors: what given ones see, and which to choose."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Sequence

import numpy
from numpy.typing import NDArray

from ._library import Path, as_numpy, c_text, call, call_long, ffi, lib, new_view
from ._results import Fielded, Result, handle_of, report_of, result_of, save

if TYPE_CHECKING:
    from ._light import Light, World
    from ._scene import Sensors


def new_sensors(world: World, sensors: Sensors) -> Any:
    """A list of sensors of the library, from dicts or from a file; released with the Python object."""
    out = ffi.new("murk_sensors **")
    if isinstance(sensors, (str, os.PathLike)):
        call(lib.murk_sensors_read, out, world.c, c_text(sensors))
        return ffi.gc(out[0], lib.murk_sensors_destroy)
    call(lib.murk_sensors_create, out, world.c)
    handle = ffi.gc(out[0], lib.murk_sensors_destroy)
    for sensor in sensors:
        c = ffi.new("murk_sensor *")
        name = c_text(sensor["type"])
        c.size, c.type = ffi.sizeof("murk_sensor"), name
        c.position_m = [float(x) for x in sensor["position_m"]]
        heading, tilt = sensor.get("heading_deg"), sensor.get("tilt_deg")
        c.heading_deg = float("nan") if heading is None else heading
        c.tilt_deg = float("nan") if tilt is None else tilt
        call(lib.murk_sensors_add, handle, c)
    return handle


class Coverage(Fielded):
    """What given sensors see of a light: `result` has the fields of coverage.json, each of which is an attribute, too.

    `coverage` has `in_sample`, the share of the power of the records that the sensors see, and `standard_error`;
    `sensors` is a list with each sensor. Pickles with its fields. Source: `murk sense`.

    Example: `light.sense("plan.json").coverage.in_sample`.
    """

    coverage: Result
    sensors: list[Result]

    def __init__(self, light: Light, sensors: Sensors, earlier: Coverage | None = None) -> None:
        self.light = light
        self.context = light.context
        out = ffi.new("murk_coverage **")
        handle_of(light)
        if earlier is None:
            call_long(self.context, lib.murk_coverage_measure, out, light.c, new_sensors(light.world, sensors))
        else:
            call_long(self.context, lib.murk_coverage_update, out, handle_of(earlier), light.c)
        self.c = ffi.gc(out[0], lib.murk_coverage_destroy)
        self.result = result_of(lib.murk_coverage_fields, self.c)

    def update(self, light: Light) -> Coverage:
        """What the same sensors see of another light: Coverage. Raises Error if a sensor does not fit its scene.

        Example: `coverage = coverage.update(light.update(world))`.
        """
        return Coverage(light, (), self)

    @property
    def matrix(self) -> NDArray[numpy.uint16]:
        """The coverage matrix: sensors x records, uint16, 65535 for full clarity, 0 for not seen.

        Records of the surface map come first, then those of the volume map, each in the order of `Light.array()`; with
        targets in place of photons the targets. Made once; a view.

        Example: `seen = (coverage.matrix > 0).any(axis=0)`.
        """
        view = new_view()
        call_long(self.context, lib.murk_coverage_matrix, handle_of(self), view)
        return as_numpy(self.c, view)


    def save(self, folder: Path, exports: Sequence[str] = (), replace: bool = False) -> None:
        """Writes the files of `murk sense` to a folder: coverage.json, coverage.csv. Arguments: `Plan.save()`.

        Raises Error.

        Example: `coverage.save("out")`.
        """
        save(self, lib.murk_coverage_save, folder, exports, replace)

    def report(self, page: Path) -> Path:
        """Writes one HTML page of the coverage and returns its path. Raises Error.

        Example: `coverage.report("coverage.html")`.
        """
        return report_of(self, page)


class Plan(Fielded):
    """The chosen sensors: `result` has the fields of plan.json, each of which is an attribute, too.

    `sensors` is a list with `type`, `position_m` [m], `heading_deg` and `tilt_deg`; `coverage` has `held_out` (on
    another photon map, None without one) and `in_sample`, shares of 1, with `held_out_standard_error`; `bound` is what
    no plan exceeds in sample. Pickles with its fields. Source: `murk place`.

    Example: `print(plan.coverage.held_out, "+-", plan.coverage.held_out_standard_error)`.
    """

    sensors: list[Result]
    coverage: Result

    def __init__(self, world: World, light: Light | None = None, earlier: Plan | None = None) -> None:
        self.world = world
        self.context = world.context
        out = ffi.new("murk_plan **")
        if light is not None and earlier is not None:
            call_long(self.context, lib.murk_plan_update, out, handle_of(earlier), handle_of(light))
        elif light is None:
            call_long(self.context, lib.murk_plan_make, out, world.c)
        else:
            call_long(self.context, lib.murk_plan_for_light, out, light.c)
        self.c = ffi.gc(out[0], lib.murk_plan_destroy)
        self.result = result_of(lib.murk_plan_fields, self.c)

    def update(self, light: Light) -> Plan:
        """The plan for another light, as `Light.update()` makes it, whose search begins at this plan: Plan.

        It is that of `placement.start_plan` with these sensors. From the second update of a sequence on, sightlines
        that no change touches are not tested again. Raises Error as `Light.place()`.

        Example: `plan = plan.update(light.update(world))`.
        """
        return Plan(light.world, light, self)

    def repeat(self, runs: int) -> Result:
        """Makes runs - 1 further plans with other seeds, each with light of its own: the field `repeat` of plan.json.

        It says how much the plan depends on chance. Raises Error if the scene cannot be repeated.

        Example: `plan.repeat(10)`.
        """
        call_long(self.context, lib.murk_plan_repeat, handle_of(self), runs)
        self.result = result_of(lib.murk_plan_fields, self.c)
        repeat: Result = self.result["repeat"]
        return repeat

    def repeat_part(self, runs: int, number: int, count: int, path: Path) -> None:
        """Makes part `number`, from 1, of `count` parts of the further plans of `repeat()`, and writes it to a file.

        For machines without a common memory, each of which makes the plan first: `merge_repeat()` puts the parts
        together. Raises Error, and Interrupted if it is cancelled; nothing is written then. Source: `murk place
        --repeat --shard`.

        Example: `plan.repeat_part(21, 2, 4, "repeat-2.part")`.
        """
        for name, value in (("number", number), ("count", count)):
            if not 0 <= value < 2**32:
                raise Error(f"{value}, must be 1 to 100000", where=f"argument {name}")
        call_long(self.context, lib.murk_plan_repeat_part, handle_of(self), runs, number, count, c_text(path))

    def merge_repeat(self, runs: int, paths: Sequence[Path]) -> Result:
        """As `repeat()`, with the further plans of files of `repeat_part()`, in any order: equal in every bit.

        Plans of missing parts are made, with a warning. Raises Error for parts of another scene or plan and for
        damaged files. Source: `murk merge`.

        Example: `plan.merge_repeat(21, glob.glob("repeat-*.part"))`.
        """
        texts = [c_text(path) for path in paths]  # live as long as the call
        call_long(self.context, lib.murk_plan_repeat_merge, handle_of(self), runs, ffi.new("const char *[]", texts),
                  len(texts))
        self.result = result_of(lib.murk_plan_fields, self.c)
        repeat: Result = self.result["repeat"]
        return repeat

    def save(self, folder: Path, exports: Sequence[str] = (), replace: bool = False) -> None:
        """Writes the files of `murk place` to a folder: plan.json, sensors.csv, coverage.csv, those of the light.

        exports: words of `--export`: fields, photons, surfaces, matrix, or-library, lp. Files that murk did not write,
        or that were edited since, are replaced only if `replace` is true. Raises Error, and writes
        nothing then, unless an export alone cannot be made: then the other files are written.

        Example: `plan.save("out", exports=["photons", "surfaces"])`.
        """
        save(self, lib.murk_plan_save, folder, exports, replace)

    def report(self, page: Path) -> Path:
        """Writes one HTML page of the plan and returns its path; no other file is left. Raises Error.

        Example: `plan.report("page.html")`.
        """
        return report_of(self, page)

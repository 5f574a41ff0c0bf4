"""murk: light in fog, smoke, rain and water, and the places of sensors in it.

    import murk
    scene = murk.Scene(file="fog-yard.yaml")
    scene["sensors.count"] = 4
    plan = scene.place()
    print(plan.coverage.held_out, "+-", plan.coverage.held_out_standard_error)
    for sensor in plan.sensors:
        print(sensor.type, sensor.position_m)

Units: metres, watts, 1/m, nanometres; degrees where a name ends in _deg. Fields of results have the names of the
JSON files of the program murk, which murk-results(5) lists. Keys of scenes are those of doc/reference.
"""
from ._context import Context
from ._library import Error, Interrupted
from ._light import Batch, Light, Tally, World
from ._library import lib as _lib
from ._library import string as _string
from ._picture import Picture
from ._plan import Coverage, Plan
from ._results import Follow, Result, Study, read_keys, reference, report, study
from ._scene import Fit, Scene

__all__ = ["Scene", "World", "Light", "Batch", "Tally", "Coverage", "Plan", "Picture", "Study", "Follow", "Fit", "Result", "Context",
           "Error", "Interrupted", "study", "report", "reference", "read_keys", "version"]


def version() -> str:
    """The version of the library that runs.

    Example: `print(murk.version())`.
    """
    return _string(_lib.murk_version())


# The modules of the parts are not public: names in messages and pickles are those of the package.
for _name in __all__:
    globals()[_name].__module__ = "murk"
del _name

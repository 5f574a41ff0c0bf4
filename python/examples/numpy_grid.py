"""Smoke as a NumPy array: a plume that widens as it rises, and the sensors that see through it.

    python3 numpy_grid.py
"""
import numpy

import murk

# Extinction of 40 x 20 x 16 cells of 0.5 m [1/m]: a plume over (6, 5), which bends with the wind.
cell_m = 0.5
x, y, z = (cell_m * (numpy.arange(n) + 0.5) for n in (40, 20, 16))
X, Y, Z = numpy.meshgrid(x, y, z, indexing="ij")
width_m = 0.5 + 0.15 * Z
plume = 3 * numpy.exp(-((X - 6 - 0.4 * Z) ** 2 + (Y - 5) ** 2) / (2 * width_m**2)) * (0.5 / width_m) ** 2

hall = {
    "domain": {"min_m": [0, 0, 0], "max_m": [20, 10, 8]},
    "geometry": [{"box": {"min_m": [0, 0, 0], "max_m": [20, 10, 8]}}],
    "media": {"smoke": {"vdb": "memory:plume", "extinction_per_m": 1, "albedo": 0.6, "phase": {"hg": 0.6}}},
    "regions": [{"medium": "smoke"}],
    "lights": [{"type": "sphere", "center_m": [x, 5, 7.5], "radius_m": 0.1, "power_w": 60} for x in (4, 10, 16)],
    "photons": {"emit": 20000},
    "sensors": {"types": [{"name": "camera", "range_m": 15}], "count": 3,
                "candidates": {"grid": {"min_m": [1, 1, 1], "max_m": [19, 9, 7], "size": [7, 4, 3]}}},
}
coverage, errors = {}, {}
for name, factor in (("no smoke", 0), ("smoke", 1), ("thick smoke", 5)):
    scene = murk.Scene(hall)
    scene.add_grid("plume", factor * plume, cell_m=cell_m, origin_m=(0.25, 0.25, 0.25))
    plan = scene.place()
    coverage[name], errors[name] = plan.coverage.held_out, plan.coverage.held_out_standard_error
    places = ", ".join(str(sensor.position_m) for sensor in plan.sensors)
    print(f"{name}: {coverage[name]:.4f} +- {errors[name]:.4f} from {places}")

# The array against the tracer: a beam through the plume at 4.25 m height.
beam = murk.Scene({
    **hall, "geometry": [], "tallies": [{"name": "end", "type": "plane", "point_m": [19.5, 0, 0], "normal": [1, 0, 0]}],
    "media": {"smoke": {**hall["media"]["smoke"], "albedo": 0}}, "photons": {"emit": 100000, "maps": "none"},
    "lights": [{"type": "beam", "origin_m": [0.1, 5.25, 4.25], "direction": [1, 0, 0], "power_w": 1}]})
beam.add_grid("plume", plume, cell_m=cell_m, origin_m=(0.25, 0.25, 0.25))
end = beam.trace().tally("end")
transmittance, transmittance_error = end.values.sum(), end.errors.max()
expected = numpy.exp(-plume[:, 10, 8].sum() * cell_m)
print(f"transmittance {transmittance:.4f} +- {transmittance_error:.4f}, by the array {expected:.4f}")

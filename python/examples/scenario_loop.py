"""A loop of one's own over scenarios: the hours of a day, and a lamp that moves.

    python3 scenario_loop.py
"""
import numpy

import murk

# The hours of a day: irradiance of the ground by sun and sky, in clear air near Utrecht at midsummer.
day = murk.Scene({
    "band_edges_nm": [400, 700],
    "domain": {"min_m": [0, 0, 0], "max_m": [20, 20, 10], "sides": "periodic"},
    "site": {"latitude_deg": 52.1, "longitude_deg": 5.2, "time_zone": "+02:00", "date": "2026-06-21", "clock": "12:00"},
    "geometry": [{"rect": {"corner_m": [0, 0, 0], "edge1_m": [20, 0, 0], "edge2_m": [0, 20, 0]}}],
    "lights": [{"type": "sun"}, {"type": "sky"}],
    "photons": {"emit": 20000, "maps": "none"},
    "tallies": [{"name": "ground", "type": "plane", "point_m": [0, 0, 0.01], "normal": [0, 0, -1]}],
})
ground_m2 = 20 * 20
hours = [2, 5, 8, 11, 14, 17, 20, 23]
irradiance, irradiance_errors = [], []
for hour in hours:
    day["site.clock"] = f"{hour:02}:00"
    tally = day.trace().tally("ground")
    down, error = tally.values[0, 0, 0, 0, 0] / ground_m2, tally.errors[0, 0, 0, 0, 0] / ground_m2
    irradiance.append(down)
    irradiance_errors.append(error)
    print(f"{hour:02}:00  {down:7.2f} +- {error:.2f} W/m2 of 400 to 700 nm")

# A lamp that moves through a foggy hall: where is it brightest, and how much do two fixed sensors see?
hall = murk.Scene({
    "domain": {"min_m": [0, 0, 0], "max_m": [20, 8, 4]},
    "geometry": [{"box": {"min_m": [0, 0, 0], "max_m": [20, 8, 4]}}],
    "media": {"fog": {"extinction_per_m": 0.3, "albedo": 0.95, "phase": {"hg": 0.8}}},
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "sphere", "center_m": [2, 4, 2], "radius_m": 0.1, "power_w": 20}],
    "photons": {"emit": 20000},
    "sensors": {"types": [{"name": "node", "range_m": 12}], "count": 1,
                "candidates": {"grid": {"min_m": [1, 1, 1], "max_m": [19, 7, 3], "size": [4, 2, 2]}}},
    "tallies": [{"name": "fluence", "type": "grid", "min_m": [0, 0, 0], "max_m": [20, 8, 4], "size": [20, 1, 1]}],
})
sensors = [{"type": "node", "position_m": [x, 4, 3.5]} for x in (3, 17)]
lamp_x_m = [2.5, 6.5, 10.5, 14.5, 17.5]
brightest_x_m, seen, seen_errors = [], [], []
for x in lamp_x_m:
    hall["lights.0.center_m"] = numpy.array([x, 4, 2])
    light = hall.trace()
    brightest_x_m.append(light.tally("fluence").values[0, :, 0, 0].argmax() + 0.5)
    coverage = light.sense(sensors).coverage
    seen.append(coverage.in_sample)
    seen_errors.append(coverage.standard_error)
    print(f"lamp at {x:4} m: brightest at {brightest_x_m[-1]:4} m, seen {seen[-1]:.4f} +- {seen_errors[-1]:.4f}")

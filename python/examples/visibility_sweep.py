"""Coverage against visibility: how much of the light of a yard do four sensors see in fog of growing density?

    python3 visibility_sweep.py [PICTURE.png]

Prints a table; draws it with error bars if matplotlib (Debian's python3-matplotlib) is there.
"""
import sys

import murk

picture = sys.argv[1] if len(sys.argv) > 1 else "visibility_sweep.png"
scene = murk.Scene({
    "bands_nm": [550],
    "domain": {"min_m": [0, 0, 0], "max_m": [30, 20, 8]},
    "geometry": [{"rect": {"corner_m": [0, 0, 0], "edge1_m": [30, 0, 0], "edge2_m": [0, 20, 0]}},
                 {"box": {"min_m": [8, 6, 0], "max_m": [11, 14, 3]}},
                 {"box": {"min_m": [19, 4, 0], "max_m": [22, 12, 3]}}],
    "media": {"fog": {"preset": "fog/radiation", "visibility_m": 100}},
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "sphere", "center_m": [x, 10, 6], "radius_m": 0.1, "power_w": 50} for x in (7, 15, 23)],
    "photons": {"emit": 1000},
    "sensors": {"types": [{"name": "node", "range_m": 15}], "count": 4,
                "candidates": {"grid": {"min_m": [2, 2, 1], "max_m": [28, 18, 5], "size": [8, 5, 2]}}},
})
visibility_m = [15, 30, 60, 120, 240, 480]
coverage, errors = [], []
for value in visibility_m:
    scene["media.fog.visibility_m"] = value
    seen = scene.place().coverage  # held out: counted on photons that did not choose the sensors
    coverage.append(seen.held_out)
    errors.append(seen.held_out_standard_error)
    print(f"{value:4} m  {seen.held_out:.4f} +- {seen.held_out_standard_error:.4f}")

try:
    import matplotlib
except ModuleNotFoundError:
    print("no matplotlib: no picture")
else:
    matplotlib.use("Agg")  # a file, no window
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4), constrained_layout=True)
    axes.errorbar(visibility_m, coverage, yerr=errors, fmt=".-", capsize=4)
    axes.set(xscale="log", xlabel="visibility in m", ylabel="coverage of four sensors (bars: standard error)", ylim=(0, 1))
    axes.set_xticks(visibility_m, [str(value) for value in visibility_m])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    figure.savefig(picture, dpi=150)
    print(f"wrote {picture}")

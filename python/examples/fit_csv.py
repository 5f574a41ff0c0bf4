"""Which fog was it? Extinction and mean cosine from the readings of a CSV file.

    python3 fit_csv.py

readings.csv has 16 readings of fluence rate along and beside a headlamp's beam in a fog chamber, planted with an
extinction of 0.22 1/m and a mean cosine of 0.87, and with errors of 2 %.
"""
import csv
import os

import murk

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), "readings.csv")
chamber = murk.Scene({
    "bands_nm": [550],
    "geometry": [{"box": {"min_m": [0, 0, 0], "max_m": [20, 10, 5]}, "material": "wall"}],
    "materials": {"wall": {"diffuse": 0.2}},
    "media": {"fog": {"extinction_per_m": 0.12, "albedo": 0.995, "phase": {"hg": 0.8}}},  # where the search begins
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "beam", "origin_m": [1, 5, 2.5], "direction": [1, 0, 0], "radius_m": 0.1, "divergence_deg": 2,
                "power_w": 100}],
    "photons": {"emit": 100000},
})
with open(data, newline="", encoding="utf-8") as file:
    readings = len(list(csv.DictReader(file)))
fit = chamber.fit(data, ["media.fog.extinction_per_m", "media.fog.phase.hg"])
for parameter in fit.parameters:
    if parameter.standard_error is None:  # at a bound, or not determined by the readings
        print(f"{parameter.key}: {parameter.status}")
        continue
    print(f"{parameter.key} = {parameter.value:.4f} +- {parameter.standard_error:.4f} "
          f"(95 %: {parameter.lower:.4f} to {parameter.upper:.4f})")
print(f"{readings} readings, chi2 {fit.chi2:.2f} for {fit.degrees_of_freedom} degrees of freedom,",
      "accepted" if fit.accepted else "refused")

"""The cube of pmcx's README in murk: a pencil beam into 60 x 60 x 60 mm of a scattering medium.

    python3 photon_cube.py [PHOTONS]

The same in pmcx (lengths in mm), which needs a GPU and is not part of Debian:

    import numpy as np, pmcx
    res = pmcx.run(nphoton=1000000, vol=np.ones([60, 60, 60], dtype='uint8'), tstart=0, tend=5e-9, tstep=5e-9,
                   srcpos=[30, 30, 0], srcdir=[0, 0, 1], prop=np.array([[0, 0, 1, 1], [0.005, 1, 0.01, 1.37]]))
    res['flux'].shape   # (60, 60, 60, 1): fluence rate per time step, without errors

Here: lengths in m, the beam a little off the edges of voxels, faces without and with Fresnel reflection.
"""
import sys

import murk

photons = int(sys.argv[1]) if len(sys.argv) > 1 else 1000000
MM = 1e-3
ABSORPTION, SCATTERING, G, N = 0.005 / MM, 1 / MM, 0.01, 1.37  # [1/m]
EXTINCTION = ABSORPTION + SCATTERING


def cube(refractive_index):
    """The light of the cube, whose faces reflect if the index is not 1."""
    return murk.Scene({
        "domain": {"min_m": [-MM] * 3, "max_m": [61 * MM] * 3},
        "media": {"tissue": {"extinction_per_m": EXTINCTION, "albedo": SCATTERING / EXTINCTION, "phase": {"hg": G}}},
        "regions": [{"medium": "tissue", "box": {"min_m": [0, 0, 0], "max_m": [60 * MM] * 3}, "ior": refractive_index}],
        # pmcx starts the photons inside, too: no light is reflected where the beam enters
        "lights": [{"type": "beam", "origin_m": [30.1 * MM, 30.2 * MM, 1e-9], "direction": [0, 0, 1], "power_w": 1}],
        "photons": {"emit": photons, "maps": "none"},
        "tallies": [{"name": "fluence", "type": "grid", "min_m": [0, 0, 0], "max_m": [60 * MM] * 3, "size": [60] * 3}],
    }).trace()


absorbed = {}
for name, index in (("faces let all light out", 1.0), ("faces reflect", N)):
    light = cube(index)
    share = light.ledger.absorbed_media_w.total / light.ledger.emitted_w.total
    error = (share * (1 - share) / photons) ** 0.5  # a photon is absorbed or not
    absorbed[name] = (share, error)
    print(f"{name}: {share:.5f} +- {error:.5f} of the power is absorbed")

# The fluence rate as an array, 60 x 60 x 60, with its standard errors [W/m2 for 1 W] -> [1/mm2].
tally = light.tally("fluence")
fluence, errors = tally.values[0] * MM**2, tally.errors[0] * MM**2
for depth in (0, 5, 10, 20):
    print(f"depth {depth + 0.5:4} mm: {fluence[30, 30, depth]:.4e} +- {errors[30, 30, depth]:.1e} 1/mm2")
absorbed_by_fluence = fluence.sum() * ABSORPTION * MM  # a voxel is 1 mm3
print(f"absorbed by the fluence: {absorbed_by_fluence:.5f}")

"""Scenarios in parallel by processes: four fogs, each in a process of its own with one thread.

    python3 parallel.py [serial | spawn | forkserver | futures]

Processes are spawned, not forked: threads of the library do not live in a forked process. Scenes travel to the
processes and plans come back by pickle; the results are those of one process, to the bit.
"""
import multiprocessing
import sys
from concurrent import futures

import murk

HALL = murk.Scene({
    "domain": {"min_m": [0, 0, 0], "max_m": [12, 8, 4]},
    "geometry": [{"box": {"min_m": [0, 0, 0], "max_m": [12, 8, 4]}}],
    "media": {"fog": {"extinction_per_m": 0.1, "albedo": 0.95, "phase": {"hg": 0.8}}},
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "sphere", "center_m": [6, 4, 3.5], "radius_m": 0.1, "power_w": 20}],
    "photons": {"emit": 10000},
    "sensors": {"types": [{"name": "node", "range_m": 8}], "count": 2,
                "candidates": {"grid": {"min_m": [1, 1, 1], "max_m": [11, 7, 3], "size": [4, 3, 2]}}},
})
EXTINCTIONS = [0.1, 0.3, 0.5, 0.7]


def plan_of(extinction_per_m):
    """The plan of one scenario, in whichever process."""
    scene = murk.Scene(text=HALL.resolved, context=murk.Context(threads=1, log=lambda *message: None))
    scene["media.fog.extinction_per_m"] = extinction_per_m
    return scene.place()


def main():
    way = sys.argv[1] if len(sys.argv) > 1 else "spawn"
    if way == "serial":
        plans = [plan_of(extinction) for extinction in EXTINCTIONS]
    elif way == "futures":
        with futures.ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
            plans = list(pool.map(plan_of, EXTINCTIONS))
    else:
        with multiprocessing.get_context(way).Pool(2) as pool:
            plans = pool.map(plan_of, EXTINCTIONS)
    for extinction, plan in zip(EXTINCTIONS, plans):
        print(extinction, repr(plan.coverage.held_out), plan.sensors[0].position_m)


if __name__ == "__main__":
    main()

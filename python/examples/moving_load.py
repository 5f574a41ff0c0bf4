"""A plan that follows what moves: a load is carried through a hall, and each new plan begins at the one before.

    python3 moving_load.py

Photons and sightlines that the load does not touch are taken over from step to step, so a step takes less time than
the plan of a new scene, and the result is the same in every bit.
"""
import murk

hall = murk.Scene({
    "domain": {"min_m": [-0.1, -0.1, -0.1], "max_m": [20.1, 12.1, 6.1]},
    "geometry": [
        {"box": {"min_m": [0, 0, 0], "max_m": [20, 12, 6]}},
        {"name": "load", "box": {"min_m": [-1, -1, -1], "max_m": [1, 1, 1]}, "translate_m": [2, 6, 2]},
    ],
    "materials": {"default": {"diffuse": 0.5}},
    "media": {"mist": {"extinction_per_m": 0.05, "albedo": 0.9}},
    "regions": [{"medium": "mist"}],
    "lights": [{"type": "sphere", "center_m": [x, 6, 5.5], "radius_m": 0.2, "power_w": 50} for x in (5, 15)],
    "photons": {"emit": 20000},
    "sensors": {"types": [{"name": "node", "range_m": 10}], "count": 4,
                "candidates": {"grid": {"min_m": [1, 1, 0.5], "max_m": [19, 11, 4], "size": [7, 5, 2]}}},
})
world = hall.world()
light = world.trace()
plan = light.place()
places = [{tuple(sensor["position_m"]) for sensor in plan.sensors}]
covered = [plan.coverage.held_out]
print(f"x =  2 m: coverage {covered[0]:.3f}")
for x in (6, 10, 14, 18):
    world = world.move("load", [x, 6, 2])
    light = light.update(world)
    plan = plan.update(light)
    places.append({tuple(sensor["position_m"]) for sensor in plan.sensors})
    covered.append(plan.coverage.held_out)
    print(f"x = {x:2} m: coverage {covered[-1]:.3f}, sensors moved: {len(places[-1] - places[-2])}")

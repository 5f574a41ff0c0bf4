"""The fields of each result file: which must be there, of which type and in
which range. Fields may be added to the files; none of these may go."""

import math
import re


def number(low, high=math.inf):
    return lambda v: type(v) in (int, float) and low <= v <= high


def whole(low, high=math.inf):
    return lambda v: type(v) is int and low <= v <= high


def text(pattern):
    return lambda v: type(v) is str and re.fullmatch(pattern, v) is not None


def one_of(*values):
    return lambda v: type(v) is str and v in values


def null(v):
    return v is None


def either(*kinds):
    return lambda v: any(kind(v) for kind in kinds)


def flag(v):
    return type(v) is bool


fraction = number(0, 1)
count = whole(0)
point = [number(-1e9, 1e9)] * 3


def complaints(value, kind, where):
    """kind: a dict of needed keys (others may be there), a list of exactly
    these items, a tuple of the one kind of all items, or a function."""
    if isinstance(kind, dict):
        if type(value) is not dict:
            yield f"{where} is no map: {value!r}"
            return
        for key, inner in kind.items():
            if key in value:
                yield from complaints(value[key], inner, f"{where}.{key}")
            else:
                yield f"{where}.{key} is missing"
    elif isinstance(kind, (list, tuple)):
        is_any_length = isinstance(kind, tuple)
        if type(value) is not list or not (is_any_length or len(value) == len(kind)):
            yield f"{where} is no such list: {value!r}"
            return
        for i, item in enumerate(value):
            inner = kind[0] if is_any_length else kind[i]
            yield from complaints(item, inner, f"{where}.{i}")
    elif not kind(value):
        yield f"{where} may not be {value!r}"


def many(kind):
    return (kind,)  # a list of any length


HEAD = {
    "murk": {"version": text(r"\d+\.\d+\.\d+"), "commit": text(".+"),
             "compiler": text(".+"),
             "packages": {"embree": text(r"3\..+"), "openvdb": text(r"10\..+"),
                          "assimp": text(r"\d.+"), "libyaml": text(r"\d.+"),
                          "xxhash": text(r"\d.+")}},
    "scene": text(".+"), "scene_sha256": text("[0-9a-f]{64}"),
    "seed": whole(0, 4294967295),
    "run": {"command": text("murk .+"), "folder": either(null, text("/.*")),
            "threads": whole(1),
            "seconds": {name: number(0, 600) for name in
                        ("load", "trace", "map", "sense", "place", "total")},
            "peak_memory_bytes": whole(1000000, 2000000000),
            "date": text(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ")}}
SUMMARY = {"run": HEAD["run"] | {"summary": many(text(r"[ -~]+"))}}
LIGHT = {"photons": {"emitted": whole(1), "surface": whole(1), "volume": whole(1)}}
SENSORS = {
    "sensors": many({"type": one_of("node"), "position_m": point, "axis": point,
                     "heading_deg": null, "tilt_deg": null, "covers": fraction,
                     "only_it_covers": fraction}),
    "seen_by_at_least": many(fraction),
    "regions_of_interest": many({"name": text(".+"), "weight": number(0),
                                 "stored_photons": count, "coverage": fraction,
                                 "standard_error": fraction,
                                 "held_out": either(null, fraction)})}
HELD = either(null, fraction)
ROBUST = {
    "robustness": {"drop_one": {"worst_sensor": whole(1), "worst_loss": fraction,
                                "mean_loss": fraction,
                                "without": many({"sensor": whole(1), "in_sample": fraction,
                                                 "held_out": HELD})},
                   "jitter": either(null, lambda v: not list(complaints(v, JITTER, ""))),
                   "link_range_m": either(null, number(0)), "plain_link_range_m": number(0),
                   "link_groups": whole(1),
                   "links": many({"from": whole(1), "to": whole(1), "length_m": number(0)})}}
JITTER = {"jitter_m": number(0), "jitter_deg": number(0, 180), "draws": whole(2),
          "measured": one_of("held_out", "in_sample"), "as_planned": fraction,
          "mean": fraction, "mean_standard_error": fraction, "quantile_5": fraction,
          "quantile_5_lower": HELD, "quantile_5_upper": HELD, "unmoved": count}
CANDIDATES = {"asked": count, "usable": count, "doubtful": count,
              "duplicates": count, "forbidden": count, "too_close": count,
              "unreached": count}
THIN = {"map": one_of("surface", "volume"), "photons": whole(1, 999), "weight": fraction,
        "standard_error": fraction, "variance_share": fraction}
SPREAD = {"median": number(0), "minimum": number(0), "maximum": number(0)}
REPEAT = {"asked": whole(1), "runs": whole(1), "first_seed": whole(0), "sensors": SPREAD,
          "in_sample": SPREAD, "held_out": SPREAD,
          "upper": SPREAD | {"mean": fraction, "standard_error": number(0)},
          "plan": {"coverage": fraction, "standard_error": number(0)},
          "gap": {"value": number(-1, 1), "lower": number(-1, 1), "upper": number(-1, 2),
                  "confidence": fraction, "runs": whole(2)},
          "best_seed": whole(0), "target_met": null}
PLAN = HEAD | SUMMARY | LIGHT | SENSORS | ROBUST | {
    "candidates": CANDIDATES | {"poses": count, "after_presolve": count},
    "targets": null, "thin_map": either(null, lambda v: not list(complaints(v, THIN, ""))),
    "weights_used": {"surface": fraction, "volume": fraction},
    "coverage": {"in_sample": fraction, "held_out": fraction,
                 "held_out_standard_error": fraction, "surface": fraction,
                 "volume": fraction, "ceiling": fraction, "sum_of_views": number(0)},
    "bound": {"upper": fraction, "gap": fraction, "proven_optimal": flag,
              "guarantee": text(".+")},
    "curve": many({"count": whole(1), "coverage": fraction, "upper": fraction}),
    "placement": {"method": one_of("best"), "detection": one_of("weighted"),
                  "visibility": one_of("ray"), "through": one_of("thin"),
                  "knowledge": one_of("known"), "restarts": count,
                  "evaluations": whole(1), "queries": whole(1), "looks": whole(1),
                  "shadow_rays": whole(1), "cut_by": null}}
COVERAGE = HEAD | SUMMARY | LIGHT | SENSORS | ROBUST | {
    "coverage": {"in_sample": fraction, "standard_error": number(1e-9, 1),
                 "held_out": null, "held_out_standard_error": null,
                 "surface": fraction, "volume": fraction,
                 "ceiling": either(null, fraction), "sum_of_views": number(0)}}
WATTS = {"total": number(0), "bands": [number(0)] * 2}
COLUMNS = ("absorbed_surfaces_w", "absorbed_media_w", "escaped_w", "lost_w")
LEDGER = HEAD | {name: WATTS for name in ("emitted_w",) + COLUMNS} | {
    "absorbed_by_material_w": {"default": WATTS, "floor": WATTS, "pane": WATTS},
    "absorbed_by_medium_w": {"fog": WATTS},
    "photons_emitted": whole(1), "collisions": count,
    "lost": {"events": count, "wraps": count, "numerical": count},
    "imbalance_quanta": whole(0, 0)}
CHECK = HEAD | {
    "surfaces": {"triangles": count, "spheres": count, "area_m2": number(0),
                 "materials": many({"name": text(".+"), "area_m2": number(0)})},
    "mesh_materials": many({"geometry": count, "file": text(".+"), "name": text(".*"),
                            "area_m2": number(0), "material": text(".+")}),
    "media": many({"name": text(".+"), "extinction_per_m": [number(0)] * 2,
                   "albedo": [fraction] * 2, "mean_cosine": [number(-1, 1)] * 2,
                   "phase": many({"kind": text("[a-z_]+"),
                                  "mean_cosine": number(-1, 1)})}),
    "tallies": many({"name": text(".+"), "type": one_of("plane", "grid", "sphere"),
                     "cells": whole(1), "unit": one_of("W", "W/m2")}),
    "candidates": CANDIDATES}
REPLAY = HEAD | {
    "photon": count,
    "events": many({"number": count,
                    "kind": one_of("emitted", "surface", "medium", "wrapped",
                                   "escaped", "lost"),
                    "position_m": point, "direction_in": point,
                    "direction_out": point, "path_m": number(0)})}

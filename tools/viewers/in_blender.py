"""Opens the .vdb and .ply files of a folder in Blender, run as
blender --background --python in_blender.py -- DIR PICTURES

A volume is shown by Blender's own material, as its menu would; a mesh in the colours of its
corners; points as small balls, since Blender 3.4's importer drops the colours of points.
"""

import math
import os
import sys

import bpy
from mathutils import Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import headers  # noqa: E402

SIZE = 400, 300
SAMPLES = 16
failures = []


def say(name, *words, failed=False):
    # importers leave lines open
    print("\nblender   %-20s %s" % (name, " ".join(str(word) for word in words)), flush=True)
    if failed:
        failures.append(name)


def check(holds, *words):
    if not holds:
        raise ValueError(" ".join(str(word) for word in words))


# ---- pictures ----

def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = False  # Debian's is built without
    scene.cycles.volume_bounces = 2
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = "Standard"
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    light = scene.world.node_tree.nodes["Background"].inputs
    light["Color"].default_value = (0.006, 0.007, 0.011, 1)


def frame(low, high):
    """A camera that sees the box from above, and a sun."""
    middle = (Vector(low) + Vector(high)) / 2
    radius = (Vector(high) - Vector(low)).length / 2
    camera = bpy.data.cameras.new("camera")
    camera.clip_end = 100 * radius
    away = Vector((-0.55, -0.85, 0.75)).normalized()
    camera.angle = math.radians(40)
    thing = bpy.data.objects.new("camera", camera)
    thing.location = middle + away * radius / math.sin(camera.angle / 2) * 1.1
    thing.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(thing)
    bpy.context.scene.camera = thing
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 12
    sun.rotation_euler = (math.radians(35), math.radians(-20), 0)
    bpy.context.collection.objects.link(sun)


def take(path):
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path)
    pixels = list(image.pixels)
    shades = {tuple(round(x, 2) for x in pixels[i:i + 3]) for i in range(0, len(pixels), 4)}
    check(len(shades) > 20, "the picture is blank:", len(shades), "shades")


# ---- volumes ----

def expected_grids(folder, name):
    """By the .vti beside it, where it says."""
    base = name[:-len(".vdb")]
    vti = os.path.join(folder, "fields.vti")
    begins = {"coverage": ("coverage_", "sensors_", "clarity_"), "extinction": ("extinction_",),
              "optical_depth": ("optical_depth_",)}.get(base)
    if base.endswith("_photons"):
        vti, begins = os.path.join(folder, base[:-len("_photons")] + ".vti"), ("photon_density",)
    if not begins or not os.path.exists(vti):
        return None, None
    names = [n for n in headers.vtk_arrays(vti)["CellData"] if n.startswith(begins)]
    return sorted(names + ["density"]), headers.domain(vti)


def check_place(low, high, origin, upper, spacing):
    """Blender's box reaches from the first voxel's middle of the first block of eight to the last
    one's of the last."""
    for a, b, o, u, s in zip(low, high, origin, upper, spacing):
        blocks = (a - o - s / 2) / (8 * s)
        check(abs(blocks - round(blocks)) < 1e-3 and blocks > -1e-3, "begins at", low, "in", origin)
        check(b < u + 8 * s, "ends at", high, "of", upper)


def open_volume(folder, name, picture):
    clear()
    bpy.ops.object.volume_import(filepath=os.path.join(folder, name), files=[])
    volume = bpy.context.object
    grids = volume.data.grids
    check(grids.load(), "cannot be read:", grids.error_message)
    names = sorted(grid.name for grid in grids)
    want, box = expected_grids(folder, name)
    check(want is None or names == want, "grids", names, "for", want)
    check(all(grid.data_type == "FLOAT" for grid in grids), "grids that are not float")
    corners = [volume.matrix_world @ Vector(c) for c in volume.bound_box]
    low, high = ([choose(c[k] for c in corners) for k in range(3)] for choose in (min, max))
    check(all(a < b for a, b in zip(low, high)), "no voxels")
    if box:
        check_place(low, high, *box)
    size = " x ".join("%.4g" % (b - a) for a, b in zip(low, high))
    if "density" in names:
        frame(low, high)
        take(picture)
    return "%s; %s m" % (", ".join(names), size)


# ---- meshes ----

def glowing(mesh=None):
    """In the mesh's own colours; without one, amber."""
    material = bpy.data.materials.new("colours")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    glow, out = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    links.new(glow.outputs["Emission"], out.inputs["Surface"])
    if mesh and mesh.color_attributes:
        color = nodes.new("ShaderNodeVertexColor")
        color.layer_name = mesh.color_attributes[0].name
        links.new(color.outputs["Color"], glow.inputs["Color"])
    else:
        glow.inputs["Color"].default_value = (1, 0.75, 0.3, 1)
    return material


def as_balls(thing, radius, material):
    """Vertices without faces are not rendered by themselves."""
    tree = bpy.data.node_groups.new("balls", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    nodes, links = tree.nodes, tree.links
    first, last = nodes.new("NodeGroupInput"), nodes.new("NodeGroupOutput")
    balls, paint = nodes.new("GeometryNodeMeshToPoints"), nodes.new("GeometryNodeSetMaterial")
    join = nodes.new("GeometryNodeJoinGeometry")
    balls.inputs["Radius"].default_value = radius
    paint.inputs["Material"].default_value = material
    links.new(first.outputs[0], balls.inputs["Mesh"])
    links.new(balls.outputs[0], paint.inputs["Geometry"])
    links.new(paint.outputs[0], join.inputs[0])
    links.new(first.outputs[0], join.inputs[0])
    links.new(join.outputs[0], last.inputs[0])
    thing.modifiers.new("balls", "NODES").node_group = tree


def open_mesh(folder, name, picture):
    path = os.path.join(folder, name)
    counts = headers.ply_counts(path)
    clear()
    bpy.ops.import_mesh.ply(filepath=path)
    thing = bpy.context.selected_objects[0]
    mesh = thing.data
    faces = counts.get("face", (0, []))[0]
    check(len(mesh.vertices) == counts["vertex"][0], len(mesh.vertices), "vertices, not", counts)
    check(len(mesh.polygons) == faces, len(mesh.polygons), "faces, not", faces)
    check(not faces or mesh.color_attributes, "no colours")
    corners = [Vector(c) for c in thing.bound_box]
    low, high = ([choose(c[k] for c in corners) for k in range(3)] for choose in (min, max))
    material = glowing(mesh)
    mesh.materials.clear()
    mesh.materials.append(material)
    if faces == 0 or len(mesh.vertices) > 3 * faces:
        as_balls(thing, 0.0015 * (Vector(high) - Vector(low)).length, glowing())
    elif name == "surfaces.ply":  # the walls that face the camera hide the rest
        hide_near(material)
    frame(low, high)
    take(picture)
    return "%d vertices, %d faces%s" % (len(mesh.vertices), faces,
                                        ", coloured" if mesh.color_attributes else "")


def hide_near(material):
    """What is seen from outside of a room: its near walls are made clear, by the way their
    triangles are wound, which points in or out as the scene has it; so only what is met first."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    path, clear_to = nodes.new("ShaderNodeLightPath"), nodes.new("ShaderNodeBsdfTransparent")
    mix, first = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeMath")
    first.operation = "LESS_THAN"
    first.inputs[1].default_value = 0.5
    glow = next(n for n in nodes if n.type == "EMISSION")
    out = next(n for n in nodes if n.type == "OUTPUT_MATERIAL")
    links.new(path.outputs["Transparent Depth"], first.inputs[0])
    links.new(first.outputs[0], mix.inputs["Fac"])
    links.new(glow.outputs[0], mix.inputs[1])
    links.new(clear_to.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], out.inputs["Surface"])


def last_line(error):
    """What an importer's traceback ends with."""
    lines = [line for line in str(error).splitlines()
             if line.strip() and not line.startswith((" ", "Location"))]
    return lines[-1] if lines else type(error).__name__


def main():
    folder, pictures = sys.argv[sys.argv.index("--") + 1:]
    names = sorted(n for n in os.listdir(folder) if n.endswith((".vdb", ".ply")))
    if not names:
        say("", "nothing to open: no .vdb and no .ply; murk place -o DIR --export "
            "fields,photons,surfaces")
    for name in names:
        opens = open_volume if name.endswith(".vdb") else open_mesh
        picture = os.path.join(pictures, "blender-%s.png" % name.replace(".", "-"))
        try:
            say(name, opens(folder, name, picture))
        except Exception as error:
            say(name, "FAILED:", last_line(error), failed=True)
    with open(os.path.join(pictures, ".blender"), "w") as file:
        file.write("".join(name + "\n" for name in failures))


main()

"""Run by scripts/check-blender inside Blender: MESH FOLDER after "--"."""

import csv
import sys

import bpy
import mathutils
import numpy

numpy.bool = bool  # Blender's importer of glTF in Debian 12 uses this name, which Debian's numpy no longer has
mesh_file, folder = sys.argv[sys.argv.index("--") + 1:]
TOLERANCE = 1e-5  # of the size of the mesh
worst = 0.0


def read_csv(name):
    frames = {}
    with open(f"{folder}/{name}", newline="") as file:
        for row in csv.DictReader(file):
            point = (float(row["x"]), float(row["y"]), float(row["z"]))
            frames.setdefault(int(row["frame"]), []).append(point)
    return frames


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = 30  # the importers convert seconds to frames


def imported(load):
    """The mesh objects that an importer adds."""
    clear()
    load()
    return [each for each in bpy.data.objects if each.type == "MESH"]


def vertices_at(thing, frame, placed):
    """The vertices after all modifiers, with the transformation of the object if asked for."""
    bpy.context.scene.frame_set(frame)
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    matrix = thing.matrix_world
    return [tuple(matrix @ v.co if placed else v.co) for v in mesh.vertices]


def compare(name, found, wanted, exact_order=True):
    global worst
    size = max(max(p[a] for p in wanted) - min(p[a] for p in wanted) for a in range(3))
    if exact_order and len(found) != len(wanted):
        raise SystemExit(f"Error: {name} has {len(found)} vertices, not {len(wanted)}")
    if not exact_order:  # split at seams: each vertex must be at the place of one of the wanted
        tree = mathutils.kdtree.KDTree(len(wanted))
        for index, point in enumerate(wanted):
            tree.insert(point, index)
        tree.balance()
        difference = max(tree.find(point)[2] for point in found) / size
    else:
        difference = max(abs(a[c] - b[c]) for a, b in zip(found, wanted) for c in range(3)) / size
    worst = max(worst, difference)
    print(f"  {name}: {len(found)} vertices, largest difference {difference:.2g} of the size")


def load_input():
    if mesh_file.lower().endswith(".ply"):
        bpy.ops.import_mesh.ply(filepath=mesh_file)
    else:
        bpy.ops.wm.obj_import(filepath=mesh_file)


def only(things):
    if len(things) != 1:
        raise SystemExit(f"Error: {len(things)} objects instead of one")
    return things[0]


def with_cache(kind, name):
    thing = only(imported(load_input))
    cache = thing.modifiers.new("cache", "MESH_CACHE")
    cache.cache_format = kind
    cache.filepath = f"{folder}/{name}"
    cache.frame_start = 0
    return thing


def z_up(points):
    return [(x, -z, y) for x, y, z in points]


wanted = read_csv("m.csv")
in_scene = read_csv("scene.csv")
last = max(wanted)
frames = sorted({0, last // 2, last})

thing = only(imported(lambda: bpy.ops.wm.obj_import(filepath=f"{folder}/end.obj")))
compare("OBJ, last frame", vertices_at(thing, 0, False), wanted[last])
thing = only(imported(lambda: bpy.ops.import_mesh.ply(filepath=f"{folder}/end.ply")))
compare("PLY, last frame", vertices_at(thing, 0, False), wanted[last])
for frame in frames:
    thing = with_cache("PC2", "m.pc2")
    compare(f"PC2 on the input, frame {frame}", vertices_at(thing, frame, False), wanted[frame])
for frame in frames:
    thing = with_cache("MDD", "m.mdd")
    compare(f"MDD on the input, frame {frame}", vertices_at(thing, frame, False), wanted[frame])
if "usd_import" in dir(bpy.ops.wm):
    thing = only(imported(lambda: bpy.ops.wm.usd_import(filepath=f"{folder}/m.usda")))
    for frame in frames:
        compare(f"USD, frame {frame}", vertices_at(thing, frame, False), wanted[frame])
else:
    print("  USD: this Blender cannot read it, as that of Debian 12")
thing = only(imported(lambda: bpy.ops.import_scene.gltf(filepath=f"{folder}/m.glb")))
for frame in frames:
    compare(f"GLB, frame {frame}", vertices_at(thing, frame, True), z_up(in_scene[frame]), exact_order=False)
if worst > TOLERANCE:
    raise SystemExit(f"Error: the largest difference is {worst:.2g} of the size")

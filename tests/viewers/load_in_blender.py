# SPDX-FileCopyrightText: 2026 the sweepkit authors
# SPDX-License-Identifier: MIT
#
# blender -b --python load_in_blender.py -- FILES.json RESULT.json: what Blender makes of each glTF file in the list,
# in the words of three_page.js's describe(). Blender's z is up: (x, y, z) here is (x, z, -y) there.
import json
import re
import sys

import numpy

numpy.bool = bool  # Blender 3.4's importer asks for what numpy 1.24 no longer has

import bpy  # noqa: E402


def describe(object):
    mesh = object.data
    mesh.calc_loop_triangles()
    local = numpy.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", local)
    matrix = numpy.array(object.matrix_world, dtype=float)
    world = local.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    world = numpy.stack([world[:, 0], world[:, 2], -world[:, 1]], axis=1)
    material = mesh.materials[0]
    # Normal maps are no colours.
    nodes = [node for node in material.node_tree.nodes if node.type == "TEX_IMAGE"]
    images = [node.image for node in nodes if node.image.colorspace_settings.name != "Non-Color"]
    return {
        "triangles": len(mesh.loop_triangles),
        "min": world.min(axis=0).tolist(),
        "max": world.max(axis=0).tolist(),
        "material": {"name": re.sub(r"\.\d{3}$", "", material.name)},  # of equal names the second gets .001
        "texture": list(images[0].size) if images else None,
    }


def load(file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=file)
    bpy.context.view_layer.update()
    return [describe(object) for object in bpy.data.objects if object.type == "MESH"]


listed, result = sys.argv[sys.argv.index("--") + 1 :]
with open(listed) as file:
    files = json.load(file)
with open(result, "w") as file:
    json.dump({name: load(name) for name in files}, file)

# SPDX-FileCopyrightText: 2026 the sweepkit authors
# SPDX-License-Identifier: MIT
#
# blender -b --python draw_in_cycles.py -- JOB.json RESULT.json: a .glb drawn by Cycles with its own camera, materials
# and lights, as linear [r, g, b] of each pixel, rows from the top, in the words of material_page.js's measure().
import json
import sys

import numpy

numpy.bool = bool  # Blender 3.4's importer asks for what numpy 1.24 no longer has

import bpy  # noqa: E402


def draw(job, picture):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # Watts are then the file's lux, with no share of them for the eye.
    bpy.ops.import_scene.gltf(filepath=job["file"], convert_lighting_mode="RAW")
    scene = bpy.context.scene
    white = 1 if job["isBeforeWhite"] else 0
    scene.world = bpy.data.worlds.new("round it")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (white, white, white, 1)
    for light in bpy.data.lights:
        light.angle = 0
    if job["isBeforeWhite"]:
        for material in bpy.data.materials:
            for node in material.node_tree.nodes if material.node_tree else []:
                if node.type == "BSDF_PRINCIPLED" and node.inputs["Metallic"].default_value == 0:
                    node.inputs["Base Color"].default_value = (0, 0, 0, 1)
    scene.camera = next(object for object in bpy.data.objects if object.type == "CAMERA")
    render = scene.render
    render.engine = "CYCLES"
    scene.cycles.samples = 64 if job["isBeforeWhite"] else 4
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.cycles.sample_clamp_indirect = 0
    render.resolution_x, render.resolution_y, render.resolution_percentage = job["width"], job["height"], 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.filepath = picture
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(picture)
    pixels = numpy.empty(4 * job["width"] * job["height"], numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(job["height"], job["width"], 4)[::-1, :, :3].reshape(-1, 3).tolist()


job, result = sys.argv[sys.argv.index("--") + 1 :]
with open(job) as file:
    drawn = draw(json.load(file), result + ".exr")
with open(result, "w") as file:
    json.dump(drawn, file)

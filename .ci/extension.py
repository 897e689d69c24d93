"""Tries the extension in Blender (the package bpy): installs it, grows on a mesh and on a plane, and renders both.

    extension.py EXTENSION.zip FOLDER

Run at the root of the repository. Ends with an error where something does not hold.
"""

import math
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

SIDE = 480  # px of a picture
TEXELS = 1024


def hold(condition, text):
    if not condition:
        raise SystemExit(f"extension.py: {text}")


def install(package):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.extensions.package_install_files(repo="user_default", filepath=str(package), enable_on_install=True)
    hold(hasattr(bpy.types, "DAPPLE_OT_grow_on_mesh"), "the extension is not there after it was installed")


def mesh():
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    while monkey.data.uv_layers:
        monkey.data.uv_layers.remove(monkey.data.uv_layers[0])
    monkey.scale = (1, 1, 1.2)
    bpy.context.view_layer.update()
    return monkey


def check(target, texels):
    (material,) = target.data.materials
    images = {node.image.name.split()[-1]: node.image for node in material.node_tree.nodes if node.type == "TEX_IMAGE"}
    hold(set(images) == {"BaseColor", "Roughness", "NormalGL"}, f"{target.name}: pictures {sorted(images)}")
    for name, image in images.items():
        hold(image.packed_file, f"{name} is not in the file")
        hold(texels is None or tuple(image.size) == (texels, texels), f"{name}: {tuple(image.size)}")
    hold(images["NormalGL"].colorspace_settings.name == "Non-Color", "normals are taken for colours")
    colour = np.empty(4 * math.prod(images["BaseColor"].size), np.float32)
    images["BaseColor"].pixels.foreach_get(colour)
    spread = colour.reshape(-1, 4)[:, :3].std(axis=0).max()
    hold(spread > 0.05, f"{target.name}: one colour, ± {spread:.3f}")
    print(f"  {target.name}: {images['BaseColor'].size[0]} × {images['BaseColor'].size[1]} texels, ± {spread:.2f}")


def render(target, path, eye):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 24, False
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.view_settings.view_transform = "Standard"
    scene.world = scene.world or bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.6, 0.6, 0.6, 1)
    for other in scene.objects:
        other.hide_render = other is not target
    light = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    light.data.energy = 2.5
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    middle = sum((target.matrix_world @ Vector(corner) for corner in target.bound_box), Vector()) / 8
    for added, direction in [(light, (-0.5, -0.7, 1.0)), (camera, eye)]:
        scene.collection.objects.link(added)
        direction = Vector(direction).normalized()
        added.location = middle + 5.5 * direction
        added.rotation_euler = direction.to_track_quat("Z", "Y").to_euler()
    scene.camera = camera
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    for added in (light, camera):
        bpy.data.objects.remove(added)
    print(f"  {path}")


def refuses(document):
    try:
        bpy.ops.dapple.grow_on_mesh(filepath=document)
    except RuntimeError as error:
        return str(error)
    raise SystemExit("extension.py: a document that is not there was grown")


package, folder = Path(sys.argv[1]), Path(sys.argv[2])
install(package)
target = mesh()
hold("nowhere.dapple: cannot be read" in refuses("nowhere.dapple"), "the message names no file")
bpy.ops.dapple.grow_on_mesh(filepath="examples/cheetah-run.dapple", px=500, texels=TEXELS, seed=3)
check(target, TEXELS)
render(target, folder / "mesh.png", (0.4, -1.0, 0.25))
bpy.ops.dapple.grow_on_plane(filepath="examples/tiger.dapple", scale=1)
check(bpy.context.object, None)
render(bpy.context.object, folder / "plane.png", (0.0, -0.5, 1.0))

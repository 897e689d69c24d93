# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and materials of Blender."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy
import numpy as np

MAPS = {
    "Base Color": ("BaseColor", "sRGB"),
    "Roughness": ("Roughness", "Non-Color"),
    "Normal": ("NormalGL", "Non-Color"),
}


def ensure_texture_coordinates(context: Any, target: Any) -> None:
    """Give a mesh texture coordinates if it has none."""
    if target.data.uv_layers:
        return
    context.view_layer.objects.active = target
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    # With its default of 66° some pieces overlap themselves.
    bpy.ops.uv.smart_project(angle_limit=math.radians(45), island_margin=0.005)
    bpy.ops.object.mode_set(mode="OBJECT")


def write_obj(target: Any, path: Path) -> None:
    """Write the mesh of an object as it is scaled, with its texture coordinates; modifiers do not count."""
    mesh = target.data
    places = np.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", places)
    places = places.reshape(-1, 3) * np.array(target.matrix_world.to_scale())
    uvs = np.empty(2 * len(mesh.loops))
    mesh.uv_layers.active.uv.foreach_get("vector", uvs)
    corners = np.empty(len(mesh.loops), int)
    mesh.loops.foreach_get("vertex_index", corners)
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in places]
    lines += [f"vt {u:.9g} {v:.9g}" for u, v in uvs.reshape(-1, 2)]
    for face in mesh.polygons:
        lines.append("f " + " ".join(f"{corners[loop] + 1}/{loop + 1}" for loop in face.loop_indices))
    path.write_text("\n".join(lines) + "\n")


def material(name: str, folder: Path, prefix: str) -> Any:
    """Make a material of the maps in a folder; their pictures are packed into the file of the scene."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    for row, (entry, (map_name, space)) in enumerate(MAPS.items()):
        image = bpy.data.images.load(str(folder / f"{prefix}_{map_name}.png"))
        image.name = f"{name} {map_name}"
        image.colorspace_settings.name = space
        image.pack()
        node = nodes.new("ShaderNodeTexImage")
        node.image, node.location = image, (-700, 300 - 300 * row)
        colour = node.outputs["Color"]
        if entry == "Normal":
            normals = nodes.new("ShaderNodeNormalMap")
            normals.location = (-300, 300 - 300 * row)
            links.new(colour, normals.inputs["Color"])
            colour = normals.outputs["Normal"]
        links.new(colour, shader.inputs[entry])
    return made


def put_on(target: Any, made: Any) -> None:
    """Give an object this material alone."""
    target.data.materials.clear()
    target.data.materials.append(made)


def plane(context: Any, name: str, size: Sequence[int]) -> Any:
    """Add a plane with the proportions of a canvas, 2 m along its longer side, and select it."""
    x, y = (side / max(size) for side in size)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], [], [(0, 1, 2, 3)])
    mesh.uv_layers.new(name="UVMap").uv.foreach_set("vector", [0, 0, 1, 0, 1, 1, 0, 1])
    added = bpy.data.objects.new(name, mesh)
    context.collection.objects.link(added)
    for selected in context.selected_objects:
        selected.select_set(False)
    added.select_set(True)
    context.view_layer.objects.active = added
    return added

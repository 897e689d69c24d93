"""Imports models that dapple wrote into Blender (the package bpy) and compares what Blender holds with the files.

    blender.py FILE... --truth TRUTH.ply --texels N [--up z] [--pictures FOLDER]

Each FILE is a .glb, .gltf or .obj of the same growth; TRUTH.ply has its colours by vertex, in the coordinates of the model's
file, and says which colour is right at a place. N is the side of the textures. With --up z the model's own upward axis is z.
Prints a line for each fact and ends with an error at the first that does not hold.
"""

import argparse
import json
import math
import random
import struct
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree
from mathutils.geometry import barycentric_transform

SIDE = 400  # px of a picture
SAMPLES = 24  # rays a px
PLACES = 3000  # places whose colours are compared


class Wrong(Exception):
    """A fact that does not hold."""


def hold(condition, text):
    if not condition:
        raise Wrong(text)


# --- What is in the files, without Blender ----------------------------------------------------------------


class Part:
    """A mesh of a file: its name, places (n × 3) and triangles, and whether it has texture coordinates and colours."""

    def __init__(self, name, places, triangles, has_uvs, has_colours):
        self.name, self.places, self.triangles = name, places, triangles
        self.has_uvs, self.has_colours = has_uvs, has_colours


def read_gltf(path):
    data = path.read_bytes()
    if path.suffix == ".glb":
        length = struct.unpack_from("<I", data, 12)[0]
        root, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    else:
        root = json.loads(data)
        binary = (path.parent / root["buffers"][0]["uri"]).read_bytes()

    def places(index):
        accessor = root["accessors"][index]
        start = root["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return np.frombuffer(binary, "<f4", 3 * accessor["count"], start).reshape(-1, 3)

    parts = []
    for mesh in root["meshes"]:
        hold(len(mesh["primitives"]) == 1, f"{path.name}: a mesh of several primitives")
        primitive = mesh["primitives"][0]
        has = primitive["attributes"]
        triangles = root["accessors"][primitive["indices"]]["count"] // 3
        parts.append(Part(mesh["name"], places(has["POSITION"]), triangles, "TEXCOORD_0" in has, "COLOR_0" in has))
    return parts


def read_obj(path):
    parts = []
    for line in path.read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "o":
            parts.append(Part(words[0], [], 0, False, False))
        elif kind == "v":
            parts[-1].places.append([float(word) for word in words])
        elif kind == "vt":
            parts[-1].has_uvs = True
        elif kind == "f":
            parts[-1].triangles += len(words) - 2
    for part in parts:
        part.places = np.array(part.places)
    return parts


def read_truth(path):
    """Places and colours, 0..1, of a binary .ply."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:end].decode().splitlines()
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[-1])
    before_faces = lines[: next(i for i, line in enumerate(lines) if line.startswith("element face"))]
    types = {"float": "<f4", "uchar": "u1"}
    fields = [line.split()[1:] for line in before_faces if line.startswith("property")]
    rows = np.frombuffer(data, np.dtype([(name, types[kind]) for kind, name in fields]), count, end)
    columns = lambda names: np.stack([rows[name] for name in names], axis=1).astype(float)
    return columns(["x", "y", "z"]), columns(["red", "green", "blue"]) / 255


# --- Blender ------------------------------------------------------------------------------------------------


def load(path, up):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.suffix == ".obj":
        axes = {"y": {"forward_axis": "NEGATIVE_Z", "up_axis": "Y"}, "z": {"forward_axis": "Y", "up_axis": "Z"}}
        bpy.ops.wm.obj_import(filepath=str(path), **axes[up])
    else:
        bpy.ops.import_scene.gltf(filepath=str(path))
    objects = [found for found in bpy.context.scene.objects if found.type == "MESH"]
    bpy.context.view_layer.update()
    return objects


def world(found):
    """The places of an object's vertices in the world."""
    local = np.empty(3 * len(found.data.vertices))
    found.data.vertices.foreach_get("co", local)
    matrix = np.array(found.matrix_world)
    return local.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


def to_blender(places, up):
    """Blender's z points up. Files of glTF have y up."""
    return places if up == "z" else np.stack([places[:, 0], -places[:, 2], places[:, 1]], axis=1)


def check_parts(objects, parts, up):
    hold(len(objects) == len(parts), f"{len(objects)} meshes; the file has {len(parts)}")
    for part in parts:
        found = next((found for found in objects if found.name == part.name), None)
        hold(found, f"no mesh has the name {part.name}, but {[found.name for found in objects]}")
        mesh = found.data
        counts = (len(mesh.vertices), len(mesh.polygons))
        hold(counts == (len(part.places), part.triangles), f"{part.name}: {counts}, not {len(part.places), part.triangles}")
        hold(bool(mesh.uv_layers) == part.has_uvs, f"{part.name}: {len(mesh.uv_layers)} sets of texture coordinates")
        here, there = world(found), to_blender(part.places, up)
        off = max(np.abs(here.min(0) - there.min(0)).max(), np.abs(here.max(0) - there.max(0)).max())
        hold(off <= 1e-5 * np.ptp(there, axis=0).max(), f"{part.name}: its bounding box is off by {off}")
        # Normals of the file and orders of corners agree, and both point outwards.
        mesh.calc_loop_triangles()
        agree = sum(face.normal.dot(mesh.corner_normals[face.loop_start].vector) > 0 for face in mesh.polygons)
        hold(agree >= 0.99 * len(mesh.polygons), f"{part.name}: {agree} of {len(mesh.polygons)} faces agree with normals")
        corners = here[np.array([triangle.vertices for triangle in mesh.loop_triangles])]
        volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
        hold(volume > 0, f"{part.name}: it is inside out, its volume is {volume:.3g}")
        print(f"  {part.name}: {counts[0]} vertices, {counts[1]} faces, box {np.ptp(here, axis=0).round(3).tolist()}")


def from_node(socket, kind):
    """The nearest node of a kind that a socket is fed by."""
    for link in socket.links:
        if link.from_node.type == kind:
            return link.from_node
        for entry in link.from_node.inputs:
            if node := from_node(entry, kind):
                return node
    return None


def shader(material):
    hold(material.node_tree, f"{material.name}: no nodes")
    return next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")


def check_textures(material, texels, is_obj):
    """Pictures of colours, normals and roughness feed the shader; returns that of the colours."""
    entries, pictures = shader(material).inputs, {}
    for name, space in [("Base Color", "sRGB"), ("Normal", "Non-Color"), ("Roughness", "Non-Color")]:
        node = from_node(entries[name], "TEX_IMAGE")
        hold(node and node.image, f"{material.name}: no picture feeds {name}")
        hold(tuple(node.image.size) == (texels, texels), f"{name}: {tuple(node.image.size)} px, not {texels}")
        if is_obj:
            # Blender takes all pictures of an .obj as colours; its user has to set this.
            node.image.colorspace_settings.name = space
        hold(node.image.colorspace_settings.name == space, f"{name}: {node.image.colorspace_settings.name}, not {space}")
        pictures[name] = node.image
    normal_map = from_node(entries["Normal"], "NORMAL_MAP")
    hold(normal_map, f"{material.name}: its normals are not those of a normal map")
    strength = normal_map.inputs["Strength"].default_value
    hold(strength == 1, f"{material.name}: its normal map has the strength {strength}")
    hold(len({image.name for image in pictures.values()}) == 3, "one picture has two uses")
    print(f"  {material.name}: colours, normals and roughness of {texels} × {texels} px")
    return pictures["Base Color"]


def missing_pictures():
    """Names of pictures that Blender cannot load, which it does when their pixels are asked for."""
    return [image.name for image in bpy.data.images if image.source == "FILE" and not (len(image.pixels) and image.has_data)]


def of_picture(image):
    width, height = image.size
    rgba = np.empty(4 * width * height, np.float32)
    image.pixels.foreach_get(rgba)
    pixels = rgba.reshape(height, width, 4)  # the lowest row first, as coordinates count

    def colour(found, face, place):
        loops = found.data.polygons[face].loop_indices
        corners = [found.data.vertices[found.data.loops[loop].vertex_index].co for loop in loops]
        uvs = [Vector((*found.data.uv_layers.active.data[loop].uv, 0)) for loop in loops]
        u, v, _ = barycentric_transform(place, *corners, *uvs)
        column, row = (min(max(int(at * side), 0), side - 1) for at, side in [(u, width), (v, height)])
        return pixels[row, column, :3]

    return colour


def of_vertices(found, face, place):
    mesh = found.data
    light = mesh.color_attributes[0].data
    by_corner = mesh.color_attributes[0].domain == "CORNER"
    loops = mesh.polygons[face].loop_indices
    vertices = [mesh.loops[loop].vertex_index for loop in loops]
    nearest = min(range(3), key=lambda at: (mesh.vertices[vertices[at]].co - place).length)
    return np.array(light[loops[nearest] if by_corner else vertices[nearest]].color_srgb[:3])


def check_colours(found, colour, truth, up):
    """The colours of places are those of the truth: no texture is mirrored, turned or elsewhere."""
    places, colours = to_blender(truth[0], up), truth[1]
    tree = BVHTree.FromPolygons(
        [vertex.co[:] for vertex in found.data.vertices], [face.vertices[:] for face in found.data.polygons]
    )
    inverse = found.matrix_world.inverted()
    longest = max(found.dimensions)
    mean = colours.mean(0)
    axis = np.linalg.svd(colours - mean, full_matrices=False)[2][0]  # from the ground to the marks
    sides, here, there, seen = [], [], [], 0
    order = random.Random(1).sample(range(len(places)), min(4 * PLACES, len(places)))
    for at in order:
        nearest, _, face, distance = tree.find_nearest(inverse @ Vector(places[at]))
        if nearest is None or distance > 0.01 * longest or seen == PLACES:
            continue
        seen += 1
        got = colour(found, face, nearest)
        here.append(got @ axis)
        there.append(colours[at] @ axis)
    here, there = np.array(here), np.array(there)
    middle = 0.5 * (there.min() + there.max())
    share = ((here > middle) == (there > middle)).mean()
    marks = (there > middle).mean()
    hold(0.03 < marks < 0.97, f"{marks:.0%} of the places are of one side; nothing can be told")
    hold(share >= 0.97, f"{found.name}: {share:.1%} of {seen} places have their colour")
    print(f"  {found.name}: {share:.2%} of {seen} places have their colour")


# --- Pictures -----------------------------------------------------------------------------------------------


def prepare(samples=SAMPLES):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.seed = 1
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.world = bpy.data.worlds.new("world")
    if not scene.world.node_tree:
        scene.world.use_nodes = True
    return scene


def sky(light):
    node = next(node for node in bpy.context.scene.world.node_tree.nodes if node.type == "BACKGROUND")
    node.inputs["Color"].default_value = (light, light, light, 1)


def looking(direction):
    """A rotation whose −z looks from `direction` at the middle; upwards is z, or y where it looks along z."""
    back = Vector(direction).normalized()
    right = Vector((0, 1, 0) if abs(back.z) > 0.999 else (0, 0, 1)).cross(back).normalized()
    return Matrix([right, back.cross(right), back]).transposed().to_4x4()


def box(objects):
    places = np.concatenate([world(found) for found in objects])
    return places.min(0), places.max(0)


def camera(objects, direction):
    low, high = box(objects)
    data = bpy.data.cameras.new("camera")
    data.type = "ORTHO"
    data.ortho_scale = 0.85 * float(np.linalg.norm(high - low))
    data.clip_end = 100 * data.ortho_scale
    found = bpy.data.objects.new("camera", data)
    bpy.context.scene.collection.objects.link(found)
    away = Matrix.Translation((0, 0, 2 * data.ortho_scale))
    found.matrix_world = Matrix.Translation(Vector((low + high) / 2)) @ looking(direction) @ away
    bpy.context.scene.camera = found
    return found


def sun(direction, strength):
    data = bpy.data.lights.new("sun", "SUN")
    data.energy, data.angle = strength, 0.02
    found = bpy.data.objects.new("sun", data)
    bpy.context.scene.collection.objects.link(found)
    found.matrix_world = looking(direction)
    return found


def rendered(path, format="PNG"):
    scene = bpy.context.scene
    scene.render.image_settings.file_format = format
    if format == "OPEN_EXR":
        scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path), check_existing=False)
    rgba = np.empty(4 * SIDE * SIDE, np.float32)
    image.pixels.foreach_get(rgba)
    bpy.data.images.remove(image)
    return rgba.reshape(SIDE, SIDE, 4)[:, :, :3]


def check_render(objects, folder, name):
    prepare()
    sky(0.6)
    light = sun((-0.5, -0.7, 1.0), 2.0)
    for side, degrees in enumerate([-30, 150]):
        turned = math.radians(degrees)
        eye = camera(objects, (math.sin(turned), -math.cos(turned), 0.6))
        light.matrix_world = looking((math.sin(turned - 0.7), -math.cos(turned - 0.7), 1.0))
        picture = rendered(folder / f"{name}-{side + 1}.png")
        corner = picture[0, 0]
        inside = picture[np.abs(picture - corner).max(2) > 0.03]
        hold(len(inside) > 0.05 * SIDE * SIDE, f"{name}: only {len(inside)} px show the model")
        spread = inside.std(0).max()
        hold(spread > 0.05, f"{name}: its picture has one colour, ± {spread:.3f}")
        bpy.data.objects.remove(eye)
    bpy.data.objects.remove(light)
    print(f"  rendered: {folder / name}-1.png, -2.png")


def check_bumps(objects, material, image, folder):
    """Light from one side makes those flanks of marks brighter that face it, and the others darker."""
    scene = prepare(samples=16)
    sky(0.0)
    camera(objects, (0, 0, 1))
    tree = material.node_tree
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    normal_map = from_node(shader(material).inputs["Normal"], "NORMAL_MAP")
    path = folder / "bump.exr"
    # What is where: the colours without light.
    plain, texture = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeTexImage")
    texture.image = image
    shown = output.inputs["Surface"].links[0].from_socket
    tree.links.new(texture.outputs["Color"], plain.inputs["Color"])
    tree.links.new(plain.outputs["Emission"], output.inputs["Surface"])
    colours = rendered(path, "OPEN_EXR")
    tree.links.new(shown, output.inputs["Surface"])
    is_model = colours.sum(2) > 0.01
    within = is_model.copy()  # not at the border of the model, where colours end
    for axis, step in [(0, 2), (0, -2), (1, 2), (1, -2)]:
        within &= np.roll(is_model, step, axis)
    axis = np.linalg.svd(colours[is_model] - colours[is_model].mean(0), full_matrices=False)[2][0]
    mark = colours @ axis
    # Marks are darker than the ground in the documents of this test.
    dark = colours[is_model].sum(1) < np.median(colours[is_model].sum(1)) * 0.5
    if mark[is_model][dark].mean() < mark[is_model].mean():
        mark = -mark
    mark = (mark - mark[is_model].min()) / np.ptp(mark[is_model])
    for name, direction, along in [("+x", (1, 0, 1), 1), ("+y", (0, 1, 1), 0)]:
        light = sun(direction, 3.0)
        normal_map.inputs["Strength"].default_value = 0.0
        smooth = rendered(path, "OPEN_EXR").sum(2)
        normal_map.inputs["Strength"].default_value = 1.0
        bumpy = rendered(path, "OPEN_EXR").sum(2)
        bpy.data.objects.remove(light)
        # How the height falls toward the light; rows of a picture count upwards. Flanks that run toward the light are darker on both sides.
        fall, across = -np.gradient(mark, axis=along), np.gradient(mark, axis=1 - along)
        lit = within & (smooth > 0.2 * smooth[is_model].mean()) & (np.abs(fall) > 2 * np.abs(across))
        toward, away = lit & (fall > 0.15), lit & (fall < -0.15)
        hold(min(toward.sum(), away.sum()) > 100, f"light from {name}: {toward.sum()} and {away.sum()} px of flanks")
        bright, dim = (float(np.median(bumpy[where] / smooth[where])) for where in [toward, away])
        print(f"  light from {name}: flanks toward it {bright:.2f} times as bright as without normals, others {dim:.2f}")
        hold(bright > 1.03 and dim < 0.97, "the normal map is lit from the wrong side")
    path.unlink()


# --- All of it ----------------------------------------------------------------------------------------------


def check(path, truth, texels, up, folder):
    is_obj = path.suffix == ".obj"
    parts = read_obj(path) if is_obj else read_gltf(path)
    up_of_file = up if is_obj else "y"
    objects = load(path, up)
    check_parts(objects, parts, up_of_file)
    grown = next(found for found in objects if found.name == "grown")
    material = grown.data.materials[0]
    name = f"{path.stem}-{path.suffix[1:]}"
    if next(part for part in parts if part.name == "grown").has_colours:
        hold(from_node(shader(material).inputs["Base Color"], "VERTEX_COLOR"), "no colours by vertex feed the shader")
        check_colours(grown, of_vertices, truth, up)
        check_render(objects, folder, name)
        return
    hold(not missing_pictures(), f"missing pictures: {missing_pictures()}")
    image = check_textures(material, texels, is_obj)
    check_colours(grown, of_picture(image), truth, up)
    check_render(objects, folder, name)
    check_bumps(objects, material, image, folder)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("files", nargs="+", type=Path)
    arguments.add_argument("--truth", required=True, type=Path)
    arguments.add_argument("--texels", required=True, type=int)
    arguments.add_argument("--up", default="y", choices=["y", "z"])
    arguments.add_argument("--pictures", required=True, type=Path)
    given = arguments.parse_args()
    print(f"Blender {bpy.app.version_string}")
    truth = read_truth(given.truth)
    for path in given.files:
        print(path.name)
        try:
            check(path, truth, given.texels, given.up, given.pictures.resolve())
        except Wrong as wrong:
            sys.exit(f"{path.name}: {wrong}")


main()

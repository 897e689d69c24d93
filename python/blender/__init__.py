# SPDX-License-Identifier: GPL-3.0-or-later
"""Grow dapple's documents in Blender: on the active mesh, or on a new plane."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any, ClassVar

import bpy

import dapple

from . import scene
from .growing import Growing

STAGES = {"plan": "planning", "grow": "growing", "refine": "correcting", "write": "writing"}


class Grows:
    """What both operators have in common: a document, a growth on a thread of its own, and Esc."""

    bl_options: ClassVar[set[str]] = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(name="Document", subtype="FILE_PATH")
    filter_glob: bpy.props.StringProperty(default="*.dapple;*.png", options={"HIDDEN"})
    seed: bpy.props.IntProperty(name="Seed", description="-1 is the document's own", default=-1, min=-1)
    relief: bpy.props.FloatProperty(name="Relief", description="Height of the marks, px of the sketch", default=6.0)

    def invoke(self, context: Any, event: Any) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Any) -> set[str]:
        self.folder = tempfile.TemporaryDirectory(prefix="dapple-")
        try:
            self.growing = Growing(self.work(context))
        except (dapple.Error, OSError) as error:
            return self.failed(context, error)
        if bpy.app.background:
            self.growing.wait()
            return self.end(context)
        self.timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        if event.type == "ESC":
            self.growing.cancel()
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        stage, share = self.growing.progress
        context.workspace.status_text_set(f"dapple is {STAGES[stage]}: {share:.0%} (Esc stops it)")
        if self.growing.is_alive():
            return {"RUNNING_MODAL"}
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        return self.end(context)

    def end(self, context: Any) -> set[str]:
        try:
            grown = self.growing.result()
            if grown is None:
                self.report({"INFO"}, "stopped")
                return {"CANCELLED"}
            self.place(context, grown)
        except (dapple.Error, OSError) as error:
            return self.failed(context, error)
        finally:
            self.folder.cleanup()
        return {"FINISHED"}

    def failed(self, context: Any, error: Exception) -> set[str]:
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}

    # Blender's own operators have properties called options and name.
    def given_seed(self) -> dict[str, int]:
        return {} if self.seed < 0 else {"seed": self.seed}

    def stem(self) -> str:
        return Path(self.filepath).stem or "dapple"


class GrowOnMesh(Grows, bpy.types.Operator):
    """Grow a document on the active mesh and give it the material."""

    bl_idname = "dapple.grow_on_mesh"
    bl_label = "Grow on the active mesh"

    px: bpy.props.FloatProperty(
        name="Size", description="The longest side of the mesh, px of the sketch", default=900.0, min=1.0, max=65536.0
    )
    texels: bpy.props.IntProperty(
        name="Texels", description="Width and height of the maps", default=2048, min=64, max=8192
    )

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and context.object.type == "MESH" and context.mode == "OBJECT"

    def work(self, context: Any) -> Any:
        """Return what to do on a thread: it touches nothing of Blender's."""
        self.target = context.object
        scene.ensure_texture_coordinates(context, self.target)
        model = Path(self.folder.name) / "mesh.obj"
        scene.write_obj(self.target, model)
        document = dapple.read(self.filepath)
        document["model"] = {**kept(document), "file": "mesh.obj", "px": self.px, "up": "z"}
        folder, mesh, seed = self.folder.name, self.target.name, self.given_seed()
        size, relief = [self.texels] * 2, self.relief

        def grow(progress: Any) -> Any:
            grown = dapple.grow_on_model(document, model=model, progress=progress, **seed)
            if grown.unfit:
                message = f"{mesh}: {grown.unfit}; allowed: coordinates from 0 to 1, without overlaps"
                raise OSError(message)
            grown.material(folder, name="map", size=size, relief=relief)
            return grown

        return grow

    def place(self, context: Any, grown: Any) -> None:
        material = scene.material(self.stem(), Path(self.folder.name), "map")
        scene.put_on(self.target, material)


def kept(document: dict[str, Any]) -> dict[str, Any]:
    """Return what of a document's own model holds for any other: the direction of the sketch."""
    model = document.get("model") or {}
    return {key: model[key] for key in ("along",) if key in model}


class GrowOnPlane(Grows, bpy.types.Operator):
    """Grow a document on a new plane."""

    bl_idname = "dapple.grow_on_plane"
    bl_label = "Grow on a new plane"

    scale: bpy.props.IntProperty(name="Scale", description="Texels a px along each side", default=2, min=1, max=16)

    def work(self, context: Any) -> Any:
        """Return what to do on a thread: it touches nothing of Blender's."""
        path, folder, seed = self.filepath, self.folder.name, self.given_seed()
        relief, scale = self.relief, self.scale

        def grow(progress: Any) -> Any:
            grown = dapple.grow(path, progress=progress, **seed)
            grown.material(folder, name="map", relief=relief, scale=scale)
            return grown

        return grow

    def place(self, context: Any, grown: Any) -> None:
        material = scene.material(self.stem(), Path(self.folder.name), "map")
        scene.put_on(scene.plane(context, self.stem(), grown.size), material)


class Panel(bpy.types.Panel):
    """The operators, in the sidebar of the 3D view."""

    bl_idname = "VIEW3D_PT_dapple"
    bl_label = "dapple"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "dapple"

    def draw(self, context: Any) -> None:
        self.layout.operator(GrowOnMesh.bl_idname)
        self.layout.operator(GrowOnPlane.bl_idname)


CLASSES = (GrowOnMesh, GrowOnPlane, Panel)


def register() -> None:
    """Add the operators and the panel."""
    for added in CLASSES:
        bpy.utils.register_class(added)


def unregister() -> None:
    """Remove the operators and the panel."""
    for removed in reversed(CLASSES):
        bpy.utils.unregister_class(removed)

"""The commands and the panel."""
import os
import tempfile

import bpy
from bpy_extras.io_utils import ExportHelper

import dragmesh

from . import inference, rig


def _parts(context):
    """The selected parts that have a joint."""
    return [thing for thing in context.selected_objects if thing.type == "MESH" and len(thing.dragmesh.hypotheses) > 0]


class Infer(bpy.types.Operator):
    """Find out how the selected objects move against the active one, the body"""
    bl_idname, bl_label, bl_options = "dragmesh.infer", "Infer joints", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        active = context.active_object
        return active is not None and active.type == "MESH" and len(context.selected_objects) > 1

    def execute(self, context):
        body = context.active_object
        parts = [thing for thing in context.selected_objects if thing.type == "MESH" and thing != body]
        manager = context.window_manager
        manager.progress_begin(0, 1)
        try:
            for part in parts:
                rig.remove(part)
            depsgraph = context.evaluated_depsgraph_get()
            with dragmesh.Context(axes=dragmesh.Axes.BLENDER) as library:
                prepared = inference.prepare(library, body, parts, depsgraph, manager.progress_update)
                for number, part in enumerate(parts):
                    inference.keep(part, number + 1, body, prepared)
        except (dragmesh.Error, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            manager.progress_end()
        for part in parts:
            rig.build(part)
        self.report({"INFO"}, f"{len(parts)} joints")
        return {"FINISHED"}


class RigAsset(bpy.types.Operator):
    """Find out which of the selected objects move, which of them as one, and how; without a selection, of all"""
    bl_idname, bl_label, bl_options = "dragmesh.rig", "Find what moves", {"REGISTER", "UNDO"}

    @staticmethod
    def things(context):
        """The objects that are asked about."""
        chosen = [thing for thing in context.selected_objects if thing.type == "MESH"]
        return chosen if len(chosen) > 1 else [thing for thing in context.scene.objects if thing.type == "MESH"]

    @classmethod
    def poll(cls, context):
        return len(cls.things(context)) > 1

    def execute(self, context):
        things, manager = self.things(context), context.window_manager
        manager.progress_begin(0, 1)
        try:
            for thing in things:
                rig.remove(thing)
            with dragmesh.Context(axes=dragmesh.Axes.BLENDER) as library:
                asset = inference.ask(library, things, context.evaluated_depsgraph_get(), manager.progress_update)
                found = inference.parts_of(asset, things)
                moving = {thing for _, main, others in found for thing in (main, *others)}
                body = max((thing for thing in things if thing not in moving), default=None, key=lambda thing: thing.dimensions.length)
                prepared = asset.make_object()
                for number, main, _ in found:
                    inference.keep(main, number, body, prepared)
        except (dragmesh.Error, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            manager.progress_end()
        for _, main, others in found:
            for other in others:
                rig.hang(other, main)
            rig.build(main)
        self.report({"INFO"}, f"{len(found)} of {len(things)} objects move by a joint of their own")
        return {"FINISHED"}


class NextHypothesis(bpy.types.Operator):
    """Take the next most probable joint of the selected parts"""
    bl_idname, bl_label, bl_options = "dragmesh.next", "Next hypothesis", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return bool(_parts(context))

    def execute(self, context):
        for part in _parts(context):
            part.dragmesh.chosen = (part.dragmesh.chosen + 1) % len(part.dragmesh.hypotheses)
            rig.build(part)
        return {"FINISHED"}


class Apply(bpy.types.Operator):
    """Put origins on the pivots, set limits, key the opening, and write custom properties"""
    bl_idname, bl_label, bl_options = "dragmesh.apply", "Make openable", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return bool(_parts(context))

    def execute(self, context):
        for part in _parts(context):
            joint = inference.joint_of(part)
            rig.attach(part)
            rig.set_origin(part)
            rig.limit(part)
            rig.animate(part)
            rig.write_properties(part, joint)
        context.scene.frame_start, context.scene.frame_end = rig.CLOSED, rig.OPEN
        context.scene.frame_set(rig.CLOSED)
        return {"FINISHED"}


class Export(bpy.types.Operator, ExportHelper):
    """Write the selected objects as .glb with animation and extras, and the prepared object as .dmo beside it"""
    bl_idname, bl_label = "dragmesh.export", "Export .glb and .dmo"
    filename_ext = ".glb"
    filter_glob: bpy.props.StringProperty(default="*.glb", options={"HIDDEN"})

    @classmethod
    def poll(cls, context):
        return bool(_parts(context))

    def execute(self, context):
        parts = _parts(context)
        body = parts[0].dragmesh.body
        frame = context.scene.frame_current
        context.scene.frame_set(rig.CLOSED)  # at rest
        try:
            # glTF's frame: the .dmo fits the .glb beside it.
            with dragmesh.Context(axes=dragmesh.Axes.BLENDER) as library:
                prepared = inference.prepare(library, body, parts, context.evaluated_depsgraph_get())
                for number, part in enumerate(parts):
                    prepared.set_joint(number + 1, inference.joint_of(part))
                dmo = prepared.save()
        except (dragmesh.Error, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            context.scene.frame_set(frame)
        for thing in (body, *(thing for part in parts for thing in (part.dragmesh.rest, part.dragmesh.motion))):
            thing.select_set(True)
        try:
            self.write(dmo)
        except OSError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def write(self, dmo):
        """The .glb and the .dmo beside it, both or none. Blender's exporter takes a path alone."""
        with tempfile.TemporaryDirectory() as folder:
            exported = os.path.join(folder, "object.glb")
            bpy.ops.export_scene.gltf(filepath=exported, export_format="GLB", use_selection=True, export_extras=True,
                                      export_animations=True)
            with open(exported, "rb") as file:
                glb = file.read()
        dragmesh.write_together({self.filepath: glb, os.path.splitext(self.filepath)[0] + ".dmo": dmo})


class Panel(bpy.types.Panel):
    """The sidebar"""
    bl_idname, bl_label = "VIEW3D_PT_dragmesh", "Openable"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "dragmesh"

    def draw(self, context):
        layout = self.layout
        layout.operator(RigAsset.bl_idname)
        layout.label(text="Or select the parts, then the body")
        layout.operator(Infer.bl_idname)
        for part in _parts(context):
            kept = part.dragmesh
            row = kept.hypotheses[kept.chosen]
            box = layout.box()
            box.label(text=f"{part.name}: {row.type.lower()}, {100 * row.confidence:.0f} %")
            box.prop(kept, "lower")
            box.prop(kept, "upper")
        layout.operator(NextHypothesis.bl_idname)
        layout.operator(Apply.bl_idname)
        layout.operator(Export.bl_idname)


CLASSES = (RigAsset, Infer, NextHypothesis, Apply, Export, Panel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)


def unregister():
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)

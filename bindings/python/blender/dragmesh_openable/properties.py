"""What is known of a part, kept with its object and saved in the .blend file."""
import bpy
from bpy.props import CollectionProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, PointerProperty

TYPES = [("UNKNOWN", "Unknown", ""), ("REVOLUTE", "Hinge", "turns between two limits"),
         ("PRISMATIC", "Slider", "slides along a line"), ("SCREW", "Screw", "turns and advances"),
         ("CONTINUOUS", "Wheel", "turns without limits"), ("FIXED", "Fixed", "does not move")]
NAMES = [name for name, _, _ in TYPES]  # by number in C


class DragmeshJoint(bpy.types.PropertyGroup):
    """A joint in the frame of the scene; limits in radians or metres from rest."""
    type: EnumProperty(items=TYPES)
    axis: FloatVectorProperty(size=3, subtype="DIRECTION")
    origin: FloatVectorProperty(size=3, subtype="TRANSLATION")
    lower: FloatProperty()
    upper: FloatProperty()
    pitch: FloatProperty()
    confidence: FloatProperty(subtype="FACTOR", min=0, max=1)


class DragmeshPart(bpy.types.PropertyGroup):
    """Of an object: its part id, the body, all joints that were found, and the rig that shows the one in force."""
    id: IntProperty()
    body: PointerProperty(type=bpy.types.Object)
    hypotheses: CollectionProperty(type=DragmeshJoint)
    chosen: IntProperty(description="Which hypothesis is in force")
    lower: FloatProperty(name="From", description="Lower limit: radians or metres from rest")
    upper: FloatProperty(name="To", description="Upper limit: radians or metres from rest")
    rest: PointerProperty(type=bpy.types.Object)
    motion: PointerProperty(type=bpy.types.Object)


def register():
    bpy.utils.register_class(DragmeshJoint)
    bpy.utils.register_class(DragmeshPart)
    bpy.types.Object.dragmesh = PointerProperty(type=DragmeshPart)


def unregister():
    del bpy.types.Object.dragmesh
    bpy.utils.unregister_class(DragmeshPart)
    bpy.utils.unregister_class(DragmeshJoint)

"""Add-on for Blender 3.4 and later: makes selected objects openable. README.md of the folder above says how."""
import os
import sys

bl_info = {
    "name": "dragmesh: make openable",
    "author": "The dragmesh authors",
    "version": (0, 4, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Sidebar > dragmesh",
    "description": "Finds out how parts move, and gives them pivot, limits and an animation",
    "category": "Rigging",
}

# The package lies in the add-on, or is found as installed.
_HERE = os.path.dirname(os.path.abspath(__file__))
if os.path.isdir(os.path.join(_HERE, "dragmesh")) and _HERE not in sys.path:
    sys.path.append(_HERE)

from . import operators, properties  # noqa: E402  pylint: disable=wrong-import-position


def register():
    """Called by Blender."""
    properties.register()
    operators.register()


def unregister():
    """Called by Blender."""
    operators.unregister()
    properties.unregister()

"""dragmesh: makes any 3D object openable. See api.py; lab.py is for training."""
from .api import Axes, Context, Drag, Error, Intent, JointType, Model, Motion, Object, load, pose_matrix
from .structs import Joint, Pose

__all__ = ["Axes", "Context", "Drag", "Error", "Intent", "Joint", "JointType", "Model", "Motion", "Object", "Pose",
           "load", "pose_matrix"]

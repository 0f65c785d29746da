"""dragmesh: makes any 3D object openable. See api.py; lab.py is for training."""
from .api import Axes, Context, Drag, Error, Event, Intent, JointType, Model, Motion, Object, Picking, load
from .api import joint_frame, joint_pose, joint_value, joint_value_at, pose_matrix
from .structs import Joint, PartState, Pose

__all__ = ["Axes", "Context", "Drag", "Error", "Event", "Intent", "Joint", "JointType", "Model", "Motion", "Object",
           "PartState", "Picking", "Pose", "joint_frame", "joint_pose", "joint_value", "joint_value_at", "load",
           "pose_matrix"]

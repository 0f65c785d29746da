"""dragmesh: makes any 3D object openable. A typed layer over dragmesh.h; arrays are numpy's, and everything is in the
host's own frame and units. lab.py is for training."""
from .assets import part_names, prepare_gltf
from .context import Context
from .exports import RIG_FORMATS, export_rig, write_rig
from .gltf import Gltf, write_glb
from .native import Camera, Hit, Hypothesis, Joint, JointFrame, PartInfo, PartState, Pose, Ray, Vec3
from .objects import Drag, Model, Motion, Object, Scene
from .rigs import Asset, rig, rig_gltf
from .values import (Axes, Error, Event, Go, InputFlag, Intent, JointBasis, JointSource, JointType, LinkKind, Phase, Picking, Rule, Status,
                     StepFlag, joint_frame, joint_pose, joint_scaled, joint_value, joint_value_at, load, pose_apply, pose_from_rotation,
                     pose_inverse, pose_matrix, pose_multiply, version)
from .whole_file import whole_file, write_together, write_whole

__version__ = "0.4.0.dev0"
__all__ = ["Asset", "Axes", "Camera", "Context", "Drag", "Error", "Event", "Gltf", "Go", "Hit", "Hypothesis", "InputFlag", "Intent", "Joint",
           "JointBasis", "JointFrame", "JointSource", "JointType", "LinkKind", "Model", "Motion", "Object", "PartInfo", "PartState",
           "Phase", "Picking", "Pose", "RIG_FORMATS", "Ray", "Rule", "Scene", "Status", "StepFlag", "Vec3", "export_rig", "joint_frame", "joint_pose",
           "joint_scaled", "joint_value", "joint_value_at", "load", "pose_apply",
           "pose_from_rotation", "pose_inverse", "pose_matrix", "pose_multiply",
           "part_names", "prepare_gltf", "rig", "rig_gltf", "version", "whole_file", "write_glb", "write_rig", "write_together", "write_whole"]

## How a part of a DragMeshBody3D moves and behaves. Numbers at 0 are the library's defaults: docs/feel.md says what each does.
@tool
class_name DragMeshPart
extends Resource

enum JointType { FIND_OUT, REVOLUTE, PRISMATIC, SCREW, CONTINUOUS, FIXED }

## The node that moves, with all that it carries, from the body on.
@export_node_path("Node3D") var node: NodePath
@export var joint_type := JointType.FIND_OUT
## The part that carries it, where it does not hang below that part in the scene.
@export_node_path("Node3D") var carrier: NodePath

@export_group("Joint", "")
## Takes the joint below in place of the one found out. Its type is joint_type.
@export var override_joint := false
## Frame of the body; a positive value turns right-handed about it.
@export var axis := Vector3.UP
@export var origin := Vector3.ZERO
## rad or m; none when both are equal.
@export var lower := 0.0
@export var upper := 0.0
## Screws: m a radian.
@export var pitch := 0.0

@export_group("Latch and lock", "")
@export var locked := false
## Held at rest until one of `handles` has turned.
@export var latch := false
@export var handles: Array[NodePath] = []
## rad
@export var latch_turn := 0.0
@export var lock_give := 0.0

@export_group("Opened and closed", "")
@export_range(0, 1) var open_share := 0.0
@export_range(0, 1) var closed_share := 0.0
@export_range(0, 1) var auto_close_share := 0.0
@export var auto_close_time := 0.0
@export var close_delay := 0.0

@export_group("Detents", "")
## Joint values, rising, at which the part catches.
@export var snaps := PackedFloat32Array()
@export var snap_reach := 0.0
## From one catch to the next; 0 = none.
@export var detent := 0.0
@export_range(0, 1) var detent_pull := 0.0

@export_group("Feel", "")
@export var smoothing_time := 0.0
@export var soft_limit := 0.0
@export var coast_time := 0.0
@export var return_time := 0.0
@export_range(0, 1) var tip_share := 0.0
@export var fall_time := 0.0
@export_range(0, 1) var restitution := 0.0
@export var max_speed := 0.0
@export var max_acceleration := 0.0
@export var break_distance := 0.0
@export var drive_speed := 0.0
@export var event_time := 0.0

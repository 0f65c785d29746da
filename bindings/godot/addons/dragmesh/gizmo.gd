## Draws the joint of each part of a DragMeshBody3D: its axis, and the way that the middle of the part goes from its lower to its
## upper limit.
@tool
extends EditorNode3DGizmoPlugin

const STEPS := 24
const PRISMATIC := 2
const FIXED := 5


func _init() -> void:
	create_material("axis", Color(1, 0.75, 0.1), false, true)
	create_material("way", Color(0.3, 1, 0.4), false, true)


func _get_gizmo_name() -> String:
	return "DragMeshBody3D"


func _has_gizmo(node: Node3D) -> bool:
	return node.is_class("DragMeshBody3D")


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var body := gizmo.get_node_3d()
	if not body.is_prepared():
		return
	for part: Node3D in body.part_nodes():
		var joint: Dictionary = body.joint(part)
		if joint.type != FIXED:
			_draw_joint(gizmo, joint, _box_of(body, part))


func _box_of(body: Node3D, part: Node3D) -> AABB:
	var box: AABB = part.get_aabb() if part is VisualInstance3D else AABB(Vector3.ZERO, Vector3.ONE)
	return body.global_transform.affine_inverse() * part.global_transform * box


func _draw_joint(gizmo: EditorNode3DGizmo, joint: Dictionary, box: AABB) -> void:
	var half := box.size.length() / 2
	var axis := PackedVector3Array([joint.origin - joint.axis * half, joint.origin + joint.axis * half])
	var way := PackedVector3Array()
	for i in STEPS:
		way.append(at(joint, box.get_center(), lerpf(joint.lower, joint.upper, float(i) / STEPS)))
		way.append(at(joint, box.get_center(), lerpf(joint.lower, joint.upper, float(i + 1) / STEPS)))
	if joint.type != PRISMATIC:
		gizmo.add_lines(axis, get_material("axis", gizmo))
	gizmo.add_lines(way, get_material("way", gizmo))


## Where a joint takes a point at a value.
static func at(joint: Dictionary, point: Vector3, value: float) -> Vector3:
	if joint.type == PRISMATIC:
		return point + joint.axis * value
	return joint.origin + (point - joint.origin).rotated(joint.axis, value) + joint.axis * (joint.pitch * value)

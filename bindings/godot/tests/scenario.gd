# The common scenario (bindings/scenario/scenario.c) through the node: every number as the bits of its float.
# godot --headless --path PROJECT --script scenario.gd
extends SceneTree

const FRAMES := 60
const SHOWN_EVERY := 10
const SAVED_AT := 30
const RELEASED_FRAMES := 120
const HANDLE_TURNS_AT := 25
const HANDLE_TURN := 1.0
const WIDEST := 0.45
const GO_OPEN := 2
const DM_LINK_HOLDS := 2

# x, y, z to x, y, z, part: samples/common/cabinet.h
const BOXES := [
	[0.00, 0.00, 0.000, 0.60, 0.02, 0.40, 0], [0.00, 0.98, 0.000, 0.60, 1.00, 0.42, 0],
	[0.00, 0.02, 0.000, 0.02, 0.98, 0.40, 0], [0.58, 0.02, 0.000, 0.60, 0.98, 0.40, 0],
	[0.02, 0.02, 0.000, 0.58, 0.98, 0.02, 0], [0.00, 0.00, 0.402, 0.60, 0.79, 0.42, 1],
	[0.54, 0.35, 0.420, 0.56, 0.55, 0.45, 1], [0.00, 0.80, 0.402, 0.60, 0.97, 0.42, 2],
	[0.25, 0.87, 0.420, 0.35, 0.89, 0.45, 2], [0.04, 0.82, 0.030, 0.56, 0.83, 0.402, 2],
	[0.04, 0.83, 0.030, 0.05, 0.95, 0.402, 2], [0.55, 0.83, 0.030, 0.56, 0.95, 0.402, 2],
	[0.05, 0.83, 0.030, 0.55, 0.95, 0.040, 2],
]
const CORNERS := [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
	2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6]

var origin := Vector3(0.9, 0.9, 2.0)
var frame_time := narrow(1.0 / narrow(60))


# The float nearest to a number, as C has it.
func narrow(number: float) -> float:
	return PackedFloat32Array([number])[0]


func bits(numbers) -> String:
	var text := ""
	for number in numbers:
		text += " %08x" % PackedFloat32Array([number]).to_byte_array().decode_u32(0)
	return text


func of(v: Vector3) -> Array:
	return [v.x, v.y, v.z]


func print_joint(j: Dictionary) -> void:
	print("joint %d source %d" % [j.type, j.source])
	print(" ", bits(of(j.axis) + of(j.origin) + [j.lower, j.upper, j.type_confidence, j.joint_confidence]))


func print_state(name: String, s: Dictionary) -> void:
	print("%s phase %d events %d changes %d basis %d" % [name, s.phase, s.events, s.changes, s.joint_basis])
	print(" ", bits([s.value, s.joint_confidence]))
	print(" ", bits(s.pose.slice(0, 4)))
	print(" ", bits(s.pose.slice(4, 8)))


# The direction of the pointer's ray in a frame, computed as C does, in floats.
func direction_at(frame: int) -> Vector3:
	var x := narrow(narrow(-0.35) - narrow(narrow(0.01) * frame))
	var z := narrow(narrow(-1.55) + narrow(narrow(0.005) * frame))
	return Vector3(x, -0.45, z)


# The boxes of a part as a mesh. Godot winds its triangles the other way.
func mesh_of(part: int) -> ArrayMesh:
	var positions := PackedVector3Array()
	var indices := PackedInt32Array()
	for box in BOXES:
		if box[6] != part:
			continue
		var first := positions.size()
		for v in 8:
			positions.append(Vector3(box[3 if v & 1 else 0], box[4 if v & 2 else 1], box[5 if v & 4 else 2]))
		for i in range(0, CORNERS.size(), 3):
			for corner in [0, 2, 1]:
				indices.append(first + CORNERS[i + corner])
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = positions
	arrays[Mesh.ARRAY_INDEX] = indices
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


func make_cabinet() -> Node3D:
	var kitchen = ClassDB.instantiate("DragMeshBody3D")
	kitchen.name = "kitchen"
	kitchen.prepare_when_ready = false
	kitchen.use_pivots = false
	kitchen.release_by_rule = true
	kitchen.body = NodePath("cabinet/body") # every other mesh is a part, as in C
	var cabinet := Node3D.new()
	cabinet.name = "cabinet"
	kitchen.add_child(cabinet)
	var names := ["body", "door", "drawer"]
	for part in 3:
		var node := MeshInstance3D.new()
		node.name = names[part]
		node.mesh = mesh_of(part)
		cabinet.add_child(node)
	root.add_child(kitchen)
	kitchen.set_process(false)
	return kitchen


func print_hypotheses(body, part: Node3D, id: int) -> void:
	var all: Array = body.hypotheses(part)
	print("part %d hypotheses %d" % [id, all.size()])
	print_joint(body.joint(part))
	for one in all:
		print_joint(one)


func drag_and_release(body, part: Node3D, point: Vector3) -> void:
	body.grab(part, point)
	var state := {}
	var events := 0
	var saved := PackedByteArray()
	for frame in FRAMES:
		state = body.pull(part, origin, direction_at(frame), frame_time)
		events |= state.events
		if frame % SHOWN_EVERY == 0:
			print_state("frame", state)
		if frame == SAVED_AT:
			saved = body.save_drag(part)
	body.restore_drag(part, saved)
	state = body.pull(part, origin, direction_at(FRAMES), frame_time)
	print_state("restored", state)
	print("plan", bits([body.release(part, GO_OPEN).end_value]))
	for frame in RELEASED_FRAMES:
		state = body.update_input(part, {}, frame_time)
		events |= state.events
	state.events = events
	print_state("released", state)
	body.end(part)
	var kept: Dictionary = body.part_state(part)
	body.reset_part(part)
	body.restore_part(part, kept)
	body.grab(part, state.grab_point)
	body.end(part)
	kept = body.part_state(part)
	print("again", bits([kept.value]))
	print(" ", bits(kept.pose.slice(0, 4)))
	print(" ", bits(kept.pose.slice(4, 8)))
	print("evidence %d %d %d %d" % kept.joint.evidence)


func drag_behind_latch(body, part: Node3D, point: Vector3) -> void:
	body.grab(part, point)
	var state := {}
	var events := 0
	var detents := 0
	for frame in FRAMES:
		state = body.update_input(part, {"origin": origin, "direction": direction_at(frame), "ask": 1,
				"handle": 0.0 if frame < HANDLE_TURNS_AT else HANDLE_TURN}, frame_time)
		if state.value > narrow(WIDEST):
			state = body.override_value(part, WIDEST)
		events |= state.events
		detents += state.detents
		if frame % SHOWN_EVERY == 0:
			print_state("latch", state)
	state.events = events
	print_state("latched", state)
	print("detents ", detents)
	body.end(part)


func follow_links(body, door: Node3D, drawer: Node3D) -> void:
	body.set_links([{"driver": door, "driven": drawer, "ratio": 0.25, "from": 0.1},
			{"driver": drawer, "driven": door, "kind": DM_LINK_HOLDS, "from": 0.05}])
	var values := PackedFloat32Array([-0.9, 0])
	for i in 2:
		var answer: Dictionary = body.follow_links(door, values)
		print("linked", bits(answer.values))
		print("held %d %d" % [answer.held[0], answer.held[1]])
		values = answer.values
		values[0] = 0.9


func save_and_load(body, door: Node3D) -> void:
	var bytes: PackedByteArray = body.dmo
	var fnv := 2166136261
	for byte in bytes:
		fnv = ((fnv ^ byte) * 16777619) & 0xffffffff
	print("saved %d bytes %08x" % [bytes.size(), fnv])
	body.load_prepared()
	print_joint(body.joint(door))


func _initialize() -> void:
	var body = make_cabinet()
	var error: String = body.prepare_now()
	if error:
		print("prepare: ", error)
		quit(1)
		return
	var door: Node3D = body.part_nodes()[0]
	var drawer: Node3D = body.part_nodes()[1]
	print_hypotheses(body, door, 1)
	print_hypotheses(body, drawer, 2)
	var hit: Dictionary = body.pick(origin, direction_at(0))
	print("picked part %d triangle %d" % [hit.part_id, hit.triangle])
	print(" ", bits(of(hit.point)))
	drag_and_release(body, hit.part, hit.point)
	body.parts = [{"node": body.get_path_to(door), "latch": true, "snaps": [0.2, 0.4]}, {"node": body.get_path_to(drawer)}]
	body.reset_part(door)
	body.load_prepared()
	drag_behind_latch(body, door, hit.point)
	follow_links(body, door, drawer)
	save_and_load(body, door)
	var box = ClassDB.instantiate("DragMeshBody3D")
	var alone := MeshInstance3D.new()
	alone.mesh = mesh_of(0)
	box.add_child(alone)
	box.prepare_when_ready = false
	root.add_child(box)
	print("error ", box.prepare_now())
	quit()

# What docs/engines/godot.md shows: physics, saving and networking of a part. Ends with an error where a number is wrong.
# godot --headless --path PROJECT --script handover.gd
extends SceneTree

const GO_OPEN := 2
const NEAR := 0.02 # rad

var failed := 0


func expect(what: bool, text: String) -> void:
	print("%s: %s" % ["ok" if what else "FAILED", text])
	failed += int(not what)


func make() -> DragMeshBody3D:
	var body := DragMeshBody3D.new()
	body.add_child(load("res://props/safe.glb").instantiate())
	body.prepare_when_ready = false
	root.add_child(body)
	body.prepare_now()
	return body


# Physics: the joint's frame is in the body's space; its x axis is the hinge, Godot's HingeJoint3D turns about z.
func hinge_of(body: DragMeshBody3D, part: Node3D, leaf: RigidBody3D) -> HingeJoint3D:
	var frame: Dictionary = body.joint_frame(part)
	var turned: Transform3D = frame.transform
	turned.basis = Basis(turned.basis.y, turned.basis.z, turned.basis.x)
	var hinge := HingeJoint3D.new()
	root.add_child(hinge)
	hinge.global_transform = body.global_transform * turned
	hinge.node_b = leaf.get_path() # node_a empty: the world
	hinge.set_flag(HingeJoint3D.FLAG_USE_LIMIT, frame.has_lower and frame.has_upper)
	hinge.set_param(HingeJoint3D.PARAM_LIMIT_LOWER, frame.lower)
	hinge.set_param(HingeJoint3D.PARAM_LIMIT_UPPER, frame.upper)
	return hinge


func hand_over(body: DragMeshBody3D, part: Node3D) -> void:
	var leaf := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	var box: AABB = part.get_aabb()
	shape.shape = BoxShape3D.new()
	shape.shape.size = box.size * 0.5
	shape.position = box.get_center()
	leaf.add_child(shape)
	leaf.gravity_scale = 0
	leaf.center_of_mass_mode = RigidBody3D.CENTER_OF_MASS_MODE_CUSTOM
	leaf.center_of_mass = box.get_center()
	root.add_child(leaf)
	leaf.global_transform = part.global_transform
	var hinge := hinge_of(body, part, leaf)
	var joint: Dictionary = body.joint(part)
	for frame in 30:
		leaf.angular_velocity = joint.axis * 2.0
		await physics_frame
	part.global_transform = leaf.global_transform
	var now: Dictionary = body.adopt(part)
	print("physics: value %.3f rad, off the joint by %.4f rad and %.4f m" % [now.value, now.angle_error, now.distance_error])
	expect(now.value > 0.1 and now.angle_error < NEAR, "physics has opened it along the joint")
	for frame in 300:
		leaf.angular_velocity = joint.axis * 2.0
		await physics_frame
	part.global_transform = leaf.global_transform
	now = body.adopt(part)
	print("physics: value %.3f rad, upper limit %.3f" % [now.value, joint.upper])
	expect(absf(now.value - joint.upper) < 0.1, "the limit of the hinge holds it")
	hinge.free()
	leaf.free()


func save_and_restore(body: DragMeshBody3D, part: Node3D) -> void:
	var learnt: Dictionary = body.part_state(part)
	learnt.joint.evidence = [1, 2, 4294967295, 4]
	body.restore_part(part, learnt)
	body.move(part, GO_OPEN)
	body.advance(0.3)
	var text := var_to_str(body.part_state(part))
	var place := part.transform
	body.reset_part(part)
	body.restore_part(part, str_to_var(text))
	expect(part.transform.is_equal_approx(place), "a saved part is where it was")
	expect(body.part_state(part).joint.evidence == [1, 2, 4294967295, 4], "what pulls have said is saved with it")


# The owner drags; the others get the joint when it changes and the value every frame.
func replicate(body: DragMeshBody3D, other: DragMeshBody3D, part: Node3D, shown: Node3D) -> void:
	var sent := {"joint": body.joint(part), "value": body.value(part)}
	other.restore_part(shown, sent)
	expect(shown.transform.is_equal_approx(part.transform), "the other machine shows it there")


func _initialize() -> void:
	await process_frame # the root is in the tree from now on
	var body := make()
	var other := make()
	var door: Node3D = body.part_nodes()[0]
	save_and_restore(body, door)
	replicate(body, other, door, other.part_nodes()[0])
	body.reset_part(door)
	await hand_over(body, door)
	quit(failed)

## A node with a model below it, made by code: finds the joints, opens the door, says so. godot --headless --script first_door.gd
extends SceneTree


func _initialize() -> void:
	var body := DragMeshBody3D.new()
	body.add_child(load("res://props/kitchen_cabinet.glb").instantiate())
	body.prepared.connect(_on_prepared.bind(body))
	body.opened.connect(func(part: Node3D) -> void: print(part.name, " has opened"))
	body.limit_upper.connect(func(_part: Node3D) -> void: quit())
	root.add_child(body) # the joints are found in the background


func _on_prepared(error: String, body: DragMeshBody3D) -> void:
	if error:
		print(error)
		quit(1)
		return
	for part: Node3D in body.part_nodes():
		var joint: Dictionary = body.joint(part)
		print("%s: type %d, axis %s, up to %.2f, sure by %.0f %%" %
				[part.name, joint.type, joint.axis, joint.upper, 100 * joint.joint_confidence])
	body.move(body.part_nodes()[0], 2) # DM_GO_OPEN

## A hand that plays the room by mouse events on the screen, as a player does.
extends Node

const TYPE_PRISMATIC := 2
## Prop, part, share of the range that it is pulled, share that it must have come at least.
const PULLS := [
	["Cabinet", "door_left", 0.8, 0.5], ["Cabinet", "door_right", 0.6, 0.4], ["Cabinet", "drawer_left", 0.7, 0.4],
	["Refrigerator", "door", 0.6, 0.4], ["Microwave", "door", 0.7, 0.4], ["Chest", "lid", 0.8, 0.5],
]
const LATCHED := [["Safe", "door", "lever", 0.7], ["HouseDoor", "door", "handle", 0.45]]
const FRAMES := 45
const SAMPLES := 7

var room: Node3D
var heard := {}
var failed := 0


func play(the_room: Node3D, picture: String) -> void:
	room = the_room
	get_viewport().disable_3d = true # nobody looks until the end
	for body in room.bodies():
		for event in ["opened", "locked_tried", "unlatched", "limit_upper", "limit_lower"]:
			body.connect(event, func(part: Node3D) -> void: heard["%s %s %s" % [body.name, part.name, event]] = true)
	for row in LATCHED:
		await open_latched(row)
	for row in PULLS:
		var body: DragMeshBody3D = room.get_node(row[0])
		await drag(body, part_of(body, row[1]), row[2], row[3])
		expect("%s %s opened" % [row[0], row[1]])
	print("the hand opened %d parts, %d of them behind a latch; %d failures" % [PULLS.size() + LATCHED.size(), LATCHED.size(), failed])
	if picture:
		get_viewport().disable_3d = false
		await get_tree().create_timer(0.5).timeout
		await RenderingServer.frame_post_draw
		get_viewport().get_texture().get_image().save_png(picture)
	get_tree().quit(1 if failed else 0)


func expect(what: String) -> void:
	if not heard.has(what):
		print("FAILED: not heard: ", what)
		failed += 1


func part_of(body: DragMeshBody3D, part: String) -> Node3D:
	return body.part_nodes().filter(func(node: Node) -> bool: return node.name == part)[0]


## Tries the door while it is latched, then once more while the handle is turned.
func open_latched(row: Array) -> void:
	var body: DragMeshBody3D = room.get_node(row[0])
	var door := part_of(body, row[1])
	var handle := part_of(body, row[2])
	await drag(body, door, row[3], 0.0)
	expect("%s %s locked_tried" % [row[0], row[1]])
	if absf(body.value(door)) > 0.05:
		print("FAILED: a latch did not hold: ", row[0])
		failed += 1
	body.move(handle, 2) # the other hand opens it
	body.set_locked(handle, false)
	for frame in 10:
		await get_tree().process_frame
	await drag(body, door, row[3], 0.3)
	expect("%s %s unlatched" % [row[0], row[1]])
	expect("%s %s opened" % [row[0], row[1]])


## The point of the part, on the screen, that is farthest from its axis; where it would be at a joint value.
func points_of(body: DragMeshBody3D, part: Node3D) -> Array:
	var camera := get_viewport().get_camera_3d()
	var joint: Dictionary = body.joint(part)
	var box: AABB = part.get_aabb()
	var best := []
	var farthest := -1.0
	for i in SAMPLES ** 3:
		var share := Vector3(i % SAMPLES, i / SAMPLES % SAMPLES, i / SAMPLES ** 2) / (SAMPLES - 1)
		var world: Vector3 = part.global_transform * (box.position + box.size * share)
		var on_screen := camera.unproject_position(world)
		var hit: Dictionary = body.pick(camera.project_ray_origin(on_screen), camera.project_ray_normal(on_screen))
		if hit.get("part") != part or not is_seen(body, on_screen, hit.distance):
			continue
		var arm: Vector3 = (hit.point - joint.origin).cross(joint.axis)
		var distance := arm.length() if joint.type != TYPE_PRISMATIC else -world.distance_to(part.global_transform * box.get_center()) + 100
		if distance > farthest:
			farthest = distance
			best = [on_screen, hit.point]
	return best


## No other prop stands before it.
func is_seen(body: DragMeshBody3D, on_screen: Vector2, distance: float) -> bool:
	var camera := get_viewport().get_camera_3d()
	for other in room.bodies():
		var hit: Dictionary = other.pick(camera.project_ray_origin(on_screen), camera.project_ray_normal(on_screen))
		if other != body and hit.get("distance", INF) < distance:
			return false
	return true


func at(joint: Dictionary, point: Vector3, value: float) -> Vector3:
	if joint.type == TYPE_PRISMATIC:
		return point + joint.axis * value
	return joint.origin + (point - joint.origin).rotated(joint.axis, value)


func drag(body: DragMeshBody3D, part: Node3D, share: float, least: float) -> void:
	var found := points_of(body, part)
	if not found:
		print("FAILED: not on the screen: %s %s" % [body.name, part.name])
		failed += 1
		return
	var camera := get_viewport().get_camera_3d()
	var joint: Dictionary = body.joint(part)
	var open: float = joint.upper if absf(joint.upper) > absf(joint.lower) else joint.lower
	button(found[0], true)
	for frame in FRAMES:
		var value: float = open * share * (frame + 1) / FRAMES
		move(camera.unproject_position(body.global_transform * at(joint, found[1], value)))
		await get_tree().process_frame
	for frame in FRAMES / 3:
		await get_tree().process_frame
	var came: float = body.value(part) / open
	button(camera.unproject_position(body.global_transform * at(joint, found[1], open * share)), false)
	if came < least:
		print("FAILED: %s %s came to %.2f of its range, not %.2f" % [body.name, part.name, came, least])
		failed += 1


func button(position: Vector2, pressed: bool) -> void:
	var event := InputEventMouseButton.new()
	event.button_index = MOUSE_BUTTON_LEFT
	event.pressed = pressed
	event.position = position
	event.global_position = position
	get_viewport().push_input(event)


func move(position: Vector2) -> void:
	var event := InputEventMouseMotion.new()
	event.position = position
	event.global_position = position
	get_viewport().push_input(event)

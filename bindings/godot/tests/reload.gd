# What an editor's reload does, 1,000 times: bodies are made, prepared in the background, dragged and freed in any order, and the
# extension is reloaded under them or unloaded without them. Memory must not grow.
# godot --headless --editor --path PROJECT --script reload.gd: only an editor reloads.
extends SceneTree

const EXTENSION := "res://addons/dragmesh/dragmesh.gdextension"
const ROUNDS := 1000
const SETTLED := 200
const ALLOWED_GROWTH := 8192 # KiB of the process between round 200 and the last, by hand
const GO_OPEN := 2

var packed: PackedScene
var dmo := PackedByteArray()
var dmo_parts := PackedStringArray()
var bodies: Array[Node] = []
var ended := {} # ids of bodies that are gone
var late := 0 # signals of those
var heard := 0
var reloads := 0
var unloads := 0
var opened := 0


func resident() -> int:
	var status := FileAccess.open("/proc/self/status", FileAccess.READ)
	var line := status.get_line()
	while not line.begins_with("VmRSS:"):
		line = status.get_line()
	return line.trim_prefix("VmRSS:").strip_edges().to_int()


func hear(_what, id: int) -> void:
	heard += 1
	if ended.has(id):
		late += 1


func make() -> void:
	var body: Node = ClassDB.instantiate("DragMeshBody3D")
	body.add_child(packed.instantiate())
	if randi() % 8 > 0: # the others find the joints in the background
		body.dmo = dmo
		body.dmo_parts = dmo_parts
	var id := body.get_instance_id()
	for signal_name in ["prepared", "opened", "limit_upper", "limit_lower"]:
		body.connect(signal_name, hear.bind(id))
	root.add_child(body)
	bodies.append(body)


func drag(body: Node) -> void:
	if not body.is_prepared():
		return
	for part in body.part_nodes():
		body.move(part, GO_OPEN)
		body.advance(0.05)
		body.advance(3)
		opened += int(absf(body.value(part)) > 0.01)
		if randi() % 2 == 0:
			body.end(part)


func drop(body: Node) -> void:
	ended[body.get_instance_id()] = true
	bodies.erase(body)
	body.free()


func reload() -> void:
	GDExtensionManager.reload_extension(EXTENSION)
	reloads += 1


func unload_and_load() -> void:
	for body in bodies.duplicate():
		drop(body)
	GDExtensionManager.unload_extension(EXTENSION)
	GDExtensionManager.load_extension(EXTENSION)
	unloads += 1


func play_round(number: int) -> void:
	var acts := [make, make, func() -> void: if bodies: drag(bodies.pick_random()), func() -> void: if bodies: drop(bodies.pick_random())]
	acts.append(reload if number % 2 else unload_and_load)
	acts.shuffle()
	for act: Callable in acts:
		act.call()
	for body in bodies.duplicate():
		if bodies.size() > 3:
			drop(body)


func _initialize() -> void:
	seed(1)
	packed = load("res://props/safe.glb")
	var first: Node = ClassDB.instantiate("DragMeshBody3D")
	first.add_child(packed.instantiate())
	root.add_child(first)
	first.prepare_now()
	dmo = first.dmo
	dmo_parts = first.dmo_parts
	first.free()
	var settled := 0
	for number in range(1, ROUNDS + 1):
		play_round(number)
		await process_frame
		if number == SETTLED:
			settled = resident()
	var growth := resident() - settled
	var failed := late > 0 or growth > ALLOWED_GROWTH or settled == 0 or opened == 0 or heard == 0
	print("%d rounds: %d reloads under living bodies, %d unloads, %d parts opened, %d signals, %d of them late; %d KiB grown since the %dth" %
			[ROUNDS, reloads, unloads, opened, heard, late, growth, SETTLED])
	quit(1 if failed else 0)

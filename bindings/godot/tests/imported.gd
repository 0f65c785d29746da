# What the import option and the root type leave in a scene: joints that are found, and loaded when it comes into the tree.
# godot --headless --path PROJECT --script imported.gd: openable.glb was imported with the option, rooted.glb with the type.
extends SceneTree

const SCENES := {"openable": "Openable", "rooted": "."} # name to path of the body
const PARTS := 4


func _initialize() -> void:
	show_scenes.call_deferred()


func show_scenes() -> void:
	var failed := 0
	for scene_name: String in SCENES:
		var scene: Node = load("res://props/%s.glb" % scene_name).instantiate()
		var body := scene.get_node(SCENES[scene_name])
		body.prepare_when_ready = false
		root.add_child(scene)
		var loaded: bool = body.is_prepared() and body.part_nodes().size() == PARTS
		print("%s: %s.glb is imported with the joints of %d parts" % ["ok" if loaded else "FAILED", scene_name, body.part_nodes().size()])
		failed += 0 if loaded else 1
		scene.free()
	quit(failed)

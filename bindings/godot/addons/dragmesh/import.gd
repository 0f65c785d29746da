## The import option "dragmesh/openable" of scenes, as of a .glb: all nodes come below a DragMeshBody3D, and its joints are found while
## the file is imported. A scene whose root type is DragMeshBody3D is prepared without the option.
@tool
extends EditorScenePostImportPlugin

const OPTION := "dragmesh/openable"
const CLASS := "DragMeshBody3D"


func _get_import_options(path: String) -> void:
	if path: # empty for the defaults of the project
		add_import_option(OPTION, false)


func _post_process(scene: Node) -> void:
	var body := scene
	if not scene.is_class(CLASS):
		if not get_option_value(OPTION):
			return
		body = _wrapped(scene)
	var error: String = body.prepare_now()
	if error:
		push_error("dragmesh: %s: %s" % [scene.name, error])


## Moves what a scene has below a body of its own: an import keeps the root. Animations find their nodes from the node above them.
func _wrapped(scene: Node) -> Node:
	var owned := scene.find_children("*", "", true, true)
	var body: Node = ClassDB.instantiate(CLASS)
	body.name = "Openable"
	for node in owned:
		node.owner = null
	for child in scene.get_children():
		scene.remove_child(child)
		body.add_child(child)
	scene.add_child(body)
	body.owner = scene
	for node in owned:
		node.owner = scene
	return body

## In the editor: the gizmo of the joints, a button that finds them, with a progress bar, and the import option that does it.
@tool
extends EditorPlugin

const Gizmo := preload("gizmo.gd")
const Import := preload("import.gd")

var gizmo := Gizmo.new()
var import := Import.new()
var panel := HBoxContainer.new()
var bar := ProgressBar.new()
var body: Node3D


func _enter_tree() -> void:
	add_node_3d_gizmo_plugin(gizmo)
	add_scene_post_import_plugin(import)
	var button := Button.new()
	button.text = "Find joints"
	button.pressed.connect(_find)
	bar.max_value = 1
	bar.custom_minimum_size.x = 120
	bar.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	bar.hide()
	panel.add_child(button)
	panel.add_child(bar)
	panel.hide()
	add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, panel)


func _exit_tree() -> void:
	remove_control_from_container(CONTAINER_SPATIAL_EDITOR_MENU, panel)
	panel.queue_free()
	remove_scene_post_import_plugin(import)
	remove_node_3d_gizmo_plugin(gizmo)


func _handles(object: Object) -> bool:
	return object.is_class("DragMeshBody3D")


func _edit(object: Object) -> void:
	if body and is_instance_valid(body):
		body.progress.disconnect(_show_progress)
		body.prepared.disconnect(_show_end)
	bar.hide()
	body = object
	if body:
		body.progress.connect(_show_progress)
		body.prepared.connect(_show_end)


func _make_visible(visible: bool) -> void:
	panel.visible = visible


func _find() -> void:
	_show_progress(0)
	body.prepare()


func _show_progress(share: float) -> void:
	bar.value = share
	bar.show()


func _show_end(error: String) -> void:
	bar.hide()
	if error:
		push_error("dragmesh: %s: %s" % [body.name, error])
		return
	EditorInterface.mark_scene_as_unsaved() # the joints are kept in the scene
	body.update_gizmos()

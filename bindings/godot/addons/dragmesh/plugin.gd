## In the editor: the gizmo of the joints, and a button that finds them, with a progress bar.
@tool
extends EditorPlugin

const Gizmo := preload("gizmo.gd")

var gizmo := Gizmo.new()
var panel := HBoxContainer.new()
var bar := ProgressBar.new()
var body: Node3D


func _enter_tree() -> void:
	add_node_3d_gizmo_plugin(gizmo)
	var button := Button.new()
	button.text = "Find joints"
	button.pressed.connect(_find)
	bar.max_value = 1
	bar.custom_minimum_size.x = 120
	bar.hide()
	panel.add_child(button)
	panel.add_child(bar)
	panel.hide()
	add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, panel)


func _exit_tree() -> void:
	remove_control_from_container(CONTAINER_SPATIAL_EDITOR_MENU, panel)
	panel.queue_free()
	remove_node_3d_gizmo_plugin(gizmo)


func _handles(object: Object) -> bool:
	return object.is_class("DragMeshBody3D")


func _edit(object: Object) -> void:
	if body and is_instance_valid(body):
		body.progress.disconnect(_show_progress)
		body.prepared.disconnect(_show_end)
	body = object
	if body:
		body.progress.connect(_show_progress)
		body.prepared.connect(_show_end)


func _make_visible(visible: bool) -> void:
	panel.visible = visible


func _find() -> void:
	bar.show()
	body.prepare()


func _show_progress(share: float) -> void:
	bar.value = share


func _show_end(error: String) -> void:
	bar.hide()
	if error:
		push_error("dragmesh: %s: %s" % [body.name, error])
		return
	EditorInterface.mark_scene_as_unsaved() # the joints are kept in the scene
	body.update_gizmos()

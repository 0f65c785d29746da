# What the plugin shows in the editor: opens a cabinet, selects it, presses Find joints, and saves pictures: editor.png of the 3D view
# with the gizmo, editor_before.png without joints, editor_reopened.png of the scene saved and opened again, without a selection.
# godot --editor --path PROJECT --script editor.gd -- FOLDER: wants a screen.
extends SceneTree

const SCENE := "res://editor_cabinet.tscn"
const PROP := "res://props/kitchen_cabinet.glb"
const BUTTON := "Find joints"
const SLIDE := Color(0.2, 0.8, 1)
const NEAR := 0.03 # by eye, as the next
const LEAST_SATURATION := 0.6
const LEAST_VALUE := 0.9
const LEAST_SHARE := 0.002
const LONGEST := 60.0 # s
const MIDDLE := Vector3(0, -0.35, 0) # before the editor's camera
const ZOOM_STEPS := 12
const SETTLED := 1.0 # s, until the editor has drawn what changed

var body: Node3D
var failed := 0


func _initialize() -> void:
	look.call_deferred()


func expect(right: bool, what: String) -> void:
	print("ok: " if right else "FAILED: ", what)
	failed += 0 if right else 1


func wait(seconds: float) -> void:
	var start := Time.get_ticks_msec() # no timer: the editor runs frames of its own while it opens scenes, within one that ends
	while Time.get_ticks_msec() - start < 1000 * seconds:
		await process_frame


func save_picture(name: String) -> Image:
	var picture := EditorInterface.get_editor_viewport_3d().get_texture().get_image()
	picture.save_png(OS.get_cmdline_user_args()[0].path_join(name))
	return picture


## The share of a picture that has the hue of slides and is as bright, as the editor's line of the z axis is too.
func share_of_slides(picture: Image) -> float:
	var count := 0
	for y in picture.get_height():
		for x in picture.get_width():
			var colour := picture.get_pixel(x, y)
			count += 1 if absf(colour.h - SLIDE.h) < NEAR and colour.s > LEAST_SATURATION and colour.v > LEAST_VALUE else 0
	return float(count) / (picture.get_width() * picture.get_height())


func save_cabinet() -> void:
	var kitchen := Node3D.new()
	kitchen.name = "Kitchen"
	var cabinet: Node3D = ClassDB.instantiate("DragMeshBody3D")
	cabinet.name = "Cabinet"
	cabinet.position = MIDDLE
	cabinet.set_meta("_edit_lock_", true) # hides the arrows that would move it
	var prop: Node = load(PROP).instantiate()
	kitchen.add_child(cabinet)
	cabinet.add_child(prop)
	cabinet.owner = kitchen
	prop.owner = kitchen
	var scene := PackedScene.new()
	scene.pack(kitchen)
	ResourceSaver.save(scene, SCENE)
	kitchen.free()


func find_button(under: Node) -> Button:
	for button: Button in under.find_children("*", "Button", true, false):
		if button.text.begins_with(BUTTON):
			return button
	return null


func wheel(position: Vector2) -> void:
	var event := InputEventMouseButton.new()
	event.button_index = MOUSE_BUTTON_WHEEL_UP
	event.pressed = true
	event.position = position
	event.global_position = position
	Input.parse_input_event(event)


func look() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await process_frame
	await wait(SETTLED)
	save_cabinet()
	EditorInterface.open_scene_from_path(SCENE)
	EditorInterface.set_main_screen_editor("3D")
	await wait(SETTLED)
	body = EditorInterface.get_edited_scene_root().get_node("Cabinet")
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(body)
	await wait(SETTLED)
	var view := EditorInterface.get_editor_viewport_3d()
	for step in ZOOM_STEPS:
		wheel(view.get_parent().get_global_rect().get_center())
		await process_frame
	await wait(SETTLED)
	var before := share_of_slides(save_picture("editor_before.png"))
	var button := find_button(root)
	expect(button != null and button.is_visible_in_tree(), "the button is above the 3D view")
	var bar: ProgressBar = button.get_parent().find_children("*", "ProgressBar", true, false)[0]
	var told := []
	body.progress.connect(func(share: float) -> void: told.append(bar.is_visible_in_tree() and absf(bar.value - share) <= bar.step))
	button.pressed.emit()
	var start := Time.get_ticks_msec()
	while not body.is_prepared() and Time.get_ticks_msec() - start < 1000 * LONGEST:
		await process_frame
	expect(body.is_prepared(), "the button finds the joints")
	expect(told.size() > 0 and false not in told, "the bar shows each progress")
	await wait(SETTLED)
	var after := share_of_slides(save_picture("editor.png"))
	expect(after - before > LEAST_SHARE, "the view shows what slides: %.2f %% of it, %.2f %% before" % [100 * after, 100 * before])
	expect(not bar.visible, "the bar goes at the end")
	EditorInterface.save_scene()
	EditorInterface.close_scene()
	await wait(SETTLED)
	EditorInterface.open_scene_from_path(SCENE)
	await wait(SETTLED)
	body = EditorInterface.get_edited_scene_root().get_node("Cabinet")
	expect(body.is_prepared(), "the joints are kept in the scene")
	EditorInterface.get_selection().clear()
	await wait(SETTLED)
	save_picture("editor_reopened.png")
	quit(failed)

## Draws the joint of each part of a DragMeshBody3D, in a colour of its kind. What turns: its axis, with an arrow where a positive value
## turns right-handed about it, a ball at its origin, and the sector that the part sweeps from its lower to its upper limit. What
## slides: the way of the part's middle, with a ball at rest and a ring at each limit. The labels of the selected body say kind and limits.
@tool
extends EditorNode3DGizmoPlugin

const REVOLUTE := 1
const PRISMATIC := 2
const SCREW := 3
const CONTINUOUS := 4
const FIXED := 5
const KINDS := {REVOLUTE: "hinge", PRISMATIC: "slide", SCREW: "screw", CONTINUOUS: "turns freely", FIXED: "fixed"}
const COLOURS := {
	REVOLUTE: Color(1, 0.7, 0.1), PRISMATIC: Color(0.2, 0.8, 1), SCREW: Color(1, 0.4, 0.8), CONTINUOUS: Color(0.5, 1, 0.3),
	FIXED: Color(0.8, 0.8, 0.8),
}
const STEPS := 32
const LEAST_IN_METRES := 0.1 # of a slide's range; a shorter one is told in millimetres
## Shares of half the diagonal of the part's box, by eye.
const ROD := 0.012
const BALL := 0.04
const TIP := Vector2(0.035, 0.12) # radius, length
const RING := 0.1
const SECTOR_ALPHA := 0.35
const FAINT_ALPHA := 0.3 # of bodies that are not selected
const LINE_PRIORITY := 100 # below labels
## Labels keep their size on the screen: these are metres seen from 1 m.
const FONT_SIZE := 32
const PIXEL_SIZE := 0.0011
const LABEL_MARGIN := Vector2(0.02, 0.012)
const LABEL_COLOUR := Color(0.08, 0.09, 0.1, 0.8)
const LABEL_LIFT := 0.06 # above what it tells of

var rod := CylinderMesh.new() # of length 1 and radius 1, as the next
var tip := CylinderMesh.new()
var ring := TorusMesh.new()
var ball := SphereMesh.new()
var selected := false # the body that is drawn


func _init() -> void:
	for kind: int in KINDS:
		var colour: Color = COLOURS[kind]
		add_material("line %d" % kind, seen_through(colour, LINE_PRIORITY))
		add_material("faint %d" % kind, flat_material(Color(colour, FAINT_ALPHA)))
		add_material("sector %d" % kind, flat_material(Color(colour, SECTOR_ALPHA)))
		add_material("text %d" % kind, label_material(colour, Material.RENDER_PRIORITY_MAX))
	add_material("label", label_material(LABEL_COLOUR, Material.RENDER_PRIORITY_MAX - 1))
	for mesh: CylinderMesh in [rod, tip]:
		mesh.top_radius = 1
		mesh.bottom_radius = 1
		mesh.height = 1
		mesh.radial_segments = 12
	tip.top_radius = 0
	ring.inner_radius = 0.8
	ring.outer_radius = 1
	ball.radius = 1
	ball.height = 2


static func flat_material(colour: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = colour
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	return material


static func seen_through(colour: Color, priority: int) -> StandardMaterial3D:
	var material := flat_material(colour)
	material.no_depth_test = true
	material.render_priority = priority
	return material


static func label_material(colour: Color, priority: int) -> StandardMaterial3D:
	var material := seen_through(colour, priority)
	material.billboard_mode = BaseMaterial3D.BILLBOARD_ENABLED
	material.fixed_size = true
	return material


func _get_gizmo_name() -> String:
	return "DragMeshBody3D"


func _has_gizmo(node: Node3D) -> bool:
	return node.is_class("DragMeshBody3D")


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var body := gizmo.get_node_3d()
	if not body.is_prepared():
		return
	selected = body in EditorInterface.get_selection().get_selected_nodes()
	for part: Node3D in body.part_nodes():
		var joint: Dictionary = body.joint(part)
		if joint.type not in KINDS:
			continue
		var box := box_of(body, part)
		var end := box.get_center()
		if joint.type == PRISMATIC:
			end = _draw_slide(gizmo, joint, box)
		elif joint.type != FIXED:
			end = _draw_turn(gizmo, joint, box)
		if selected:
			_draw_label(gizmo, joint.type, text_of(joint), end)


func line_of(kind: int) -> Material:
	return get_material(("line %d" if selected else "faint %d") % kind)


## The box of a part and what hangs below it, in the frame of the body.
static func box_of(body: Node3D, part: Node3D) -> AABB:
	var to_body := body.global_transform.affine_inverse()
	var shown: Array[Node] = []
	for node: Node3D in body.nodes_of(part):
		shown.append_array(node.find_children("*", "VisualInstance3D", true, false))
		if node is VisualInstance3D:
			shown.append(node)
	var box := AABB(to_body * part.global_position, Vector3.ZERO)
	for i in shown.size():
		var own: AABB = to_body * shown[i].global_transform * shown[i].get_aabb()
		box = box.merge(own) if i > 0 else own
	return box


static func text_of(joint: Dictionary) -> String:
	var limits: String = " without limits"
	if joint.type == FIXED or joint.type == CONTINUOUS:
		limits = ""
	elif joint.lower < joint.upper and joint.type == PRISMATIC:
		limits = span(joint, 1, 0.01, " m") if joint.upper - joint.lower >= LEAST_IN_METRES else span(joint, 1000, 0.1, " mm")
	elif joint.lower < joint.upper:
		limits = span(joint, 180 / PI, 1, "°")
	return KINDS[joint.type] + limits


static func span(joint: Dictionary, scale: float, step: float, unit: String) -> String:
	return " %s … %s%s" % [str(snappedf(joint.lower * scale, step) + 0.0).trim_suffix(".0"), # + 0.0: no -0
			str(snappedf(joint.upper * scale, step)).trim_suffix(".0"), unit]


## Lower and upper limit; of a joint without: a turn, or as far as the part is large.
static func limits_of(joint: Dictionary, half: float) -> Vector2:
	if joint.type != CONTINUOUS and joint.lower < joint.upper:
		return Vector2(joint.lower, joint.upper)
	return Vector2(-half, half) if joint.type == PRISMATIC else Vector2(-PI, PI)


## Where a joint takes a point at a value.
static func at(joint: Dictionary, point: Vector3, value: float) -> Vector3:
	if joint.type == PRISMATIC:
		return point + joint.axis * value
	return joint.origin + (point - joint.origin).rotated(joint.axis, value) + joint.axis * (joint.pitch * value)


## The place of `rod` or `tip` from one point to another.
static func between(from: Vector3, to: Vector3, radius: float) -> Transform3D:
	var y := to - from
	var along := y.normalized()
	var x := along.cross(Vector3.RIGHT if absf(along.x) < 0.9 else Vector3.UP).normalized()
	return Transform3D(Basis(x * radius, y, x.cross(along) * radius), (from + to) / 2)


func _draw_arrow(gizmo: EditorNode3DGizmo, material: Material, from: Vector3, to: Vector3, half: float) -> void:
	var point := to + (to - from).normalized() * TIP.y * half
	gizmo.add_mesh(rod, material, between(from, to, ROD * half))
	gizmo.add_mesh(tip, material, between(to, point, TIP.x * half))


## Returns where the label goes.
func _draw_slide(gizmo: EditorNode3DGizmo, joint: Dictionary, box: AABB) -> Vector3:
	var half := box.size.length() / 2
	var material := line_of(PRISMATIC)
	var limits := limits_of(joint, half)
	var middle := box.get_center()
	var ends: Array[Vector3] = [at(joint, middle, limits.x), at(joint, middle, limits.y)]
	_draw_arrow(gizmo, material, ends[0], ends[1], half)
	for end in ends:
		gizmo.add_mesh(ring, material, between(end - joint.axis * RING * half / 2, end + joint.axis * RING * half / 2, RING * half))
	gizmo.add_mesh(ball, material, Transform3D(Basis.from_scale(Vector3.ONE * BALL * half), middle))
	return ends[1]


## Returns where the label goes.
func _draw_turn(gizmo: EditorNode3DGizmo, joint: Dictionary, box: AABB) -> Vector3:
	var half := box.size.length() / 2
	var material := line_of(joint.type)
	var top: Vector3 = joint.origin + joint.axis * half
	_draw_arrow(gizmo, material, joint.origin - joint.axis * half, top, half)
	gizmo.add_mesh(ball, material, Transform3D(Basis.from_scale(Vector3.ONE * BALL * half), joint.origin))
	_draw_sector(gizmo, joint, rim_of(joint, box), limits_of(joint, half), half)
	return top


## The point of the part's middle plane that is farthest from the axis on the side of its middle.
static func rim_of(joint: Dictionary, box: AABB) -> Vector3:
	var arm: Vector3 = box.get_center() - joint.origin
	var foot: Vector3 = joint.origin + joint.axis * arm.dot(joint.axis)
	var out := box.get_center() - foot
	if out.length() < ROD * box.size.length():
		out = joint.axis.cross(Vector3.RIGHT if absf(joint.axis.x) < 0.9 else Vector3.UP)
	out = out.normalized()
	return foot + out * (box.get_support(out) - foot).dot(out)


func _draw_sector(gizmo: EditorNode3DGizmo, joint: Dictionary, rim: Vector3, limits: Vector2, half: float) -> void:
	var foot: Vector3 = joint.origin + joint.axis * (rim - joint.origin).dot(joint.axis)
	var material := line_of(joint.type)
	var way := PackedVector3Array()
	var feet := PackedVector3Array()
	for i in STEPS + 1:
		var value := lerpf(limits.x, limits.y, float(i) / STEPS)
		way.append(at(joint, rim, value))
		feet.append(at(joint, foot, value))
	var triangles := PackedVector3Array()
	for i in STEPS:
		triangles.append_array([feet[i], way[i], way[i + 1], feet[i], way[i + 1], feet[i + 1]])
		gizmo.add_mesh(rod, material, between(way[i], way[i + 1], ROD * half))
	for i: int in [0, STEPS] if joint.type != CONTINUOUS else []:
		gizmo.add_mesh(rod, material, between(feet[i], way[i], ROD * half))
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = triangles
	var sector := ArrayMesh.new()
	sector.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	gizmo.add_mesh(sector, get_material("sector %d" % joint.type))


func _draw_label(gizmo: EditorNode3DGizmo, kind: int, words: String, place: Vector3) -> void:
	var text := TextMesh.new()
	text.text = words
	text.font_size = FONT_SIZE
	text.pixel_size = PIXEL_SIZE
	text.depth = 0
	var lift := Vector3(0, LABEL_LIFT, 0)
	var arrays := text.get_mesh_arrays()
	arrays[Mesh.ARRAY_VERTEX] = Transform3D(Basis.IDENTITY, lift) * arrays[Mesh.ARRAY_VERTEX]
	var lifted := ArrayMesh.new()
	lifted.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var board := QuadMesh.new()
	board.size = Vector2(text.get_aabb().size.x, text.get_aabb().size.y) + LABEL_MARGIN
	board.center_offset = lift
	gizmo.add_mesh(board, get_material("label"), Transform3D(Basis.IDENTITY, place))
	gizmo.add_mesh(lifted, get_material("text %d" % kind), Transform3D(Basis.IDENTITY, place))

## A room of props that the mouse opens. `-- --play FILE.png` lets a hand play that moves the mouse; it fails where a part does not
## follow, and writes a picture unless FILE.png is left out.
extends Node3D

const OAK := Color(0.66, 0.47, 0.29)
const STEEL := Color(0.62, 0.65, 0.68)
const ENAMEL := Color(0.74, 0.77, 0.78)
const BRASS := Color(0.78, 0.62, 0.3)
const IRON := Color(0.3, 0.33, 0.37)
const WALNUT := Color(0.42, 0.27, 0.17)
## Of the nodes of each prop; "": of the others.
const PAINT := {
	"HouseDoor": {"body": Color(0.6, 0.62, 0.58), "handle": BRASS, "": OAK},
	"Safe": {"body": IRON, "door": Color(0.36, 0.4, 0.46), "": STEEL},
	"Cabinet": {"body": Color(0.75, 0.71, 0.6), "": Color(0.5, 0.6, 0.52)},
	"Refrigerator": {"crisper": Color(0.25, 0.45, 0.6), "crisper_2": Color(0.25, 0.45, 0.6), "": ENAMEL},
	"Microwave": {"body": STEEL, "turntable": ENAMEL, "": Color(0.22, 0.23, 0.25)},
	"Chest": {"body": WALNUT, "": Color(0.55, 0.33, 0.18)},
}
const EVENTS := ["opened", "closed", "limit_lower", "limit_upper", "detent", "latched", "unlatched", "locked_tried", "joint_changed"]
const SHOWN := 8

var lines: PackedStringArray = []
var waiting := 0


func _ready() -> void:
	for body: DragMeshBody3D in bodies():
		paint(body)
		waiting += 1
		body.prepared.connect(_on_prepared.bind(body))
		for event in EVENTS:
			body.connect(event, func(part: Node3D) -> void: tell("%s: %s %s" % [body.name, part.name, event.replace("_", " ")]))


func bodies() -> Array:
	return get_children().filter(func(node: Node) -> bool: return node is DragMeshBody3D)


func tell(text: String) -> void:
	print(text)
	lines.append(text)
	$Events.text = "\n".join(lines.slice(-SHOWN))


func paint(body: Node3D) -> void:
	var paints: Dictionary = PAINT[str(body.name)]
	for node: MeshInstance3D in body.find_children("*", "MeshInstance3D", true, false):
		var material := StandardMaterial3D.new()
		material.albedo_color = paints.get(str(node.name), paints.get("", Color.WHITE))
		material.roughness = 0.55
		node.material_override = material


func _on_prepared(error: String, body: DragMeshBody3D) -> void:
	if error:
		tell("%s: %s" % [body.name, error])
	waiting -= 1
	var arguments := OS.get_cmdline_user_args()
	if waiting == 0 and arguments.size() > 0 and arguments[0] == "--play":
		var hand := preload("hand.gd").new()
		add_child(hand)
		hand.play(self, arguments[1] if arguments.size() > 1 else "")

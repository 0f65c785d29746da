-- What a host does with a joint beside dragging: a constraint for physics, a saved game, a client. handover.lua LIBRARY OBJECT.dmo
local ffi = require "ffi"
local dragmesh = require("dragmesh").load(arg[1])
local C = dragmesh.C

-- Numbers, not the struct as it lies in memory: structs grow. %.9g keeps every bit of a float.
local function save(door)
    local j = door.joint
    return ("%d %d" .. (" %.9g"):rep(12) .. (" %d"):rep(4)):format(j.type, j.source, door.value, j.type_confidence, j.joint_confidence, j.pitch,
        j.axis.x, j.axis.y, j.axis.z, j.origin.x, j.origin.y, j.origin.z, j.lower, j.upper,
        j.evidence[0], j.evidence[1], j.evidence[2], j.evidence[3]) -- what pulls have said
end

local function load(text)
    local n = {}
    for word in text:gmatch "%S+" do n[#n + 1] = tonumber(word) end
    local joint = dragmesh.new("dm_joint", { type = n[1], source = n[2], type_confidence = n[4], joint_confidence = n[5],
        pitch = n[6], axis = { n[7], n[8], n[9] }, origin = { n[10], n[11], n[12] }, lower = n[13], upper = n[14],
        evidence = { n[15], n[16], n[17], n[18] } })
    return dragmesh.new("dm_part_state", { value = n[3], joint = joint }) -- its pose is zeros: that of joint and value
end

local file = assert(io.open(arg[2], "rb"))
local context = dragmesh.context()
local object = context:load_object(file:read "*a")
local part = object:part(0)
local door = dragmesh.new("dm_part_state", { joint = object:joint(part.id) })

-- Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider.
local frame = dragmesh.new "dm_joint_frame"
C.dm_joint_get_frame(door.joint, frame)
print(("a constraint that opens to %.2f"):format(frame.upper))

-- … and back: body is the transform that the engine has given the part, from rest.
local body = dragmesh.joint_pose(door.joint, 1.2)
local value, angle_off, distance_off = ffi.new "float[1]", ffi.new "float[1]", ffi.new "float[1]"
C.dm_joint_value(door.joint, body, value, angle_off, distance_off)
door.value, door.pose = value[0], body
print(("physics leaves it at %.2f"):format(door.value))

local loaded = load(save(door))
print(("saved and loaded at %.2f"):format(loaded.value))

-- A client has neither object nor context: the joint once, the value every frame.
local shown = dragmesh.joint_pose(loaded.joint, loaded.value)

-- The next grab begins where the part stands.
local x, y, z = dragmesh.apply(shown, part.centre.x, part.centre.y, part.centre.z)
local drag = object:grab(dragmesh.new("dm_drag_desc", { part_id = part.id, grab_point = { x, y, z }, state = loaded }))
print(("grabbed again at %.2f"):format(drag:finish().value))

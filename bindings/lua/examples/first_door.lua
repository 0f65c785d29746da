-- Pulls the first part of a prepared object open with a pointer, and lets it swing: first_door.lua LIBRARY OBJECT.dmo
local ffi = require "ffi"
local dragmesh = require("dragmesh").load(arg[1])

local file = assert(io.open(arg[2], "rb"))
local context = dragmesh.context()
local object = context:load_object(file:read "*a")
local part = object:part(0)
local drag = object:grab(dragmesh.new("dm_drag_desc", { part_id = part.id, grab_point = part.centre })) -- at a hit's object_point
local eye = ffi.new("dm_vec3", part.centre.x, part.centre.y, part.centre.z + 2)
for frame = 0, 59 do -- every frame, with the pointer's ray in the object's frame
    drag:update(ffi.new("dm_ray", eye, { -0.003 * frame, 0, -2 }), 1 / 60)
end
drag:release(dragmesh.new("dm_release_desc", { intent = dragmesh.C.DM_GO_OPEN }))
while drag.state.phase ~= dragmesh.C.DM_DRAG_AT_REST do drag:update(nil, 1 / 60) end
local kept = drag:finish() -- joint, value and pose: what the instance saves
print(("part %d stands open at %.2f"):format(part.id, kept.value))

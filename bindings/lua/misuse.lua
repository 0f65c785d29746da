-- What a host may do wrong with the methods of dragmesh.lua: an error each time, and the context goes on.
-- misuse.lua LIBRARY OBJECT.dmo FILE.glb GLTF_LIBRARY
local ffi = require "ffi"
local dragmesh = require "dragmesh"
dragmesh.load(arg[1], nil, arg[4])

local file = assert(io.open(arg[2], "rb"))
local dmo = file:read "*a"
file:close()

local checks = 0
local function fails(what, text, call, ...)
    local works, message = pcall(call, ...)
    checks = checks + 1
    assert(not works, what .. " did not fail")
    assert(tostring(message):find(text), ("%s failed with %s"):format(what, message))
end

local wrong_numbers = { 0 / 0, 1 / 0, -1 / 0, 1e300 }
local wrong_integers = { -1, 1.5, 2 ^ 32, 2 ^ 53 + 2, 0 / 0, 1 / 0, "1", {}, false }
local ray = ffi.new("dm_ray", { { 0, 0, 5 }, { 0, 0, -1 } })
local new = dragmesh.new

local function door(context) return context:load_object(dmo) end
local function grab(object)
    return object:grab(new("dm_drag_desc", { part_id = object:part(0).id, flags = dragmesh.C.DM_DRAG_WITHOUT_POINT,
        rules = new "dm_drag_rules" }))
end

-- Ends, in any order.
local context = dragmesh.context()
local object = door(context)
local drag, part, scene = grab(object), object:part(0).id, context:scene()
scene:add(object)
object:close()
object:close()
for what, call in pairs { info = object.info, save = object.save, grab = grab } do fails(what, "STALE_HANDLE", call, object) end
fails("a drag of an ended object", "STALE_HANDLE", drag.update, drag, ray, 0.01)
fails("an ended object in a scene", "STALE_HANDLE", scene.add, scene, object)
drag:close()
fails("an ended drag", "STALE_HANDLE", drag.finish, drag)
scene:commit()
local other = dragmesh.context()
fails("an object of another context", "STALE_HANDLE", scene.add, scene, door(other))
local left, held = door(other), grab(door(other))
other:close()
other:close()
for _, call in ipairs { function() left:info() end, function() held:update(ray, 0.01) end, function() door(other) end,
    function() other:scene() end, function() other:camera_ray(new "dm_camera", 0, 0) end } do
    fails("an ended context", "INVALID_ARGUMENT", call)
end
left:close()
held:close()
left, held, other = nil, nil, nil
for _ = 1, 20 do
    local lost = dragmesh.context()
    grab(door(lost))
    if math.random(2) == 1 then lost:close() end
end
collectgarbage()
collectgarbage()

-- Arguments.
object = door(context)
drag = grab(object)
for _, number in ipairs(wrong_integers) do
    for _, call in ipairs { function() object:part(number) end, function() object:joint(number) end,
        function() object:hypotheses(number) end, function() object:reset_joint(number) end,
        function() object:set_joint(number, new "dm_joint") end, function() scene:remove(number) end,
        function() scene:move(number, 0, ffi.new "dm_pose") end,
        function() object:follow_links(part, ffi.new "float[1]", nil, number) end } do
        fails("the integer " .. tostring(number), "must be an integer", call)
    end
end
for _, number in ipairs(wrong_numbers) do
    local bent, input = object:joint(part), new "dm_drag_input"
    bent.axis.x = number
    input.hand.kind, input.hand.amount = dragmesh.C.DM_HAND_VALUE, number
    fails("an axis", "NOT_FINITE", object.set_joint, object, part, bent)
    fails("a hand", "NOT_FINITE", drag.step, drag, input, 0.01)
    fails("a time", "NOT_FINITE", drag.update, drag, ray, number)
    fails("a value", "NOT_FINITE", dragmesh.joint_pose, object:joint(part), number)
end
for _, values in ipairs { ffi.new "float[1]", ffi.new("float[?]", 99), ffi.cast("float*", ffi.new "float[2]"), {}, "text", 5 } do
    fails("values", "must be an array", object.follow_links, object, part, values, nil, 1000)
end
fails("held", "must be an array", object.follow_links, object, part, ffi.new "float[100]", ffi.new "uint8_t[1]", 100)
fails("too many values", "INVALID_ARGUMENT", object.follow_links, object, part, ffi.new "float[100]", nil, 100)
fails("a wrong link", "cannot convert", object.set_links, object, { { driver = 1, driven = {} } })
local saved = drag:save()
for _, data in ipairs { 5, {}, true, ffi.new "uint8_t[9]", ffi.cast("void*", 8) } do
    fails("bytes", "must be a string", context.load_object, context, data)
    fails("a saved drag", "must be a string", drag.restore, drag, data)
    fails("weights", "must be a string", context.load_model, context, data)
    fails("a path", "must be a string", dragmesh.gltf, data)
end
for _, data in ipairs { "", "x", saved:sub(2), dmo } do fails("another state", "DM_ERROR", drag.restore, drag, data) end
drag:restore(saved)
fails("a path with a zero", "zero", dragmesh.gltf, arg[3] .. "\0.txt")

-- Structs: of another kind, of another size.
for _, struct in ipairs { ffi.new "dm_pose", ffi.new "dm_joint", new("dm_joint", { struct_size = 4096 }), {}, 5, "text",
    new("dm_drag_desc", { struct_size = 2 ^ 32 - 1 }) } do
    for _, call in ipairs { function() object:set_joint(part, struct) end, function() object:grab(struct) end,
        function() object:motion(struct) end, function() drag:step(struct, 0.01) end, function() drag:release(struct) end,
        function() context:prepare(struct) end, function() context:camera_ray(struct, 0, 0) end,
        function() dragmesh.joint_pose(struct, 0) end, function() dragmesh.context(struct) end } do
        fails("a struct", "is needed", call)
    end
end
drag.state.struct_size = 2 ^ 32 - 1 -- set anew by each call
drag:update(ray, 0.01)

-- The arrays of a file keep it.
local positions, indices, count = dragmesh.gltf(arg[3]):mesh()
for _ = 1, 3 do
    collectgarbage()
    dragmesh.gltf(arg[3])
end
local sum = 0
for i = 0, count - 1 do sum = sum + positions[3 * indices[i]] end
assert(sum == sum and math.abs(sum) < 1e6)

assert(drag:update(ray, 0.01).phase == dragmesh.C.DM_DRAG_HELD) -- the context goes on
print(("LuaJIT: %d misuses refused"):format(checks)) -- the rest is left to the end of the program

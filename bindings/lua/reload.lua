-- What an editor's reload does: loads, drags, unloads and ends in any order, 1,000 times. No callback may come after the end
-- of a context, and memory must not grow. reload.lua LIBRARY WEIGHTS_FOLDER OBJECT.dmo
local ffi = require "ffi"
local dragmesh = require "dragmesh"
dragmesh.load(arg[1])

local ROUNDS, SETTLED = 1000, 200
local ALLOWED_GROWTH = 8192 -- KiB of the process between round 200 and the last, by hand

local function read(path)
    local file = assert(io.open(path, "rb"))
    local text = file:read "*a"
    file:close()
    return text
end

local function resident()
    for line in io.lines "/proc/self/status" do
        local size = line:match "^VmRSS:%s*(%d+)"
        if size then return tonumber(size) end
    end
end

local ranker, dmo = read(arg[2] .. "/ranker.safetensors"), read(arg[3])
local ended, late, heard = false, 0, 0
local on_message = ffi.cast("void (*)(void*, int32_t, dm_result, const char*)", function()
    heard = heard + 1
    if ended then late = late + 1 end
end)

local function round()
    ended = false
    local desc = dragmesh.new "dm_context_desc"
    desc.log.message = on_message
    local context = dragmesh.context(desc)
    local model = context:load_model(nil, nil, ranker)
    local door = context:load_object(dmo, model)
    local part = door:part(0)
    local drag = door:grab(dragmesh.new("dm_drag_desc", { part_id = part.id, grab_point = part.centre,
        rules = dragmesh.new "dm_drag_rules" }))
    local scene = context:scene()
    scene:add(door)
    drag:update(ffi.new("dm_ray", { { 0, 0, 5 }, { 0, 0, -1 } }), 0.016)
    assert(not pcall(context.load_object, context, "no")) -- logs
    local made = { context, model, door, drag, scene }
    while #made > 0 do
        local one = table.remove(made, math.random(#made))
        if one == context or math.random(4) > 1 then -- the others are left to the collector
            one:close()
            if one == context then ended = true end
            pcall(drag.update, drag, nil, 0.016)
        end
    end
end

math.randomseed(1)
local settled
for number = 1, ROUNDS do
    jit.off(round)
    round()
    if number % 50 == 0 then collectgarbage() end
    if number == SETTLED then settled = resident() end
end
local growth = resident() - settled
assert(late == 0, late .. " messages came after the end of their context")
assert(heard >= ROUNDS, "the log was not called")
assert(growth < ALLOWED_GROWTH, "memory has grown by " .. growth .. " KiB")
print(("LuaJIT: %d reloads, %d KiB grown since the %dth"):format(ROUNDS, growth, SETTLED))

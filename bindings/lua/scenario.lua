-- The common scenario through dragmesh.lua: prints what bindings/scenario/scenario.c prints.
local ffi, bit = require "ffi", require "bit"
local dragmesh = require "dragmesh"

dragmesh.load(arg[1])
local C = dragmesh.C

local FRAMES, SHOWN_EVERY, SAVED_AT, RELEASED_FRAMES, HANDLE_TURNS_AT = 60, 10, 30, 120, 25
local FRAME_TIME = 1 / 60
local HANDLE_TURN, WIDEST = 1, 0.45 -- rad
local SNAPS = ffi.new("float[2]", 0.2, 0.4) -- rad
local DOOR, DRAWER = 1, 2

local float = ffi.typeof "float[1]"
-- Computes as C does: in single precision.
local function f32(x) return float(x)[0] end

local function ray_at(frame)
    local ray = ffi.new("dm_ray", { { 0.9, 0.9, 2.0 }, { -0.35, -0.45, -1.55 } })
    ray.direction.x = f32(ray.direction.x - f32(f32(0.01) * frame))
    ray.direction.z = f32(ray.direction.z + f32(f32(0.005) * frame))
    return ray
end

-- From x, y, z to x, y, z, and the part: samples/common/cabinet.h.
local BOXES = {
    { 0.00, 0.00, 0.000, 0.60, 0.02, 0.40, 0 }, { 0.00, 0.98, 0.000, 0.60, 1.00, 0.42, 0 },
    { 0.00, 0.02, 0.000, 0.02, 0.98, 0.40, 0 }, { 0.58, 0.02, 0.000, 0.60, 0.98, 0.40, 0 },
    { 0.02, 0.02, 0.000, 0.58, 0.98, 0.02, 0 }, { 0.00, 0.00, 0.402, 0.60, 0.79, 0.42, DOOR },
    { 0.54, 0.35, 0.420, 0.56, 0.55, 0.45, DOOR }, { 0.00, 0.80, 0.402, 0.60, 0.97, 0.42, DRAWER },
    { 0.25, 0.87, 0.420, 0.35, 0.89, 0.45, DRAWER }, { 0.04, 0.82, 0.030, 0.56, 0.83, 0.402, DRAWER },
    { 0.04, 0.83, 0.030, 0.05, 0.95, 0.402, DRAWER }, { 0.55, 0.83, 0.030, 0.56, 0.95, 0.402, DRAWER },
    { 0.05, 0.83, 0.030, 0.55, 0.95, 0.040, DRAWER },
}
local CORNERS = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
    2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 }

local positions = ffi.new("float[?]", #BOXES * 24)
local parts = ffi.new("uint8_t[?]", #BOXES * 8)
local indices = ffi.new("uint16_t[?]", #BOXES * 36)
for v = 0, #BOXES * 8 - 1 do
    local box = BOXES[math.floor(v / 8) + 1]
    for k = 0, 2 do positions[3 * v + k] = box[k + 1 + 3 * bit.band(bit.rshift(v, k), 1)] end
    parts[v] = box[7]
end
for i = 0, #BOXES * 36 - 1 do indices[i] = math.floor(i / 36) * 8 + CORNERS[i % 36 + 1] end

local function print_floats(label, ...)
    local line = { label }
    for _, value in ipairs { ... } do
        line[#line + 1] = bit.tohex(ffi.cast("uint32_t*", float(value))[0])
    end
    print(table.concat(line, " "))
end

local function print_joint(j)
    print(("joint %d source %d"):format(j.type, j.source))
    print_floats(" ", j.axis.x, j.axis.y, j.axis.z, j.origin.x, j.origin.y, j.origin.z, j.lower, j.upper,
        j.type_confidence, j.joint_confidence)
end

local function print_pose(pose)
    print_floats(" ", pose.real[0], pose.real[1], pose.real[2], pose.real[3])
    print_floats(" ", pose.dual[0], pose.dual[1], pose.dual[2], pose.dual[3])
end

local function print_state(label, state, events)
    print(("%s phase %d events %d changes %d basis %d"):format(label, state.phase, events or state.events, state.changes,
        state.joint_basis))
    print_floats(" ", state.value, state.joint_confidence)
    print_pose(state.pose)
end

local function print_hypotheses(object, part)
    local all, count = object:hypotheses(part)
    print(("part %d hypotheses %d"):format(part, count))
    print_joint(object:joint(part))
    for i = 0, count - 1 do print_joint(all[i]) end
end

local function pick(context, object)
    local scene = context:scene()
    scene:add(object)
    scene:commit()
    local hit = scene:pick(ray_at(0))
    print(("picked part %d triangle %d"):format(hit.part_id, hit.triangle))
    print_floats(" ", hit.object_point.x, hit.object_point.y, hit.object_point.z)
    scene:close()
    return hit
end

local function drag_and_release(object, hit)
    local rules = dragmesh.new "dm_drag_rules"
    local desc = dragmesh.new("dm_drag_desc", { part_id = hit.part_id, grab_point = hit.object_point, rules = rules })
    local drag, events, saved = object:grab(desc), 0, nil
    for frame = 0, FRAMES - 1 do
        local state = drag:update(ray_at(frame), FRAME_TIME)
        events = bit.bor(events, state.events)
        if frame % SHOWN_EVERY == 0 then print_state("frame", state) end
        if frame == SAVED_AT then saved = drag:save() end
    end
    drag:restore(saved)
    print_state("restored", drag:update(ray_at(FRAMES), FRAME_TIME))
    local plan = drag:release(dragmesh.new("dm_release_desc",
        { intent = C.DM_GO_OPEN, flags = C.DM_RELEASE_BY_RULE }))
    print_floats("plan", plan.end_value)
    for _ = 1, RELEASED_FRAMES do events = bit.bor(events, drag:update(nil, FRAME_TIME).events) end
    print_state("released", drag.state, events)
    local kept = drag:finish()
    desc.grab_point, desc.state = drag.state.grab_point, kept
    local last = object:grab(desc):finish()
    print_floats("again", last.value)
    print_pose(last.pose)
    local words = last.joint.evidence
    print(("evidence %d %d %d %d"):format(words[0], words[1], words[2], words[3]))
end

local function drag_behind_latch(object, hit)
    local rules = dragmesh.new("dm_drag_rules", { flags = C.DM_RULE_LATCH, snaps = SNAPS, snap_count = 2 })
    local desc = dragmesh.new("dm_drag_desc", { part_id = hit.part_id, grab_point = hit.object_point, rules = rules })
    local input = dragmesh.new("dm_drag_input", { flags = C.DM_INPUT_ASK })
    input.hand.kind = C.DM_HAND_RAY
    local drag, events, detents = object:grab(desc), 0, 0
    for frame = 0, FRAMES - 1 do
        input.hand.ray = ray_at(frame)
        input.handles[0] = frame < HANDLE_TURNS_AT and 0 or HANDLE_TURN
        local state = drag:update_input(input, FRAME_TIME)
        if state.value > f32(WIDEST) then state = drag:override(WIDEST) end
        events, detents = bit.bor(events, state.events), detents + state.detents
        if frame % SHOWN_EVERY == 0 then print_state("latch", state) end
    end
    print_state("latched", drag.state, events)
    print("detents " .. detents)
    drag:close()
end

local function follow_links(object)
    local values, held = ffi.new("float[2]", -0.9, 0), ffi.new "uint8_t[2]"
    object:set_links { { driver = DOOR, driven = DRAWER, ratio = 0.25, from = 0.1 },
        { driver = DRAWER, driven = DOOR, kind = C.DM_LINK_HOLDS, from = 0.05 } }
    for _ = 1, 2 do
        object:follow_links(DOOR, values, held, 2)
        print_floats("linked", values[0], values[1])
        print(("held %d %d"):format(held[0], held[1]))
        values[0] = 0.9
    end
end

local function save_and_load(context, object)
    local data, hash = object:save(), 2166136261 -- FNV-1a
    for i = 1, #data do
        hash = bit.bxor(hash, data:byte(i))
        hash = tonumber(ffi.cast("uint32_t", ffi.cast("uint64_t", bit.band(hash, -1) % 2 ^ 32) * 16777619ULL))
    end
    print(("saved %d bytes %s"):format(#data, bit.tohex(hash)))
    print_joint(context:load_object(data):joint(DOOR))
end

local context = dragmesh.context()
local model = context:load_model_from(arg[2])
local mesh = dragmesh.new("dm_mesh_desc", {
    positions = positions, vertex_count = #BOXES * 8, position_bytes = ffi.sizeof(positions),
    indices = indices, index_count = #BOXES * 36, index_bytes = ffi.sizeof(indices), index_format = C.DM_UINT16,
    part_ids = parts, part_id_bytes = ffi.sizeof(parts), part_id_format = C.DM_UINT8 })
local labels = { "kitchen/cabinet/door", "kitchen/cabinet/drawer" }
local hints = ffi.new "dm_part_desc[2]"
for i = 0, 1 do
    hints[i].struct_size, hints[i].id, hints[i].label = ffi.sizeof "dm_part_desc", i + 1, labels[i + 1]
end
local object = context:prepare(dragmesh.new("dm_object_desc",
    { mesh = mesh, parts = hints, part_count = 2 }), model)
print_hypotheses(object, DOOR)
print_hypotheses(object, DRAWER)
local hit = pick(context, object)
drag_and_release(object, hit)
drag_behind_latch(object, hit)
follow_links(object)
save_and_load(context, object)
mesh.index_count = 3 * 12 -- one box, without any part
local fine, message = pcall(context.prepare, context, dragmesh.new("dm_object_desc", { mesh = mesh }))
assert(not fine)
print("error " .. message:match "DM_ERROR_[A-Z_]+")
context:close()

-- A prop: a glTF file as drawable pieces, its .dmo, and what the player has done to it.
local ffi = require "ffi"
local dragmesh = require "dragmesh"

local FORMAT = { { "VertexPosition", "float", 3 }, { "VertexNormal", "float", 3 }, { "VertexColor", "byte", 4 } }
local IDENTITY = ffi.new("dm_pose", { { 0, 0, 0, 1 } })

local Prop = {}
Prop.__index = Prop

local function bytes_of(path) return (assert(love.filesystem.read(path))) end -- without its size

-- The faces of one node as a mesh with flat normals.
local function make_mesh(node, positions, indices, colour)
    local vertices = {}
    for face = node.first_face, node.first_face + node.face_count - 1 do
        local p = {}
        for corner = 0, 2 do
            local at = 3 * indices[3 * face + corner]
            p[corner] = { positions[at], positions[at + 1], positions[at + 2] }
        end
        local a, b = {}, {}
        for k = 1, 3 do a[k], b[k] = p[1][k] - p[0][k], p[2][k] - p[0][k] end
        local n = { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
        local length = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
        if length > 0 then
            for corner = 0, 2 do
                local v = p[corner]
                vertices[#vertices + 1] = { v[1], v[2], v[3], n[1] / length, n[2] / length, n[3] / length, colour[1],
                    colour[2], colour[3], 1 }
            end
        end
    end
    return #vertices > 0 and love.graphics.newMesh(FORMAT, vertices, "triangles", "static") or nil
end

--- Loads props/NAME.glb and .dmo. row: of room.lua.
function Prop.load(context, row)
    local self = setmetatable({ name = row.name, parts = {}, pieces = {}, by_name = {} }, Prop)
    self.object = context:load_object(bytes_of("props/" .. row.name .. ".dmo"))
    local info = self.object:info()
    local low, high = info.box_min, info.box_max
    self.scale = row.height / (high.y - low.y)
    -- Stands on its point, with the middle of its foot there.
    local foot = dragmesh.pose({ 0, 1, 0 }, 0, -(low.x + high.x) / 2 * self.scale, -low.y * self.scale,
        -(low.z + high.z) / 2 * self.scale)
    self.placement = dragmesh.multiply(dragmesh.pose({ 0, 1, 0 }, row.turn or 0, unpack(row.at)), foot)
    local gltf = dragmesh.gltf(love.filesystem.getSource() .. "/props/" .. row.name .. ".glb")
    local nodes = gltf:nodes()
    local positions, indices = gltf:mesh()
    local part_of_node = {} -- by the number of the node in the file
    for _, told in ipairs(love.filesystem.load("props/" .. row.name .. ".lua")()) do
        local part_row = (row.parts or {})[told.name] or {}
        local part = { id = told.id, name = told.name, row = part_row, prop = self, pose = IDENTITY, value = 0 }
        self.parts[told.id], self.by_name[told.name] = part, part
        for _, node in ipairs(told.nodes) do part_of_node[node] = part end
    end
    for _, part in pairs(self.parts) do part.carrier = self.by_name[part.row.on] end
    for _, node in ipairs(nodes) do
        local part = part_of_node[node.node]
        local colour = part and (row.paint[part.name] or row.paint.parts) or row.paint.body
        local mesh = make_mesh(node, positions, indices, colour)
        if mesh then self.pieces[#self.pieces + 1] = { mesh = mesh, part = part } end
    end
    self.scene = context:scene()
    self.instance = self.scene:add(self.object)
    self.scene:commit()
    return self
end

--- The pose of a part from rest, with that of what carries it.
function Prop.pose_of(part)
    if not part then return IDENTITY end
    if part.carrier then return dragmesh.multiply(Prop.pose_of(part.carrier), part.pose) end
    return part.pose
end

-- A ray of the world in the object's frame; with a part, in the frame of what carries it.
function Prop:to_object(ray, part)
    local back = dragmesh.inverse(self.placement)
    local o, d = ray.origin, ray.direction
    local function point(x, y, z)
        x, y, z = dragmesh.apply(back, x, y, z)
        x, y, z = x / self.scale, y / self.scale, z / self.scale
        if part and part.carrier then return dragmesh.apply(dragmesh.inverse(Prop.pose_of(part.carrier)), x, y, z) end
        return x, y, z
    end
    local ax, ay, az = point(o.x, o.y, o.z)
    local bx, by, bz = point(o.x + d.x, o.y + d.y, o.z + d.z)
    return ffi.new("dm_ray", { { ax, ay, az }, { bx - ax, by - ay, bz - az } })
end

--- The nearest hit of a ray of the world, and its distance there.
function Prop:pick(ray)
    local hit = self.scene:pick(self:to_object(ray))
    if not hit then return nil end
    return hit, hit.distance * self.scale
end

local function fields(target, values)
    for key, value in pairs(values or {}) do target[key] = value end
end

--- Grabs a part at a hit; nil: by no point.
function Prop:grab(part, hit)
    self:let(part)
    local rules = dragmesh.new "dm_drag_rules"
    fields(rules, part.row.rules)
    if part.row.latch then rules.flags = dragmesh.C.DM_RULE_LATCH end
    local desc = dragmesh.new("dm_drag_desc", { part_id = part.id, rules = rules, state = part.kept })
    fields(desc.feel, part.row.feel)
    if hit then
        local p = hit.object_point
        local x, y, z = p.x, p.y, p.z
        if part.carrier then x, y, z = dragmesh.apply(dragmesh.inverse(Prop.pose_of(part.carrier)), x, y, z) end
        desc.grab_point.x, desc.grab_point.y, desc.grab_point.z = x, y, z
    else
        desc.flags = dragmesh.C.DM_DRAG_WITHOUT_POINT
    end
    part.drag, part.held = self.object:grab(desc), true
    part.input = dragmesh.new "dm_drag_input"
end

function Prop:release(part)
    part.held = false
    part.drag:release(dragmesh.new("dm_release_desc", { flags = dragmesh.C.DM_RELEASE_BY_RULE }))
end

--- Ends a drag and keeps what the instance keeps.
function Prop:let(part)
    if part.drag then part.kept = part.drag:finish() end
    part.drag, part.held = nil, false
end

--- One frame of a part that is held (ray: of the world) or moves by itself. hear: gets the events.
function Prop:update(part, ray, dt, hear)
    if not part.drag then return end
    local input, latch = part.input, self.by_name[part.row.latch]
    input.hand.kind = part.held and ray and dragmesh.C.DM_HAND_RAY or dragmesh.C.DM_HAND_NONE
    if ray then input.hand.ray = self:to_object(ray, part) end
    if latch then input.handles[0] = math.max(math.abs(latch.value), self.key_turn or 0) end
    local state = part.drag:update_input(input, dt)
    part.pose, part.value = ffi.new("dm_pose", state.pose), state.value
    self:place()
    if state.events ~= 0 then hear(part, state) end
    if state.phase == dragmesh.C.DM_DRAG_AT_REST then self:let(part) end
end

--- Tells the scene where the parts are.
function Prop:place()
    for id, part in pairs(self.parts) do self.scene:move(self.instance, id, Prop.pose_of(part)) end
    self.scene:commit()
end

return Prop

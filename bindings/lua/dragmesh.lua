--- dragmesh for LuaJIT, through its FFI. Frames, units and threads are those of dragmesh.h.
--
-- Structs are those of C: M.new("dm_drag_desc") makes one with struct_size set and zeros elsewhere. Methods raise an error
-- whose text begins with the name of the result, such as "DM_ERROR_EMPTY_MASK"; pcall catches it. Objects end by
-- themselves when they are collected, or at once by :close().
local ffi = require "ffi"

local M = {}

local here = debug.getinfo(1, "S").source:match "^@(.*[/\\])" or "./"

local function read(path)
    local file = assert(io.open(path, "rb"))
    local text = file:read "*a"
    file:close()
    return text
end

local C

--- Loads the library. path: of the shared library; nil: "dragmesh" where the system looks. ffi_header: of
-- dragmesh_ffi.h; nil: beside this file or in the folder above. gltf_path: of the library for M.gltf; nil: "dragmesh_gltf"
-- where the system looks. Call it once, before anything else.
function M.load(path, ffi_header, gltf_path)
    if C then return M end
    local candidates = ffi_header and { ffi_header } or { here .. "dragmesh_ffi.h", here .. "../dragmesh_ffi.h" }
    for _, name in ipairs(candidates) do
        local file = io.open(name, "rb")
        if file then
            ffi.cdef(file:read "*a")
            file:close()
            C = ffi.load(path or "dragmesh")
            M.C, M.gltf_path = C, gltf_path or "dragmesh_gltf"
            return M
        end
    end
    error("dragmesh_ffi.h was not found: " .. table.concat(candidates, ", "))
end

local function check(result)
    if result ~= 0 then error(ffi.string(C.dm_result_string(result)), 3) end
end

--- A struct of C with struct_size set. fields: a table of values to set.
function M.new(name, fields)
    local struct = ffi.new(name)
    if ffi.offsetof(name, "struct_size") then struct.struct_size = ffi.sizeof(name) end
    for key, value in pairs(fields or {}) do struct[key] = value end
    return struct
end

-- What can be checked of arguments. Pointers inside structs, arrays behind them and callbacks can't: they are C's.

-- An integer that a uint32_t holds. The FFI would cut others in silence.
local function whole(number, what)
    if type(number) ~= "number" or number % 1 ~= 0 or number < 0 or number >= 2 ^ 32 then
        error(("%s is %s, it must be an integer from 0 on"):format(what, tostring(number)), 3)
    end
    return number
end

-- A string: the FFI would take other things for its address.
local function bytes(data, what)
    if type(data) ~= "string" then error(what .. " must be a string", 3) end
    return data
end

-- A struct of this very kind, as M.new makes it.
local function sized(struct, name)
    if not ffi.istype(name, struct) or struct.struct_size ~= ffi.sizeof(name) then
        error(("a %s of dragmesh.new is needed"):format(name), 3)
    end
    return struct
end

-- An array with room for what counts.
local function room(array, size, what)
    if type(array) ~= "cdata" or ffi.sizeof(array) < size then
        error(("%s must be an array of %d bytes"):format(what, size), 3)
    end
    return array
end

-- Owners ------------------------------------------------------------------------------------------------------------

-- Makes a class of handles that `finish(context, handle)` ends. A closed handle is 0, which the library refuses.
local function class(finish)
    local methods = {}
    methods.__index = methods
    --- Ends it now; a second time does nothing.
    function methods:close()
        if self.handle ~= 0 and self.context.pointer ~= nil then finish(self.context.pointer, self.handle) end
        self.handle = ffi.cast("uint64_t", 0)
    end
    -- kept: what must not be collected before this
    methods.make = function(context, handle, kept)
        local self = setmetatable({ context = context, handle = handle, kept = kept }, methods)
        self.guard = newproxy(true) -- LuaJIT collects userdata with __gc, tables it does not
        getmetatable(self.guard).__gc = function() self:close() end
        return self
    end
    return methods
end

local Model = class(function(context, handle) C.dm_model_unload(context, handle) end)
local Object = class(function(context, handle) C.dm_object_destroy(context, handle) end)
local Drag = class(function(context, handle) C.dm_drag_end(context, handle, nil) end)
local Scene = class(function(context, handle) C.dm_scene_destroy(context, handle) end)
local Motion = class(function(context, handle) C.dm_motion_destroy(context, handle) end)

local Context = {}
Context.__index = Context

--- Makes a context. desc: a dm_context_desc; nil = all defaults.
function M.context(desc)
    local out = ffi.new "dm_context*[1]"
    check(C.dm_context_create(sized(desc or M.new "dm_context_desc", "dm_context_desc"), out))
    local self = setmetatable({ pointer = out[0] }, Context)
    self.guard = newproxy(true)
    getmetatable(self.guard).__gc = function() self:close() end
    return self
end

--- Ends it, and everything made with it.
function Context:close()
    C.dm_context_destroy(self.pointer)
    self.pointer = nil -- later calls by what it has made are refused
end

--- Reads weights, each the bytes of a file as a string; nil = absent.
function Context:load_model(kinematics, motion, ranker)
    local desc, out = M.new "dm_model_desc", ffi.new "dm_model[1]"
    desc.kinematics, desc.kinematics_size = kinematics, kinematics and #bytes(kinematics, "kinematics") or 0
    desc.motion, desc.motion_size = motion, motion and #bytes(motion, "motion") or 0
    desc.ranker, desc.ranker_size = ranker, ranker and #bytes(ranker, "ranker") or 0
    check(C.dm_model_load(self.pointer, desc, out))
    return Model.make(self, out[0])
end

--- Reads the weights in a folder.
function Context:load_model_from(folder)
    return self:load_model(read(folder .. "/kpp_net.safetensors"), read(folder .. "/dq_vae.safetensors"),
        read(folder .. "/ranker.safetensors"))
end

--- Finds out how each part moves. desc: a dm_object_desc; what it points to must live during the call. model: the weights,
-- instead of desc.model; nil = none.
function Context:prepare(desc, model)
    local out = ffi.new "dm_object[1]"
    sized(desc, "dm_object_desc")
    if model then desc.model = model.handle end
    check(C.dm_object_prepare(self.pointer, desc, out))
    return Object.make(self, out[0], model)
end

--- Reads the bytes of a .dmo, a string. model: for its motions; nil = none.
function Context:load_object(data, model)
    local out = ffi.new "dm_object[1]"
    check(C.dm_object_load(self.pointer, bytes(data, "data"), #data, model and model.handle or 0, out))
    return Object.make(self, out[0], model)
end

function Context:scene()
    local out = ffi.new "dm_scene[1]"
    check(C.dm_scene_create(self.pointer, M.new "dm_scene_desc", out))
    return Scene.make(self, out[0], {})
end

--- The ray through a pixel, (0, 0) the top left corner.
function Context:camera_ray(camera, x, y)
    local out = ffi.new "dm_ray"
    check(C.dm_camera_ray(self.pointer, sized(camera, "dm_camera"), x, y, out))
    return out
end

-- Objects -----------------------------------------------------------------------------------------------------------

--- The part at a position 0 .. part_count - 1: a dm_part_info.
function Object:part(index)
    local out = M.new "dm_part_info"
    check(C.dm_object_get_part(self.context.pointer, self.handle, whole(index, "index"), out))
    return out
end

function Object:info()
    local out = M.new "dm_object_info"
    check(C.dm_object_get_info(self.context.pointer, self.handle, out))
    return out
end

--- The joint in force: a dm_joint.
function Object:joint(part)
    local out = M.new "dm_joint"
    check(C.dm_object_get_joint(self.context.pointer, self.handle, whole(part, "part"), out))
    return out
end

--- All that were found, most probable first: an array of dm_joint from 0 on, and how many. hint: a dm_drag_hint, or nil.
function Object:hypotheses(part, hint)
    local out, count = ffi.new("dm_joint[?]", C.DM_MAX_HYPOTHESES), ffi.new "uint32_t[1]"
    for i = 0, C.DM_MAX_HYPOTHESES - 1 do out[i].struct_size = ffi.sizeof "dm_joint" end
    check(C.dm_object_get_hypotheses(self.context.pointer, self.handle, whole(part, "part"), hint, out, C.DM_MAX_HYPOTHESES,
        count))
    return out, count[0]
end

function Object:set_joint(part, joint)
    check(C.dm_object_set_joint(self.context.pointer, self.handle, whole(part, "part"), sized(joint, "dm_joint")))
end

function Object:reset_joint(part)
    check(C.dm_object_reset_joint(self.context.pointer, self.handle, whole(part, "part")))
end

--- Links parts, in place of the links of before. links: tables with the fields of dm_link; none: unlinks them.
function Object:set_links(links)
    check(C.dm_object_set_links(self.context.pointer, self.handle, ffi.new("dm_link[?]", #links, links), #links))
end

--- Moves what is linked with a part. values: the joint values of one instance, a float[?] from 0 on; held: a uint8_t[?]
-- that gets 1 where a link holds the part, or nil; count: of parts.
function Object:follow_links(part, values, held, count)
    room(values, ffi.sizeof "float" * whole(count, "count"), "values")
    if held ~= nil then room(held, count, "held") end
    check(C.dm_object_follow_links(self.context.pointer, self.handle, whole(part, "part"), values, held, count))
end

--- The bytes of a .dmo, a string.
function Object:save()
    local size = ffi.new "size_t[1]"
    check(C.dm_object_save(self.context.pointer, self.handle, nil, 0, size))
    local data = ffi.new("uint8_t[?]", size[0])
    check(C.dm_object_save(self.context.pointer, self.handle, data, size[0], size))
    return ffi.string(data, size[0])
end

--- Grabs a part. desc: a dm_drag_desc; its object is filled in.
function Object:grab(desc)
    local out = ffi.new "dm_drag[1]"
    sized(desc, "dm_drag_desc").object = self.handle
    check(C.dm_drag_begin(self.context.pointer, desc, out))
    local drag = Drag.make(self.context, out[0], self)
    drag.state = M.new "dm_drag_state" -- one for all frames
    return drag
end

function Object:motion(desc)
    local out = ffi.new "dm_motion[1]"
    check(C.dm_motion_generate(self.context.pointer, self.handle, sized(desc, "dm_motion_desc"), out))
    return Motion.make(self.context, out[0], self)
end

--- The pose at t, 0 to 1, and the joint value.
function Motion:sample(t)
    local pose, value = ffi.new "dm_pose", ffi.new "float[1]"
    check(C.dm_motion_sample(self.context.pointer, self.handle, t, pose, value))
    return pose, value[0]
end

-- Drags -------------------------------------------------------------------------------------------------------------

--- Follows a dm_ray, or with nil goes on after a release. Returns the drag's dm_drag_state, the same one every frame.
function Drag:update(ray, seconds)
    self.state.struct_size = ffi.sizeof "dm_drag_state"
    check(C.dm_drag_update(self.context.pointer, self.handle, ray, seconds, self.state))
    return self.state
end

--- The same for all that a dm_drag_input holds.
function Drag:update_input(input, seconds)
    self.state.struct_size = ffi.sizeof "dm_drag_state"
    check(C.dm_drag_update_input(self.context.pointer, self.handle, sized(input, "dm_drag_input"), seconds, self.state))
    return self.state
end

--- After an update_input with DM_INPUT_ASK: takes another value.
function Drag:override(value)
    self.state.struct_size = ffi.sizeof "dm_drag_state"
    check(C.dm_drag_override(self.context.pointer, self.handle, value, self.state))
    return self.state
end

Drag.step, Drag.take = Drag.update_input, Drag.override -- their names in 0.2

--- Lets go. desc: a dm_release_desc; nil = all defaults. Returns the dm_release_plan.
function Drag:release(desc)
    local plan = M.new "dm_release_plan"
    if desc ~= nil then sized(desc, "dm_release_desc") end
    check(C.dm_drag_release(self.context.pointer, self.handle, desc, plan))
    return plan
end

--- What the instance keeps: a dm_part_state.
function Drag:part_state()
    local out = M.new "dm_part_state"
    check(C.dm_drag_get_part_state(self.context.pointer, self.handle, out))
    return out
end

--- Ends it and returns what the instance keeps.
function Drag:finish()
    local out = M.new "dm_part_state"
    check(C.dm_drag_end(self.context.pointer, self.handle, out))
    self.handle = ffi.cast("uint64_t", 0)
    return out
end

--- The whole state, a string, for rollback.
function Drag:save()
    local size = C.dm_drag_snapshot_size()
    local data = ffi.new("uint8_t[?]", size)
    check(C.dm_drag_save(self.context.pointer, self.handle, data, size))
    return ffi.string(data, size)
end

function Drag:restore(data)
    check(C.dm_drag_restore(self.context.pointer, self.handle, bytes(data, "data"), #data))
end

-- Scenes ------------------------------------------------------------------------------------------------------------

--- Places an object and returns its instance. placement: a dm_pose; nil = identity.
function Scene:add(object, placement)
    local out = ffi.new "uint32_t[1]"
    check(C.dm_scene_add(self.context.pointer, self.handle, object.handle, placement, out))
    self.kept[out[0]] = object
    return out[0]
end

--- Moves a part, or with part 0 the instance.
function Scene:move(instance, part, pose)
    check(C.dm_scene_move(self.context.pointer, self.handle, whole(instance, "instance"), whole(part, "part"), pose))
end

function Scene:remove(instance)
    check(C.dm_scene_remove(self.context.pointer, self.handle, whole(instance, "instance")))
    self.kept[instance] = nil
end

function Scene:commit() check(C.dm_scene_commit(self.context.pointer, self.handle)) end

--- The nearest hit, a dm_hit; nil when nothing is hit.
function Scene:pick(ray)
    local hit = M.new "dm_hit"
    check(C.dm_scene_pick(self.context.pointer, self.handle, ray, hit))
    if hit.object == 0 then return nil end
    return hit
end

-- Files -------------------------------------------------------------------------------------------------------------

local Gltf = {}
Gltf.__index = Gltf
local G
local files = setmetatable({}, { __mode = "k" }) -- of arrays that a file owns: it lives as long as they do

--- Opens a .glb or .gltf with the files beside it.
function M.gltf(path)
    if bytes(path, "path"):find("\0", 1, true) then error("the path has a zero in it", 2) end
    G = G or ffi.load(M.gltf_path)
    local out = ffi.new "dm_gltf*[1]"
    check(G.dm_gltf_open_file(path, M.new "dm_gltf_desc", out))
    return setmetatable({ pointer = ffi.gc(out[0], G.dm_gltf_close) }, Gltf)
end

--- All nodes with a mesh: an array of tables of name, first_face, face_count, from 1 on. Part id of a prepared file: the index
-- here.
function Gltf:nodes()
    local nodes, row = {}, ffi.new "dm_gltf_node"
    for i = 0, G.dm_gltf_node_count(self.pointer) - 1 do
        check(G.dm_gltf_get_node(self.pointer, i, row))
        nodes[i + 1] = { name = ffi.string(row.name), node = row.node, first_face = tonumber(row.first_face), face_count = tonumber(row.face_count) }
    end
    return nodes
end

--- The merged mesh: a float* of positions, a uint32_t* of indices, and how many indices. The file lives as long as one of
-- the two, not of what is computed from them.
function Gltf:mesh()
    local mesh = M.new "dm_mesh_desc"
    check(G.dm_gltf_get_mesh(self.pointer, mesh))
    local positions, indices = ffi.cast("const float*", mesh.positions), ffi.cast("const uint32_t*", mesh.indices)
    files[positions], files[indices] = self, self
    return positions, indices, tonumber(mesh.index_count)
end

-- Poses -------------------------------------------------------------------------------------------------------------

--- A point moved by a pose: x, y, z.
function M.apply(pose, x, y, z)
    local p = ffi.new("float[3]", x, y, z)
    C.dm_pose_apply_points(pose, p, 0, p, 0, 1)
    return p[0], p[1], p[2]
end

--- A pose as 16 numbers, column by column.
function M.matrix(pose)
    local m = ffi.new "float[16]"
    C.dm_pose_to_matrix(pose, m)
    return m
end

--- a after b.
function M.multiply(a, b)
    local out = ffi.new "dm_pose"
    C.dm_pose_multiply(a, b, out)
    return out
end

--- The motion back.
function M.inverse(pose)
    local out = ffi.new "dm_pose"
    C.dm_pose_inverse(pose, out)
    return out
end

--- A rotation about an axis of length 1, then a translation.
function M.pose(axis, angle, x, y, z)
    local s, w, out = math.sin(angle / 2), math.cos(angle / 2), ffi.new "dm_pose"
    local rotation = ffi.new("float[4]", axis[1] * s, axis[2] * s, axis[3] * s, w)
    check(C.dm_pose_from_rotation(rotation, ffi.new("dm_vec3", x, y, z), out))
    return out
end

--- The pose of a joint at a value, and the value at a share of its way.
function M.joint_pose(joint, value)
    local out = ffi.new "dm_pose"
    check(C.dm_joint_pose(sized(joint, "dm_joint"), value, out))
    return out
end

function M.joint_value_at(joint, share)
    local out = ffi.new "float[1]"
    check(C.dm_joint_value_at(sized(joint, "dm_joint"), share, out))
    return out[0]
end

return M

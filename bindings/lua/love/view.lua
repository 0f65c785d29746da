-- Draws the room: camera, shader, walls.
local ffi = require "ffi"
local dragmesh = require "dragmesh"

local FIELD_OF_VIEW, NEAR, FAR = 0.9, 0.05, 30 -- rad, m
local IDENTITY = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }

local View = {}
View.__index = View

local SHADER = [[
varying vec3 seen_normal, seen_point;
#ifdef VERTEX
attribute vec3 VertexNormal;
uniform mat4 model, camera;
uniform float size;
vec4 position(mat4 unused, vec4 vertex) {
    vec4 world = model * vec4(size * vertex.xyz, 1.0);
    seen_normal = mat3(model) * VertexNormal;
    seen_point = world.xyz;
    return camera * world;
}
#endif
#ifdef PIXEL
uniform vec3 eye;
uniform float glow;
vec4 effect(vec4 colour, Image unused, vec2 at, vec2 pixel) {
    vec3 n = normalize(seen_normal), to_eye = normalize(eye - seen_point);
    n *= sign(dot(n, to_eye)); // walls of generated props are thin
    vec3 lamp = vec3(0.3, 2.5, 0.6) - seen_point;
    float light = max(dot(n, normalize(lamp)), 0.0) / (0.45 + 0.09 * dot(lamp, lamp));
    float sky = 0.5 + 0.5 * n.y;
    vec3 seen = colour.rgb * (0.42 + 0.18 * sky + 0.5 * light) + glow * vec3(0.16, 0.13, 0.04);
    return vec4(seen, 1.0);
}
#endif
]]

local FORMAT = { { "VertexPosition", "float", 3 }, { "VertexNormal", "float", 3 }, { "VertexColor", "byte", 4 } }

-- Floor, ceiling and three walls, in planks and plain.
local function make_walls(size)
    local vertices, x, y, z = {}, size[1] / 2, size[2], size[3] / 2
    local function quad(a, b, c, d, n, colour)
        for _, p in ipairs { a, b, c, a, c, d } do
            vertices[#vertices + 1] = { p[1], p[2], p[3], n[1], n[2], n[3], colour[1], colour[2], colour[3], 1 }
        end
    end
    local planks = 14
    for i = 0, planks - 1 do
        local from, to = -x + 2 * x * i / planks, -x + 2 * x * (i + 1) / planks
        local shade = 0.9 + 0.1 * ((i * 7) % 5) / 4
        quad({ from, 0, -z }, { to, 0, -z }, { to, 0, z + 2 }, { from, 0, z + 2 }, { 0, 1, 0 }, { 0.62 * shade, 0.45 * shade, 0.3 * shade })
    end
    local wall, skirting = { 0.80, 0.82, 0.78 }, { 0.93, 0.92, 0.88 }
    quad({ -x, 0, -z }, { x, 0, -z }, { x, y, -z }, { -x, y, -z }, { 0, 0, 1 }, wall)
    quad({ -x, 0, -z }, { -x, y, -z }, { -x, y, z + 2 }, { -x, 0, z + 2 }, { 1, 0, 0 }, wall)
    quad({ x, 0, -z }, { x, y, -z }, { x, y, z + 2 }, { x, 0, z + 2 }, { -1, 0, 0 }, wall)
    quad({ -x, y, -z }, { x, y, -z }, { x, y, z + 2 }, { -x, y, z + 2 }, { 0, -1, 0 }, skirting)
    quad({ -x, 0, -z + 0.01 }, { x, 0, -z + 0.01 }, { x, 0.09, -z + 0.01 }, { -x, 0.09, -z + 0.01 }, { 0, 0, 1 }, skirting)
    return love.graphics.newMesh(FORMAT, vertices, "triangles", "static")
end

function View.new(room)
    return setmetatable({ eye = { unpack(room.eye) }, yaw = 0, pitch = -0.16, shader = love.graphics.newShader(SHADER),
        walls = make_walls(room.size) }, View)
end

function View:forward()
    return math.sin(self.yaw) * math.cos(self.pitch), math.sin(self.pitch), -math.cos(self.yaw) * math.cos(self.pitch)
end

--- The camera as the library takes it.
function View:camera()
    local width, height = love.graphics.getDimensions()
    return dragmesh.new("dm_camera", { fov_y = FIELD_OF_VIEW, eye = self.eye, forward = { self:forward() }, up = { 0, 1, 0 },
        viewport_width = width, viewport_height = height })
end

-- Projection times view, column by column.
function View:matrix()
    local width, height = love.graphics.getDimensions()
    local fx, fy, fz = self:forward()
    local rx, rz = math.cos(self.yaw), math.sin(self.yaw)
    local ux, uy, uz = -rz * fy, rz * fx - rx * fz, rx * fy
    local f = 1 / math.tan(FIELD_OF_VIEW / 2)
    local a, e = f * height / width, self.eye
    local depth, shift = (FAR + NEAR) / (FAR - NEAR), 2 * FAR * NEAR / (FAR - NEAR)
    local rt, ut, ft = -(rx * e[1] + rz * e[3]), -(ux * e[1] + uy * e[2] + uz * e[3]), -(fx * e[1] + fy * e[2] + fz * e[3])
    return { a * rx, f * ux, depth * fx, fx, 0, f * uy, depth * fy, fy, a * rz, f * uz, depth * fz, fz,
        a * rt, f * ut, depth * ft - shift, ft }
end

--- Where a point of the world is on the screen.
function View:project(x, y, z)
    local m = self:matrix()
    local w = m[4] * x + m[8] * y + m[12] * z + m[16]
    local width, height = love.graphics.getDimensions()
    return width / 2 * (1 + (m[1] * x + m[5] * y + m[9] * z + m[13]) / w),
        height / 2 * (1 - (m[2] * x + m[6] * y + m[10] * z + m[14]) / w)
end

local function columns(pose)
    local m, out = dragmesh.matrix(pose), {}
    for i = 0, 15 do out[i + 1] = m[i] end
    return out
end

--- Draws all props; glowing: a part that is drawn brighter.
function View:draw(props, glowing)
    love.graphics.clear(0.1, 0.1, 0.12, 1, true, 1)
    love.graphics.setShader(self.shader)
    love.graphics.setDepthMode("lequal", true)
    self.shader:send("camera", "column", self:matrix())
    self.shader:send("eye", self.eye)
    self.shader:send("model", "column", IDENTITY)
    self.shader:send("size", 1)
    self.shader:send("glow", 0)
    love.graphics.draw(self.walls)
    for _, prop in ipairs(props) do
        self.shader:send("size", prop.scale)
        for _, piece in ipairs(prop.pieces) do
            local scaled = ffi.new("dm_pose", prop.pose_of(piece.part))
            for k = 0, 3 do scaled.dual[k] = scaled.dual[k] * prop.scale end -- the translation, in metres of the room
            self.shader:send("model", "column", columns(dragmesh.multiply(prop.placement, scaled)))
            self.shader:send("glow", piece.part ~= nil and piece.part == glowing and 1 or 0)
            love.graphics.draw(piece.mesh)
        end
    end
    love.graphics.setDepthMode()
    love.graphics.setShader()
end

return View

-- A room of props whose doors, drawers and lids the mouse drags. `love FOLDER` plays it; `love FOLDER --play PICTURE` lets a
-- scripted hand play it and writes a picture. README.md says how FOLDER is made.
local here = love.filesystem.getSource()
package.path = here .. "/?.lua;" .. package.path
local dragmesh = require "dragmesh"
dragmesh.load(here .. "/libdragmesh.so", here .. "/dragmesh_ffi.h", here .. "/libdragmesh_gltf.so")
local bit = require "bit"
local Prop, View, room, play, sound = require "props", require "view", require "room", require "play", require "sounds"

local EVENTS = { "LIMIT_LOWER", "LIMIT_UPPER", "OPENED", "CLOSED", "DETENT", "LATCHED", "UNLATCHED", "LOCKED" }
local SHOWN_SECONDS, WALK, LOOK = 4, 1.5, 0.004 -- s, m/s, rad a pixel
local PLAYED_AT_ONCE = 60 -- frames of the scripted hand for one that is drawn
local KEY_TURN = 1 -- rad: what the key E turns the handles by

local game = { props = {}, said = {}, heard = {} }

function game.hear(part, state)
    for _, name in ipairs(EVENTS) do
        if bit.band(state.events, dragmesh.C["DM_EVENT_" .. name]) ~= 0 then
            table.insert(game.said, 1, { text = ("%s %s: %s"):format(part.prop.name, part.name, name:lower():gsub("_", " ")),
                left = SHOWN_SECONDS })
            game.heard[name] = (game.heard[name] or 0) + 1
            sound(name)
        end
    end
end

function game.ray(x, y) return game.context:camera_ray(game.view:camera(), x, y) end

--- The nearest part along a ray: prop, part, hit.
function game.pick(ray)
    local best, nearest = {}, math.huge
    for _, prop in ipairs(game.props) do
        local hit, distance = prop:pick(ray)
        if hit and distance < nearest then
            nearest, best = distance, { prop, prop.parts[hit.part_id], hit }
        end
    end
    return unpack(best, 1, 3)
end

function game.press(x, y)
    local prop, part, hit = game.pick(game.ray(x, y))
    if not part then return end
    prop:grab(part, hit)
    game.held = part
end

function game.letgo()
    if game.held and game.held.drag then game.held.prop:release(game.held) end
    game.held = nil
end

--- A wheel moves the part under the pointer by a share of its range.
function game.wheel(x, y, amount)
    local prop, part = game.pick(game.ray(x, y))
    if not part or part.held then return end
    prop:grab(part, nil)
    part.input.hand.kind, part.input.hand.amount = dragmesh.C.DM_HAND_STEP, amount
    part.drag:update_input(part.input, 0)
    prop:release(part)
end

function game.step(dt, x, y)
    local ray = game.ray(x, y)
    local turn = love.keyboard.isDown "e" and KEY_TURN or 0
    for _, prop in ipairs(game.props) do
        prop.key_turn = turn
        for _, part in pairs(prop.parts) do prop:update(part, ray, dt, game.hear) end
    end
    local _, part = game.pick(ray)
    game.pointed = game.held or part
    for i = #game.said, 1, -1 do
        game.said[i].left = game.said[i].left - dt
        if game.said[i].left < 0 then table.remove(game.said, i) end
    end
end

local function walk(dt)
    local v, e = game.view, game.view.eye
    local ahead = (love.keyboard.isDown "w" and 1 or 0) - (love.keyboard.isDown "s" and 1 or 0)
    local aside = (love.keyboard.isDown "d" and 1 or 0) - (love.keyboard.isDown "a" and 1 or 0)
    e[1] = math.max(-3.2, math.min(3.2, e[1] + WALK * dt * (ahead * math.sin(v.yaw) + aside * math.cos(v.yaw))))
    e[3] = math.max(-1.8, math.min(4.2, e[3] + WALK * dt * (-ahead * math.cos(v.yaw) + aside * math.sin(v.yaw))))
end

-- Without a player, an error ends the program.
local function fail(message)
    io.stderr:write(debug.traceback(message), "\n")
    os.exit(1)
end

function love.load(arguments)
    if arguments[1] == "--play" then love.errorhandler = fail end
    game.context = dragmesh.context()
    for _, row in ipairs(room.props) do game.props[#game.props + 1] = Prop.load(game.context, row) end
    game.view = View.new(room)
    if arguments[1] == "--play" then game.script = play(game, assert(arguments[2], "--play PICTURE")) end
end

function love.update(dt)
    if game.script then
        for _ = 1, PLAYED_AT_ONCE do
            local fine, message = coroutine.resume(game.script)
            if not fine then fail(message) end
        end
        return
    end
    walk(dt)
    game.step(math.min(dt, 0.1), love.mouse.getPosition())
end

function love.mousepressed(x, y, button)
    if button == 1 then game.press(x, y) end
end

function love.mousereleased(_, _, button)
    if button == 1 then game.letgo() end
end

function love.mousemoved(_, _, dx, dy)
    if not love.mouse.isDown(2) then return end
    game.view.yaw = game.view.yaw + LOOK * dx
    game.view.pitch = math.max(-1.2, math.min(1.2, game.view.pitch - LOOK * dy))
end

function love.wheelmoved(_, amount)
    local x, y = love.mouse.getPosition()
    game.wheel(x, y, 0.1 * amount)
end

function love.draw()
    game.view:draw(game.props, game.pointed)
    love.graphics.setColor(1, 1, 1)
    love.graphics.print("drag with the left button, look with the right one, walk with W A S D, E turns handles, wheel moves", 12, 10)
    for i, said in ipairs(game.said) do
        love.graphics.setColor(1, 1, 1, math.min(1, said.left))
        love.graphics.print(said.text, 12, 14 + 18 * i)
    end
    love.graphics.setColor(1, 1, 1)
    if game.pointed then
        local x, y = love.mouse.getPosition()
        if game.script then x, y = game.x or 0, game.y or 0 end
        love.graphics.print(game.pointed.prop.name .. ": " .. game.pointed.name, x + 14, y - 6)
    end
    if game.picture then
        local path = game.picture
        game.picture = nil
        love.graphics.captureScreenshot(function(image)
            local part = path .. ".part" -- renamed when it is whole
            local file = assert(io.open(part, "wb"))
            local wrote, problem = file:write(image:encode("png"):getString())
            if wrote then wrote, problem = file:close() end
            if wrote then wrote, problem = os.rename(part, path) end
            if not wrote then os.remove(part) end
            assert(wrote, problem)
            love.event.quit()
        end)
    end
end

-- A hand that plays the room by itself: it pulls parts open on the screen, as a player does.
local dragmesh = require "dragmesh"

local FRAME, FRAMES = 1 / 60, 50

return function(game, picture)
    -- Where a point of a part is on the screen, with the part at a share of its way.
    local function seen(part, point, share)
        local prop = part.prop
        local joint = prop.object:joint(part.id)
        local pose = dragmesh.joint_pose(joint, dragmesh.joint_value_at(joint, share))
        local x, y, z = dragmesh.apply(pose, unpack(point))
        if part.carrier then x, y, z = dragmesh.apply(prop.pose_of(part.carrier), x, y, z) end
        return game.view:project(dragmesh.apply(prop.placement, x * prop.scale, y * prop.scale, z * prop.scale))
    end

    local function frame(x, y)
        game.x, game.y = x, y
        game.step(FRAME, x, y)
        coroutine.yield()
    end

    -- A point of the part that the camera sees: the middle of its box, or near it.
    local function find(part)
        local info
        for i = 0, part.prop.object:info().part_count - 1 do
            info = part.prop.object:part(i)
            if info.id == part.id then break end
        end
        local low, high = info.box_min, info.box_max
        for _, u in ipairs { 0.5, 0.85, 0.15, 0.7, 0.3 } do
            for _, v in ipairs { 0.5, 0.8, 0.2 } do
                local point = { low.x + u * (high.x - low.x), low.y + v * (high.y - low.y), high.z }
                local x, y = seen(part, point, 0)
                local _, hit_part, hit = game.pick(game.ray(x, y))
                if hit_part == part then
                    local p = hit.object_point
                    return { p.x, p.y, p.z }, x, y
                end
            end
        end
        error("the hand does not see " .. part.prop.name .. " " .. part.name)
    end

    local function pull(prop_name, part_name, share, keep)
        local part
        for _, prop in ipairs(game.props) do
            if prop.name == prop_name then part = prop.by_name[part_name] end
        end
        local point, x, y = find(part)
        game.press(x, y)
        assert(game.held == part, "another part was grabbed")
        for i = 1, FRAMES do frame(seen(part, point, share * i / FRAMES)) end
        if keep then return part end
        game.letgo()
        for _ = 1, FRAMES do frame(game.x, game.y) end
        return part
    end

    return coroutine.create(function()
        local locked = pull("safe", "door", 0.5) -- the lever has not turned
        assert(locked.value < 0.05 and game.heard.LOCKED, "the latch did not hold")
        -- The lever is held by one hand, the door pulled by the other.
        local lever = pull("safe", "lever", 0.9, true)
        game.held = nil
        local hand = lever.held
        lever.held = false -- stays where it is while nobody moves it
        local door = pull("safe", "door", 0.6)
        assert(hand and door.value > 0.3 and game.heard.UNLATCHED, "the lever did not open the latch")
        pull("refrigerator", "door", 0.6)
        pull("refrigerator", "freezer_door", 0.35)
        pull("kitchen_cabinet", "drawer_right", 0.8)
        pull("kitchen_cabinet", "door_left", 0.55)
        pull("microwave", "door", 0.55)
        pull("chest", "lid", 0.75)
        pull("slab_cabinet", "door", 0.6)
        pull("door", "handle", 0.9, true)
        game.held = nil
        local leaf = pull("door", "door", 0.6, true)
        assert(leaf.value > 0.3, "the handle did not open the door")
        assert(game.heard.OPENED >= 8, "fewer parts were opened than pulled")
        print(("played: %d parts opened, %d latches freed, %d tried while latched"):format(game.heard.OPENED,
            game.heard.UNLATCHED, game.heard.LOCKED))
        game.picture = picture
        while true do frame(game.x, game.y) end
    end)
end

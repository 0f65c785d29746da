-- The props of the room: where each stands, and how its parts behave. Metres, y up; height: it is scaled to that. rules: of
-- dm_drag_rules, feel: of dm_drag_feel. latch: the part whose value opens a part's latch. on: the part that carries it.
-- paint: of the body, of parts by name, and of the other parts.
local deg = math.pi / 180
local oak, walnut, enamel, cream = { 0.66, 0.47, 0.29 }, { 0.42, 0.27, 0.17 }, { 0.9, 0.92, 0.93 }, { 0.9, 0.87, 0.78 }
local sage, steel, brass, iron, sea = { 0.5, 0.6, 0.52 }, { 0.62, 0.65, 0.68 }, { 0.78, 0.62, 0.3 }, { 0.3, 0.33, 0.37 },
    { 0.25, 0.45, 0.6 }
local plaster, dark = { 0.8, 0.82, 0.78 }, { 0.22, 0.23, 0.25 }

return {
    size = { 7, 2.7, 5 }, -- x from -3.5 to 3.5, z from -2.5 to 2.5
    eye = { 0, 1.65, 3.6 },
    props = {
        { name = "door", height = 2.3, at = { 2.2, 0, -2.41 }, paint = { body = plaster, parts = oak, handle = brass }, parts = {
            door = { latch = "handle", rules = { auto_close_share = 0.12 } },
            handle = { on = "door", feel = { return_time = 0.15 } },
        } },
        { name = "refrigerator", height = 1.8, at = { -2.9, 0, -2.05 }, paint = { body = enamel, parts = enamel, crisper = sea, crisper_2 = sea }, parts = {
            door = { rules = { auto_close_share = 0.2, restitution = 0.1 } },
            freezer_door = { rules = { auto_close_share = 0.2 } },
        } },
        { name = "kitchen_cabinet", height = 0.92, at = { -1.55, 0, -2.1 }, paint = { body = cream, parts = sage } },
        { name = "microwave", height = 0.34, at = { -1.55, 0.92, -2.15 }, paint = { body = steel, parts = dark, turntable = enamel }, parts = {
            door = { rules = { auto_close_share = 0.25 } },
        } },
        { name = "safe", height = 0.7, at = { -0.1, 0, -2.0 }, paint = { body = iron, door = { 0.36, 0.4, 0.46 }, parts = steel }, parts = {
            door = { latch = "lever", feel = { coast_time = 0.5 } },
            lever = { on = "door", feel = { return_time = 0.4 } },
        } },
        { name = "chest", height = 0.55, at = { 0.75, 0, -1.2 }, turn = -25 * deg, paint = { body = walnut, parts = { 0.55, 0.33, 0.18 } }, parts = {
            lid = { rules = { tip_share = 0.55, fall_time = 0.6, restitution = 0.25 } },
        } },
        { name = "slab_cabinet", height = 1.5, at = { -3.0, 0, -0.2 }, turn = 60 * deg, paint = { body = walnut, parts = { 0.5, 0.33, 0.2 } } },
        { name = "globe", height = 0.8, at = { 2.7, 0, -0.6 }, paint = { body = brass, parts = sea }, parts = { globe = { feel = { coast_time = 1.2 } } } },
    },
}

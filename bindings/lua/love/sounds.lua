-- Short sounds, made from numbers: no files.
local RATE = 22050

-- A knock: noise through a decaying tone. pitch: Hz; length: s.
local function knock(pitch, length)
    local count = math.floor(RATE * length)
    local data = love.sound.newSoundData(count, RATE, 16, 1)
    for i = 0, count - 1 do
        local t = i / RATE
        local fade = math.exp(-8 * t / length)
        data:setSample(i, fade * (0.6 * math.sin(2 * math.pi * pitch * t) + 0.4 * (math.random() - 0.5)))
    end
    return love.audio.newSource(data)
end

local sounds = { LIMIT_LOWER = { 140, 0.18 }, LIMIT_UPPER = { 110, 0.2 }, CLOSED = { 160, 0.15 }, LATCHED = { 900, 0.06 },
    UNLATCHED = { 1200, 0.06 }, LOCKED = { 420, 0.09 }, DETENT = { 1800, 0.03 } }
local made = {}

--- Plays the sound of an event, where it has one.
return function(name)
    if not sounds[name] or not love.audio then return end
    made[name] = made[name] or knock(unpack(sounds[name]))
    made[name]:stop()
    made[name]:play()
end

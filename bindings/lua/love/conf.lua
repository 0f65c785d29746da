function love.conf(t)
    t.identity, t.version = "dragmesh", "11.4"
    t.window.title, t.window.width, t.window.height = "dragmesh", 1280, 720
    t.window.depth, t.window.msaa, t.window.resizable = 24, 4, true
    t.modules.physics, t.modules.joystick, t.modules.video = false, false, false
end

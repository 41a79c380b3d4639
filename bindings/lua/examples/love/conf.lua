function love.conf(settings)
    settings.window.title = "thud"
    settings.window.width, settings.window.height = 960, 640
    settings.modules.physics = false -- that is Box2D
end

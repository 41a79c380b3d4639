--- falling.lua: a game loop without a window: a ball falls onto hills, in pictures that come at uneven
-- times. Each picture shows where the ball is between the last two steps.
local thud = require("thud")

local world = assert(thud.world())
local points = {}
for x = -20, 20 do
    points[#points + 1] = { x, math.sin(0.5 * x) }
end
local ground = assert(world:create_body())
assert(ground:create_terrain({ kind = "irregular", points = points }))
local ball = assert(world:create_body({ kind = "dynamic", position = { 0.5, 6 } }))
assert(ball:create_circle({ 0, 0 }, 0.5, { restitution = 0.6 }))

-- From 144 pictures a second down to 20, as on a display that cannot keep up.
local lengths = { 1 / 144, 1 / 60, 1 / 30, 1 / 20 }
local time = 0
for number = 0, 79 do
    local seconds = lengths[number % 4 + 1]
    time = time + seconds
    local _, alpha = assert(world:advance(seconds))
    local events = world:events()
    for i = 0, events.hit_count - 1 do
        print(("         hit at %.1f lengths a second"):format(events.hit[i].speed))
    end
    local pose = world:poses(alpha)[ball:slot()]
    print(("%5.3f s  x %.2f  y %.2f"):format(time, pose.x, pose.y))
end

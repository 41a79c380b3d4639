--- Boxes and balls in a window of LÖVE: a click drops one, Escape ends.
--
--     THUD_LIBRARY=./libthud.so love bindings/lua/examples/love [PICTURES]
--
-- With a number it ends after so many pictures.
package.path = love.filesystem.getSource() .. "/../../?.lua;" .. package.path
local thud = require("thud")

local PIXELS = 32 -- of a length
local world, hills
local things = {} -- body, and a radius or half extents
local pictures, last = 0, nil

local function drop(x, y)
    local body = assert(world:create_body({ kind = "dynamic", position = { x, y } }))
    if #things % 2 == 0 then
        assert(body:create_circle({ 0, 0 }, 0.5, { restitution = 0.4 }))
        things[#things + 1] = { body = body, radius = 0.5 }
    else
        assert(body:create_obb({ 0, 0 }, { 0.7, 0.4 }, 0))
        things[#things + 1] = { body = body, half_x = 0.7, half_y = 0.4 }
    end
end

function love.load(arguments)
    last = tonumber(arguments[1])
    world = assert(thud.world())
    hills = {}
    for x = 0, love.graphics.getWidth() / PIXELS do
        hills[#hills + 1] = { x, 1.2 + math.sin(0.5 * x) }
    end
    assert(assert(world:create_body()):create_terrain({ kind = "irregular", points = hills }))
    for number = 0, 23 do
        drop(5 + number % 8 * 2.5, 8 + math.floor(number / 8) * 2)
    end
end

function love.keypressed(key)
    if key == "escape" then
        love.event.quit()
    end
end

function love.mousepressed(x, y)
    drop(x / PIXELS, (love.graphics.getHeight() - y) / PIXELS)
end

local alpha = 1

function love.update(seconds)
    local _
    _, alpha = assert(world:advance(seconds))
    pictures = pictures + 1
    if pictures == last then
        local y = world:poses()[things[1].body:slot()].y
        print(("%d pictures; the first ball is at a height of %.2f"):format(pictures, y))
        love.event.quit()
    end
end

function love.draw()
    local graphics = love.graphics
    graphics.translate(0, graphics.getHeight())
    graphics.scale(PIXELS, -PIXELS)
    graphics.setLineWidth(2 / PIXELS)
    graphics.setColor(0.43, 0.47, 0.43)
    for i = 2, #hills do
        graphics.line(hills[i - 1][1], hills[i - 1][2], hills[i][1], hills[i][2])
    end
    local poses = world:poses(alpha)
    for _, thing in ipairs(things) do
        local pose = poses[thing.body:slot()]
        if thing.radius then
            graphics.setColor(0.94, 0.63, 0.24)
            graphics.circle("fill", pose.x, pose.y, thing.radius)
        else
            graphics.push()
            graphics.translate(pose.x, pose.y)
            graphics.rotate(math.atan2(pose.s, pose.c))
            graphics.setColor(0.35, 0.63, 0.9)
            graphics.rectangle("fill", -thing.half_x, -thing.half_y, 2 * thing.half_x, 2 * thing.half_y)
            graphics.pop()
        end
    end
end

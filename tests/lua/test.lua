--- test.lua: what thud.lua adds to the engine: options, errors, views, owners and callbacks, and the
-- golden hashes of scenes that are built with it.
--
-- usage: luajit test.lua GOLDEN_HASHES
local ffi = require("ffi")
local thud = require("thud")

local function equal(is, wanted)
    if is ~= wanted then
        error(("%s is not %s"):format(tostring(is), tostring(wanted)), 2)
    end
end

local function raises(words, fn, ...)
    local done, reason = pcall(fn, ...)
    assert(not done, "no error")
    assert(tostring(reason):find(words, 1, true), reason)
end

local function dynamic(world, x, y)
    return assert(world:create_body({ kind = "dynamic", position = { x, y } }))
end

local function falling(options)
    local world = assert(thud.world(options))
    assert(assert(world:create_body()):create_terrain({ kind = "flat" }))
    local ball = dynamic(world, 0, 5)
    assert(ball:create_circle({ 0, 0 }, 0.5))
    return world, ball
end

local scenes, tests = {}, {}

function scenes.tall_stack()
    local world = assert(thud.world())
    assert(assert(world:create_body({ position = { 0, -1 } })):create_aabb({ 0, 0 }, { 20, 1 }))
    for row = 0, 29 do
        assert(dynamic(world, 0, row + 0.5):create_obb({ 0, 0 }, { 0.5, 0.5 }, 0))
    end
    return world
end

function scenes.heavy_on_light()
    local world = assert(thud.world())
    assert(assert(world:create_body({ position = { 0, -1 } })):create_aabb({ 0, 0 }, { 24, 1 }))
    for group, below in ipairs({ 1, 10 }) do
        for power = 0, 4 do
            for row = 0, below do
                local body = dynamic(world, (power + 0.5 + (group - 1) * 5 - 5) * 4, row + 0.5)
                local density = row == below and 10 ^ (power + 1) or 1
                assert(body:create_obb({ 0, 0 }, { 0.5, 0.5 }, 0, { density = density }))
            end
        end
    end
    return world
end

function scenes.cradle()
    local world = assert(thud.world({ gravity = { 0, 0 } }))
    local bouncy = { friction = 0, restitution = 1 }
    for _, x in ipairs({ -15.5, 15.5 }) do
        assert(assert(world:create_body({ position = { x, 0 } })):create_aabb({ 0, 0 }, { 1, 8 }, bouncy))
    end
    for row = 1, 3 do
        for i = 0, 4 do
            local flies = i < row
            local body = assert(world:create_body({
                kind = "dynamic",
                position = { i - 2 - (flies and 6 or 0), 4 * (2 - row) },
                velocity = { flies and 5 or 0, 0 },
                may_sleep = false,
            }))
            assert(body:create_circle({ 0, 0 }, 0.5, bouncy))
        end
    end
    return world
end

function tests.golden_hashes_are_those_of_c()
    local rows = {}
    for line in io.lines(arg[1]) do
        local name, hash = line:match("^(%S+) +(%x+)$")
        rows[name] = hash
    end
    for name, make in pairs(scenes) do
        local world = make()
        assert(world:step(120))
        equal(bit.tohex(world:hash(), 16), rows[name])
    end
end

function tests.refused_calls_return_nil_and_the_message_and_change_nothing()
    local world, ball = falling()
    local before = world:snapshot()
    local made, reason = ball:create_circle({ 0, 0 }, 0.5, { friction = -1 })
    equal(made, nil)
    assert(reason:find("friction is -1, not in [0, 1000000]", 1, true), reason)
    made, reason = ball:set_velocity({ 0 / 0, 0 }, 0)
    assert(made == nil and reason:find("velocity"), reason)
    equal(world:snapshot(), before)
    made, reason = thud.world({ time_step = 2 })
    assert(made == nil and reason:find("time_step is 2"), reason)
    made, reason = thud.geometry_check({ kind = "circle", hx = -1 })
    equal(made, nil)
    equal(reason, ffi.string(thud.C.thud_result_text("THUD_ERROR_INVALID")))
    equal(ball:destroy(), true)
    equal(ball:is_valid(), false)
    equal(ball:state(), nil)
end

function tests.wrong_options_are_errors_by_name()
    local world, ball = falling()
    raises("no field \"gravty\"", thud.world, { gravty = { 0, 0 } })
    raises("it has default, draft, exact, high", thud.world, { quality = "hihg" })
    raises("it has dynamic, kinematic, static", world.create_body, world, { kind = "dynamik" })
    raises("cannot convert", ball.set_awake, ball, {})
    raises("thud_drive", world.create_joint, world, { kind = "hinge", drive = { turn = { lowr = 1 } } })
    world:close()
    raises("it is closed", world.step, world)
    raises("it is closed", ball.position, ball)
    world:close()
end

function tests.objects_of_the_engine_are_words()
    local world = falling({ quality = "high", detection = "swept", broadphase = "sweep", sleeping = false })
    local plain = falling()
    assert(world:step() and plain:step())
    equal(world:stats().substeps, 8)
    equal(plain:stats().substeps, 4)
    assert(plain:set_quality("high") and plain:step())
    equal(plain:stats().substeps, 8)
end

function tests.poses_and_events_are_views()
    local world, ball = falling()
    local begun, speed = 0, 0
    for _ = 1, 120 do
        assert(world:step())
        local events = world:events()
        begun = begun + events.begin_count
        for i = 0, events.hit_count - 1 do
            speed = events.hit[i].speed
        end
    end
    equal(begun, 1)
    assert(math.abs(speed - 9.5) < 0.2)
    local poses, count = world:poses()
    equal(count, 2)
    assert(math.abs(poses[ball:slot()].y - ball:position().y) < 1e-6)
    equal(world:poses(), poses)
    assert(world:poses(1, { 0, 4 })[ball:slot()].y < poses[ball:slot()].y + 4)
    raises("constant", function()
        poses[0].x = 1
    end)
    local none, reason = world:poses(2)
    assert(none == nil and reason)
end

function tests.outputs_are_values_and_lists()
    local world, ball = falling()
    local sine, cosine = thud.sincos(0)
    assert(sine == 0 and cosine == 1)
    local bodies = world:bodies()
    equal(#bodies, 2)
    assert(bodies[2] == ball and bodies[1] ~= ball)
    local last
    for i = 1, 40 do
        last = dynamic(world, 10 * i, 1)
    end
    equal(#world:bodies(), 42)
    equal(world:bodies()[42], last)
    local hit = world:cast_ray({ origin = { 0, 10 }, dy = -20 })
    assert(math.abs(hit.point.y - 5.5) < 1e-6 and hit.normal.y == 1)
    equal(world:cast_ray({ origin = { 0, 10 }, dy = 1 }), false)
    local hits, count = world:cast_rays({ { origin = { 0, 10 }, dy = -20 }, { origin = { 0, 10 }, dy = 1 } })
    assert(count == nil and hits[0].shape.index1 ~= 0 and hits[1].shape.index1 == 0)
    local every, found = world:cast_ray_all({ origin = { 0, 10 }, dy = -20, filter = { mask = 0 } })
    assert(every and found == 0)
    equal(ball:shapes()[1]:body(), ball)
    equal(thud.geometry_cast_ray({ kind = "circle", hx = 1 }, { 9, 9, 1, 0 }), false)
    equal((thud.geometry_cast_ray({ kind = "circle", hx = 1 }, { 0, 3, 0, -4 })), 0.5)
end

function tests.snapshots_bring_back_the_bits()
    local world = falling()
    assert(world:step(30))
    local kept, hash = world:snapshot(), world:hash()
    assert(world:step(30) and world:hash() ~= hash)
    assert(world:restore(kept))
    equal(world:hash(), hash)
    local done, reason = world:restore(kept:sub(1, -2))
    assert(done == nil and reason)
end

function tests.joints_hold()
    local world = assert(thud.world())
    local post, door = world:create_body({ position = { 0, 5 } }), dynamic(world, 1, 5)
    assert(door:create_obb({ 0, 0 }, { 1, 0.1 }, 0))
    local def = world:hinge_at(post, door, { 0, 5 })
    def.drive[thud.enums.thud_direction.turn].limited = true
    local hinge = assert(world:create_joint(def))
    assert(world:step(60))
    local state = hinge:state()
    assert(state.gap < 0.01 and math.abs(state.value[2]) < 0.05)
    equal(world:joints()[1], hinge)
    local free = assert(world:create_joint({
        kind = "hinge", body_a = post, body_b = door, drive = { turn = { motor_speed = 2, motor_force = 3 } },
    }))
    equal(free:def().drive[2].motor_speed, 2)
end

function tests.callbacks_are_functions()
    local world, ball = falling()
    local counts = { prologue = 0, all = 0, epilogue = 0, before = 0 }
    assert(world:set_listeners({
        prologue = function(_, contact, settings)
            assert(contact.point_count > 0 and settings.friction > 0)
            counts.prologue = counts.prologue + 1
            return true
        end,
        epilogue_all = function(_, contacts, count)
            for i = 0, count - 1 do
                counts.all = counts.all + (contacts[i].normal_impulse >= 0 and 1 or 0)
            end
        end,
    }))
    local function touched()
        counts.epilogue = counts.epilogue + 1
    end
    assert(ball:set_epilogue(touched))
    for _ = 1, 90 do
        assert(world:advance_with(1 / 60, 1, {
            before = function()
                counts.before = counts.before + 1
            end,
        }))
    end
    equal(counts.before, 90)
    assert(counts.prologue > 10 and counts.all > 10 and counts.epilogue > 10)
    local before = counts.epilogue
    assert(ball:set_epilogue(nil) and world:step())
    equal(counts.epilogue, before)

    local met = {}
    assert(world:cast_ray_each({ origin = { 0, 9 }, dy = -20 }, function(hit)
        met[#met + 1] = hit.shape.index1
        return thud.constants.CAST_IGNORE
    end))
    equal(#met, 2)
    local at_most = 2000 -- more than LuaJIT has callbacks: each is given back
    for _ = 1, at_most do
        assert(world:cast_ray_each({ origin = { 0, 9 }, dy = -20 }, function()
            return thud.constants.CAST_END
        end))
        assert(ball:set_epilogue(touched))
    end
end

function tests.an_error_in_a_callback_is_raised_by_the_call()
    local world, ball = falling()
    assert(world:step(60))
    ball:set_epilogue(function()
        error("in an epilogue")
    end)
    raises("in an epilogue", world.step, world, 30)
    assert(ball:set_epilogue(nil) and world:step())
    raises("in a cast", world.cast_ray_each, world, { origin = { 0, 9 }, dy = -20 }, function()
        error("in a cast")
    end)
end

function tests.worlds_are_freed_after_what_uses_them()
    for _ = 1, 30 do
        local pool = assert(thud.threads(2))
        local world = falling({ threads = pool })
        local rollback = assert(world:create_rollback({
            players = 1, depth = 4,
            step = function(stepped)
                return thud.C.thud_world_step(stepped)
            end,
        }))
        assert(rollback:input(0, 0, 7))
        equal(rollback:advance(), true)
        equal(tonumber(rollback:progress().steps), 1)
        equal(tonumber(world:stats().steps), 1)
        pool, world, rollback = nil, nil, nil
        collectgarbage()
    end
    local world = falling()
    local rollback = world:create_rollback({ players = 1, depth = 4, step = function() end })
    world:close()
    raises("it is closed", world.step, world)
    equal(world.node.users, 1)
    equal(tonumber(rollback:progress().steps), 0) -- the world is there as long as it is used
    rollback:close()
    equal(world.node.users, 0)
    assert(thud.threads(-1) == nil)
end

local DOWN = { origin = { 0, 9 }, dy = -20 }

function tests.callbacks_that_return_nonsense_raise_and_leave_the_world_usable()
    local world = falling()
    for _, nonsense in ipairs({ "s", {}, true }) do
        raises("not a number", world.cast_ray_each, world, DOWN, function()
            return nonsense
        end)
        assert(world:step())
    end
    raises("returned a nil", world.cast_ray_each, world, DOWN, function() end)
    assert(world:cast_ray_each(DOWN, nil) == nil)
    raises("nil", world.cast_ray_each, world, DOWN, function()
        error(nil)
    end)
    assert(world:step())
end

function tests.a_world_is_not_closed_inside_its_callback()
    local world = falling()
    local closed, why
    assert(world:cast_ray_each(DOWN, function()
        closed, why = world:close()
        return 1
    end))
    assert(closed == nil and why:find("callback", 1, true), why)
    assert(world:step() and world:close())
end

function tests.callbacks_end_with_their_world_and_with_calls_that_fail()
    local kept = falling()
    for _ = 1, 1500 do
        local world, ball = falling()
        assert(ball:set_epilogue(function() end))
        world:close()
        raises("no field", kept.cast_ray_each, kept, { orgin = { 0, 1 } }, function() end)
    end
end

function tests.structs_in_tables_live_as_long_as_the_call()
    local world = falling()
    debug.sethook(collectgarbage, "", 1)
    for _ = 1, 20 do
        local hit, why = world:cast_ray({ origin = { 0, 9 }, dx = 0, dy = -20,
                                          filter = { 0xffffffff, 0xffffffff, true, 0 } })
        if not hit then
            debug.sethook()
            error(why)
        end
    end
    debug.sethook()
end

function tests.the_log_is_no_option()
    raises("log", thud.world, { log = function() end })
end

function tests.what_reads_poses_is_compiled()
    local world, ball = falling()
    local sum, traces = 0, 0
    local function count(what)
        traces = traces + (what == "stop" and 1 or 0)
    end
    jit.attach(count, "trace")
    for _ = 1, 200 do
        world:step()
        local poses, slots = world:poses()
        for again = 1, 50 do
            for slot = 0, slots - 1 do
                sum = sum + poses[slot].y * again
            end
        end
    end
    jit.attach(count)
    assert(sum > 0 and traces > 0 and ball:is_valid())
end

local names = {}
for name in pairs(tests) do
    names[#names + 1] = name
end
table.sort(names)
for _, name in ipairs(names) do
    local done, reason = xpcall(tests[name], debug.traceback)
    if not done then
        print(name .. ": " .. reason)
        os.exit(1)
    end
end
print(#names .. " tests passed")

/* input.c: see input.h. */
#include "input.h"

#include "dig.h"
#include "panel/panel.h"
#include "panel/timeline.h"

#include <math.h>

const char INPUT_HELP[] =
    "In the window:\n"
    "  left drag          pull a body; on empty ground: move the view\n"
    "  right, middle drag move the view        wheel, + -   zoom, the wheel about the pointer\n"
    "  Space              pause and go on      N            a single step\n"
    "  arrows, A D W S    on a level with a character: walk, jump, drop through planks;\n"
    "                     Space jumps as well, and P pauses\n"
    "  R                  reset                Home         first view\n"
    "  , .                slower, faster       Q            next quality\n"
    "  C B                drop a circle, a box at the pointer; with Shift a large one\n"
    "  G                  dig a crater into the ground at the pointer; with Shift raise a mound\n"
    "  X                  explode at the pointer\n"
    "  L M                next pair of kinds; collide, ignore or one-way, where a scene has kinds\n"
    "  V                  of scene minkowski's pairs: their sums, closest points, bounds\n"
    "  T                  save the last 30 s as a recording in the present folder: for a report of\n"
    "                     an error, or to look at slowly\n"
    "  Delete             remove the body under the pointer\n"
    "  1 to 9, 0          contacts, normals, bounds, cells, islands, sleeping, timings, axes,\n"
    "                     pairs, motions\n"
    "  J K                joints; their forces and gaps\n"
    "  E F                next detection, next broadphase; the scene starts anew\n"
    "  Up Down PgUp PgDn  previous, next scene or level\n"
    "  of a recording, which may also be dropped on the window:\n"
    "  Left Right         a step back, forward; with Shift 60 steps\n"
    "  Home End           its first, its last step; the line at the foot: any step\n"
    "  H                  fork: go on by hand from this step; again: back to the recording\n"
    "  I                  list the calls of the present step\n"
    "  Tab                hide and show panel and texts\n"
    "  F11                full screen          Esc          quit\n";

/* Factor of the scale for a notch of the wheel. */
static const double ZOOM_PER_NOTCH = 1.15;
/* Distance in points from the pointer at which a body is still picked. */
static const float PICK_PIXELS = 3;
/* Steps of a recording that the arrows go with Shift: a second of most. Chosen. */
enum { STEPS_WITH_SHIFT = 60 };

/* Pixels of the output in a unit of event coordinates; more than 1 on dense displays. */
static float pixels_per_window_unit(const viewer *v, SDL_Window *window) {
    int width = 0;
    SDL_GetWindowSize(window, &width, NULL);
    return width > 0 ? (float)v->canvas.width / (float)width : 1;
}

/* Whether the pointer is over the panel or the line of steps. */
static bool over_panel(const viewer *v) {
    return (!v->bare && v->ui.x < panel_width(&v->canvas)) || timeline_hovered(v);
}

static thud_pos pointer_place(const viewer *v) {
    return camera_to_world(&v->camera, v->ui.x, v->ui.y);
}

static double pick_margin(const viewer *v) {
    double margin = PICK_PIXELS * v->canvas.unit / v->camera.scale;
    return fmax(margin, 1e-4 * v->session.scene.length_scale);
}

/* Whether bodies can be pulled: a recording that plays cannot be changed. */
static bool may_grab(const viewer *v) {
    return !v->session.played || v->session.played->forked;
}

/* Begins a click on the panel, a pull at a body, or a pan of the view. */
static void press(viewer *v, int button) {
    if (button == SDL_BUTTON_LEFT) {
        v->ui.down = true;
        if (over_panel(v))
            v->ui.pressed = true;
        else if (!may_grab(v) ||
                 !grab_start(&v->grab, &v->session, pointer_place(v), pick_margin(v)))
            v->panning = true;
    } else if ((button == SDL_BUTTON_RIGHT || button == SDL_BUTTON_MIDDLE) && !over_panel(v)) {
        v->panning = true;
    }
}

static void release(viewer *v, int button) {
    v->panning = false;
    if (button == SDL_BUTTON_LEFT) {
        v->ui.down = false;
        grab_end(&v->grab, &v->session);
    }
}

static void move(viewer *v, float x, float y) {
    if (v->panning)
        camera_pan(&v->camera, x - v->ui.x, y - v->ui.y);
    v->ui.x = x;
    v->ui.y = y;
}

static void turn_wheel(viewer *v, float notches) {
    if (over_panel(v))
        v->ui.wheel += notches;
    else
        camera_zoom(&v->camera, pow(ZOOM_PER_NOTCH, notches), v->ui.x, v->ui.y);
}

static void zoom_centre(viewer *v, double notches) {
    SDL_FRect r = v->camera.view;
    camera_zoom(&v->camera, pow(ZOOM_PER_NOTCH, notches), r.x + 0.5f * r.w, r.y + 0.5f * r.h);
}

static void open_neighbour(viewer *v, int direction) {
    int count = v->catalog.count, from = v->selected < 0 && direction < 0 ? 0 : v->selected;
    if (count > 0)
        viewer_open(v, (from + direction + count) % count);
}

static void spawn_here(viewer *v, thud_shape_kind kind, bool large) {
    if (!over_panel(v))
        session_spawn(&v->session, kind, pointer_place(v), large ? 4 : 1);
}

static void dig_here(viewer *v, bool mound) {
    if (!over_panel(v))
        (mound ? dig_mound : dig_crater)(&v->session, pointer_place(v));
}

static void explode_here(viewer *v) {
    if (!over_panel(v))
        session_explode(&v->session, pointer_place(v));
}

static void remove_here(viewer *v) {
    thud_body_id body;
    if (!over_panel(v) &&
        session_pick(&v->session, pointer_place(v), pick_margin(v), THUD_BODY_DYNAMIC, &body))
        session_remove(&v->session, body);
}

static void toggle_full_screen(SDL_Window *window) {
    bool full = (SDL_GetWindowFlags(window) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    SDL_SetWindowFullscreen(window, full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

/* Keys of a recording; those that move by a step act again while they are held. True for a key that
 * acts on recordings alone. */
static bool press_recording_key(viewer *v, const SDL_KeyboardEvent *event) {
    const playback *p = v->session.played;
    int steps = event->keysym.mod & KMOD_SHIFT ? STEPS_WITH_SHIFT : 1;
    if (!p)
        return false;
    switch (event->keysym.sym) {
    case SDLK_LEFT:
        viewer_go(v, -steps);
        return true;
    case SDLK_RIGHT:
        viewer_go(v, steps);
        return true;
    case SDLK_HOME:
        viewer_go_to(v, p->progress.first);
        return true;
    case SDLK_END:
        viewer_go_to(v, p->progress.end);
        return true;
    case SDLK_h:
        if (!event->repeat)
            viewer_fork(v);
        return true;
    case SDLK_i:
        if (!event->repeat)
            v->lists_calls = !v->lists_calls;
        return true;
    default:
        return false;
    }
}

/* Keys that act once when they are pressed. Overlay keys are among them. */
static void press_key(viewer *v, SDL_Window *window, SDL_Keycode key) {
    for (int i = 0; i < OVERLAY_COUNT; i++)
        if (key == SDL_tolower(overlay_key((overlay)i))) {
            viewer_toggle_overlay(v, (overlay)i);
            return;
        }
    switch (key) {
    case SDLK_ESCAPE:
        v->quit = true;
        break;
    case SDLK_SPACE:
        if (!v->character.present)
            viewer_toggle_pause(v);
        break;
    case SDLK_p:
        viewer_toggle_pause(v);
        break;
    case SDLK_r:
        viewer_reset(v);
        break;
    case SDLK_HOME:
        viewer_look_home(v);
        break;
    case SDLK_q:
        session_set_quality(&v->session, (session_quality(&v->session) + 1) % QUALITY_CHOICES);
        break;
    case SDLK_e:
        viewer_set_detection(v, (v->session.detection + 1) % DETECTION_CHOICES);
        break;
    case SDLK_f:
        viewer_set_broadphase(v, (v->session.broadphase + 1) % BROADPHASE_CHOICES);
        break;
    case SDLK_x:
        explode_here(v);
        break;
    case SDLK_l:
        session_next_pair(&v->session);
        break;
    case SDLK_t:
        session_save_last(&v->session);
        break;
    case SDLK_m:
        session_next_meeting(&v->session);
        break;
    case SDLK_v:
        v->pair_look = (pair_look)((v->pair_look + 1) % PAIR_LOOKS);
        break;
    case SDLK_DELETE:
    case SDLK_BACKSPACE:
        remove_here(v);
        break;
    case SDLK_TAB:
        v->bare = !v->bare;
        viewer_layout(v);
        break;
    case SDLK_F11:
        toggle_full_screen(window);
        break;
    default:
        break;
    }
}

/* Keys that act again while they are held. */
static void repeat_key(viewer *v, SDL_Keycode key, bool shift) {
    switch (key) {
    case SDLK_n:
        viewer_single_step(v);
        break;
    case SDLK_COMMA:
        viewer_change_speed(v, -1);
        break;
    case SDLK_PERIOD:
        viewer_change_speed(v, 1);
        break;
    case SDLK_c:
        spawn_here(v, THUD_SHAPE_CIRCLE, shift);
        break;
    case SDLK_b:
        spawn_here(v, THUD_SHAPE_OBB, shift);
        break;
    case SDLK_g:
        dig_here(v, shift);
        break;
    case SDLK_UP:
    case SDLK_DOWN:
        if (!v->character.present)
            open_neighbour(v, key == SDLK_UP ? -1 : 1);
        break;
    case SDLK_PAGEUP:
        open_neighbour(v, -1);
        break;
    case SDLK_PAGEDOWN:
        open_neighbour(v, 1);
        break;
    case SDLK_PLUS:
    case SDLK_EQUALS:
    case SDLK_KP_PLUS:
        zoom_centre(v, 1);
        break;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
        zoom_centre(v, -1);
        break;
    default:
        break;
    }
}

/* Handles one event. */
static void handle(viewer *v, SDL_Window *window, const SDL_Event *event) {
    float scale = pixels_per_window_unit(v, window);
    switch (event->type) {
    case SDL_QUIT:
        v->quit = true;
        break;
    case SDL_WINDOWEVENT:
        if (event->window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
            int width = 1;
            SDL_GetWindowSize(window, &width, NULL);
            SDL_GetRendererOutputSize(v->canvas.renderer, &v->canvas.width, &v->canvas.height);
            canvas_resize(&v->canvas, (float)v->canvas.width / (float)(width > 0 ? width : 1));
            viewer_layout(v);
        }
        break;
    case SDL_MOUSEMOTION:
        move(v, (float)event->motion.x * scale, (float)event->motion.y * scale);
        break;
    case SDL_MOUSEBUTTONDOWN:
        move(v, (float)event->button.x * scale, (float)event->button.y * scale);
        press(v, event->button.button);
        break;
    case SDL_MOUSEBUTTONUP:
        release(v, event->button.button);
        break;
    case SDL_MOUSEWHEEL:
        turn_wheel(v, event->wheel.preciseY);
        break;
    case SDL_DROPFILE:
        viewer_open_file(v, event->drop.file);
        SDL_free(event->drop.file);
        break;
    case SDL_KEYDOWN:
        if (press_recording_key(v, &event->key))
            break;
        if (!event->key.repeat)
            press_key(v, window, event->key.keysym.sym);
        repeat_key(v, event->key.keysym.sym, (event->key.keysym.mod & KMOD_SHIFT) != 0);
        break;
    default:
        break;
    }
}

/* Sets the character's keys to those that are down. */
static void steer_character(viewer *v) {
    const Uint8 *down = SDL_GetKeyboardState(NULL);
    v->character.keys = (character_keys){
        .left = down[SDL_SCANCODE_LEFT] || down[SDL_SCANCODE_A],
        .right = down[SDL_SCANCODE_RIGHT] || down[SDL_SCANCODE_D],
        .jump = down[SDL_SCANCODE_UP] || down[SDL_SCANCODE_W] || down[SDL_SCANCODE_SPACE],
        .down = down[SDL_SCANCODE_DOWN] || down[SDL_SCANCODE_S],
    };
}

void input_poll(viewer *v, SDL_Window *window) {
    SDL_Event event;
    v->ui.pressed = false;
    v->ui.wheel = 0;
    while (SDL_PollEvent(&event))
        handle(v, window, &event);
    steer_character(v);
    /* In each frame, since the view or the body may move while the pointer rests. */
    if (v->grab.held)
        grab_move(&v->grab, &v->session, pointer_place(v));
}

/* scenes.c: the list of built-in scenes. demo/scenes/CMakeLists.txt generates it (scene_list.h). */
#include "scenes.h"

#include <string.h>

static const scene_info *const LIST[] = {SCENE_LIST};

enum { LIST_COUNT = sizeof LIST / sizeof LIST[0] };

int scenes_count(void) {
    return LIST_COUNT;
}

const scene_info *scenes_at(int index) {
    return index >= 0 && index < LIST_COUNT ? LIST[index] : NULL;
}

const scene_info *scenes_find(const char *name) {
    for (int i = 0; name && i < LIST_COUNT; i++)
        if (strcmp(LIST[i]->name, name) == 0)
            return LIST[i];
    return NULL;
}

bool scenes_fill(const scene_info *info, int size, scene *s) {
    scene_init(s);
    if (size == 0)
        size = info->default_size;
    if (size < info->min_size || size > info->max_size)
        return false;
    s->name = info->name;
    s->title = info->title;
    s->about = info->about;
    info->fill(s, size);
    if (s->failed) {
        scene_free(s);
        return false;
    }
    return true;
}

typedef struct thud_py_context thud_py_context;
thud_py_context *thud_py_context_create(void);
thud_result thud_py_context_create_world(thud_py_context *context, thud_world_def *def);
thud_world *thud_py_context_world(const thud_py_context *context);
void thud_py_context_destroy(thud_py_context *context);
void thud_py_context_hold(thud_py_context *context);
void thud_py_context_let_go(thud_py_context *context);
const char *thud_py_context_message(const thud_py_context *context);
void thud_py_step_all(thud_world **worlds, int count, int steps, thud_result *out_results);

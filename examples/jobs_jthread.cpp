// jobs_jthread.cpp: a pool of std::jthread as the job system of a world, in C++20. The steps of a
// large pyramid end with the same bits as on one thread.
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <thread>
#include <thud/thud.h>
#include <thud/thud_make.h>
#include <thud/thud_snapshot.h>
#include <vector>

// A thread takes a call that nobody has made yet, and so does the thread that steps the world once
// its own call has returned. All fields but the threads are guarded by the mutex.
class pool {
  public:
    explicit pool(int count) : workers(count) {
        for (int i = 1; i < count; i++) {
            threads.emplace_back([this](std::stop_token stop) {
                std::unique_lock lock(mutex);
                while (offered.wait(lock, stop, [this] { return left > 0; })) {
                    call(lock);
                }
            });
        }
    }

    thud_job_system job_system() {
        return {.run = run,
                .context = this,
                .workers = workers,
                .stages = &thud_shared_stages_all,
                .share_from = 0};
    }

  private:
    static void run(thud_task_fn *new_task, void *its_argument, int calls, void *context) {
        pool &p = *static_cast<pool *>(context);
        std::unique_lock lock(p.mutex);
        p.task = new_task;
        p.argument = its_argument;
        p.left = p.unfinished = calls;
        p.offered.notify_all();
        while (p.left > 0) {
            p.call(lock);
        }
        p.finished.wait(lock, [&p] { return p.unfinished == 0; });
    }

    // Makes one of the calls that are left, with the mutex unlocked.
    void call(std::unique_lock<std::mutex> &lock) {
        left--;
        lock.unlock();
        task(argument);
        lock.lock();
        if (--unfinished == 0) {
            finished.notify_one();
        }
    }

    std::mutex mutex;
    std::condition_variable_any offered, finished;
    thud_task_fn *task = nullptr;
    void *argument = nullptr;
    int workers, left = 0, unfinished = 0;
    std::vector<std::jthread> threads; // the last field: it ends before what it uses
};

static unsigned long long hash_with(thud_job_system jobs) {
    const int rows = 30;
    thud_world_def def = thud_default_world_def();
    def.job_system = jobs;
    thud_world *world;
    if (thud_world_create(&def, &world) != THUD_OK) {
        return 0;
    }
    thud_body_options box = {};
    box.kind = THUD_BODY_DYNAMIC;
    thud_body_make(world, thud_aabb_at(0, -1, 60, 1), nullptr);
    for (int row = 0; row < rows; row++) {
        for (int i = 0; i < rows - row; i++) {
            thud_body_make(world, thud_obb_at(i - 0.5 * (rows - row), 0.5 + row, 0.45, 0.5, 0),
                           &box);
        }
    }
    for (int i = 0; i < 60; i++) {
        thud_world_step(world);
    }
    unsigned long long hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

int main() {
    unsigned long long alone = hash_with({});
    for (int workers = 2; workers <= 4; workers++) {
        pool threads(workers);
        if (hash_with(threads.job_system()) != alone) {
            return 1;
        }
    }
    std::puts("2 to 4 workers of std::jthread: the same bits as one");
}

#include "cli/execution.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <functional>
#include <memory>

#include "cli/stop_signal.h"

namespace nacre {

Execution execution_on(int threads, Console& console) {
    const int count = threads > 0 ? threads : int{tbb::task_arena::automatic};
    const auto arena = std::make_shared<tbb::task_arena>(count);
    Execution execution;
    execution.for_each = [arena](std::size_t pieces, const std::function<void(std::size_t)>& function) {
        arena->execute([&] { tbb::parallel_for(std::size_t{0}, pieces, function); });
    };
    execution.step = throw_if_stopped;
    execution.progress = [&console](std::size_t done, std::size_t total) { console.progress(done, total); };
    return execution;
}

}  // namespace nacre

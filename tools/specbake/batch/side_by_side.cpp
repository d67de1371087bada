#include "batch/side_by_side.h"

#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace specbake::tool {

void sideBySide(std::span<const std::size_t> numbers, int threads,
                const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    const auto take = [&] {
        for (std::size_t i = next++; i < numbers.size(); i = next++) work(numbers[i]);
    };
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < threads && std::size_t(i) < numbers.size(); ++i) {
            others.emplace_back(take);
        }
    } catch (const std::system_error&) {
        // No more of them: those that there are do it.
    }
    take();
}

}  // namespace specbake::tool

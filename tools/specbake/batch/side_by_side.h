#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace specbake::tool {

/// Does `work` for each of the numbers, in their order, on so many threads: this one and others.
/// Where the system grants fewer, on those. `work` must not throw.
void sideBySide(std::span<const std::size_t> numbers, int threads,
                const std::function<void(std::size_t)>& work);

}  // namespace specbake::tool

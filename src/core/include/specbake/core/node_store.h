#pragma once

#include <specbake/core/node_values.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

namespace specbake {

/// The values at a grid's nodes, each found when it is first asked for, by whichever thread asks.
/// Since what stands at a node depends on the node alone, a result never depends on the order.
class NodeStore {
  public:
    /// Finds the values of a node; empty where there are none (outside the solid). Thread-safe.
    using Finder = std::function<bool(std::uint32_t node, NodeValues& values)>;

    NodeStore(std::size_t nodeCount, Finder finder);

    /// The values of a node, kNodeStride floats, or nullptr where there are none.
    const float* at(std::uint32_t node);

    /// How many nodes were asked for so far.
    std::size_t foundCount() const { return found_.load(); }

  private:
    enum State : std::uint8_t { unknown, arriving, present, absent };

    void find(std::uint32_t node);

    Finder finder_;
    std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
    std::unique_ptr<NodeValues[], void (*)(NodeValues*)> values_;
    std::atomic<std::size_t> found_ = 0;
};

}  // namespace specbake

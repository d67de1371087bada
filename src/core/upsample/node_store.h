#pragma once

#include "upsample/node_values.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

namespace specbake::internal {

/// The values at a grid's nodes, each found when it is first asked for, by whichever thread asks.
/// Since what stands at a node depends on the node alone, a result never depends on the order.
class NodeStore {
  public:
    /// Finds the values of a node; empty where there are none (outside the solid). Thread-safe.
    using Finder = std::function<bool(std::uint32_t node, NodeValues& values)>;

    NodeStore(std::size_t nodeCount, Finder finder);

    /// The values of a node, kNodeStride floats, or nullptr where there are none.
    const float* at(std::uint32_t node) {
        const bool there = state_[node].load(std::memory_order_acquire) == present;
        return there ? values_[node].value.data() : findOrWait(node);
    }

    using Simplex = std::array<std::uint32_t, 4>;
    /// The values of four nodes; false where one has none.
    bool at(const Simplex& nodes, std::array<const float*, 4>& values) {
        const auto there = [this, &nodes](std::size_t k) {
            return state_[nodes[k]].load(std::memory_order_acquire) == present;
        };
        const auto at = [all = values_.get(), &nodes](std::size_t k) {
            return all[nodes[k]].value.data();
        };
        values = {at(0), at(1), at(2), at(3)};
        return (there(0) & there(1) & there(2) & there(3)) || findOrWait(nodes, values);
    }

    /// How many nodes were asked for so far.
    std::size_t foundCount() const { return found_.load(); }

  private:
    enum State : std::uint8_t { unknown, arriving, present, absent };

    const float* findOrWait(std::uint32_t node);
    bool findOrWait(const Simplex& nodes, std::array<const float*, 4>& values);
    void find(std::uint32_t node);

    Finder finder_;
    std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
    std::unique_ptr<NodeValues[], void (*)(NodeValues*)> values_;
    std::atomic<std::size_t> found_ = 0;
};

}  // namespace specbake::internal

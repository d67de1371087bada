#pragma once

#include "upsample/node_values.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace specbake::internal {

/// The values at a grid's nodes, each found when it is first asked for. Nodes that are wanted are
/// noted first, and then found some dozens at a time, by whichever threads are there: each node
/// once. Since what stands at a node depends on the node alone, a result never depends on the
/// order.
class NodeStore {
  public:
    /// Finds the values of nodes; `there[i]` stays 0 where there are none (outside the solid).
    /// Thread-safe.
    using Finder = std::function<void(std::span<const std::uint32_t> nodes,
                                      std::span<NodeValues> values, std::span<std::uint8_t> there)>;

    NodeStore(std::size_t nodeCount, Finder finder);

    using Simplex = std::array<std::uint32_t, 4>;

    /// The values of four nodes, if all are known to be there.
    bool present(const Simplex& nodes, std::array<const float*, 4>& values) const {
        const auto there = [this, &nodes](std::size_t k) {
            return state_[nodes[k]].load(std::memory_order_acquire) == State::present;
        };
        const auto at = [all = values_.get(), &nodes](std::size_t k) {
            return all[nodes[k]].value.data();
        };
        values = {at(0), at(1), at(2), at(3)};
        return there(0) & there(1) & there(2) & there(3);
    }

    /// Those of the nodes that nobody asked for yet are to be found.
    void note(const Simplex& nodes) {
        for (const std::uint32_t node : nodes) note(node);
    }
    void note(std::uint32_t node) {
        if (state_[node].load(std::memory_order_relaxed) == State::unknown) claim(node);
    }

    /// Finds noted nodes until none is left that no other thread has taken.
    void findNoted() {
        while (findSome()) {
        }
    }
    /// How many nodes are noted that no thread has taken.
    std::size_t notedCount() const;

    /// The values of four nodes, which are found now if they are not known; false where one has
    /// none.
    bool at(const Simplex& nodes, std::array<const float*, 4>& values);

    /// How many nodes were asked for so far.
    std::size_t foundCount() const { return found_.load(); }

    static constexpr std::size_t kTogether = 64;  ///< nodes that a thread takes at a time

  private:
    enum class State : std::uint8_t { unknown, noted, present, absent };

    void claim(std::uint32_t node);
    bool findSome();
    std::vector<std::uint32_t> takeSome();
    State findOrWait(std::uint32_t node);

    Finder finder_;
    std::unique_ptr<std::atomic<State>[]> state_;
    std::unique_ptr<NodeValues[], void (*)(NodeValues*)> values_;
    std::atomic<std::size_t> found_ = 0;
    mutable std::mutex mutex_;  ///< of noted_
    std::vector<std::uint32_t> noted_;
};

}  // namespace specbake::internal

#include "upsample/node_store.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <thread>

namespace specbake::internal {
namespace {

/// Zero pages that cost memory only when a node is written to: a fine grid is mostly empty.
NodeValues* reserve(std::size_t count) {
    const std::size_t bytes = (count * sizeof(NodeValues) + alignof(NodeValues) - 1) /
                              alignof(NodeValues) * alignof(NodeValues);
    void* memory = std::aligned_alloc(alignof(NodeValues), bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<NodeValues*>(memory);
}

void freeValues(NodeValues* values) {
    std::free(values);
}

}  // namespace

NodeStore::NodeStore(std::size_t nodeCount, Finder finder)
    : finder_(std::move(finder)),
      state_(std::make_unique<std::atomic<State>[]>(nodeCount)),
      values_(reserve(nodeCount), freeValues) {}

void NodeStore::claim(std::uint32_t node) {
    State expected = State::unknown;
    if (!state_[node].compare_exchange_strong(expected, State::noted)) return;
    const std::lock_guard lock(mutex_);
    noted_.push_back(node);
}

std::size_t NodeStore::notedCount() const {
    const std::lock_guard lock(mutex_);
    return noted_.size();
}

std::vector<std::uint32_t> NodeStore::takeSome() {
    const std::lock_guard lock(mutex_);
    const std::size_t left = noted_.size() - std::min(noted_.size(), kTogether);
    std::vector<std::uint32_t> some(noted_.begin() + std::ptrdiff_t(left), noted_.end());
    noted_.resize(left);
    return some;
}

/// Finds some of the noted nodes; false if there are none.
bool NodeStore::findSome() {
    const std::vector<std::uint32_t> nodes = takeSome();
    if (nodes.empty()) return false;
    std::vector<NodeValues> values(nodes.size());
    std::vector<std::uint8_t> there(nodes.size());
    try {
        finder_(nodes, values, there);
    } catch (...) {  // or who waits for these would wait for ever
        for (const std::uint32_t node : nodes) state_[node].store(State::unknown);
        throw;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (there[i] != 0) values_[nodes[i]] = values[i];
        state_[nodes[i]].store(there[i] != 0 ? State::present : State::absent,
                               std::memory_order_release);
    }
    found_ += nodes.size();
    return true;
}

/// While another thread finds the node, this one finds what else is noted.
NodeStore::State NodeStore::findOrWait(std::uint32_t node) {
    for (;;) {
        const State state = state_[node].load(std::memory_order_acquire);
        if (state == State::present || state == State::absent) return state;
        note(node);
        if (!findSome()) std::this_thread::yield();
    }
}

bool NodeStore::at(const Simplex& nodes, std::array<const float*, 4>& values) {
    if (present(nodes, values)) return true;
    bool all = true;
    for (const std::uint32_t node : nodes) all &= findOrWait(node) == State::present;
    return all;
}

}  // namespace specbake::internal

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

void release(NodeValues* values) {
    std::free(values);
}

}  // namespace

NodeStore::NodeStore(std::size_t nodeCount, Finder finder)
    : finder_(std::move(finder)),
      state_(std::make_unique<std::atomic<std::uint8_t>[]>(nodeCount)),
      values_(reserve(nodeCount), release) {}

const float* NodeStore::findOrWait(std::uint32_t node) {
    std::uint8_t state = state_[node].load(std::memory_order_acquire);
    if (state == unknown) {
        find(node);
        state = state_[node].load(std::memory_order_acquire);
    }
    while (state == arriving) {  // another thread is copying 384 bytes
        std::this_thread::yield();
        state = state_[node].load(std::memory_order_acquire);
    }
    return state == present ? values_[node].value.data() : nullptr;
}

bool NodeStore::findOrWait(const Simplex& nodes, std::array<const float*, 4>& values) {
    for (std::size_t k = 0; k < 4; ++k) values[k] = findOrWait(nodes[k]);
    return std::find(values.begin(), values.end(), nullptr) == values.end();
}

/// Two threads may both find a node; the first to arrive stores it, and both found the same.
void NodeStore::find(std::uint32_t node) {
    NodeValues values;
    const bool there = finder_(node, values);
    std::uint8_t expected = unknown;
    if (!state_[node].compare_exchange_strong(expected, arriving)) return;
    if (there) values_[node] = values;
    state_[node].store(there ? present : absent, std::memory_order_release);
    ++found_;
}

}  // namespace specbake::internal

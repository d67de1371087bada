#pragma once

#include "deflate/bit_writer.h"
#include "deflate/huffman.h"

#include <span>

namespace specbake::internal {

/// Writes the lengths of a block's two codes, from which a decoder makes them (RFC 1951, 3.2.7).
void writeCodeLengths(std::span<const CodeWord> literals, std::span<const CodeWord> distances,
                      BitWriter& out);

}  // namespace specbake::internal

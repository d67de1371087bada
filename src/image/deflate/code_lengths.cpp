#include "deflate/code_lengths.h"

#include "deflate/deflate_symbols.h"

#include <algorithm>
#include <array>
#include <vector>

namespace specbake::internal {
namespace {

/// Both codes' lengths, one after the other, in symbols of their own.
class LengthsHeader {
  public:
    LengthsHeader(std::span<const CodeWord> literals, std::span<const CodeWord> distances)
        : literals_(used(literals, 257)), distances_(used(distances, 1)) {
        std::vector<std::uint32_t> lengths;
        for (std::size_t i = 0; i < literals_; ++i) lengths.push_back(literals[i].length);
        for (std::size_t i = 0; i < distances_; ++i) lengths.push_back(distances[i].length);
        for (std::size_t i = 0; i < lengths.size();) i += addRun(lengths, i);
    }

    void write(BitWriter& out) const {
        constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                       11, 4,  12, 3, 13, 2, 14, 1, 15};
        // Two symbols at least, since decoders refuse a code that is not complete.
        std::array<std::uint32_t, 19> counts{};
        counts[0] = counts[18] = 1;
        for (const Symbol& s : symbols_) ++counts[s.symbol];
        const auto code = huffmanCode(counts, 7);
        out.put(literals_ - 257, 5);
        out.put(distances_ - 1, 5);
        out.put(order.size() - 4, 4);
        out.flush();
        for (const std::size_t s : order) {
            out.put(code[s].length, 3);
            out.flush();
        }
        for (const Symbol& s : symbols_) {
            out.put(code[s.symbol].bits, code[s.symbol].length);
            out.put(s.extra, s.extraBits);
            out.flush();
        }
    }

  private:
    static std::size_t used(std::span<const CodeWord> code, std::size_t least) {
        std::size_t count = code.size();
        while (count > least && code[count - 1].length == 0) --count;
        return count;
    }

    /// Adds a symbol for the lengths from `first` on; returns how many it stands for.
    std::size_t addRun(const std::vector<std::uint32_t>& lengths, std::size_t first) {
        std::size_t run = 1;
        while (first + run < lengths.size() && lengths[first + run] == lengths[first]) ++run;
        const bool zeros = lengths[first] == 0;
        const bool repeats = first > 0 && lengths[first - 1] == lengths[first];
        if (zeros && run >= 11) return add(18, 7, 11, std::min<std::size_t>(run, 138));
        if (zeros && run >= 3) return add(17, 3, 3, run);
        if (!zeros && repeats && run >= 3) return add(16, 2, 3, std::min<std::size_t>(run, 6));
        return add(lengths[first], 0, 1, 1);
    }
    std::size_t add(std::uint32_t symbol, std::uint32_t extraBits, std::size_t least,
                    std::size_t run) {
        symbols_.push_back({symbol, extraBits, std::uint32_t(run - least)});
        return run;
    }

    std::size_t literals_, distances_;
    std::vector<Symbol> symbols_;
};

}  // namespace

void writeCodeLengths(std::span<const CodeWord> literals, std::span<const CodeWord> distances,
                      BitWriter& out) {
    LengthsHeader(literals, distances).write(out);
}

}  // namespace specbake::internal

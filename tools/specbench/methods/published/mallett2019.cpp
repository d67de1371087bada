#include "methods/published/mallett2019.h"

#include "methods/csv.h"

#include <specbake/core/error.h>

namespace specbake::bench {

Mallett2019::Mallett2019(Frame frame, std::string table)
    : LinearMethod({"Mallett & Yuksel 2019", ""}, std::move(frame)), table_(std::move(table)) {}

void Mallett2019::setUp() {
    const auto rows = readCsv(table_);
    if (rows.size() != kBandCount) throw FileError(table_, "81 rows expected");
    Basis basis;
    for (std::size_t m = 0; m < rows.size(); ++m) {
        for (std::size_t i = 0; i < 3; ++i) basis[i][m] = numberIn(rows[m], i + 1, table_);
    }
    setBasis(basis);
}

}  // namespace specbake::bench

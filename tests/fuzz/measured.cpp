#include "samples/sample_table.h"
#include "target.h"

#include <specbake/image/light_file.h>

namespace specbake::fuzz {

/// Tables that people bring: samples and lights, as CSV and CGATS.
void run(std::span<const std::uint8_t> bytes) {
    const internal::SampleTable table = internal::parseSampleTable(textOf(bytes));
    for (const auto& row : table.samples) expect(row.values.size() == table.wavelengths.size());
    const InputFile file(bytes);
    static_cast<void>(readLight(file.path()));
}

}  // namespace specbake::fuzz

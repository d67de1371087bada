#pragma once

#include <specbake/sampler.h>

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::python {

/// A table's bytes, and the view of them that renderers have.
class Table {
  public:
    /// Throws FileError on `name` for bytes that are no table.
    Table(const std::string& name, std::vector<std::byte> bytes);

    const std::vector<std::byte>& bytes() const { return bytes_; }
    const SpectralTable& view() const { return view_; }

  private:
    std::vector<std::byte> bytes_;
    SpectralTable view_;
};

}  // namespace specbake::python

#pragma once

#include <specbake/image/texture.h>

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace specbake::internal {

/// Rows of a texture, as it stores them, for any number of threads. It is read in bands of rows, of
/// which those last used are kept.
class StoredRows {
  public:
    /// `bytes`: to keep, beside what is in use. The texture must outlive it.
    StoredRows(Texture& texture, std::size_t bytes);

    using Band = std::vector<std::byte>;

    /// The band that a row is in. Throws FileError.
    std::shared_ptr<const Band> bandOf(int row);
    /// The row in its band.
    std::span<const std::byte> rowIn(const Band& band, int row) const;

  private:
    struct Kept {
        std::shared_ptr<const Band> band;
        std::list<int>::iterator use;
    };

    int bandNumber(int row) const { return row / rows_; }
    std::shared_ptr<const Band> read(int number);

    Texture& texture_;
    int rows_;  ///< of a band
    std::size_t most_;
    std::mutex mutex_;
    std::map<int, Kept> kept_;
    std::list<int> uses_;  ///< numbers, the latest first
};

}  // namespace specbake::internal

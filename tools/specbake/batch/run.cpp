#include "batch/run.h"

#include "bake_report.h"
#include "batch/side_by_side.h"

#include <specbake/bake/model_cache.h>
#include <specbake/bake/up_to_date.h>
#include <specbake/core/error.h>

#include <tbb/info.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <new>
#include <numeric>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

/// From here on a texture is baked with all threads: it keeps them busy by itself.
constexpr std::size_t kLarge = std::size_t(1) << 20;  // texels

void makeFolderOf(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    if (!folder.empty()) fs::create_directories(folder);
}

class Batch {
  public:
    Batch(std::span<const BatchItem> items, const BatchOptions& options)
        : items_(items),
          options_(options),
          threads_(options.bake.threads > 0 ? options.bake.threads
                                            : tbb::info::default_concurrency()),
          results_(items.size()),
          texels_(items.size()),
          shares_(items.size()) {
        if (!options_.bake.models) options_.bake.models = std::make_shared<ModelCache>();
    }

    std::vector<BatchResult> run() {
        std::vector<std::size_t> all(items_.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        sideBySide(all, threads_, [this](std::size_t i) { look(i); });
        std::erase_if(all, [this](std::size_t i) { return through_[i]; });
        total_ = std::accumulate(all.begin(), all.end(), 0.0,
                                 [this](double sum, std::size_t i) { return sum + weight(i); });
        const auto small = std::stable_partition(
            all.begin(), all.end(), [this](std::size_t i) { return texels_[i] >= kLarge; });
        for (auto i = all.begin(); i != small; ++i) make(*i, threads_);
        bakeSmall(std::span(small, all.end()));
        return std::move(results_);
    }

  private:
    bool stopped() const { return options_.bake.stop.stop_requested(); }
    double weight(std::size_t i) const { return double(texels_[i]); }

    void bakeSmall(std::span<const std::size_t> small) {
        if (small.empty()) return;
        const int together = int(std::min(std::size_t(threads_), small.size()));
        const int each = threads_ / together;
        sideBySide(small, together, [&](std::size_t i) { make(i, each); });
    }

    /// Of what needs no bake, or cannot have one, that much is known then; else the size.
    void look(std::size_t i) {
        if (stopped()) return;
        const Input& input = items_[i].input;
        attempt(i, [&](BatchResult& result) {
            texels_[i] = kLarge;  // for what could be opened once only, such as a pipe
            if (items_[i].output.empty()) result.outcome = Outcome::passed;
            if (result.outcome == Outcome::passed) return;
            if (fs::exists(input.path) && !fs::is_regular_file(input.path)) return;
            const TextureReader texture(input.path, options_.bake.read);
            const Window& window = texture.info().data;
            texels_[i] = std::size_t(window.width) * std::size_t(window.height);
            if (options_.update && !outdated(input.path, items_[i].output, options_.bake)) {
                result.outcome = Outcome::current;
            }
        });
    }

    void make(std::size_t i, int threads) {
        if (stopped()) return;
        attempt(i, [&](BatchResult& result) {
            const BatchItem& item = items_[i];
            makeFolderOf(item.output);
            BakeOptions options = options_.bake;
            options.threads = threads;
            options.progress = [this, i](double done) { advance(i, done); };
            result.statistics = bake(item.input.path, item.output, options);
            if (!item.page.empty()) {
                makeFolderOf(item.page);
                writePage(item.page, item.input.path, item.output, options, result.statistics);
            }
            result.outcome = Outcome::baked;
        });
    }

    /// Does it, and notes what came of it unless that is open yet.
    template <class Work>
    void attempt(std::size_t i, const Work& work) {
        BatchResult result;
        try {
            work(result);
        } catch (const Cancelled&) {
            result.outcome = Outcome::left;
        } catch (const std::bad_alloc&) {
            result = {Outcome::failed, "not enough memory", {}};
        } catch (const std::exception& error) {
            result = {Outcome::failed, reasonOf(error, items_[i].input.path), {}};
        }
        if (result.outcome == Outcome::left) return;
        const std::lock_guard lock(mutex_);
        through_[i] = true;
        results_[i] = std::move(result);
        if (options_.finished) options_.finished(items_[i], results_[i]);
    }

    void advance(std::size_t i, double done) {
        const std::lock_guard lock(mutex_);
        done_ += weight(i) * (done - shares_[i]);
        shares_[i] = done;
        if (options_.progress) options_.progress(std::min(1.0, done_ / total_));
    }

    std::span<const BatchItem> items_;
    BatchOptions options_;
    int threads_;
    std::vector<BatchResult> results_;
    std::vector<std::size_t> texels_;
    std::vector<double> shares_;  ///< how much of each is done
    std::vector<bool> through_ = std::vector<bool>(items_.size());
    double done_ = 0;  ///< texels
    double total_ = 0;
    std::mutex mutex_;
};

}  // namespace

std::string reasonOf(const std::exception& error, const std::string& file) {
    const std::string what = error.what();
    return what.starts_with(file + ": ") ? what.substr(file.size() + 2) : what;
}

std::vector<BatchResult> runBatch(std::span<const BatchItem> items, const BatchOptions& options) {
    return Batch(items, options).run();
}

}  // namespace specbake::tool

#pragma once

#include "batch/plan.h"
#include "batch/run.h"
#include "progress_bar.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace specbake::tool {

/// One texture's line of `--stats`: its names, its status, and its figures or the reason.
nlohmann::ordered_json batchJson(const BatchItem& item, const BatchResult& result);

/// What a batch tells: a line per file as it is through, and a table at the end.
class BatchReport {
  public:
    struct Options {
        std::string statsFile;  ///< lines of JSON; "-": to stdout, where nothing else is then
        std::string outside;    ///< the rule for colours that no reflectance has
        bool verbose = false;
        bool quiet = false;  ///< failures alone
        bool sync = false;   ///< the file outlives a power cut
    };

    BatchReport(Options options, ProgressBar& bar);

    void tell(const BatchItem& item, const BatchResult& result);

    /// Writes the file of `--stats` and prints the table. Throws FileError.
    void end(std::span<const BatchItem> items, std::span<const BatchResult> results, double seconds,
             int threads) const;

  private:
    bool statsToStdout() const { return options_.statsFile == "-"; }

    Options options_;
    ProgressBar& bar_;
    bool lines_;  ///< a line per file
};

}  // namespace specbake::tool

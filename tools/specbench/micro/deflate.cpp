/// deflate_bench FILE...: our encoder of zip levels 1 to 3 beside libdeflate and zlib, on the bytes
/// that the chunks of these files gave to their encoder, with one thread. Prints tables, Markdown.
///
/// The encoders take turns on each chunk, so that what else the machine does falls on all alike. A
/// time's ratio is the median over chunks and rounds, a size's that of all chunks together.
#include "deflate/row_deflate.h"
#include "statistics.h"
#include "zip_chunks.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <zlib.h>

#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

namespace specbake::bench {

using namespace internal;

namespace {

constexpr std::size_t kChunks = 16;
constexpr std::size_t kRounds = 3;

using Packed = std::vector<std::uint8_t>;

struct Encoder {
    std::string name;
    /// The size of the stream; `packed` is large enough for any.
    std::function<std::size_t(const ZipChunk& chunk, Packed& packed)> encode;
};

Encoder ownEncoder(std::size_t level) {
    return {fmt::format("own {}", level), [level](const ZipChunk& chunk, Packed& packed) {
                return rowDeflate(chunk.bytes, chunk.rowLength, level, packed);
            }};
}

Encoder libdeflateEncoder(int level) {
    const std::shared_ptr<libdeflate_compressor> compressor(libdeflate_alloc_compressor(level),
                                                            libdeflate_free_compressor);
    return {fmt::format("libdeflate {}", level), [compressor](const ZipChunk& chunk, Packed& to) {
                return libdeflate_zlib_compress(compressor.get(), chunk.bytes.data(),
                                                chunk.bytes.size(), to.data(), to.size());
            }};
}

Encoder zlibEncoder(int level) {
    return {fmt::format("zlib {}", level), [level](const ZipChunk& chunk, Packed& packed) {
                uLongf size = packed.size();
                const int result =
                    compress2(packed.data(), &size, chunk.bytes.data(), chunk.bytes.size(), level);
                return result == Z_OK ? std::size_t(size) : 0;
            }};
}

/// The first is what the others are held against.
std::vector<Encoder> allEncoders() {
    std::vector<Encoder> encoders = {libdeflateEncoder(1)};
    for (std::size_t level = 1; level <= 3; ++level) encoders.push_back(ownEncoder(level));
    for (int level = 2; level <= 6; ++level) encoders.push_back(libdeflateEncoder(level));
    encoders.push_back(zlibEncoder(4));  // OpenEXR's default
    return encoders;
}

/// Seconds of processor time: what other programs use does not count.
double secondsOf(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Of one encoder and one chunk.
struct Run {
    std::size_t size = 0;
    double packing = 0, inflating = 0;  ///< seconds
};

Run run(const Encoder& encoder, const ZipChunk& chunk, Packed& packed) {
    static const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    Run result;
    result.packing = secondsOf([&] { result.size = encoder.encode(chunk, packed); });
    Packed again(chunk.bytes.size(), 1);
    result.inflating = secondsOf([&] {
        libdeflate_zlib_decompress(decompressor.get(), packed.data(), result.size, again.data(),
                                   again.size(), nullptr);
    });
    if (again != chunk.bytes) throw std::runtime_error(encoder.name + ": other bytes come back");
    return result;
}

/// What is known of one encoder on one file.
struct Record {
    std::size_t size = 0;
    std::vector<double> packing, inflating;  ///< seconds per byte, of each chunk and round
};

std::vector<Record> measure(const std::vector<Encoder>& encoders,
                            const std::vector<ZipChunk>& chunks) {
    std::vector<Record> records(encoders.size());
    for (const ZipChunk& chunk : chunks) {
        const auto bytes = double(chunk.bytes.size());
        Packed packed(2 * rowDeflateBound(chunk.bytes.size()), 1);
        for (std::size_t turn = 0; turn < kRounds * encoders.size(); ++turn) {
            const std::size_t e = turn % encoders.size();
            const Run result = run(encoders[e], chunk, packed);
            records[e].packing.push_back(result.packing / bytes);
            records[e].inflating.push_back(result.inflating / bytes);
            if (turn < encoders.size()) records[e].size += result.size;
        }
    }
    return records;
}

double medianRatio(const std::vector<double>& of, const std::vector<double>& to) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < of.size(); ++i) ratios.push_back(of[i] / to[i]);
    return median(std::move(ratios));
}

/// One of the three tables: a row a file, all encoders as ratios to the first.
class Table {
  public:
    Table(const std::string& title, const std::string& unit, const std::vector<Encoder>& encoders) {
        text_ = fmt::format("\n| {} | {}, {} |", title, encoders[0].name, unit);
        for (std::size_t e = 1; e < encoders.size(); ++e) {
            text_ += fmt::format(" {} |", encoders[e].name);
        }
        text_ += "\n|---|";
        for (std::size_t e = 0; e < encoders.size(); ++e) text_ += "---|";
    }
    void addRow(const std::string& file, double first, const std::vector<double>& ratios) {
        text_ += fmt::format("\n| {} | {:.3g} |", file, first);
        for (const double ratio : ratios) text_ += fmt::format(" {:.2f} |", ratio);
    }
    void print() const { fmt::print("{}\n", text_); }

  private:
    std::string text_;
};

/// Of all encoders but the first, their medianRatio() to it.
std::vector<double> timeRatios(const std::vector<Record>& records,
                               std::vector<double> Record::*times) {
    std::vector<double> ratios;
    for (std::size_t e = 1; e < records.size(); ++e) {
        ratios.push_back(medianRatio(records[e].*times, records[0].*times));
    }
    return ratios;
}

std::vector<double> sizeRatios(const std::vector<Record>& records) {
    std::vector<double> ratios;
    for (std::size_t e = 1; e < records.size(); ++e) {
        ratios.push_back(double(records[e].size) / double(records[0].size));
    }
    return ratios;
}

void compare(const std::vector<std::string>& files) {
    constexpr double perMB = 1e3 * 1e6;  // seconds a byte to milliseconds a megabyte
    const std::vector<Encoder> encoders = allEncoders();
    Table packing("time to pack", "ms/MB", encoders);
    Table size("size", "share", encoders);
    Table inflating("time to inflate", "ms/MB", encoders);
    for (const std::string& file : files) {
        const std::vector<ZipChunk> chunks = readZipChunks(file, kChunks);
        const std::vector<Record> records = measure(encoders, chunks);
        const Record& first = records[0];
        const std::string name = std::filesystem::path(file).stem().string();
        std::size_t bytes = 0;
        for (const ZipChunk& chunk : chunks) bytes += chunk.bytes.size();
        packing.addRow(name, median(first.packing) * perMB, timeRatios(records, &Record::packing));
        size.addRow(name, double(first.size) / double(bytes), sizeRatios(records));
        inflating.addRow(name, median(first.inflating) * perMB,
                         timeRatios(records, &Record::inflating));
    }
    fmt::print("libdeflate {}, zlib {}\n", LIBDEFLATE_VERSION_STRING, zlibVersion());
    packing.print();
    size.print();
    inflating.print();
}

}  // namespace
}  // namespace specbake::bench

int main(int argc, char** argv) try {
    if (argc < 2) {
        fmt::print(stderr, "usage: deflate_bench FILE...\n");
        return 2;
    }
    specbake::bench::compare({argv + 1, argv + argc});
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "deflate_bench: {}\n", error.what());
    return 1;
}

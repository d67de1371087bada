#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>

#include <cstdint>

using namespace specbake::testing;

namespace {

using Names = std::vector<std::string>;

void checkRefused(const Outcome& outcome, const std::string& says) {
    CAPTURE(says);
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == 1);
    CHECK(outcome.signal == 0);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
}

std::string little(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += char(value >> (8 * i));
    return text;
}

/// A TGA's header alone: 24 bits a pixel (Truevision TGA 2.0, table 3).
std::string targaOfSize(int width, int height) {
    return std::string("\0\0\2\0\0\0\0\0", 8) + little(0, 4) + little(std::uint64_t(width), 2) +
           little(std::uint64_t(height), 2) + std::string("\x18\0", 2) + std::string(2000, '\0');
}

/// Half R, G, B of one wide row.
std::string wideImage(const Scratch& scratch, int width) {
    const std::string path = scratch.path("wide.png");
    const OIIO::ImageSpec spec(width, 1, 3, OIIO::TypeUInt8);
    writeImage(path, spec, std::vector<float>(std::size_t(width) * 3, 0.5F));
    return path;
}

/// Of an EXR whose header begins with the attribute, as it is in the file.
Outcome bakeWithAttribute(const Scratch& scratch, const std::string& attribute) {
    std::string exr = contentsOf(testImage("tiled_offset.exr"));
    exr.insert(8, attribute);
    writeFile(scratch.path("with.exr"), exr);
    return runTool({"bake", scratch.path("with.exr"), "-o", scratch.path("o.exr"), "-q"});
}

}  // namespace

TEST_SUITE_BEGIN("limits");

TEST_CASE("--max-pixels holds for every reader, to the pixel") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    for (const std::string& image : testImages()) {
        CAPTURE(image);
        if (image == "1x1.png") continue;
        checkRefused(runTool({"bake", testImage(image), "-o", output, "-q", "--max-pixels", "1"}),
                     "more than the limit of 1 (--max-pixels)");
    }
    const std::string image = testImage("17x33.png");
    CHECK(runTool({"bake", image, "-o", output, "--max-pixels", "561"}).exitCode == 0);
    checkRefused(runTool({"bake", image, "-o", output, "--max-pixels", "560"}), "561 pixels");
    checkRefused(runTool({"inspect", output, "--max-pixels", "560"}), "561 pixels");
    checkRefused(runTool({"verify", output, image, "--max-pixels", "560"}), "561 pixels");
    checkRefused(runTool({"relight", output, "-o", scratch.path("o.png"), "--max-pixels", "560"}),
                 "561 pixels");
}

TEST_CASE("--max-memory refuses what cannot be done with less") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    const std::string image = wideImage(scratch, 20000);
    checkRefused(runTool({"bake", image, "-o", output, "--max-memory", "5M"}), "--compression");
    CHECK(runTool({"bake", image, "-o", output, "--max-memory", "100M"}).exitCode == 0);
    const std::string whole = contentsOf(output);
    CHECK(runTool({"bake", image, "-o", output, "--max-memory", "12M", "-j", "64"}).exitCode == 0);
    CHECK(contentsOf(output) == whole);
    checkRefused(runTool({"bake", testImage("rgb8.tif"), "-o", output, "--max-memory", "100"}),
                 "--max-memory");
}

TEST_CASE("a header's word alone costs nothing") {
    const Scratch scratch;
    writeFile(scratch.path("claims.tga"), targaOfSize(65535, 65535));
    checkRefused(runTool({"bake", scratch.path("claims.tga"), "-o", scratch.path("o.exr")}),
                 "its header claims 12.9 GB, which a file of 2.02 kB cannot hold");

    checkRefused(bakeWithAttribute(scratch, std::string("a\0opaque\0\xff\xff\xff\x7f", 13)),
                 "damaged: an attribute claims 2.15 GB, which the file does not have");
}

TEST_CASE("an EXR's attributes take what their types say") {
    using namespace std::string_literals;
    const Scratch scratch;
    // Whoever goes by the type, as OpenEXR's C++ reader does, finds one more attribute within.
    const std::string within = "b\0opaque\0\xff\xff\xff\x7f"s;
    const std::string seventeen = "\x11\0\0\0"s;
    const std::string noText = "\0\0\0\0"s;
    const std::string widthAndHeight = "\x02\0\0\0\x01\0\0\0"s;
    for (const std::string& attribute : {
             "a\0int\0"s + seventeen + noText + within,
             "a\0chlist\0\x0e\0\0\0\0"s + within,
             "a\0preview\0\x15\0\0\0"s + widthAndHeight + within,
             "a\0stringvector\0\x04\0\0\0\xff\xff\xff\x7f"s,
         }) {
        CAPTURE(attribute);
        checkRefused(bakeWithAttribute(scratch, attribute), "which its type contradicts");
    }
    for (const std::string& attribute : {
             "a\0int\0\x04\0\0\0"s + noText,
             "a\0preview\0\x10\0\0\0"s + widthAndHeight + "rgbargba"s,
             "a\0stringvector\0\x0d\0\0\0\x01\0\0\0x\x04\0\0\0text"s,
         }) {
        CAPTURE(attribute);  // the chunks are no longer where the file says: that is refused
        CHECK(bakeWithAttribute(scratch, attribute).err.find("attribute") == std::string::npos);
    }
}

TEST_CASE("sides and tiles beyond all bounds cost nothing") {
    using namespace std::string_literals;
    const Scratch scratch;
    const auto refused = [&](const std::string& attribute, const std::string& value,
                             const std::string& says) {
        std::string exr = contentsOf(testImage("tiled_offset.exr"));
        exr.replace(exr.find(attribute) + attribute.size(), value.size(), value);
        writeFile(scratch.path("odd.exr"), exr);
        const Names bake = {"bake", scratch.path("odd.exr"), "-o", scratch.path("o.exr"), "-q"};
        checkRefused(runTool(bake), says);
    };
    refused("dataWindow\0box2i\0\x10\0\0\0"s, "\0\0\0\0\0\0\0\0\xff\xff\xff\x6f"s,
            "a side of more than");
    refused("tiles\0tiledesc\0\x09\0\0\0"s, "\xff\xff\xff\x7f\xff\xff\xff\x7f"s, "--max-memory");
    refused("tiles\0tiledesc\0\x09\0\0\0"s, "\0\x40\0\0\0\x40\0\0"s,
            "its header claims 1.61 GB, which a file of 3.87 kB cannot hold");
}

TEST_CASE("more threads than there is room for are not begun") {
    const Scratch scratch;
    const Names bake = {"bake", testImage("17x33.png"), "-o", scratch.path("o.exr"), "-j", "1024"};
    CHECK(runTool(bake).exitCode == 0);
#if !defined(__SANITIZE_ADDRESS__)
    const std::string whole = contentsOf(scratch.path("o.exr"));
    CHECK(runIn("ulimit -v 1500000", bake).exitCode == 0);
    CHECK(contentsOf(scratch.path("o.exr")) == whole);
    const Outcome little = runIn("ulimit -v 120000", bake);
    CHECK(little.signal == 0);
    CHECK(little.exitCode != 134);
#endif
}

TEST_CASE("what is no amount is refused") {
    for (const char* amount : {"", "0", "0.9", "-1", "nan", "1e30", "12Q", "1 G", "G"}) {
        CAPTURE(amount);
        CHECK(runTool({"inspect", "absent.exr", "--max-memory", amount}).exitCode == 2);
    }
    CHECK(runTool({"inspect", "absent.exr", "--max-memory", "1.5k"}).exitCode == 1);
}

TEST_SUITE_END();

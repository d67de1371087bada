#include "process.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/verify.h>

#include <doctest/doctest.h>

using namespace specbake;
using namespace specbake::testing;

namespace {

/// Every image with every compression, half of them as half: through the library, since starting
/// the program takes longer than its work. spectral_file_test.cpp bakes each image once by the
/// program.
Verification bakedAndVerified(const std::string& image, const StorageOptions& storage) {
    const Scratch scratch;
    BakeOptions options;
    options.storage = storage;
    bake(testImage(image), scratch.path("o.exr"), options);
    CHECK(scratch.names() == std::vector<std::string>{"o.exr"});
    return verify(scratch.path("o.exr"), testImage(image), {});
}

/// Half keeps 11 significant bits: each band is off by at most 2⁻¹² of itself (or 2⁻²⁵), and so
/// are X, Y and Z. In the worst case X, Y, Z are off in the directions that move L*, a*, b* most:
/// a* = 500 (f(X/Xn) - f(Y/Yn)) with f the cube root, so by 500/3 · 2 · 2⁻¹² = 0.081 near white.
/// The 81 roundings are independent and mostly cancel; 0.03 is design.md's figure with a margin
/// (its worst of 10⁶ colours is 0.021).
constexpr double kHalfDE2000 = 0.03;

/// Floats round each band by 2⁻²⁵, the blend's weights and their sum by a few 2⁻²⁴ of Y ≤ 1.
constexpr double kFloatXYZ = 1e-6;

}  // namespace

TEST_SUITE_BEGIN("every_image");

TEST_CASE("every test image bakes to half, and verifies") {
    for (const std::string& image : testImages()) {
        CAPTURE(image);
        for (const Compression compression : {Compression::zip, Compression::zips}) {
            CAPTURE(int(compression));
            const Verification v = bakedAndVerified(image, {SampleType::half, compression});
            CHECK(v.texels > 0);
            CHECK(v.maxDE2000 <= kHalfDE2000);
            CHECK(v.outOfRange == 0);
            CHECK(v.outsideSolid == 0);
        }
    }
}

TEST_CASE("every test image bakes to float, and verifies") {
    for (const std::string& image : testImages()) {
        if (image == "demo.png") continue;  // as large as all the others together, ten times over
        CAPTURE(image);
        for (const Compression compression : {Compression::none, Compression::piz}) {
            CAPTURE(int(compression));
            const Verification v = bakedAndVerified(image, {SampleType::float32, compression});
            CHECK(v.maxXYZDifference <= kFloatXYZ);
            CHECK(v.outOfRange == 0);
            CHECK(v.outsideSolid == 0);
        }
    }
}

TEST_CASE("small levels of zip verify too") {
    for (const int level : {1, 4, 12}) {
        CHECK(
            bakedAndVerified("17x33.png", {SampleType::half, Compression::zip, level}).maxDE2000 <=
            kHalfDE2000);
    }
}

TEST_SUITE_END();

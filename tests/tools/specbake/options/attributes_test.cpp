#include "process.h"
#include "read_back.h"

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenImageIO/texture.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace specbake::testing;

namespace {

using Names = std::vector<std::string>;

OIIO::ImageSpec bakedWith(const Scratch& scratch, Names options) {
    options.insert(options.begin(),
                   {"bake", "-q", testImage("rgb8.png"), "-o", scratch.path("o.exr")});
    const Outcome outcome = runTool(options);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return ReadBack(scratch.path("o.exr")).spec;
}

/// The first channel of the file where a renderer looks it up, by OpenImageIO's texture system with
/// the wrap mode that the file names.
float lookedUp(const std::string& path, float s, float t) {
    // The shared one: OpenImageIO 2.4.7 deletes one of one's own by a wrong size.
    OIIO::TextureSystem* const system = OIIO::TextureSystem::create(true);
    system->invalidate(OIIO::ustring(path));
    OIIO::TextureOpt options;
    options.interpmode = OIIO::TextureOpt::InterpClosest;
    float value = -1;
    REQUIRE(system->texture(OIIO::ustring(path), options, s, t, 0, 0, 0, 0, 1, &value));
    return value;
}

/// By OpenEXR: OpenImageIO hides marks of files that its own programs have not written. "": none.
std::string headerText(const std::string& path, const char* name) {
    const Imf::InputFile file(path.c_str());
    const auto* found = file.header().findTypedAttribute<Imf::StringAttribute>(name);
    return found == nullptr ? "" : found->value();
}

}  // namespace

TEST_SUITE_BEGIN("attributes");

TEST_CASE("--attrib writes an int, a float or a string, as another program reads them") {
    const Scratch scratch;
    const OIIO::ImageSpec spec =
        bakedWith(scratch, {"--attrib", "frame", "-12",         "--attrib", "focus",     "2.5e-1",
                            "--attrib", "owner", "A. Lovelace", "--attrib", "tag",       "12th",
                            "--attrib", "big",   "99999999999", "--attrib", "Copyright", "",
                            "--attrib", "not",   "nan"});
    CHECK(spec.find_attribute("frame")->type() == OIIO::TypeInt);
    CHECK(spec.get_int_attribute("frame") == -12);
    CHECK(spec.find_attribute("focus")->type() == OIIO::TypeFloat);
    CHECK(spec.get_float_attribute("focus") == 0.25F);
    CHECK(spec.get_string_attribute("tag") == "12th");
    CHECK(spec.get_float_attribute("big") == 99999999999.0F);
    CHECK(spec.get_string_attribute("not") == "nan");
    CHECK(spec.get_string_attribute("Copyright") == "A. Lovelace");  // OpenImageIO's word for owner
}

TEST_CASE("the last word on a name holds, against the texture's own too") {
    const Scratch scratch;
    const Names twice = {"--attrib", "Artist", "first", "--attrib", "Artist", "second"};
    CHECK(bakedWith(scratch, twice).get_string_attribute("Artist") == "second");
}

TEST_CASE("names that have a meaning already are refused") {
    const Scratch scratch;
    for (const char* name : {"", "specbake:grid", "oiio:SHA-1", "spectralLayoutVersion", "channels",
                             "dataWindow", "compression", "openexr:dwaCompressionLevel",
                             "a.name.that.is.longer.than.an.EXR.holds"}) {
        CAPTURE(name);
        const Outcome outcome = runTool(
            {"bake", testImage("1x1.png"), "-o", scratch.path("o.exr"), "--attrib", name, "1"});
        CHECK(outcome.exitCode == 2);
        CHECK(linesOf(outcome.err).size() == 1);
    }
    CHECK(scratch.names().empty());
}

TEST_CASE("oiio:SHA-1 of tiled files tells bakes apart that have other pixels, and those alone") {
    const Scratch scratch;
    const auto hash = [&](Names options) {
        options.insert(options.begin(), {"--tile", "16", "16"});
        bakedWith(scratch, options);
        return headerText(scratch.path("o.exr"), "oiio:SHA-1");
    };
    const std::string first = hash({});
    CHECK(first.size() == 40);
    CHECK(first.find_first_not_of("0123456789ABCDEF") == std::string::npos);
    CHECK(hash({}) == first);
    CHECK(hash({"-j", "1"}) == first);
    for (const Names& options : {Names{"--illuminant", "A"}, Names{"--bits", "7"},
                                 Names{"--observer", "10"}, Names{"--mipmap"}}) {
        CHECK(hash(options) != first);
    }
    bakedWith(scratch, {});
    CHECK(headerText(scratch.path("o.exr"), "oiio:SHA-1").empty());
}

TEST_CASE("OpenImageIO's texture system knows the average colour of a file with mip levels") {
    const Scratch scratch;
    const OIIO::ImageSpec spec = bakedWith(scratch, {"--mipmap", "-d", "float"});
    OIIO::TextureSystem* const system = OIIO::TextureSystem::create(true);
    system->invalidate(OIIO::ustring(scratch.path("o.exr")));
    std::vector<float> average(std::size_t(spec.nchannels), -1.0F);
    REQUIRE(system->get_texture_info(
        OIIO::ustring(scratch.path("o.exr")), 0, OIIO::ustring("averagecolor"),
        OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, spec.nchannels), average.data()));
    const ReadBack all(scratch.path("o.exr"));
    for (std::size_t c = 0; c < average.size(); ++c) {
        double sum = 0;
        for (std::size_t at = c; at < all.samples.size(); at += average.size()) {
            sum += double(all.samples[at]);
        }
        const double mean = sum * double(average.size()) / double(all.samples.size());
        // A rounding to float in each of at most 8 levels.
        CHECK(std::abs(double(average[c]) - mean) <= 8 * 0x1p-24 * mean);
    }
}

TEST_CASE("tiled files have the marks that maketx writes") {
    const Scratch scratch;
    const std::string made = scratch.path("m.exr");
    const std::string maketx = "maketx " + testImage("rgb8.png") + " -o " + made;
    REQUIRE(std::system((maketx + " > /dev/null").c_str()) == 0);
    const OIIO::ImageSpec theirs = ReadBack(made).spec;
    const OIIO::ImageSpec ours = bakedWith(scratch, {"--mipmap"});
    for (const char* name : {"textureformat", "wrapmodes"}) {
        CAPTURE(name);
        REQUIRE(!theirs.get_string_attribute(name).empty());
        CHECK(ours.get_string_attribute(name) == theirs.get_string_attribute(name));
    }
    CHECK(bakedWith(scratch, {}).get_string_attribute("wrapmodes").empty());
    CHECK(bakedWith(scratch, {"--mipmap", "--wrap", "clamp,mirror"})
              .get_string_attribute("wrapmodes") == "clamp,mirror");
    const Outcome wrong = runTool({"bake", testImage("1x1.png"), "-o", made, "--wrap", "round"});
    CHECK(wrong.exitCode == 2);
}

TEST_CASE("OpenImageIO's texture system continues a texture as --wrap says") {
    const Scratch scratch;
    const std::string path = scratch.path("o.exr");
    bakedWith(scratch, {"--mipmap", "--wrap", "periodic,mirror"});
    const float inside = lookedUp(path, 0.3F, 0.2F);
    CHECK(inside > 0);
    CHECK(lookedUp(path, 1.3F, 0.2F) == inside);
    CHECK(lookedUp(path, 0.3F, -0.2F) == inside);
    bakedWith(scratch, {"--mipmap"});
    CHECK(lookedUp(path, 0.3F, 0.2F) == inside);
    CHECK(lookedUp(path, 1.3F, 0.2F) == 0);
}

TEST_CASE("attributes are part of what -u compares") {
    const Scratch scratch;
    const Names bake = {"bake", testImage("1x1.png"), "-o", scratch.path("o.exr"), "-u", "-v"};
    const auto isCurrent = [&](const Names& more) {
        Names words = bake;
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = runTool(words);
        REQUIRE(outcome.exitCode == 0);
        return outcome.out.find("is up to date") != std::string::npos;
    };
    CHECK(!isCurrent({"--attrib", "shot", "7"}));
    CHECK(isCurrent({"--attrib", "shot", "7"}));
    CHECK(!isCurrent({"--attrib", "shot", "8"}));
    CHECK(!isCurrent({}));
}

TEST_SUITE_END();

#include "support/csv.h"
#include "support/temporary_file.h"

#include <specbake/core/error.h>
#include <specbake/core/wavelengths.h>
#include <specbake/image/measured_file.h>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::testing;
using namespace std::string_literals;

namespace {

MeasuredFile readText(const std::string& text) {
    const TemporaryFile file(text, ".csv");
    return readMeasuredFile(file.path());
}

bool isRefused(const std::string& text, const std::string& reason) {
    const TemporaryFile file(text, ".csv");
    try {
        (void)readMeasuredFile(file.path());
    } catch (const FileError& error) {
        const std::string what = error.what();
        CAPTURE(what);
        CHECK(what.find(file.path()) != std::string::npos);
        CHECK(what.find(reason) != std::string::npos);
        return true;
    }
    return false;
}

bool hasNote(const MeasuredFile& file, const std::string& words) {
    for (const std::string& note : file.notes) {
        if (note.find(words) != std::string::npos) return true;
    }
    return false;
}

/// 'red' and 'blue, dark' at 400, 500 and 600 nm, as instruments and programs write them.
const std::vector<std::string> kLayouts = {
    "# a comment\nname,400,500,600\nred,0.1,0.2,0.7\n\"blue, dark\",0.5,0.25,0.125\n",
    "name,400 nm,500 nm,600 nm\r\nred,0.1,0.2,0.7\r\n\"blue, dark\",0.5,0.25,0.125\r\n",
    "\xEF\xBB\xBFname;400;500;600\nred;0,1;0,2;0,7\n\"blue, dark\";0,5;0,25;0,125",
    "ID\tname\tR_400\tR_500\tR_600\n1\tred\t0.1\t0.2\t0.7\n2\tblue, dark\t0.5\t0.25\t0.125\n",
    "wavelength,red,\"blue, dark\"\n400,0.1,0.5\n500,0.2,0.25\n600,0.7,0.125\n",
    "wavelength,red,\"blue, dark\",\n600,0.7,0.125,\n500,0.2,0.25,\n400,0.1,0.5,\n",
    "name,400,500,600\nred,10,20,70\n\"blue, dark\",50,25,12.5\n",
    "CGATS.17\nORIGINATOR \"a spectrometer\"\nNUMBER_OF_FIELDS 6\nBEGIN_DATA_FORMAT\n"
    "SAMPLE_ID SAMPLE_NAME LAB_L SPECTRAL_NM400 SPECTRAL_NM500 SPECTRAL_NM600\n"
    "END_DATA_FORMAT\nNUMBER_OF_SETS 2\nBEGIN_DATA\n1 \"red\" 50.1 0.1 0.2 0.7\n"
    "2 \"blue, dark\" 40.2 0.5 0.25 0.125\nEND_DATA\n",
    "CTI3   \n\nKEYWORD \"SPECTRAL_BANDS\"\nSPECTRAL_BANDS \"3\"\nSPECTRAL_NORM \"100.0\"\n"
    "BEGIN_DATA_FORMAT\nSAMPLE_ID\tSAMPLE_LOC\tSPEC_400\tSPEC_500\tSPEC_600\nEND_DATA_FORMAT\n"
    "BEGIN_DATA\n1\tred\t10\t20\t70\n2\t\"blue, dark\"\t50\t25\t12.5\nEND_DATA\n",
    "CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_NAME nm400 nm500 nm600\nEND_DATA_FORMAT\nBEGIN_DATA\n"
    "red 0.1 0.2 0.7\n\"blue, dark\" 0.5 0.25 0.125\nEND_DATA\n"};

}  // namespace

TEST_CASE("the same samples in every layout") {
    for (const std::string& text : kLayouts) {
        CAPTURE(text);
        const MeasuredFile file = readText(text);
        REQUIRE(file.samples.size() == 2);
        CHECK(file.samples[0].name == "red");
        CHECK(file.samples[1].name == "blue, dark");
        CHECK(hasNote(file, "from 400 to 600 nm: extended flat"));
        for (std::size_t m = 0; m < kBandCount; ++m) {
            const double nm = wavelength(int(m));
            const double at = std::min(std::max(nm, 400.0), 600.0);
            const double red = at < 500 ? 0.1 + (at - 400) * 1e-3 : 0.2 + (at - 500) * 5e-3;
            const double blue = at < 500 ? 0.5 - (at - 400) * 2.5e-3 : 0.25 - (at - 500) * 1.25e-3;
            CHECK(std::abs(file.samples[0].reflectance[m] - red) <= 4 * 0x1p-53);
            CHECK(std::abs(file.samples[1].reflectance[m] - blue) <= 4 * 0x1p-53);
        }
    }
}

TEST_CASE("the chart of the project is read as its own reader reads it, without a remark") {
    const auto rows = readCsv("data/colorchecker_24.csv");
    const MeasuredFile file = readMeasuredFile(SPECBAKE_SOURCE_DIR "/data/colorchecker_24.csv");
    CHECK(file.notes.empty());
    REQUIRE(file.samples.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(file.samples[i].name == rows[i][0]);
        for (std::size_t m = 0; m < kBandCount; ++m) {
            CHECK(file.samples[i].reflectance[m] == std::stod(rows[i][m + 1]));
        }
    }
}

TEST_CASE("names that end in numbers are names where rows are wavelengths") {
    const MeasuredFile file =
        readText("nm,NCS1050,NCS2060,paint 300\n380,.1,.2,.3\n780,.1,.2,.3\n");
    REQUIRE(file.samples.size() == 3);
    CHECK(file.samples[1].name == "NCS2060");
    CHECK(file.samples[2].reflectance == constantSpectrum(0.3));
    CHECK(readText("380,0.25\n780,0.25").samples.at(0).name == "sample 1");
}

TEST_CASE("what leaves [0, 1] a little is held there, and more is refused") {
    const MeasuredFile file = readText("name,380,780\na,-0.01,1.04\nb,0.1,0.2\n");
    CHECK(file.samples.at(0).reflectance[0] == 0);
    CHECK(file.samples.at(0).reflectance[80] == 1);
    CHECK(hasNote(file, "1 samples leave [0, 1]"));
    CHECK(hasNote(readText("name,380,780\na,10,90\n"), "percent"));
    CHECK(isRefused("name,380,780\nfluorescent,0.5,1.3\n", "'fluorescent' is 1.05"));
    CHECK(isRefused("name,380,780\na,nan,0.5\n", "'a' is nan"));
    CHECK(isRefused("name,380,780\na,0.5,inf\n", "no reflectance"));
}

TEST_CASE("what is no table is refused with the file, and the line where there is one") {
    CHECK(isRefused("", "no spectra"));
    CHECK(isRefused("# nothing\n\n", "no spectra"));
    CHECK(isRefused("name,value\na,1\n", "line 2: no number: a"));
    CHECK(isRefused("name,380,385\n", "no spectra"));
    CHECK(isRefused("name,380,385\na,0.1\n", "line 2: fewer values than the heading has"));
    CHECK(isRefused("name,380,385\na,0.1,x\n", "line 2: no number: x"));
    CHECK(isRefused("name,380,385,383\na,0.1,0.1,0.1\n", "do not ascend"));
    CHECK(isRefused("nm,a\n1,0.1\n2,0.1\n", "no wavelength in nm"));
    CHECK(isRefused("CGATS.17\nBEGIN_DATA_FORMAT\nnm400 nm500\nBEGIN_DATA\n", "each from BEGIN"));
    CHECK(isRefused("BEGIN_DATA\nEND_DATA\nBEGIN_DATA_FORMAT\nEND_DATA_FORMAT\n", "from BEGIN"));
    CHECK(isRefused("BEGIN_DATA_FORMAT\nEND_DATA_FORMAT\nBEGIN_DATA\nEND_DATA\n", "no spectra"));
    CHECK(isRefused(std::string(1000, '\0'), "no spectra"));
    CHECK_THROWS_AS((void)readMeasuredFile("/no/such/file.csv"), FileError);
    CHECK_THROWS_AS((void)readMeasuredFile("/"), FileError);
}

TEST_CASE("sizes are bounded") {
    CHECK_THROWS_AS((void)readMeasuredFile("/dev/zero"), FileError);
    std::string many = "name,380,780\n";
    for (std::size_t i = 0; i <= kMostSamples; ++i) many += "s,0.1,0.2\n";
    CHECK(isRefused(many, "of at most 2000"));
    CHECK(isRefused("name" + std::string(20'000, ',') + "\n", "too many cells"));
    std::string wide = "nm";
    for (std::size_t i = 0; i <= kMostSamples; ++i) wide += ",s";
    CHECK(isRefused(wide + "\n", "of at most 2000"));
}

TEST_CASE("a damaged file is refused or is reflectances: 5000 of them") {
    std::mt19937 random(81);
    const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
    const std::string signs = "0123456789.,;\t\n\r\"' #-eEnm\0\xFF"s;
    for (int i = 0; i < 5000; ++i) {
        std::string text = kLayouts[below(kLayouts.size())];
        for (std::size_t hits = 1 + below(6); hits > 0; --hits) {
            const std::size_t at = below(text.size());
            if (below(3) == 0)
                text.erase(at, 1 + below(20));
            else if (below(2) == 0)
                text.insert(at, 1, signs[below(signs.size())]);
            else
                text[at] = signs[below(signs.size())];
            if (text.empty()) break;
        }
        CAPTURE(text);
        try {
            for (const MeasuredSample& sample : readText(text).samples) {
                for (const double value : sample.reflectance) REQUIRE((value >= 0 && value <= 1));
            }
        } catch (const FileError&) {
            continue;
        }
    }
}

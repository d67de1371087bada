#include "process.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

using namespace specbake::testing;

namespace {

using Names = std::vector<std::string>;

const Names kCommands = {"bake",  "solve",  "region",     "inspect", "relight",
                         "table", "verify", "completion", "manual"};

/// Standard output of the program in a terminal of so many columns.
std::string helpAt(const char* columns, const Names& words) {
    setenv("COLUMNS", columns, 1);
    const Outcome outcome = runTool(words);
    unsetenv("COLUMNS");
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
}

std::size_t characters(const std::string& line) {
    return std::size_t(std::count_if(line.begin(), line.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

std::size_t widest(const std::string& text) {
    std::size_t most = 0;
    for (const std::string& line : linesOf(text)) most = std::max(most, characters(line));
    return most;
}

std::multiset<std::string> wordsOf(const std::string& text) {
    std::multiset<std::string> words;
    std::string word;
    for (const char c : text + ' ') {
        if (c != ' ' && c != '\n') {
            word += c;
        } else if (!word.empty()) {
            words.insert(word);
            word.clear();
        }
    }
    return words;
}

/// What bash offers for the last of these words.
std::set<std::string> completed(const Scratch& scratch, const std::string& words) {
    const std::string script = scratch.path("completions");
    const std::string out = scratch.path("out");
    const std::string command = "bash -c 'source " + script + "; COMP_WORDS=(specbake " + words +
                                "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _specbake; "
                                "printf \"%s\\n\" \"${COMPREPLY[@]}\"' > " +
                                out;
    REQUIRE(std::system(command.c_str()) == 0);
    std::set<std::string> offered;
    for (const std::string& line : linesOf(contentsOf(out))) {
        if (!line.empty()) offered.insert(line);
    }
    return offered;
}

}  // namespace

TEST_SUITE_BEGIN("help");

TEST_CASE("help is never wider than the terminal, and says the same at every width") {
    for (const std::string& command : kCommands) {
        CAPTURE(command);
        const std::string wide = helpAt("100", {command, "--help"});
        CHECK(widest(wide) <= 100);
        for (const char* columns : {"60", "80", "99"}) {
            const std::string narrow = helpAt(columns, {command, "--help"});
            CHECK(widest(narrow) <= std::size_t(std::atoi(columns)));
            CHECK(wordsOf(narrow) == wordsOf(wide));
        }
        CHECK(widest(helpAt("40", {command, "--help"})) <= 40);
    }
    CHECK(widest(helpAt("50", {"--help"})) <= 50);
}

TEST_CASE("help has groups, and two examples of each command that makes something") {
    for (const std::string& command : kCommands) {
        CAPTURE(command);
        const Names lines = linesOf(helpAt("100", {command, "--help"}));
        if (command == "completion" || command == "manual") continue;
        const std::string begin = "  specbake " + command + " ";
        CHECK(std::count_if(lines.begin(), lines.end(),
                            [&](const std::string& line) { return line.starts_with(begin); }) == 2);
    }
    const std::string bake = helpAt("80", {"bake", "--help"});
    for (const char* group : {"\nWhat is read:\n", "\nColours and spectra:\n",
                              "\nWhat is written:\n", "\nHow it is done:\n"}) {
        CHECK(bake.find(group) != std::string::npos);
    }
}

TEST_CASE("a misspelt command or option is told what was probably meant") {
    struct Case {
        Names words;
        std::string says;
    };
    for (const Case& c :
         {Case{{"bkae", "a.png"}, "there is no command 'bkae'; did you mean 'bake'?"},
          Case{{"verfy"}, "did you mean 'verify'?"},
          Case{{"frobnicate"}, "there is no command 'frobnicate' ("},
          Case{{"bake", "a.png", "-o", "o.exr", "--thread", "2"}, "did you mean '--threads'?"},
          Case{{"bake", "a.png", "-o", "o.exr", "--iluminant=A"}, "did you mean '--illuminant'?"},
          Case{{"bake", "a.png", "-o", "o.exr", "--mip-map"}, "did you mean '--mipmap'?"},
          Case{{"bake", "a.png", "-o", "o.exr", "--zzz"}, "bake has no option --zzz ("}}) {
        const Outcome outcome = runTool(c.words);
        CAPTURE(outcome.err);
        CHECK(outcome.exitCode == 2);
        CHECK(linesOf(outcome.err).size() == 1);
        CHECK(outcome.err.find(c.says) != std::string::npos);
    }
}

TEST_CASE("bash completes commands, options and their words") {
    const Scratch scratch;
    writeFile(scratch.path("completions"), runTool({"completion", "bash"}).out);
    CHECK(completed(scratch, "ver") == std::set<std::string>{"verify"});
    CHECK(completed(scratch, "bake --comp") == std::set<std::string>{"--compression"});
    CHECK(completed(scratch, "bake --data-type ha") == std::set<std::string>{"half"});
    CHECK(completed(scratch, "bake -d flo") == std::set<std::string>{"float"});
    CHECK(completed(scratch, "bake wood").empty());
    CHECK(runTool({"completion", "tcsh"}).exitCode == 2);
    for (const char* shell : {"zsh", "fish"}) {
        CHECK(runTool({"completion", shell}).out.find("max-deviation") != std::string::npos);
    }
}

TEST_CASE("a page of the manual has every option of the help") {
    for (const std::string& command : kCommands) {
        CAPTURE(command);
        std::string page = runTool({"manual", command}).out;
        page.erase(std::remove(page.begin(), page.end(), '\\'), page.end());
        CHECK(page.starts_with(".TH "));
        for (const std::string& word : wordsOf(helpAt("100", {command, "--help"}))) {
            const std::string option = word.substr(0, word.find_first_of(",=.;:)`'"));
            if (!option.starts_with("--")) continue;
            CAPTURE(option);
            CHECK(page.find(option) != std::string::npos);
        }
    }
    CHECK(runTool({"manual"}).out.find("specbake\\-verify") != std::string::npos);
    CHECK(runTool({"manual", "boil"}).exitCode == 2);
}

TEST_CASE("SPECBAKE_THREADS stands for --threads") {
    setenv("SPECBAKE_THREADS", "many", 1);
    CHECK(runTool({"bake", testImage("1x1.png"), "-o", "/dev/null/o.exr"}).exitCode == 2);
    setenv("SPECBAKE_THREADS", "2", 1);
    const Scratch scratch;
    CHECK(runTool({"bake", testImage("1x1.png"), "-o", scratch.path("o.exr")}).exitCode == 0);
    unsetenv("SPECBAKE_THREADS");
}

TEST_CASE("options that contradict each other, or are no numbers, are refused") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    for (const Names& options :
         {Names{"--bits", "7", "--max-de", "1"}, Names{"--grid", "33", "--max-deviation", "0.01"},
          Names{"--bits", "7", "-d", "float"}, Names{"--max-de", "1", "-d", "float"},
          Names{"--per-texel", "--grid", "9"}, Names{"--per-texel", "--max-deviation", "0.01"},
          Names{"--max-de", "nan"}, Names{"--max-deviation", "nan"}, Names{"--max-de", "inf"},
          Names{"-v", "-q"}}) {
        CAPTURE(options);
        Names words = {"bake", testImage("1x1.png"), "-o", output};
        words.insert(words.end(), options.begin(), options.end());
        const Outcome outcome = runTool(words);
        CHECK(outcome.exitCode == 2);
        CHECK(linesOf(outcome.err).size() == 1);
    }
    CHECK(scratch.names().empty());
    REQUIRE(runTool({"bake", testImage("1x1.png"), "-o", output}).exitCode == 0);
    CHECK(runTool({"verify", output, testImage("1x1.png"), "--max-de", "nan"}).exitCode == 2);
    CHECK(runTool({"relight", output, "-o", scratch.path("p.png"), "--exposure", "nan"}).exitCode ==
          2);
    const std::string plot = scratch.path("plot.png");
    CHECK(runTool({"inspect", output, "--at", "0", "0", "--plot", plot}).exitCode == 2);
    CHECK(scratch.names() == Names{"o.exr"});
}

TEST_SUITE_END();

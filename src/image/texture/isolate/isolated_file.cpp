#include "texture/isolate/isolated_file.h"

#include "file/input_stream.h"
#include "texture/isolate/reader_process.h"
#include "texture/isolate/wire.h"
#include "texture/plain/exr_input.h"

#include <specbake/core/error.h>
#include <specbake/image/isolation.h>
#include <specbake/image/limits.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

namespace specbake {

using namespace internal;

namespace {

struct Setting {
    Isolation isolation = Isolation::never;
    std::vector<std::string> program;
};

/// Set before there are threads.
Setting& setting() {
    static Setting only;
    return only;
}

}  // namespace

std::optional<Isolation> isolationFromName(std::string_view name) {
    if (name == "auto") return Isolation::automatic;
    if (name == "always") return Isolation::always;
    if (name == "never") return Isolation::never;
    return {};
}

void setIsolation(Isolation isolation, std::vector<std::string> program) {
    setting() = {isolation, std::move(program)};
}

}  // namespace specbake

namespace specbake::internal {
namespace {

/// Readers that have stood up to hostile files.
bool isHammered(const std::string& path) {
    using namespace std::string_literals;
    static const std::array signatures = {"\x89PNG\r\n\x1a\n"s,
                                          "\xff\xd8\xff"s,
                                          std::string(kExrSignature),
                                          "II*\0"s,
                                          "MM\0*"s,
                                          "II+\0"s,
                                          "MM\0+"s};
    for (const std::string& signature : signatures) {
        if (beginsWith(path, signature)) return true;
    }
    return false;
}

/// A request's answer. Throws FileError if it is a failure, WireError for what is none.
void checkAnswer(Message& answer, const std::string& path) {
    if (answer.take<int>() == int(Answer::done)) return;
    throw FileError(path, answer.takeText());
}

class IsolatedFile : public ImageFile {
  public:
    IsolatedFile(std::string path, std::unique_ptr<ReaderProcess> reader,
                 ImageDescription description)
        : ImageFile(std::move(description)), path_(std::move(path)), reader_(std::move(reader)) {}

    ~IsolatedFile() override {
        if (alive_) keepIdle(std::move(reader_));
    }

    std::optional<std::string> text(const std::string& attribute) const override {
        return guarded([&] {
            Message().put(int(Request::text)).putText(attribute).send(reader_->socket());
            Message answer = Message::receive(reader_->socket());
            checkAnswer(answer, path_);
            return answer.takeOptionalText();
        });
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override {
        guarded([&] {
            Message()
                .put(int(Request::rows))
                .put(first)
                .put(count)
                .put(int(type))
                .send(reader_->socket());
            Message answer = Message::receive(reader_->socket());
            checkAnswer(answer, path_);
            receiveBytes(reader_->socket(), samples.first(rowBytes(type) * std::size_t(count)));
            return true;
        });
    }

    template <class Work>
    auto guarded(const Work& work) const -> decltype(work()) {
        if (!alive_) throw FileError(path_, "its reader has ended before");
        try {
            return work();
        } catch (const WireError&) {
            alive_ = false;
            throw FileError(path_, reader_->death());
        }
    }

    std::string path_;
    std::unique_ptr<ReaderProcess> reader_;
    mutable bool alive_ = true;
};

}  // namespace

bool isIsolated(const std::string& path) {
    if (setting().isolation == Isolation::never) return false;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    return setting().isolation == Isolation::always || !isHammered(path);
}

std::unique_ptr<ImageFile> openIsolated(const std::string& path,
                                        const std::optional<std::string>& part) {
    std::unique_ptr<ReaderProcess> reader;
    try {
        reader = idleReader(setting().program);
        Message request;
        request.put(int(Request::open)).put(limits()).putText(path).putOptionalText(part);
        request.send(reader->socket());
        Message answer = Message::receive(reader->socket());
        checkAnswer(answer, path);
        ImageDescription description = takeDescription(answer);
        checkSides(path, description.data.width, description.data.height);
        return std::make_unique<IsolatedFile>(path, std::move(reader), std::move(description));
    } catch (const WireError&) {
        throw FileError(path, reader->death());
    } catch (const std::system_error& error) {
        throw FileError(path, "no process can be started to read it: " + error.code().message());
    }
}

}  // namespace specbake::internal

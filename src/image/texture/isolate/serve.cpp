#include "texture/isolate/reader_process.h"
#include "texture/isolate/wire.h"

#include <specbake/core/error.h>
#include <specbake/image/isolation.h>
#include <specbake/image/limits.h>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <new>
#include <utility>

namespace specbake {

using namespace internal;

namespace {

void limit(__rlimit_resource resource, std::uint64_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    now.rlim_cur = std::min<rlim_t>(most, now.rlim_max);
    setrlimit(resource, &now);
}

/// No memory beyond what the file's size explains: a small file may make much of little, but that
/// much. Sanitizers take what they want.
void limitMemory(const std::string& path) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr std::uint64_t free = std::uint64_t(2) << 30;
    constexpr std::uint64_t mostUnpacked = 4096;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    const std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / mostUnpacked / 2;
    const std::uint64_t explained = free + mostUnpacked * std::min<std::uint64_t>(size, most);
    limit(RLIMIT_DATA, std::min(limits().memory + free / 8, explained));
#else
    static_cast<void>(path);
#endif
}

/// "REASON" of "FILE: REASON".
std::string reasonOf(const std::exception& error, const std::string& path) {
    const std::string what = error.what();
    return what.starts_with(path + ": ") ? what.substr(path.size() + 2) : what;
}

class Server {
  public:
    explicit Server(int socket) : socket_(socket) {}

    [[noreturn]] void run() {
        for (;;) answer(Message::receive(socket_));
    }

  private:
    /// What can fail is done before a word of the answer is sent.
    void answer(Message request) {
        Message reply;
        reply.put(int(Answer::done));
        rows_.clear();
        try {
            serve(request, reply);
        } catch (const WireError&) {
            throw;
        } catch (const std::bad_alloc&) {
            return fail("not enough memory to read it");
        } catch (const std::exception& error) {
            return fail(reasonOf(error, path_));
        }
        reply.send(socket_);
        sendBytes(socket_, rows_);
    }

    void fail(const std::string& reason) {
        rows_ = {};
        Message().put(int(Answer::failed)).putText(reason).send(socket_);
    }

    void serve(Message& request, Message& reply) {
        switch (Request(request.take<int>())) {
            case Request::open:
                return open(request, reply);
            case Request::text:
                reply.putOptionalText(file().text(request.takeText()));
                return;
            case Request::rows:
                return read(request);
        }
        throw WireError("no such request");
    }

    void open(Message& request, Message& reply) {
        file_.reset();
        setLimits(request.take<Limits>());
        path_ = request.takeText();
        const auto part = request.takeOptionalText();
        limitMemory(path_);
        file_ = openImageFile(path_, part);
        putDescription(reply, file_->description());
    }

    void read(Message& request) {
        const int first = request.take<int>();
        const int count = request.take<int>();
        const auto type = TexelType(request.take<int>());
        const ImageDescription& d = file().description();
        rows_.resize(std::size_t(d.data.width) * d.channels.size() * bytesPerSample(type) *
                     std::size_t(count));
        file_->readRows(first, count, type, rows_);
    }

    ImageFile& file() {
        if (!file_) throw WireError("no file is open");
        return *file_;
    }

    int socket_;
    std::string path_;
    std::unique_ptr<ImageFile> file_;
    std::vector<std::byte> rows_;
};

}  // namespace

void serveIsolatedReads(int socket) {
    // The terminal's signals are for the other process, which ends this one.
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    try {
        Server(socket).run();
    } catch (const WireError&) {  // the other end is gone
        return;
    }
}

}  // namespace specbake

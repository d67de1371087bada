#include "texture/isolate/wire.h"

#include "target.h"

#include <specbake/core/error.h>

#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace specbake::fuzz {

/// What a reader that a hostile file has taken over could say.
void run(std::span<const std::uint8_t> bytes) {
    std::array<int, 2> ends{};
    constexpr std::size_t most = 60000;  // what a socket takes without being read
    if (bytes.size() > most || socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) return;
    try {
        internal::sendBytes(ends[0], std::as_bytes(bytes));
        close(ends[0]);
        internal::Message message = internal::Message::receive(ends[1]);
        const internal::ImageDescription description = internal::takeDescription(message);
        internal::Message again;
        internal::putDescription(again, description);
    } catch (const internal::WireError&) {  // it says so
    }
    close(ends[1]);
}

}  // namespace specbake::fuzz

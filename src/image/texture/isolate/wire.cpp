#include "texture/isolate/wire.h"

#include <sys/socket.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>

namespace specbake::internal {
namespace {

constexpr std::uint64_t kLongest = std::uint64_t(1) << 28;  // bytes: an ICC profile, metadata

}  // namespace

void sendBytes(int socket, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) throw WireError("the other process does not listen");
        bytes = bytes.subspan(std::size_t(sent));
    }
}

void receiveBytes(int socket, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t received = ::read(socket, bytes.data(), bytes.size());
        if (received < 0 && errno == EINTR) continue;
        if (received <= 0) throw WireError("the other process is gone");
        bytes = bytes.subspan(std::size_t(received));
    }
}

void Message::append(const void* bytes, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(bytes);
    bytes_.insert(bytes_.end(), first, first + count);
}

Message& Message::putText(const std::string& text) {
    put(std::uint64_t(text.size()));
    append(text.data(), text.size());
    return *this;
}

Message& Message::putOptionalText(const std::optional<std::string>& text) {
    put(std::uint8_t(text.has_value()));
    return text ? putText(*text) : *this;
}

const std::byte* Message::next(std::size_t count) {
    if (count > bytes_.size() - at_) throw WireError("a message ends too early");
    const std::byte* value = bytes_.data() + at_;
    at_ += count;
    return value;
}

std::size_t Message::takeCount() {
    const auto count = take<std::uint64_t>();
    if (count > bytes_.size() - at_) throw WireError("a message ends too early");
    return std::size_t(count);
}

std::string Message::takeText() {
    const std::size_t length = takeCount();
    return {reinterpret_cast<const char*>(next(length)), length};
}

std::optional<std::string> Message::takeOptionalText() {
    if (take<std::uint8_t>() == 0) return {};
    return takeText();
}

void Message::send(int socket) const {
    const std::uint64_t length = bytes_.size();
    sendBytes(socket, std::as_bytes(std::span(&length, 1)));
    sendBytes(socket, bytes_);
}

Message Message::receive(int socket) {
    std::uint64_t length = 0;
    receiveBytes(socket, std::as_writable_bytes(std::span(&length, 1)));
    if (length > kLongest) throw WireError("a message too long");
    Message message;
    message.bytes_.resize(std::size_t(length));
    receiveBytes(socket, message.bytes_);
    return message;
}

}  // namespace specbake::internal

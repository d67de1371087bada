#pragma once

#include "texture/image_file.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace specbake::internal {

/// The other end is gone, or says what makes no sense.
class WireError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// All of it. Throws WireError.
void sendBytes(int socket, std::span<const std::byte> bytes);
void receiveBytes(int socket, std::span<std::byte> bytes);

/// Values one behind the other, as this processor stores them: both ends are one program.
class Message {
  public:
    Message() = default;

    template <class T>
    Message& put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
        return *this;
    }
    Message& putText(const std::string& text);
    Message& putOptionalText(const std::optional<std::string>& text);

    /// What comes next. Throws WireError.
    template <class T>
    T take() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        std::memcpy(&value, next(sizeof value), sizeof value);
        return value;
    }
    std::string takeText();
    std::optional<std::string> takeOptionalText();
    /// How many of something follow that take a byte or more each.
    std::size_t takeCount();

    void send(int socket) const;
    static Message receive(int socket);

  private:
    void append(const void* bytes, std::size_t count);
    const std::byte* next(std::size_t count);

    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

void putDescription(Message& message, const ImageDescription& description);

/// What a process says that may be in the hands of a hostile file: throws WireError for what no
/// reader says.
ImageDescription takeDescription(Message& message);

}  // namespace specbake::internal

#pragma once

#include "methods/method.h"
#include "texture.h"

namespace specbake::bench {

/// Bytes of the pixels of the texture's spectral image, half, ZIP at its default level, with the
/// mantissas of all channels rounded to so many bits. Nothing is written. Throws FileError.
double packedBytes(const Texture& texture, const Method& method, int bits);

}  // namespace specbake::bench

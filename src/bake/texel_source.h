#pragma once

#include <specbake/image/texel_decoder.h>

#include <stop_token>

namespace specbake::internal {

/// A texture with what is needed to go through its texels. It refers to the texture and the
/// decoder, which must outlive it.
struct TexelSource {
    Texture& texture;
    const TexelDecoder& decoder;
    int threads = 0;       ///< 0: all cores
    std::stop_token stop;  ///< when stopped, who goes through the texels throws Cancelled

    const TextureInfo& info() const { return texture.info(); }
};

}  // namespace specbake::internal

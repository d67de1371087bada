#include "texture/plain/exr_input.h"

#include "file/input_stream.h"

#include <specbake/core/error.h>
#include <specbake/image/image_types.h>

namespace specbake::internal {
namespace {

void ignoreMessage(exr_const_context_t /*context*/, exr_result_t /*code*/, const char* /*text*/) {}

}  // namespace

ExrInput::ExrInput(std::string path) : path_(std::move(path)) {
    if (!beginsWith(path_, kExrSignature)) return;
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.error_handler_fn = ignoreMessage;
    options.max_image_width = kLargestSide;
    options.max_image_height = kLargestSide;
    options.max_tile_width = kLargestSide;
    options.max_tile_height = kLargestSide;
    exr_context_t context = nullptr;
    if (exr_start_read(&context, path_.c_str(), &options) == EXR_ERR_SUCCESS) {
        context_.reset(context);
    }
}

void ExrInput::check(exr_result_t result) const {
    if (result != EXR_ERR_SUCCESS) {
        throw FileError(path_, exr_get_default_error_message(result));
    }
}

exr_compression_t ExrInput::compression() const {
    exr_compression_t compression{};
    check(exr_get_compression(get(), 0, &compression));
    return compression;
}

}  // namespace specbake::internal

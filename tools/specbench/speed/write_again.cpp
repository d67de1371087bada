/// write_again IN OUT COMPRESSION: reads an image into memory, then writes it anew by OpenImageIO
/// for each line on standard input, and prints the seconds that took. What a bake is held against.
#include <OpenImageIO/imageio.h>

#include <chrono>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Image {
    OIIO::ImageSpec spec;
    std::vector<std::byte> pixels;  ///< as the file has them
};

Image read(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error(OIIO::geterror());
    Image image{input->spec(), std::vector<std::byte>(input->spec().image_bytes())};
    if (!input->read_image(0, 0, 0, image.spec.nchannels, image.spec.format, image.pixels.data())) {
        throw std::runtime_error(input->geterror());
    }
    return image;
}

void write(const std::string& path, const Image& image) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error(OIIO::geterror());
    if (!output->open(path, image.spec) ||
        !output->write_image(image.spec.format, image.pixels.data()) || !output->close()) {
        throw std::runtime_error(output->geterror());
    }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) {
        std::cerr << "usage: write_again IN OUT COMPRESSION\n";
        return 2;
    }
    Image image = read(argv[1]);
    image.spec.attribute("compression", argv[3]);
    std::cout << "ready" << std::endl;
    for (std::string line; std::getline(std::cin, line);) {
        const auto start = std::chrono::steady_clock::now();
        write(argv[2], image);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        std::cout << time.count() << std::endl;
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "write_again: " << error.what() << '\n';
    return 1;
}

#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace nacre {

/// A width x height grid of pixels, row-major, (0, 0) top left: the first row of a file.
///
/// In a LUT the first row is the smallest value of y. The only place that turns (x, y) into an offset.
template <typename Pixel>
class Image {
public:
    Image() = default;
    /// @pre width, height >= 0
    Image(int width, int height, Pixel fill = {})
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {
        assert(width >= 0 && height >= 0);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return pixels_.size(); }

    Pixel& at(int x, int y) { return pixels_[offset(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[offset(x, y)]; }

    Pixel* data() { return pixels_.data(); }
    const Pixel* data() const { return pixels_.data(); }

    auto begin() { return pixels_.begin(); }
    auto end() { return pixels_.end(); }
    auto begin() const { return pixels_.begin(); }
    auto end() const { return pixels_.end(); }

private:
    std::size_t offset(int x, int y) const {
        assert(x >= 0 && x < width_ && y >= 0 && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0;
    int height_ = 0;
    std::vector<Pixel> pixels_;
};

}  // namespace nacre

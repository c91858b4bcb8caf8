#include "nacre/swatch/swatch_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/sampler.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/swatch/smooth_bake.h"

namespace nacre {
namespace {

// A closed form: a million colours take some tenths of a second.
bool is_cheap(const Job& job) {
    return std::holds_alternative<Palette>(job.material.mechanism);
}

// By how much the sides are divided: both of a job with y, else the width.
double panel_reduction(const Job& job, double most_effort) {
    if (is_cheap(job)) return 1.0;
    Sampler sampler(job);
    sampler.at(0.5, 0.5);
    const double pixels = static_cast<double>(job.width) * job.height;
    const double effort = pixels * static_cast<double>(sampler.work().samples) *
                          effort_per_sample(mechanism_at(job, 0.5, 0.5), job.sampling.slices);
    const double ratio = std::max(1.0, effort / most_effort);
    return job.y ? std::sqrt(ratio) : ratio;
}

Xyz mixed(double share, const Xyz& a, const Xyz& b) {
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share), std::lerp(a.z, b.z, share)};
}

// Linear between the pixels of a smaller picture, whose first and last are at the edges as the larger one's.
class Enlarged {
public:
    Enlarged(Image<Xyz> small, int width, int height) : small_(std::move(small)), width_(width), height_(height) {}

    Xyz at(int column, int row) const {
        if (small_.width() == width_ && small_.height() == height_) return small_.at(column, row);
        const auto [left, right, across] = place(column, width_, small_.width());
        const auto [below, above, along] = place(row, height_, small_.height());
        return mixed(along, mixed(across, small_.at(left, below), small_.at(right, below)),
                     mixed(across, small_.at(left, above), small_.at(right, above)));
    }

private:
    struct Place {
        int low, high;
        double share;
    };
    static Place place(int pixel, int many, int few) {
        if (many < 2 || few < 2) return {0, 0, 0.0};
        const double at = static_cast<double>(pixel) * (few - 1) / (many - 1);
        const int low = std::min(static_cast<int>(at), few - 2);
        return {low, low + 1, at - low};
    }

    Image<Xyz> small_;
    int width_;
    int height_;
};

}  // namespace

Panel bake_panel(const Job& job, const PlotArea& area, double most_effort) {
    Job sized = job;
    sized.width = area.width;
    sized.height = job.y ? area.height : 1;
    sized.sampling = choose_sampling(sized, {0.1, 1.0, 0.1, 0.0}).sampling;
    if (const double reduction = panel_reduction(sized, most_effort); reduction > 1.0) {
        constexpr double smallest = 64.0;
        sized.width = static_cast<int>(std::max(area.width / reduction, smallest));
        if (job.y) sized.height = static_cast<int>(std::max(area.height / reduction, smallest));
    }
    const Enlarged baked(is_cheap(sized) ? bake(sized) : bake_smoothly(sized), area.width, job.y ? area.height : 1);
    Panel panel{area.left, area.top, Image<Xyz>(area.width, area.height)};
    for (int row = 0; row < area.height; ++row) {
        const int from_row = job.y ? area.height - 1 - row : 0;
        for (int column = 0; column < area.width; ++column) panel.image.at(column, row) = baked.at(column, from_row);
    }
    return panel;
}

}  // namespace nacre

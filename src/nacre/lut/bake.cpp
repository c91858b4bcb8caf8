#include "nacre/lut/bake.h"

#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/sampler.h"

namespace nacre {

Image<Xyz> bake(const Job& job, const AfterRow& after_row, Work* work) {
    Image<Xyz> image(job.width, job.height);
    Sampler sampler(job);
    for (int row = 0; row < job.height; ++row) {
        const double y = coordinate_of_texel(row, job.height);
        for (int column = 0; column < job.width; ++column) {
            image.at(column, row) = sampler.at(coordinate_of_texel(column, job.width), y);
        }
        if (after_row) after_row();
    }
    if (work != nullptr) {
        *work += sampler.work();
        work->texels += image.size();
    }
    return image;
}

}  // namespace nacre

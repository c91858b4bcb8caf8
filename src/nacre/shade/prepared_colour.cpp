#include "nacre/shade/prepared_colour.h"

#include "nacre/shade/shading.h"

namespace nacre {
namespace {

struct ColourAt {
    const Geometry& geometry;
    Work& work;

    Xyz operator()(PaletteColour& colour) const { return colour.at(geometry.incidence, work); }
    Xyz operator()(LayeredColour& colour) const { return colour.at(geometry.incidence, &work); }
    Xyz operator()(GratingColour& colour) const {
        ++work.spectra;
        work.samples += colour.samples();
        work_of(work.effects, Effect::higher_orders).points += colour.samples_of_higher_orders();
        return colour.at(geometry.grating_u);
    }
    Xyz operator()(ScatterColour& colour) const { return colour.at(geometry.cos_scatter, &work); }
    Xyz operator()(MeasuredColour& colour) const { return colour.at(geometry.incidence, &work); }
};

}  // namespace

PreparedColour prepare_colour(const Mechanism& mechanism, const SpectralSampling& sampling, const Light& light) {
    return shading_of(mechanism).prepare(mechanism, sampling, light);
}

Xyz colour_at(PreparedColour& prepared, const Geometry& geometry, Work& work) {
    return std::visit(ColourAt{geometry, work}, prepared);
}

}  // namespace nacre

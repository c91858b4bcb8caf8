#include "nacre/lut/sampler.h"

#include <cassert>
#include <utility>
#include <variant>

#include "nacre/colour/adaptation.h"
#include "nacre/lut/axis.h"
#include "nacre/lut/job.h"
#include "nacre/material/effects.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/shade/kinks.h"
#include "nacre/shade/palette_colour.h"

namespace nacre {
namespace {

bool is_parameter(const Axis& axis) {
    return !axis.is_angle();
}

// Whether two mechanisms differ in nothing that facets' colours depend on.
bool same_but_for_relief(Mechanism a, const Mechanism& b) {
    a.effects.relief = b.effects.relief;
    return a == b;
}

}  // namespace

Sampler::Sampler(const Job& job)
    : job_(job),
      mechanism_(simulated_at(job, 0.0, 0.0)),
      sampling_(job.sampling),
      prepared_(prepare_colour(mechanism_, sampling_, *job.light)) {
    assert(job.sampling.is_decided() || !samples_spectra(mechanism_));
}

void Sampler::set_parameters(double x, double y) {
    const bool x_moves = is_parameter(job_.x) && last_x_ != x;
    const bool y_moves = job_.y && is_parameter(*job_.y) && last_y_ != y;
    if (!x_moves && !y_moves) return;
    last_x_ = x;
    last_y_ = y;
    auto* palette = std::get_if<PaletteColour>(&prepared_);
    if (palette != nullptr && mechanism_.effects.relief.is_plane()) {
        // Planes and palettes call this a million times, so it copies nothing.
        if (x_moves) job_.x.parameter.set(mechanism_, job_.x.parameter_value(x));    // planning guarantees that the
        if (y_moves) job_.y->parameter.set(mechanism_, job_.y->parameter_value(y));  // axes set different numbers
        remove(job_.without, mechanism_, job_.light->settings.first_nm);
        palette->reset(std::get<Palette>(mechanism_));
        if (facets_.is_made()) facets_ = {};  // of the bands before
        return;
    }
    Mechanism next = simulated_at(job_, x, y);
    const bool only_relief_moves = same_but_for_relief(next, mechanism_);
    mechanism_ = std::move(next);
    if (only_relief_moves) return;
    prepared_ = prepare_colour(mechanism_, sampling_, *job_.light);
    facets_ = {};
}

const Geometry& Sampler::geometry(double x, double y) {
    const double coordinate = job_.x.is_angle() ? x : job_.y && job_.y->is_angle() ? y : 0.0;
    if (last_angle_ != coordinate) {
        geometry_ = geometry_at(job_, x, y);
        last_angle_ = coordinate;
    }
    return geometry_;
}

Lobe Sampler::lobe_at(double x, double y) {
    set_parameters(x, y);
    return std::get<PaletteColour>(prepared_).lobe_at(geometry(x, y).incidence);
}

Xyz Sampler::mean_of_facets(const Incidence& incidence) {
    const Relief& relief = mechanism_.effects.relief;
    EffectWork& effort = work_of(work_.effects, facet_effect(relief));
    if (!facets_.is_made() && sampling_.facets != nullptr) facets_ = *sampling_.facets;
    if (!facets_.is_made()) {
        const auto colour = [&](const Incidence& facet) {
            ++effort.spectra;
            return colour_at(prepared_, facet, work_);
        };
        facets_ = FacetColours(facet_curve(colour, kinks_deg(mechanism_)));
    }
    return facets_.mean(relief, incidence, effort.points);
}

Xyz Sampler::at(double x, double y) {
    set_parameters(x, y);
    const Geometry& here = geometry(x, y);
    const Xyz seen =
        mechanism_.effects.relief.is_plane() ? colour_at(prepared_, here, work_) : mean_of_facets(here.incidence);
    return adapt(job_.light->adaptation, seen);
}

}  // namespace nacre

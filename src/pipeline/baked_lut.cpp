#include "pipeline/baked_lut.h"

#include <memory>
#include <string>
#include <variant>

#include "nacre/accuracy/measure.h"
#include "nacre/base/error.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/optics/palette.h"
#include "pipeline/lut_header.h"
#include "pipeline/rounding.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

GamutRule gamut_rule(const ColourSpace& space, Gamut gamut) {
    if (gamut == Gamut::compress && !space.linear_matrix()) {
        throw Error("gamut = \"compress\" needs a linear space, and " + space.name() +
                    " is not linear; use clip or keep");
    }
    return {gamut, space.linear_matrix()};
}

}  // namespace

Encoding lut_encoding(const ColourSpace& space, Gamut gamut) {
    Encoding encoding;
    // Shared, because a std::function is copied with what it holds.
    encoding.to_rgb = [&space,
                       rule = std::make_shared<const GamutRule>(gamut_rule(space, gamut))](const Image<Xyz>& xyz) {
        Image<Rgb> rgb = space.to_rgb(xyz);
        rule->apply(rgb, xyz);
        return rgb;
    };
    if (space.has_inverse()) {
        encoding.to_xyz = [&space](const Image<Rgb>& rgb) { return space.to_xyz(rgb); };
    }
    encoding.stored = stored_value;
    encoding.keeps_colours = gamut == Gamut::keep;
    return encoding;
}

BakedLut bake_lut(const ChosenLut& chosen, const Plan& plan, const ColourSource& source, const ColourSpace& space,
                  const AfterRow& after_row) {
    const PlannedLut& lut = chosen.lut;
    BakedLut baked;
    const double begin = thread_seconds();
    const Image<Xyz> xyz = bake(lut.job, after_row, &baked.work);
    baked.computing_seconds = thread_seconds() - begin;
    baked.image = space.to_rgb(xyz);
    baked.gamut = gamut_report(baked.image);
    gamut_rule(space, lut.colour.gamut).apply(baked.image, xyz);
    check_storable(baked.image, lut.format);
    for (Rgb& texel : baked.image) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b})
            texel.*component = stored_value(texel.*component, lut.format);
    }
    baked.left = gamut_report(baked.image);
    const Encoding encoding = lut_encoding(space, lut.colour.gamut);
    if (encoding.to_xyz) {
        const double ready = thread_seconds();
        const Measured& measured = baked.measured.emplace(measure(chosen, xyz, baked.image, encoding));
        baked.reached = rounded_up(measured.reached);
        baked.measuring_seconds = thread_seconds() - ready;
        baked.work += measured.work;
        if (encoding.keeps_colours)
            baked.clipping = clipping_loss(baked.image, encoding, measured.scale, lut.request.max_de00);
    }
    const SceneMaterial* material = find_material(plan, lut.job.material.name);
    if (material != nullptr && !is_transmittance(lut.job.material.mechanism)) baked.picked = material->picked;
    if (const auto* palette = std::get_if<Palette>(&lut.job.material.mechanism))
        baked.clamped = palette_clamp_bounds(*palette);
    baked.header = lut_header(chosen, source, space, baked);
    return baked;
}

}  // namespace nacre

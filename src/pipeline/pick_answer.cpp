#include "pipeline/pick_answer.h"

#include <algorithm>
#include <limits>
#include <string>

#include "io/ceres_solver.h"
#include "nacre/base/text.h"
#include "nacre/colour/illuminant.h"
#include "nacre/optics/incidence.h"
#include "nacre/scene/readers/light_reader.h"
#include "nacre/shade/band.h"

namespace nacre {
namespace {

// Enough for a thousandth of a nanometre of a film; the rounded answer is judged again, so nothing is claimed for more.
constexpr int answer_digits = 6;

}  // namespace

Mechanism rounded_answer(const MaterialSearch& search, std::size_t answer) {
    const FoundMechanism& found = search.found[answer];
    Mechanism mechanism = search.search.start;
    for (std::size_t i = 0; i < search.search.free.size(); ++i)
        search.search.free[i].set(mechanism, std::stod(significant_text(found.values[i], answer_digits)));
    return mechanism;
}

std::vector<AngleFit> compare_with_measured(const MeasuredSpectra& spectra, const SceneMaterial& material) {
    std::vector<AngleFit> angles;
    for (const PickedColour& one : material.picked) {
        const auto found = std::find(spectra.angle_deg.begin(), spectra.angle_deg.end(), one.angle_deg);
        AngleFit angle;
        angle.angle_deg = one.angle_deg;
        angle.measured_peak_nm = measured_peak_nm(spectra, static_cast<std::size_t>(found - spectra.angle_deg.begin()));
        const auto band = find_band(material.mechanism, Incidence::from_degrees(one.angle_deg), angle.measured_peak_nm);
        angle.peak_nm = band ? band->peak_nm : std::numeric_limits<double>::quiet_NaN();
        angle.de00 = one.de00;
        angles.push_back(angle);
    }
    return angles;
}

PaletteFit fit_readable_palette(const MeasuredSpectra& spectra, std::size_t count) {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    PaletteFit fit = fit_palette(spectra, count, make_light(settings), least_squares_solver());
    const auto round = [](double& value, int decimals) { value = std::stod(fixed_text(value, decimals)); };
    for (Pick& pick : fit.palette.picks) {
        round(pick.lobe.peak_nm, 3);
        round(pick.lobe.width_nm, 3);
        round(pick.lobe.height, 6);
    }
    round(fit.palette.shape, 6);
    return fit;
}

}  // namespace nacre

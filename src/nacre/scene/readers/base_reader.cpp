#include "nacre/scene/readers/base_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "nacre/base/crop_curve.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/colour/tristimulus.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_reflectance{0.0, 1.0};
constexpr Allowed allowed_scattering{1e-9, 1e6, "per um"};
constexpr Allowed allowed_wavelength{1.0, 1e6, "nm"};
constexpr std::size_t most_samples = 100000;
// What a colour may be off: just not told apart.
constexpr double most_ciede2000 = 1.0;

// Colours of sigmoids, as linear Rec.709. Coefficients here are of u^2, u, 1 with u in [-1, 1] over the wavelengths:
// nearly orthogonal, where those of t in [0, 1] are nearly dependent.
class SigmoidColours {
public:
    SigmoidColours() {
        const TristimulusWeights weights = make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name("D65"));
        const GridWeights per_nm = make_grid_weights(weights, WavelengthGrid{});
        const Xyz d65 = xyz_from_chromaticity(d65_chromaticity);
        const glm::dmat3 to_rgb = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
        const glm::dmat3 seen = to_rgb * adaptation_matrix(Adaptation::bradford, per_nm.white, d65);
        for (std::size_t i = 0; i < per_nm.x.size(); ++i)
            weight_.push_back(seen * glm::dvec3(per_nm.x[i], per_nm.y[i], per_nm.z[i]));
        to_xyz_ = glm::inverse(to_rgb);
    }

    // The colour, and its derivatives by the coefficients, if wanted: column by coefficient.
    glm::dvec3 at(const glm::dvec3& coefficients, glm::dmat3* derivatives = nullptr) const {
        glm::dvec3 sum(0.0);
        if (derivatives != nullptr) *derivatives = glm::dmat3(0.0);
        const double last = static_cast<double>(weight_.size() - 1);
        for (std::size_t i = 0; i < weight_.size(); ++i) {
            const double u = 2.0 * static_cast<double>(i) / last - 1.0;
            const double x = (coefficients[0] * u + coefficients[1]) * u + coefficients[2];
            const double root = std::sqrt(1.0 + x * x);
            sum += (0.5 + 0.5 * x / root) * weight_[i];
            if (derivatives == nullptr) continue;
            const glm::dvec3 by_x = 0.5 / (root * root * root) * weight_[i];
            *derivatives += glm::dmat3(u * u * by_x, u * by_x, by_x);
        }
        return sum;
    }

    Lab lab(const glm::dvec3& rgb) const {
        const glm::dvec3 xyz = to_xyz_ * rgb;
        return to_lab({xyz.x, xyz.y, xyz.z}, xyz_from_chromaticity(d65_chromaticity));
    }

    double luminance(const glm::dvec3& rgb) const { return (to_xyz_ * rgb).y; }

private:
    std::vector<glm::dvec3> weight_;  // per nanometre
    glm::dmat3 to_xyz_{1.0};
};

// The x at which the sigmoid is a given reflectance. Its ends are infinitely far: at 1e9 it is 0 or 1 in double.
double sigmoid_argument(double reflectance) {
    constexpr double far = 1e9;
    const double root = std::sqrt(reflectance * (1.0 - reflectance));
    return root > 0.0 ? std::clamp((reflectance - 0.5) / root, -far, far) : std::copysign(far, reflectance - 0.5);
}

// Levenberg and Marquardt's method towards a colour, from coefficients that are near.
glm::dvec3 approach(const SigmoidColours& colours, const glm::dvec3& target, glm::dvec3 coefficients, int steps) {
    constexpr double close = 1e-13;
    double damping = 1e-6;
    glm::dmat3 derivatives;
    glm::dvec3 error = colours.at(coefficients, &derivatives) - target;
    for (int i = 0; i < steps && glm::dot(error, error) > close * close * glm::dot(target, target); ++i) {
        const glm::dmat3 transposed = glm::transpose(derivatives);
        glm::dmat3 normal = transposed * derivatives;
        for (int j = 0; j < 3; ++j) normal[j][j] *= 1.0 + damping;
        const double determinant = glm::determinant(normal);
        if (!(std::abs(determinant) > 0.0)) break;
        const glm::dvec3 moved = coefficients - glm::inverse(normal) * (transposed * error);
        glm::dmat3 derivatives_there;
        const glm::dvec3 error_there = colours.at(moved, &derivatives_there) - target;
        if (glm::dot(error_there, error_there) < glm::dot(error, error)) {
            coefficients = moved;
            error = error_there;
            derivatives = derivatives_there;
            damping = std::max(0.1 * damping, 1e-15);
        } else {
            damping *= 10.0;
            if (damping > 1e12) break;
        }
    }
    return coefficients;
}

std::vector<double> read_numbers(const Table& table, std::string_view key, const Allowed& allowed) {
    const Value* value = table.find(key);
    if (value == nullptr) table.fail_missing(key, "give an array of numbers");
    std::vector<double> numbers;
    for (const Value& element : table.checked_array(key, *value))
        numbers.push_back(table.checked_number(key, element, allowed));
    return numbers;
}

RgbBase read_rgb(const Table& table) {
    const Where& where = table.find("rgb")->where;
    const std::vector<double> numbers = read_numbers(table, "rgb", allowed_reflectance);
    if (numbers.size() != 3) {
        table.fail(where, "rgb has " + std::to_string(numbers.size()) +
                              " numbers; give three, of linear Rec.709: [red, green, blue]");
    }
    const Upsampled found = upsampled({numbers[0], numbers[1], numbers[2]});
    // None of 20 000 random colours is off by more than 4e-5; if one is, it is said rather than shown.
    if (!(found.ciede2000 <= most_ciede2000)) {
        table.fail(where, "no smooth reflectance has this colour, the nearest is CIEDE2000 " +
                              significant_text(found.ciede2000, 2) + " off; allowed is " + number_text(most_ciede2000) +
                              ", of colours that are less pure");
    }
    return found.base;
}

SpectrumBase read_spectrum_file(const Table& table, const Value& value, const SceneContext& context) {
    const std::string& file = table.checked_text("spectrum", value);
    SampledCurve curve = context.read_curve(file, value.where);
    // Instruments see further than eyes, and their last values may be noise.
    crop_curve(curve, context.index.first_nm, context.index.last_nm);
    if (curve.value.size() > most_samples) {
        table.fail(value.where, in_quotes(file) + " has " + std::to_string(curve.value.size()) +
                                    " values over the light's range; allowed " + std::to_string(most_samples));
    }
    for (std::size_t i = 0; i < curve.value.size(); ++i) {
        if (curve.value[i] >= 0.0 && curve.value[i] <= 1.0) continue;
        const std::string what = curve.value[i] > 1.0 ? " is a base brighter than 1, " : " is a base below 0, ";
        table.fail(value.where, in_quotes(file) + what + number_text(curve.value[i]) + " at " +
                                    number_text(curve.wavelength_nm[i]) + " nm; a reflectance is 0 to 1");
    }
    return {std::move(curve)};
}

SpectrumBase read_inline_spectrum(const Table& table) {
    SampledCurve curve{read_numbers(table, "wavelength_nm", allowed_wavelength),
                       read_numbers(table, "reflectance", allowed_reflectance)};
    if (curve.wavelength_nm.size() != curve.value.size() || curve.value.size() < 2 ||
        curve.value.size() > most_samples) {
        table.fail_at("reflectance", "wavelength_nm has " + std::to_string(curve.wavelength_nm.size()) +
                                         " numbers and reflectance " + std::to_string(curve.value.size()) +
                                         "; allowed: as many of each, 2 to " + std::to_string(most_samples));
    }
    if (std::adjacent_find(curve.wavelength_nm.begin(), curve.wavelength_nm.end(), std::greater_equal<>()) !=
        curve.wavelength_nm.end()) {
        table.fail_at("wavelength_nm", "wavelength_nm does not ascend; give every wavelength once, smallest first");
    }
    return {std::move(curve)};
}

PigmentBase read_pigment(const Table& table, const IndexReader& index) {
    PigmentBase base;
    base.pigment = read_required_index(table, "pigment", index);
    base.scattering_per_um = table.number_or("scattering_per_um", allowed_scattering, base.scattering_per_um);
    base.share = table.number_or("share", allowed_reflectance, base.share);
    return base;
}

constexpr std::string_view forms =
    "a number, { rgb }, { spectrum }, { wavelength_nm, reflectance }, { pigment, scattering_per_um, share } or "
    "{ metal }";

Base read_form(const Table& table, const SceneContext& context) {
    // One of these says which form it is.
    constexpr std::array<std::string_view, 5> leading{"rgb", "spectrum", "reflectance", "pigment", "metal"};
    std::string_view form;
    for (const std::string_view key : leading) {
        const Value* value = table.find(key);
        if (value == nullptr) continue;
        if (!form.empty()) {
            table.fail(value->where, "base has both " + std::string(form) + " and " + std::string(key) +
                                         "; give one of " + std::string(forms));
        }
        form = key;
    }
    if (form.empty() && table.find("wavelength_nm") != nullptr) form = "reflectance";
    if (form == "rgb") return read_rgb(table);
    if (form == "spectrum") return read_spectrum_file(table, *table.find("spectrum"), context);
    if (form == "reflectance") return read_inline_spectrum(table);
    if (form == "pigment") return read_pigment(table, context.index);
    if (form == "metal") return MetalBase{read_required_index(table, "metal", context.index)};
    for (const std::string_view key : {"scattering_per_um", "share"}) table.find(key);
    table.expect_all_read();
    table.fail(table.where(), "base says nothing; give " + std::string(forms));
}

std::string list_text(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
    return "[" + text + "]";
}

struct BaseText {
    std::string operator()(const GreyBase& base) const { return number_text(base.reflectance); }
    std::string operator()(const RgbBase& base) const {
        return "{ rgb = " + list_text({base.rgb.begin(), base.rgb.end()}) + " }";
    }
    std::string operator()(const SpectrumBase& base) const {
        return "{ wavelength_nm = " + list_text(base.reflectance.wavelength_nm) +
               ", reflectance = " + list_text(base.reflectance.value) + " }";
    }
    std::string operator()(const PigmentBase& base) const {
        return "{ pigment = " + index_toml(base.pigment) +
               ", scattering_per_um = " + number_text(base.scattering_per_um) + ", share = " + number_text(base.share) +
               " }";
    }
    std::string operator()(const MetalBase& base) const { return "{ metal = " + index_toml(base.metal) + " }"; }
};

}  // namespace

std::optional<Base> read_base(const Table& table, const SceneContext& context) {
    const Value* value = table.find("base");
    if (value == nullptr) return {};
    if (const auto* word = std::get_if<std::string>(&value->data)) {
        if (*word == "black") return {};
        table.fail(value->where, "unknown base " + in_quotes(*word) + "; known: black, " + std::string(forms));
    }
    if (std::holds_alternative<std::shared_ptr<Table>>(value->data)) {
        const Table& form = table.checked_table("base", *value);
        const Base base = read_form(form, context);
        form.expect_all_read();
        return base;
    }
    if (!std::holds_alternative<double>(value->data) && !std::holds_alternative<std::int64_t>(value->data)) {
        table.fail(value->where, "base = " + value->text() + " is " + std::string(value->kind()) + "; give black, " +
                                     std::string(forms));
    }
    return GreyBase{table.checked_number("base", *value, allowed_reflectance)};
}

std::string base_toml(const Base& base) {
    return std::visit(BaseText{}, base);
}

double largest_k(const Index& index, double first_nm, double last_nm) {
    if (index.is_constant()) return index.constant.imag();
    double largest = index.at(last_nm).imag();
    for (double nm = first_nm; nm < last_nm; nm += 1.0) largest = std::max(largest, index.at(nm).imag());
    return largest;
}

Upsampled upsampled(const std::array<double, 3>& rgb) {
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return {{rgb, {0.0, 0.0, sigmoid_argument(rgb[0])}}, 0.0};
    const SigmoidColours colours;
    const glm::dvec3 target(rgb[0], rgb[1], rgb[2]);
    const glm::dvec3 grey(std::clamp(colours.luminance(target), 1e-9, 1.0 - 1e-9));
    glm::dvec3 found(0.0, 0.0, sigmoid_argument(grey.x));
    constexpr int stations = 16;
    constexpr int steps_between = 20;
    constexpr int last_steps = 400;
    for (int i = 1; i < stations; ++i)
        found = approach(colours, grey + static_cast<double>(i) / stations * (target - grey), found, steps_between);
    found = approach(colours, target, found, last_steps);
    // u = 2 t - 1
    const std::array<double, 3> of_t{4.0 * found[0], 2.0 * found[1] - 4.0 * found[0], found[0] - found[1] + found[2]};
    return {{rgb, of_t}, ciede2000(colours.lab(colours.at(found)), colours.lab(target))};
}

}  // namespace nacre

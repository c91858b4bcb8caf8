#include <array>

#include "nacre/base/text.h"
#include "nacre/scene/readers/index_reader.h"

namespace nacre {
namespace {

std::string numbers_text(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
    return "[" + text + "]";
}

std::string n_toml(const IndexCurve& curve) {
    if (const auto* formula = std::get_if<IndexFormula>(&curve.n)) {
        return "formula = " + std::to_string(formula->number) +
               ", coefficients = " + numbers_text(formula->coefficients);
    }
    if (const auto* table = std::get_if<SampledCurve>(&curve.n))
        return "wavelength_nm = " + numbers_text(table->wavelength_nm) + ", n = " + numbers_text(table->value);
    return "n = " + number_text(std::get<double>(curve.n));
}

std::string k_toml(const IndexCurve& curve) {
    const auto* table = std::get_if<SampledCurve>(&curve.k);
    if (table == nullptr) {
        const double k = std::get<double>(curve.k);
        return k == 0.0 ? "" : ", k = " + number_text(k);
    }
    const auto* n = std::get_if<SampledCurve>(&curve.n);
    const bool shares_grid = n != nullptr && n->wavelength_nm == table->wavelength_nm;
    const std::string grid = shares_grid ? "" : ", k_wavelength_nm = " + numbers_text(table->wavelength_nm);
    return grid + ", k = " + numbers_text(table->value);
}

}  // namespace

std::string index_toml(const Index& index) {
    if (index.is_constant()) {
        std::string n = number_text(index.constant.real());
        if (index.constant.imag() == 0.0) return n;
        return "{ n = " + n + ", k = " + number_text(index.constant.imag()) + " }";
    }
    const IndexCurve& curve = *index.curve;
    if (curve.metal) {
        const auto rgb = [](const std::array<double, 3>& colour) {
            return numbers_text({colour.begin(), colour.end()});
        };
        const auto& tint = curve.metal->edge_tint;
        return "{ f0 = " + rgb(curve.metal->f0) + (tint ? ", edge_tint = " + rgb(*tint) : "") + " }";
    }
    if (curve.is_shipped) {
        if (!curve.holds_outside) return toml_string(curve.name);
        return "{ material = " + toml_string(curve.name) + ", outside = \"hold\" }";
    }
    std::string text = "{ ";
    if (!curve.name.empty()) text += "name = " + toml_string(curve.name) + ", ";
    text += n_toml(curve) + k_toml(curve);
    if (curve.first_nm > 0.0 && curve.first_nm < curve.last_nm)
        text += ", range_nm = [" + number_text(curve.first_nm) + ", " + number_text(curve.last_nm) + "]";
    if (curve.holds_outside) text += ", outside = \"hold\"";
    return text + " }";
}

}  // namespace nacre

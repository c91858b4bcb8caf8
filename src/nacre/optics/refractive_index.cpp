#include "nacre/optics/refractive_index.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace nacre {
namespace {

constexpr int formula_count = 9;

// Coefficients as the formulas count them, from C1; one that is left out is 0.
struct Coefficients {
    const std::vector<double>& values;

    double operator()(std::size_t number) const { return number <= values.size() ? values[number - 1] : 0.0; }
};

// Terms that are left out have no strength, and no pole either: not 0/0 where their missing pole would be.
double term(double strength, double numerator, double denominator) {
    return strength == 0.0 ? 0.0 : strength * numerator / denominator;
}

// Formulas 1 and 2, n^2. A resonance is given by its wavelength in 1, by the square of it in 2.
double sellmeier(const Coefficients& c, double square_um2, bool squares_resonances) {
    double sum = 1.0 + c(1);
    for (std::size_t i = 2; i <= c.values.size(); i += 2) {
        const double resonance = squares_resonances ? c(i + 1) * c(i + 1) : c(i + 1);
        sum += term(c(i), square_um2, square_um2 - resonance);
    }
    return sum;
}

// The pairs of strength and exponent of formulas 3, 4 and 5.
double powers(const Coefficients& c, std::size_t first, double um) {
    double sum = 0.0;
    for (std::size_t i = first; i <= c.values.size(); i += 2) sum += term(c(i), std::pow(um, c(i + 1)), 1.0);
    return sum;
}

// Formula 4, n^2: two resonances, then powers.
double resonances_and_powers(const Coefficients& c, double um) {
    double sum = c(1);
    for (const std::size_t i : {std::size_t{2}, std::size_t{6}})
        sum += term(c(i), std::pow(um, c(i + 1)), um * um - std::pow(c(i + 2), c(i + 3)));
    return sum + powers(c, 10, um);
}

// Formula 6, n: gases.
double gas(const Coefficients& c, double square_um2) {
    double sum = 1.0 + c(1);
    for (std::size_t i = 2; i <= c.values.size(); i += 2) sum += term(c(i), 1.0, c(i + 1) - 1.0 / square_um2);
    return sum;
}

// Formula 7, n: Herzberger's.
double herzberger(const Coefficients& c, double square_um2) {
    const double distance = square_um2 - 0.028;
    return c(1) + term(c(2), 1.0, distance) + term(c(3), 1.0, distance * distance) + c(4) * square_um2 +
           c(5) * square_um2 * square_um2 + c(6) * square_um2 * square_um2 * square_um2;
}

// Formula 8, n^2, from (n^2 - 1) / (n^2 + 2).
double retro(const Coefficients& c, double square_um2) {
    const double ratio = c(1) + term(c(2), square_um2, square_um2 - c(3)) + c(4) * square_um2;
    return (1.0 + 2.0 * ratio) / (1.0 - ratio);
}

// Formula 9, n^2.
double exotic(const Coefficients& c, double um) {
    const double distance = um - c(5);
    return c(1) + term(c(2), 1.0, um * um - c(3)) + term(c(4), distance, distance * distance + c(6));
}

double index_at(const std::variant<double, IndexFormula, SampledCurve>& n, double wavelength_nm) {
    if (const auto* formula = std::get_if<IndexFormula>(&n)) return formula->at(wavelength_nm);
    if (const auto* table = std::get_if<SampledCurve>(&n)) return table->at(wavelength_nm);
    return *std::get_if<double>(&n);
}

double absorption_at(const std::variant<double, SampledCurve>& k, double wavelength_nm) {
    if (const auto* table = std::get_if<SampledCurve>(&k)) return table->at(wavelength_nm);
    return *std::get_if<double>(&k);
}

}  // namespace

// Gulbrandsen's k^2 has the factors (n_max - n)(n - 1 / n_max). With d = 2 sqrt(R) / (1 + R) they are sums of positive
// terms, so that nothing cancels.
RefractiveIndex metal_index(double reflectance, double edge_tint) {
    const double root = std::sqrt(reflectance);
    const double n_max = (1.0 + root) * (1.0 + root) / (1.0 - reflectance);
    const double d = 2.0 * root / (1.0 + reflectance);
    const double n = (1.0 - reflectance) / (1.0 + reflectance) + (1.0 - edge_tint) * d * n_max;
    return {n, d * std::sqrt(edge_tint * (1.0 + (1.0 - edge_tint) * n_max * n_max))};
}

RefractiveIndex metal_index(double reflectance) {
    return {1.0, 2.0 * std::sqrt(reflectance / (1.0 - reflectance))};
}

double IndexFormula::at(double wavelength_nm) const {
    const double um = wavelength_nm / 1000.0;
    const double square_um2 = um * um;
    const Coefficients c{coefficients};
    switch (number) {
        case 1:
            return std::sqrt(sellmeier(c, square_um2, true));
        case 2:
            return std::sqrt(sellmeier(c, square_um2, false));
        case 3:
            return std::sqrt(c(1) + powers(c, 2, um));
        case 4:
            return std::sqrt(resonances_and_powers(c, um));
        case 5:
            return c(1) + powers(c, 2, um);
        case 6:
            return gas(c, square_um2);
        case 7:
            return herzberger(c, square_um2);
        case 8:
            return std::sqrt(retro(c, square_um2));
        case 9:
            return std::sqrt(exotic(c, um));
        default:
            assert(false);
            return std::nan("");
    }
}

std::size_t most_coefficients(int formula_number) {
    assert(formula_number >= 1 && formula_number <= formula_count);
    constexpr std::array<std::size_t, formula_count> most{17, 17, 17, 17, 11, 11, 6, 4, 6};
    return most[static_cast<std::size_t>(formula_number - 1)];
}

RefractiveIndex IndexCurve::at(double wavelength_nm) const {
    // A table is 0 outside its nodes, but first_nm and last_nm lie within all of them.
    const double nm = holds_outside ? std::clamp(wavelength_nm, first_nm, last_nm) : wavelength_nm;
    assert(nm >= first_nm && nm <= last_nm);
    return {index_at(n, nm), absorption_at(k, nm)};
}

bool IndexCurve::is_dispersive() const {
    const auto varies = [](const SampledCurve* table) {
        return table != nullptr && std::any_of(table->value.begin(), table->value.end(),
                                               [&](double value) { return value != table->value.front(); });
    };
    const auto* formula = std::get_if<IndexFormula>(&n);
    // C1 alone is a number in every formula.
    const bool formula_varies = formula != nullptr && formula->coefficients.size() > 1;
    return formula_varies || varies(std::get_if<SampledCurve>(&n)) || varies(std::get_if<SampledCurve>(&k));
}

bool IndexCurve::is_lossless() const {
    const auto is_zero = [](double value) { return value == 0.0; };
    const auto* table = std::get_if<SampledCurve>(&k);
    return table ? std::all_of(table->value.begin(), table->value.end(), is_zero) : is_zero(*std::get_if<double>(&k));
}

}  // namespace nacre

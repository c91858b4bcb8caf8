#include "reference/materials.h"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nacre::reference {
namespace {

struct SellmeierTerm {
    double strength = 0.0, resonance_um2 = 0.0;
};
struct Sellmeier {
    const char* material;
    std::array<SellmeierTerm, 4> terms;
};
const std::array<Sellmeier, 5> sellmeier_materials{{
    // Malitson 1965, JOSA 55, 1205
    {"sio2",
     {{{0.6961663, square(0.0684043)}, {0.4079426, square(0.1162414)}, {0.8974794, square(9.896161)}, {0.0, 0.0}}}},
    // Dodge 1984, Appl. Opt. 23, 1980, ordinary ray
    {"mgf2",
     {{{0.48755108, square(0.04338408)},
       {0.39875031, square(0.09461442)},
       {2.3120353, square(23.793604)},
       {0.0, 0.0}}}},
    // Malitson and Dodge 1972, JOSA 62, 1405, ordinary ray
    {"al2o3",
     {{{1.4313493, square(0.0726631)}, {0.65054713, square(0.1193242)}, {5.3414021, square(18.028251)}, {0.0, 0.0}}}},
    // Schott's catalogue: N-BK7
    {"bk7", {{{1.03961212, 0.00600069867}, {0.231792344, 0.0200179144}, {1.01046945, 103.560653}, {0.0, 0.0}}}},
    // Daimon and Masumura 2007, Appl. Opt. 46, 3811, 20 degrees
    {"water",
     {{{5.684027565e-1, 5.101829712e-3},
       {1.726177391e-1, 1.821153936e-2},
       {2.086189578e-2, 2.620722293e-2},
       {1.130748688e-1, 1.069792721e1}}}},
}};

struct Row {
    double nm = 0.0, n = 0.0, k = 0.0;
};
struct TabulatedMetal {
    const char* material;
    std::vector<Row> rows;
};
// Johnson and Christy 1972, Phys. Rev. B 6, 4370 (ag, au), and 1974, 9, 5056 (cr); Rakic 1995, Appl. Opt. 34, 4755
// (al).
const std::vector<TabulatedMetal>& metals() {
    static const std::vector<TabulatedMetal> tables{
        {"ag",
         {{354.2, 0.10, 1.419},
          {367.9, 0.07, 1.657},
          {381.5, 0.05, 1.864},
          {397.4, 0.05, 2.070},
          {413.3, 0.05, 2.275},
          {430.5, 0.04, 2.462},
          {450.9, 0.04, 2.657},
          {471.4, 0.05, 2.869},
          {495.9, 0.05, 3.093},
          {520.9, 0.05, 3.324},
          {548.6, 0.06, 3.586},
          {582.1, 0.05, 3.858},
          {616.8, 0.06, 4.152},
          {659.5, 0.05, 4.483},
          {704.5, 0.04, 4.838},
          {756.0, 0.03, 5.242},
          {821.1, 0.04, 5.727},
          {892.0, 0.04, 6.312}}},
        {"au",
         {{354.2, 1.50, 1.866},
          {367.9, 1.48, 1.895},
          {381.5, 1.46, 1.933},
          {397.4, 1.47, 1.952},
          {413.3, 1.46, 1.958},
          {430.5, 1.45, 1.948},
          {450.9, 1.38, 1.914},
          {471.4, 1.31, 1.849},
          {495.9, 1.04, 1.833},
          {520.9, 0.62, 2.081},
          {548.6, 0.43, 2.455},
          {582.1, 0.29, 2.863},
          {616.8, 0.21, 3.272},
          {659.5, 0.14, 3.697},
          {704.5, 0.13, 4.103},
          {756.0, 0.14, 4.542},
          {821.1, 0.16, 5.083},
          {892.0, 0.17, 5.663}}},
        {"al",
         {{326.28, 0.31474, 3.9165},
          {364.66, 0.39877, 4.3957},
          {413.28, 0.52135, 5.0008},
          {442.80, 0.6079, 5.3676},
          {476.87, 0.7278, 5.7781},
          {516.60, 0.8734, 6.2418},
          {563.57, 1.0728, 6.7839},
          {619.93, 1.3660, 7.4052},
          {652.25, 1.5724, 7.7354},
          {688.81, 1.8301, 8.0601},
          {729.32, 2.1606, 8.3565},
          {774.91, 2.6154, 8.4914},
          {794.78, 2.7675, 8.3866},
          {815.69, 2.7668, 8.2573},
          {837.74, 2.6945, 8.1878}}},
        {"cr",
         {{354.0, 1.84, 2.64},
          {368.0, 1.87, 2.69},
          {381.0, 1.92, 2.74},
          {397.0, 2.00, 2.83},
          {413.0, 2.08, 2.93},
          {431.0, 2.19, 3.04},
          {451.0, 2.33, 3.14},
          {471.0, 2.51, 3.24},
          {496.0, 2.75, 3.30},
          {521.0, 2.94, 3.33},
          {549.0, 3.18, 3.33},
          {582.0, 3.22, 3.30},
          {617.0, 3.17, 3.30},
          {659.0, 3.09, 3.34},
          {704.0, 3.05, 3.39},
          {756.0, 3.08, 3.42},
          {821.0, 3.20, 3.48},
          {892.0, 3.30, 3.52}}},
    };
    return tables;
}

// refractiveindex.info's formulas 1 (Sellmeier) and 5 (Cauchy).
double formula_at(const IndexFormula& formula, double nm) {
    const double um = nm / 1000.0;
    const auto& c = formula.coefficients;
    double sum = formula.number == 1 ? 1.0 + c[0] : c[0];
    for (std::size_t i = 1; i + 1 < c.size(); i += 2)
        sum += formula.number == 1 ? c[i] * um * um / (um * um - c[i + 1] * c[i + 1]) : c[i] * std::pow(um, c[i + 1]);
    if (formula.number != 1 && formula.number != 5) throw std::runtime_error("a formula that the model does not know");
    return formula.number == 1 ? std::sqrt(sum) : sum;
}

}  // namespace

Complex material_index(const std::string& material, double wavelength_nm) {
    const double um2 = square(wavelength_nm / 1000.0);
    for (const Sellmeier& glass : sellmeier_materials) {
        if (material != glass.material) continue;
        double sum = 1.0;
        for (const SellmeierTerm& term : glass.terms) sum += term.strength * um2 / (um2 - term.resonance_um2);
        return std::sqrt(sum);
    }
    // Stavenga and others 2012, PLoS ONE 7, e49743
    if (material == "melanin") return {1.648 + 0.0237 / um2, 0.56 * std::exp(-wavelength_nm / 270.0)};
    for (const TabulatedMetal& metal : metals()) {
        if (material != metal.material) continue;
        std::size_t right = 1;
        while (metal.rows[right].nm < wavelength_nm) ++right;
        const Row &a = metal.rows[right - 1], &b = metal.rows[right];
        const double t = (wavelength_nm - a.nm) / (b.nm - a.nm);
        return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
    }
    throw std::runtime_error("no material " + material);
}

double linear_at(const SampledCurve& table, double nm, bool holds) {
    const auto& at = table.wavelength_nm;
    if (nm < at.front() || nm > at.back()) {
        if (!holds) throw std::runtime_error("a table ends before the light does");
        return nm < at.front() ? table.value.front() : table.value.back();
    }
    std::size_t right = 1;
    while (right + 1 < at.size() && at[right] < nm) ++right;
    const double t = (nm - at[right - 1]) / (at[right] - at[right - 1]);
    return (1.0 - t) * table.value[right - 1] + t * table.value[right];
}

// A curve without numbers: its name says all.
Index named_index(const std::string& material) {
    static std::map<std::string, std::shared_ptr<const IndexCurve>> known;
    auto& curve = known[material];
    if (!curve) {
        IndexCurve named;
        named.name = material;
        named.n = SampledCurve{};
        curve = std::make_shared<const IndexCurve>(std::move(named));
    }
    return Index(curve);
}

bool is_named(const Index& index) {
    const auto* table = index.curve ? std::get_if<SampledCurve>(&index.curve->n) : nullptr;
    return table != nullptr && table->value.empty();
}

Index tabulated_index(const std::string& material) {
    IndexCurve curve;
    SampledCurve n, k;
    for (double nm = 360.0; nm <= 830.0; nm += 10.0) {
        const Complex index = material_index(material, nm);
        n.wavelength_nm.push_back(nm);
        n.value.push_back(index.real());
        k.wavelength_nm.push_back(nm);
        k.value.push_back(index.imag());
    }
    curve.name = material;
    curve.n = std::move(n);
    curve.k = std::move(k);
    curve.first_nm = 360.0;
    curve.last_nm = 830.0;
    return Index(std::make_shared<const IndexCurve>(std::move(curve)));
}

// Rows are the only lines that begin with a number and have two more.
Index index_of_file(const std::string& material, const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    IndexCurve curve;
    SampledCurve n, k;
    for (std::string line; std::getline(file, line);) {
        std::istringstream row(line);
        double um = 0.0, of_n = 0.0, of_k = 0.0;
        if (!(row >> um >> of_n >> of_k) || um < 0.35 || um > 0.85) continue;
        n.wavelength_nm.push_back(1000.0 * um);
        n.value.push_back(of_n);
        k.wavelength_nm.push_back(1000.0 * um);
        k.value.push_back(of_k);
    }
    curve.name = material;
    curve.n = std::move(n);
    curve.k = std::move(k);
    return Index(std::make_shared<const IndexCurve>(std::move(curve)));
}

bool same(const Index& one, const Index& other) {
    return one.curve == other.curve && (one.curve != nullptr || one.constant == other.constant);
}

Complex index_at(const Index& index, double nm) {
    if (index.curve == nullptr) return index.constant;
    if (is_named(index)) return material_index(index.curve->name, nm);
    const IndexCurve& curve = *index.curve;
    double n = 0.0, k = 0.0;
    if (const auto* constant = std::get_if<double>(&curve.n)) n = *constant;
    if (const auto* formula = std::get_if<IndexFormula>(&curve.n)) n = formula_at(*formula, nm);
    if (const auto* table = std::get_if<SampledCurve>(&curve.n)) n = linear_at(*table, nm, curve.holds_outside);
    if (const auto* constant = std::get_if<double>(&curve.k)) k = *constant;
    if (const auto* table = std::get_if<SampledCurve>(&curve.k)) k = linear_at(*table, nm, curve.holds_outside);
    return {n, k};
}

Layer layer_of(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

Layer periods_of(int repeat, const Layer& first, const Layer& second) {
    Layer group;
    group.repeat = repeat;
    group.layers = {first, second};
    return group;
}

}  // namespace nacre::reference

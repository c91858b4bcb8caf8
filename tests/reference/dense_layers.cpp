#include "reference/dense_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/weights.h"

namespace nacre::reference {
namespace {

using Complex = std::complex<double>;

constexpr int first_nm = 360;
constexpr int last_nm = 830;
constexpr std::size_t most_media = 48;

// ---- Materials ----

struct SellmeierTerm {
    double strength = 0.0, resonance_um2 = 0.0;
};
struct Sellmeier {
    const char* material;
    std::array<SellmeierTerm, 4> terms;
};
constexpr double square(double value) {
    return value * value;
}
const std::array<Sellmeier, 4> sellmeier_materials{{
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
    static const std::vector<TabulatedMetal> tables{{"ag",
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
                                                      {892.0, 3.30, 3.52}}}};
    return tables;
}

Complex index_of(const ModelIndex& index, double wavelength_nm) {
    return index.material.empty() ? index.constant : material_index(index.material, wavelength_nm);
}

bool same(const ModelIndex& one, const ModelIndex& other) {
    return one.material == other.material && (!one.material.empty() || one.constant == other.constant);
}

// Products and quotients written out: the numbers are finite, and the library's are slow because they need not be.
Complex times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
double norm_of(const Complex& a) {
    return a.real() * a.real() + a.imag() * a.imag();
}
// 0 for 0 / 0: a face between equal media, both with the wave running along it.
Complex over(const Complex& a, const Complex& b) {
    const double size = norm_of(b);
    return size == 0.0 ? Complex(0.0) : times(a, std::conj(b)) / size;
}

// ---- Colour ----

using Triple = std::array<double, 3>;

Triple from_chromaticity(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

// Lam's cone responses (ICC profile specification, annex E).
constexpr double cones[3][3] = {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};

Triple responses(const Triple& colour) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = cones[i][0] * colour[0] + cones[i][1] * colour[1] + cones[i][2] * colour[2];
    return result;
}

// Cramer's rule.
Triple colour_of_responses(const Triple& response) {
    const auto determinant = [](const Triple& a, const Triple& b, const Triple& c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
               c[0] * (a[1] * b[2] - a[2] * b[1]);
    };
    std::array<Triple, 3> columns{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) columns[j][i] = cones[i][j];
    const double whole = determinant(columns[0], columns[1], columns[2]);
    return {determinant(response, columns[1], columns[2]) / whole,
            determinant(columns[0], response, columns[2]) / whole,
            determinant(columns[0], columns[1], response) / whole};
}

ModelLab scaled_lab(const ModelXyz& colour, double scale) {
    return lab_of({scale * colour.x, scale * colour.y, scale * colour.z});
}

double cosine_at(ModelAxis axis, double x) {
    if (axis == ModelAxis::sqrt_cos_theta) return x * x;
    return axis == ModelAxis::cos_theta ? x : std::sin((1.0 - x) * std::numbers::pi / 2.0);
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

std::size_t LayersModel::expanded_layers() const {
    std::size_t count = 0;
    for (const ModelGroup& group : groups) count += static_cast<std::size_t>(group.repeat) * group.layers.size();
    return count;
}

// Observer times illuminant at whole nanometres, Y of the perfect reflector 1.
struct DenseLayers::Light {
    std::vector<Triple> weights;
    Triple gain{};  // per cone

    Light(const std::string& illuminant, int observer_deg) {
        const char* file = observer_deg == 10 ? "cmf_cie1964_10deg_1nm.csv" : "cmf_cie1931_2deg_1nm.csv";
        const Weights table = weights_from_files(file, illuminant, first_nm, last_nm);
        const Number whole = integral_of(table.y);
        for (std::size_t i = 0; i < table.y.size(); ++i) {
            weights.push_back({static_cast<double>(table.x[i] / whole), static_cast<double>(table.y[i] / whole),
                               static_cast<double>(table.z[i] / whole)});
        }
        const XyzNumbers white = white_of(table);
        const Triple from = responses({static_cast<double>(white.x), 1.0, static_cast<double>(white.z)});
        const Triple to = responses(from_chromaticity(0.3127, 0.3290));
        for (std::size_t i = 0; i < 3; ++i) gain[i] = to[i] / from[i];
    }

    ModelXyz adapted(const Triple& seen) const {
        Triple response = responses(seen);
        for (std::size_t i = 0; i < 3; ++i) response[i] *= gain[i];
        const Triple colour = colour_of_responses(response);
        return {colour[0], colour[1], colour[2]};
    }
};

// So many midpoints per nanometre, what each weighs, and the indices there.
struct DenseLayers::Grid {
    std::vector<double> wavelength_nm;
    std::vector<Triple> weight;
    std::vector<Complex> index;  // media_.size() per wavelength

    Grid(const Light& light, const std::vector<ModelIndex>& media, int parts) {
        for (std::size_t cell = 0; cell + 1 < light.weights.size(); ++cell) {
            for (int part = 0; part < parts; ++part) {
                const double t = (part + 0.5) / parts;
                wavelength_nm.push_back(first_nm + static_cast<double>(cell) + t);
                Triple here{};
                for (std::size_t c = 0; c < 3; ++c)
                    here[c] = ((1.0 - t) * light.weights[cell][c] + t * light.weights[cell + 1][c]) / parts;
                weight.push_back(here);
                for (const ModelIndex& medium : media) index.push_back(index_of(medium, wavelength_nm.back()));
            }
        }
    }
};

DenseLayers::DenseLayers(const LayersModel& model) : model_(model), media_{model.incident, model.substrate} {
    for (const ModelLayer& layer : model.layers) {
        std::size_t medium = 0;
        while (medium < media_.size() && !same(media_[medium], layer.index)) ++medium;
        if (medium == media_.size()) media_.push_back(layer.index);
        media_of_layer_.push_back(medium);
        thickness_nm_.push_back(layer.thickness_nm);
    }
    for (const ModelGroup& group : model.groups)
        for (int i = 0; i < group.repeat; ++i)
            sequence_.insert(sequence_.end(), group.layers.begin(), group.layers.end());
    if (model.layers.size() > most_media || media_.size() > most_media) throw std::runtime_error("too many layers");
    static std::map<std::pair<std::string, int>, std::shared_ptr<const Light>> known;
    auto& light = known[{model.illuminant, model.observer_deg}];
    if (!light) light = std::make_shared<const Light>(model.illuminant, model.observer_deg);
    light_ = light;
}

const DenseLayers::Grid& DenseLayers::grid(int parts) const {
    auto& known = grids_[parts];
    if (!known) known = std::make_shared<const Grid>(*light_, media_, parts);
    return *known;
}

void DenseLayers::set_thicknesses(double y) const {
    if (model_.y_layer) thickness_nm_[*model_.y_layer] = model_.y_from_nm + (model_.y_to_nm - model_.y_from_nm) * y;
}

double DenseLayers::reflectance_of(double cos_theta, double wavelength_nm, const Complex* indices) const {
    // q = N cos of the angle inside, so that the phase of a passage is 2 pi d q / wavelength; Im q >= 0.
    std::array<Complex, most_media> q, q_p, turn;
    const double n0 = indices[0].real();
    for (std::size_t m = 0; m < media_.size(); ++m) {
        const Complex& n = indices[m];
        Complex q_square = times(n - n0, n + n0) + square(n0 * cos_theta);
        // Bounces of a wave that runs along its layer cannot be summed; at an angle next to that one they can. A layer
        // is even in q, so that it errs by 1e-14; rounding costs 1e-9.
        if (norm_of(q_square) < 1e-28) q_square = 1e-14;
        q[m] = std::sqrt(q_square);
        if (q[m].imag() < 0.0) q[m] = -q[m];
        q_p[m] = over(q[m], times(n, n));
    }
    for (std::size_t i = 0; i < model_.layers.size(); ++i) {
        const Complex phase = q[media_of_layer_[i]] * (4.0 * std::numbers::pi * thickness_nm_[i] / wavelength_nm);
        turn[i] = std::polar(std::exp(-phase.imag()), phase.real());
    }
    // Amplitude from below a face, r; above it (r_face + r) / (1 + r_face r) with r_face = difference / sum.
    const auto face = [](const Complex& above, const Complex& below, const Complex& r) {
        const Complex difference = above - below, sum = above + below;
        return over(difference + times(sum, r), sum + times(difference, r));
    };
    Complex r_s = 0.0, r_p = 0.0;
    std::size_t below = 1;
    for (std::size_t i = sequence_.size(); i-- > 0;) {
        const std::size_t layer = sequence_[i], medium = media_of_layer_[layer];
        r_s = times(turn[layer], face(q[medium], q[below], r_s));
        r_p = times(turn[layer], face(q_p[medium], q_p[below], r_p));
        below = medium;
    }
    return 0.5 * (norm_of(face(q[0], q[below], r_s)) + norm_of(face(q_p[0], q_p[below], r_p)));
}

double DenseLayers::reflectance(double cos_theta, double wavelength_nm, double y) const {
    set_thicknesses(y);
    std::vector<Complex> indices;
    for (const ModelIndex& medium : media_) indices.push_back(index_of(medium, wavelength_nm));
    return reflectance_of(cos_theta, wavelength_nm, indices.data());
}

std::vector<double> DenseLayers::critical_coordinates() const {
    std::vector<double> coordinates;
    for (const double nm : {450.0, 550.0, 650.0}) {
        const double n0 = index_of(media_.front(), nm).real();
        for (const ModelIndex& medium : media_) {
            const double sine = index_of(medium, nm).real() / n0;
            if (sine >= 1.0) continue;
            const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
            coordinates.push_back(model_.x == ModelAxis::sqrt_cos_theta ? std::sqrt(cosine)
                                  : model_.x == ModelAxis::cos_theta    ? cosine
                                                                        : std::asin(sine) * 2.0 / std::numbers::pi);
        }
    }
    std::sort(coordinates.begin(), coordinates.end());
    coordinates.erase(std::unique(coordinates.begin(), coordinates.end()), coordinates.end());
    return coordinates;
}

// Four per nanometre, and a step of at most 0.7 radians of the longest round trip; towards grazing every face is a
// mirror, and fringes become sharp.
int DenseLayers::fewest_parts(double cos_theta) const {
    double path_nm = 0.0;
    for (const std::size_t layer : sequence_)
        path_nm += thickness_nm_[layer] * index_of(model_.layers[layer].index, 450.0).real();
    const double radians_per_nm = 4.0 * std::numbers::pi * path_nm / square(450.0);
    const double parts = radians_per_nm / (0.7 * std::clamp(4.0 * cos_theta, 0.1, 1.0));
    int rounded = 4;
    while (rounded < parts && rounded < 64) rounded *= 2;
    return rounded;
}

double DenseLayers::cost() const {
    double longest_nm = 0.0;
    for (const double y : {0.0, 1.0}) {
        set_thicknesses(y);
        longest_nm = std::max(longest_nm, static_cast<double>(fewest_parts(0.5)));
    }
    return 3.0 * longest_nm * (last_nm - first_nm) * static_cast<double>(2 + sequence_.size() + 2 * media_.size());
}

ModelXyz DenseLayers::sum(double cos_theta, double y, int parts) const {
    set_thicknesses(y);
    const Grid& nodes = grid(parts);
    Triple seen{};
    for (std::size_t i = 0; i < nodes.wavelength_nm.size(); ++i) {
        const double r = reflectance_of(cos_theta, nodes.wavelength_nm[i], &nodes.index[i * media_.size()]);
        for (std::size_t c = 0; c < 3; ++c) seen[c] += r * nodes.weight[i][c];
    }
    return light_->adapted(seen);
}

ModelXyz DenseLayers::at(double x, double y, double tolerance, double scale) const {
    // 90 degrees is the limit from below.
    const double cos_theta = std::max(cosine_at(model_.x, x), 1e-9);
    set_thicknesses(y);
    int parts = fewest_parts(cos_theta);
    constexpr int most_parts = 256;
    ModelXyz colour = sum(cos_theta, y, parts);
    while (parts < most_parts) {
        parts *= 2;
        const ModelXyz finer = sum(cos_theta, y, parts);
        const double change = ciede2000(scaled_lab(colour, scale), scaled_lab(finer, scale));
        colour = finer;
        if (change <= tolerance) return colour;
    }
    ++unsettled_;
    return colour;
}

}  // namespace nacre::reference

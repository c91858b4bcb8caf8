#include "reference/dense_model.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "reference/lobe_quadrature.h"

namespace nacre::reference {
namespace {

constexpr int first_nm = 360;
constexpr int last_nm = 830;
constexpr std::size_t cells = last_nm - first_nm;

// ---- Palette: one text for double and for 50 digits ----

constexpr std::size_t most_picks = 8;
enum LobeMember : std::size_t { peak, width, height, lobe_members };

template <typename T>
using LobeOf = std::array<T, lobe_members>;

template <typename T>
struct Node {
    T abscissa{};  // Y(theta), equation (3.2.5) of Park & Tsuruno
    LobeOf<T> value{}, slope{};
};

template <typename T>
struct Nodes {
    std::array<Node<T>, most_picks> node{};
    std::size_t count = 0;
};

template <typename T>
T abscissa_of(const T& shape, const T& cosine) {
    return cosine * (shape * cosine + (1 - shape));
}

template <typename T>
T secant(const Node<T>& a, const Node<T>& b, std::size_t member) {
    return (b.value[member] - a.value[member]) / (b.abscissa - a.abscissa);
}

// Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5(2): with alpha = (h1 + 2 h2) / (3 (h1 + h2)) the slope is
// S1 S2 / (alpha S2 + (1 - alpha) S1) where the secants agree in sign, else 0. At the ends: the secant.
template <typename T>
void set_slopes(Nodes<T>& nodes) {
    for (std::size_t m = 0; m < lobe_members; ++m) {
        const std::size_t last = nodes.count - 1;
        nodes.node[0].slope[m] = secant(nodes.node[0], nodes.node[1], m);
        nodes.node[last].slope[m] = secant(nodes.node[last - 1], nodes.node[last], m);
        for (std::size_t i = 1; i < last; ++i) {
            const T s1 = secant(nodes.node[i - 1], nodes.node[i], m), s2 = secant(nodes.node[i], nodes.node[i + 1], m);
            const T h1 = nodes.node[i].abscissa - nodes.node[i - 1].abscissa;
            const T h2 = nodes.node[i + 1].abscissa - nodes.node[i].abscissa;
            const T alpha = (h1 + 2 * h2) / (3 * (h1 + h2));
            const bool same_sign = (s1 > 0 && s2 > 0) || (s1 < 0 && s2 < 0);
            nodes.node[i].slope[m] = same_sign ? T(s1 * s2 / (alpha * s2 + (1 - alpha) * s1)) : T(0);
        }
    }
}

// The picks as the second axis leaves them, by ascending Y(theta), which is by descending angle.
template <typename T>
Nodes<T> nodes_of(const SceneModel& scene, const T* pick_cosines, const T& y, T& shape) {
    shape = T(scene.shape);
    const T parameter = scene.y ? T(T(scene.y->from) + (T(scene.y->to) - T(scene.y->from)) * y) : T(0);
    const auto set = [&](const char* name, T& number) {
        if (scene.y && scene.y->name == name) number = parameter;
    };
    set("shape", shape);
    Nodes<T> nodes;
    for (const ModelPick& pick : scene.picks) {
        Node<T>& node = nodes.node[nodes.count];
        node.abscissa = abscissa_of(shape, pick_cosines[nodes.count++]);
        node.value = {T(pick.peak_nm), T(pick.width_nm), T(pick.height)};
        set("peak_nm", node.value[peak]);
        set("width_nm", node.value[width]);
        set("height", node.value[height]);
    }
    std::sort(nodes.node.begin(), nodes.node.begin() + static_cast<std::ptrdiff_t>(nodes.count),
              [](const Node<T>& a, const Node<T>& b) { return a.abscissa < b.abscissa; });
    set_slopes(nodes);
    return nodes;
}

// Cubic Hermite inside (of two picks: a straight line), straight lines outside; then what no surface can do is clamped.
template <typename T>
LobeOf<T> lobe_at(const Nodes<T>& nodes, const T& abscissa) {
    std::size_t right = 1;
    while (right + 1 < nodes.count && abscissa > nodes.node[right].abscissa) ++right;
    const Node<T>&a = nodes.node[right - 1], &b = nodes.node[right];
    const T step = b.abscissa - a.abscissa;
    const T t = (abscissa - a.abscissa) / step;
    LobeOf<T> lobe{};
    for (std::size_t m = 0; m < lobe_members; ++m) {
        if (t < 0) {
            lobe[m] = a.value[m] + a.slope[m] * (abscissa - a.abscissa);
        } else if (t > 1) {
            lobe[m] = b.value[m] + b.slope[m] * (abscissa - b.abscissa);
        } else {
            const T t2 = t * t, t3 = t2 * t;
            lobe[m] = (2 * t3 - 3 * t2 + 1) * a.value[m] + (t3 - 2 * t2 + t) * step * a.slope[m] +
                      (3 * t2 - 2 * t3) * b.value[m] + (t3 - t2) * step * b.slope[m];
        }
    }
    if (lobe[height] < 0) lobe[height] = 0;
    if (lobe[height] > 1) lobe[height] = 1;
    if (lobe[width] < 0) lobe[width] = 0;
    return lobe;
}

template <typename T>
T cosine_at(ModelAxis axis, const T& x, const T& pi_number) {
    using std::cos;
    if (axis == ModelAxis::sqrt_cos_theta) return x * x;
    return axis == ModelAxis::cos_theta ? x : T(cos(x * pi_number / 2));
}

// ---- 3 x 3 matrices ----

template <typename T>
using Matrix = std::array<std::array<T, 3>, 3>;
template <typename T>
using Vector = std::array<T, 3>;

template <typename T>
Vector<T> operator*(const Matrix<T>& m, const Vector<T>& v) {
    Vector<T> product{};
    for (std::size_t i = 0; i < 3; ++i) product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

// By cofactors.
template <typename T>
Matrix<T> inverse(const Matrix<T>& m) {
    Matrix<T> result{};
    T determinant(0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
        determinant += m[0][i] * result[i][0];
    }
    for (auto& row : result)
        for (T& element : row) element /= determinant;
    return result;
}

template <typename T>
Vector<T> from_chromaticity(const T& x, const T& y) {
    return {x / y, T(1), (1 - x - y) / y};
}

template <typename T>
Vector<T> d65_white() {
    return from_chromaticity(T(T(3127) / 10000), T(T(3290) / 10000));
}

// Lam 1985; as printed in the ICC profile specification, annex E.
template <typename T>
Vector<T> bradford_to_d65(const Vector<T>& white, const Vector<T>& colour) {
    const auto ten_thousandth = [](int number) { return T(T(number) / 10000); };
    Matrix<T> cones{};
    constexpr int printed[3][3] = {{8951, 2664, -1614}, {-7502, 17135, 367}, {389, -685, 10296}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) cones[i][j] = ten_thousandth(printed[i][j]);
    const Vector<T> from = cones * white, to = cones * d65_white<T>();
    Vector<T> response = cones * colour;
    for (std::size_t i = 0; i < 3; ++i) response[i] *= to[i] / from[i];
    return inverse(cones) * response;
}

// Columns are the primaries of ITU-R BT.709, scaled so that (1, 1, 1) is D65.
const Matrix<double>& rec709_to_xyz() {
    static const Matrix<double> matrix = [] {
        const Vector<double> primaries[3] = {from_chromaticity(0.64, 0.33), from_chromaticity(0.30, 0.60),
                                             from_chromaticity(0.15, 0.06)};
        Matrix<double> columns{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) columns[i][j] = primaries[j][i];
        const Vector<double> scale = inverse(columns) * d65_white<double>();
        for (auto& row : columns)
            for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
        return columns;
    }();
    return matrix;
}

// ---- Integration over wavelengths ----

// Abscissae and weights on [0, 1].
template <std::size_t points>
struct GaussRule {
    std::array<double, points> node{}, weight{};
    GaussRule() {
        using Rule = boost::math::quadrature::gauss<double, points>;  // holds the half that is not negative
        const auto& abscissa = Rule::abscissa();
        const auto& weights = Rule::weights();
        std::size_t next = 0;
        for (std::size_t i = 0; i < abscissa.size(); ++i) {
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0.0 && abscissa[i] == 0.0) continue;
                node.at(next) = 0.5 + 0.5 * sign * abscissa[i];
                weight.at(next++) = 0.5 * weights[i];
            }
        }
    }
};

template <std::size_t points>
const GaussRule<points>& gauss_rule() {
    static const GaussRule<points> rule;
    return rule;
}

using NodeWeights = std::array<Vector<double>, cells + 1>;

Vector<double> weight_at(const NodeWeights& weights, std::size_t cell, double t) {
    Vector<double> weight{};
    for (std::size_t c = 0; c < 3; ++c) weight[c] = weights[cell][c] + t * (weights[cell + 1][c] - weights[cell][c]);
    return weight;
}

// Quadrature weight times colour weight at the Gauss points of every whole nanometre.
template <std::size_t points>
struct WholeCells {
    std::vector<std::array<Vector<double>, points>> cell;

    explicit WholeCells(const NodeWeights& weights) : cell(cells) {
        const auto& rule = gauss_rule<points>();
        for (std::size_t k = 0; k < cells; ++k) {
            for (std::size_t g = 0; g < points; ++g) {
                cell[k][g] = weight_at(weights, k, rule.node[g]);
                for (double& component : cell[k][g]) component *= rule.weight[g];
            }
        }
    }

    // Adds cells [from, to) of the lobe. The cosine is turned from cell to cell: 470 turns lose 1e-13.
    void add(double peak_nm, double width_nm, int from_nm, int to_nm, Vector<double>& sum) const {
        const double per_nm = std::numbers::pi / width_nm;
        const double turn_cos = std::cos(per_nm), turn_sin = std::sin(per_nm);
        std::array<double, points> cosine{}, sine{};
        for (std::size_t g = 0; g < points; ++g) {
            const double phase = per_nm * (from_nm - peak_nm + gauss_rule<points>().node[g]);
            cosine[g] = std::cos(phase);
            sine[g] = std::sin(phase);
        }
        double x = 0.0, y = 0.0, z = 0.0;
        for (int nm = from_nm; nm < to_nm; ++nm) {
            const auto& at_points = cell[static_cast<std::size_t>(nm - first_nm)];
            for (std::size_t g = 0; g < points; ++g) {
                x += cosine[g] * at_points[g][0];
                y += cosine[g] * at_points[g][1];
                z += cosine[g] * at_points[g][2];
                const double turned = cosine[g] * turn_cos - sine[g] * turn_sin;
                sine[g] = sine[g] * turn_cos + cosine[g] * turn_sin;
                cosine[g] = turned;
            }
        }
        sum = {sum[0] + x, sum[1] + y, sum[2] + z};
    }
};

// A piece that crosses no whole nanometre. Eight points integrate half a turn of the cosine to 1e-15.
void add_piece(const NodeWeights& weights, double peak_nm, double width_nm, double from_nm, double to_nm,
               Vector<double>& sum) {
    if (!(from_nm < to_nm)) return;
    const auto& rule = gauss_rule<8>();
    const double cell_nm = std::min(std::floor(from_nm), last_nm - 1.0);
    const auto cell = static_cast<std::size_t>(cell_nm - first_nm);
    for (std::size_t g = 0; g < 8; ++g) {
        const double nm = from_nm + rule.node[g] * (to_nm - from_nm);
        const double lobe = std::cos(std::numbers::pi * (nm - peak_nm) / width_nm);
        const Vector<double> weight = weight_at(weights, cell, nm - cell_nm);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += rule.weight[g] * (to_nm - from_nm) * lobe * weight[c];
    }
}

Weights weights_of(const SceneModel& scene) {
    const char* file = scene.observer_deg == 10 ? "cmf_cie1964_10deg_1nm.csv" : "cmf_cie1931_2deg_1nm.csv";
    return weights_from_files(file, scene.illuminant, first_nm, last_nm);
}

NodeWeights normalised(const Weights& weights) {
    const Number whole = integral_of(weights.y);
    NodeWeights result{};
    for (std::size_t k = 0; k <= cells; ++k) {
        result[k] = {static_cast<double>(weights.x.at(k) / whole), static_cast<double>(weights.y.at(k) / whole),
                     static_cast<double>(weights.z.at(k) / whole)};
    }
    return result;
}

}  // namespace

// ---- The model ----

struct DenseModel::Light {
    explicit Light(const Weights& table) : weights(normalised(table)), coarse(weights), fine(weights) {
        const XyzNumbers white = white_of(table);
        const Vector<double> seen{static_cast<double>(white.x), 1.0, static_cast<double>(white.z)};
        for (std::size_t j = 0; j < 3; ++j) {
            Vector<double> unit{};
            unit[j] = 1.0;
            const Vector<double> column = bradford_to_d65(seen, unit);
            for (std::size_t i = 0; i < 3; ++i) to_d65[i][j] = column[i];
        }
    }

    // Colour of a lobe of height 1 before adaptation.
    Vector<double> seen(double peak_nm, double width_nm) const {
        Vector<double> sum{};
        const double from = std::max<double>(first_nm, peak_nm - width_nm / 2);
        const double to = std::min<double>(last_nm, peak_nm + width_nm / 2);
        if (!(width_nm > 0.0) || !(from < to)) return sum;
        const int first_whole = static_cast<int>(std::ceil(from)), last_whole = static_cast<int>(std::floor(to));
        if (first_whole > last_whole) {
            add_piece(weights, peak_nm, width_nm, from, to, sum);
            return sum;
        }
        add_piece(weights, peak_nm, width_nm, from, first_whole, sum);
        add_piece(weights, peak_nm, width_nm, last_whole, to, sum);
        // Gauss-Legendre over 1 nm errs by 5e-7 (pi / w)^6 with 3 points, by 4e-13 (pi / w)^10 with 5.
        if (width_nm >= 40.0) {
            coarse.add(peak_nm, width_nm, first_whole, last_whole, sum);
        } else if (width_nm >= 4.0) {
            fine.add(peak_nm, width_nm, first_whole, last_whole, sum);
        } else {
            for (int nm = first_whole; nm < last_whole; ++nm) add_piece(weights, peak_nm, width_nm, nm, nm + 1, sum);
        }
        return sum;
    }

    NodeWeights weights;
    WholeCells<3> coarse;
    WholeCells<5> fine;
    Matrix<double> to_d65{};
};

std::shared_ptr<const DenseModel::Light> DenseModel::light_of(const SceneModel& scene) {
    static std::map<std::pair<std::string, int>, std::shared_ptr<const Light>> known;
    auto& light = known[{scene.illuminant, scene.observer_deg}];
    if (!light) light = std::make_shared<const Light>(weights_of(scene));
    return light;
}

DenseModel::DenseModel(const SceneModel& scene) : scene_(scene), light_(light_of(scene)) {
    if (scene.picks.size() < 2 || scene.picks.size() > most_picks) throw std::runtime_error("2 to 8 picks");
    for (const ModelPick& pick : scene.picks)
        pick_cosines_.push_back(static_cast<double>(cos_of_degrees(pick.angle_deg)));
}

ModelXyz DenseModel::at(double x, double y) const {
    double shape = 0.0;
    const Nodes<double> nodes = nodes_of(scene_, pick_cosines_.data(), y, shape);
    const LobeOf<double> lobe = lobe_at(nodes, abscissa_of(shape, cosine_at(scene_.x, x, std::numbers::pi)));
    if (lobe[height] == 0.0) return {};
    Vector<double> colour = light_->seen(lobe[peak], lobe[width]);
    for (double& component : colour) component *= lobe[height];
    colour = light_->to_d65 * colour;
    return {colour[0], colour[1], colour[2]};
}

XyzNumbers twin_xyz(const SceneModel& scene, double x, double y) {
    std::vector<Number> cosines;
    for (const ModelPick& pick : scene.picks) cosines.push_back(cos_of_degrees(pick.angle_deg));
    Number shape;
    const Nodes<Number> nodes = nodes_of(scene, cosines.data(), Number(y), shape);
    const LobeOf<Number> lobe = lobe_at(nodes, abscissa_of(shape, cosine_at(scene.x, Number(x), pi())));
    const Weights weights = weights_of(scene);
    // The quadrature takes doubles: what rounding moves the lobe by, 1e-13 nm, moves the colour by less than 1e-14.
    const XyzNumbers seen = reference_lobe_to_xyz(weights, static_cast<double>(lobe[peak]),
                                                  static_cast<double>(lobe[width]), static_cast<double>(lobe[height]));
    const XyzNumbers white = white_of(weights);
    const Vector<Number> colour = bradford_to_d65<Number>({white.x, white.y, white.z}, {seen.x, seen.y, seen.z});
    return {colour[0], colour[1], colour[2]};
}

// ---- Colour difference ----

ModelXyz from_rec709(const ModelRgb& rgb) {
    const Vector<double> xyz = rec709_to_xyz() * rgb;
    return {xyz[0], xyz[1], xyz[2]};
}

ModelRgb to_rec709(const ModelXyz& colour) {
    static const Matrix<double> matrix = inverse(rec709_to_xyz());
    return matrix * Vector<double>{colour.x, colour.y, colour.z};
}

ModelLab lab_of(const ModelXyz& colour) {
    static const Vector<double> white = d65_white<double>();
    const auto f = [](double ratio) {
        return ratio > 216.0 / 24389.0 ? std::cbrt(ratio) : (24389.0 / 27.0 * ratio + 16.0) / 116.0;
    };
    const double fx = f(colour.x / white[0]), fy = f(colour.y / white[1]), fz = f(colour.z / white[2]);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

double ciede2000(const ModelLab& one, const ModelLab& two) {
    constexpr double pi_number = std::numbers::pi, degree = pi_number / 180.0, full = 2.0 * pi_number;
    const auto seventh = [](double chroma) {
        const double c7 = std::pow(chroma, 7.0);
        return std::sqrt(c7 / (c7 + 6103515625.0));  // 25^7
    };
    const double mean_chroma = (std::hypot(one.a, one.b) + std::hypot(two.a, two.b)) / 2.0;
    const double g = 0.5 * (1.0 - seventh(mean_chroma));
    const double a1 = (1.0 + g) * one.a, a2 = (1.0 + g) * two.a;
    const double c1 = std::hypot(a1, one.b), c2 = std::hypot(a2, two.b);
    const auto hue = [&](double a, double b) {
        if (a == 0.0 && b == 0.0) return 0.0;
        const double angle = std::atan2(b, a);
        return angle < 0.0 ? angle + full : angle;
    };
    const double h1 = hue(a1, one.b), h2 = hue(a2, two.b);
    const bool grey = c1 * c2 == 0.0;

    double dh = grey ? 0.0 : h2 - h1;
    if (dh > pi_number) dh -= full;
    if (dh < -pi_number) dh += full;
    const double d_l = two.l - one.l, d_c = c2 - c1, d_h = 2.0 * std::sqrt(c1 * c2) * std::sin(dh / 2.0);

    double mean_h = h1 + h2;
    if (!grey) {
        if (std::abs(h1 - h2) > pi_number) mean_h += mean_h < full ? full : -full;
        mean_h /= 2.0;
    }
    const double mean_l = (one.l + two.l) / 2.0, mean_c = (c1 + c2) / 2.0;
    const double t = 1.0 - 0.17 * std::cos(mean_h - 30.0 * degree) + 0.24 * std::cos(2.0 * mean_h) +
                     0.32 * std::cos(3.0 * mean_h + 6.0 * degree) - 0.20 * std::cos(4.0 * mean_h - 63.0 * degree);
    const double bell = (mean_h / degree - 275.0) / 25.0;
    const double rotation = -2.0 * seventh(mean_c) * std::sin(60.0 * degree * std::exp(-bell * bell));
    const double square = (mean_l - 50.0) * (mean_l - 50.0);
    const double l_term = d_l / (1.0 + 0.015 * square / std::sqrt(20.0 + square));
    const double c_term = d_c / (1.0 + 0.045 * mean_c);
    const double h_term = d_h / (1.0 + 0.015 * mean_c * t);
    return std::sqrt(std::max(0.0, l_term * l_term + c_term * c_term + h_term * h_term + rotation * c_term * h_term));
}

// ---- LUTs ----

double as_half(double value) {
    if (value == 0.0) return 0.0;
    // 11 significant bits; below 2^-14 steps of 2^-24. nearbyint rounds ties to even.
    const int exponent = std::max(std::ilogb(value) - 10, -24);
    return std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
}

Pixels make_lut(const DenseModel& model, int width_texels, int height_texels, StoredAs format) {
    Pixels lut{width_texels, height_texels, {}};
    for (int row = 0; row < height_texels; ++row) {
        for (int column = 0; column < width_texels; ++column) {
            const double y = height_texels > 1 ? static_cast<double>(row) / (height_texels - 1) : 0.0;
            ModelRgb rgb = to_rec709(model.at(static_cast<double>(column) / (width_texels - 1), y));
            for (double& component : rgb) {
                component = format == StoredAs::half_float ? as_half(component)
                                                           : static_cast<double>(static_cast<float>(component));
            }
            lut.rgb.push_back(rgb);
        }
    }
    return lut;
}

namespace {

// What a sampler returns at a fraction of the way from texel (column, row) to the next ones.
ModelRgb fetch(const Pixels& lut, int column, int row, double across, double down) {
    const int right = std::min(column + 1, lut.width - 1), below = std::min(row + 1, lut.height - 1);
    const ModelRgb &a = lut.at(column, row), &b = lut.at(right, row);
    const ModelRgb &c = lut.at(column, below), &d = lut.at(right, below);
    ModelRgb rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        rgb[i] =
            (1.0 - down) * ((1.0 - across) * a[i] + across * b[i]) + down * ((1.0 - across) * c[i] + across * d[i]);
    }
    return rgb;
}

double scale_of(const Pixels& lut) {
    double brightest = 0.0;
    for (const ModelRgb& rgb : lut.rgb) brightest = std::max(brightest, from_rec709(rgb).y);
    return brightest > 0.0 ? 1.0 / brightest : 1.0;
}

ModelLab scaled_lab(const ModelXyz& colour, double scale) {
    return lab_of({scale * colour.x, scale * colour.y, scale * colour.z});
}

// Coordinates along one axis of one cell: its first texel and `oversample` - 1 points inside; in the last cell the
// last texel too.
int points_of_cell(int cell, int texels, int oversample) {
    if (texels == 1) return 1;
    return cell == texels - 2 ? oversample + 1 : oversample;
}

double cell_error(const Pixels& lut, const DenseModel& model, int column, int row, int oversample, double scale) {
    double worst = 0.0;
    const int across = points_of_cell(column, lut.width, oversample);
    const int down = points_of_cell(row, lut.height, oversample);
    for (int j = 0; j < down; ++j) {
        const double fy = static_cast<double>(j) / oversample;
        const double y = lut.height > 1 ? (row + fy) / (lut.height - 1) : 0.0;
        for (int i = 0; i < across; ++i) {
            const double fx = static_cast<double>(i) / oversample;
            const double x = lut.width > 1 ? (column + fx) / (lut.width - 1) : 0.0;
            const ModelLab fetched = scaled_lab(from_rec709(fetch(lut, column, row, fx, fy)), scale);
            worst = std::max(worst, ciede2000(fetched, scaled_lab(model.at(x, y), scale)));
        }
    }
    return worst;
}

// The step-th index below count: steps of the golden section, so that any number of them is spread evenly, and `count`
// of them are all.
std::size_t spread_index(std::size_t step, std::size_t count) {
    auto stride = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(count)) + 1;
    while (std::gcd(stride, count) != 1) ++stride;
    return step * stride % count;
}

}  // namespace

double dense_error(const Pixels& stored, const DenseModel& model, const Density& density) {
    const double scale = scale_of(stored);
    const auto columns = static_cast<std::size_t>(std::max(stored.width - 1, 1));
    const auto all = columns * static_cast<std::size_t>(std::max(stored.height - 1, 1));
    const auto points_of = [&](int oversample) {
        const auto per_axis = static_cast<std::size_t>(oversample);
        return stored.height > 1 ? per_axis * per_axis : per_axis;
    };
    const auto error_of = [&](std::size_t cell, int oversample) {
        const int column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
        return cell_error(stored, model, column, row, oversample, scale);
    };
    const bool all_fit = all <= density.most_points / points_of(density.oversample);
    // Too many points: texels and middles first, and then the worst cells as closely as was asked.
    const int first_look = all_fit ? density.oversample : 2;
    const std::size_t visited =
        all_fit ? all : std::clamp<std::size_t>(density.most_points / 2 / points_of(first_look), 1, all);
    std::vector<std::pair<double, std::size_t>> cells_by_error;
    double worst = 0.0;
    for (std::size_t step = 0; step < visited && worst <= density.enough; ++step) {
        const std::size_t cell = spread_index(step, all);
        cells_by_error.emplace_back(error_of(cell, first_look), cell);
        worst = std::max(worst, cells_by_error.back().first);
    }
    if (all_fit) return worst;
    std::sort(cells_by_error.rbegin(), cells_by_error.rend());
    const std::size_t closely = density.most_points / 2 / points_of(density.oversample);
    for (std::size_t i = 0; i < std::min(closely, visited) && worst <= density.enough; ++i)
        worst = std::max(worst, error_of(cells_by_error[i].second, density.oversample));
    return worst;
}

double dense_error(const Pixels& stored, const SceneModel& scene, int oversample) {
    Density density;
    density.oversample = oversample;
    return dense_error(stored, DenseModel(scene), density);
}

}  // namespace nacre::reference

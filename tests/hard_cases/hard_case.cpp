#include "hard_cases/hard_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "nacre/optics/incidence.h"
#include "reference/exact_multilayer.h"

namespace nacre::hard_cases {

using reference::ExactMultilayer;
using reference::ExactNode;
using reference::ExactResponse;
using reference::Wide;

Stack& Stack::layer(RefractiveIndex index, double thickness_nm) {
    items.push_back({Kind::layer, index, thickness_nm, 0});
    return *this;
}
Stack& Stack::incoherent_layer(RefractiveIndex index, double thickness_nm) {
    items.push_back({Kind::incoherent_layer, index, thickness_nm, 0});
    return *this;
}
Stack& Stack::begin_group(int repeat) {
    items.push_back({Kind::begin_group, {}, 0.0, repeat});
    return *this;
}
Stack& Stack::end_group() {
    items.push_back({Kind::end_group, {}, 0.0, 0});
    return *this;
}

Stack Stack::reversed() const {
    Stack mirrored(substrate, incident);
    std::vector<std::size_t> begins;
    std::vector<int> repeat_of_end(items.size(), 0);
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].kind == Kind::begin_group) begins.push_back(i);
        if (items[i].kind != Kind::end_group) continue;
        repeat_of_end[i] = items[begins.back()].repeat;
        begins.pop_back();
    }
    for (std::size_t i = items.size(); i-- > 0;) {
        if (items[i].kind == Kind::begin_group) {
            mirrored.end_group();
        } else if (items[i].kind == Kind::end_group) {
            mirrored.begin_group(repeat_of_end[i]);
        } else {
            mirrored.items.push_back(items[i]);
        }
    }
    return mirrored;
}

LayerSystem layer_system(const Stack& stack) {
    LayerSystemBuilder builder{Index(stack.incident), Index(stack.substrate)};
    for (const Stack::Item& item : stack.items) {
        switch (item.kind) {
            case Stack::Kind::layer:
                builder.layer(Index(item.index), item.thickness_nm);
                break;
            case Stack::Kind::incoherent_layer:
                builder.layer(Index(item.index), item.thickness_nm, true);
                break;
            case Stack::Kind::begin_group:
                builder.begin_group(item.repeat);
                break;
            case Stack::Kind::end_group:
                builder.end_group();
                break;
        }
    }
    return builder.take();
}

namespace {

std::string digits(const Wide& value) {
    return value.str(20);
}
std::string digits(double value) {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
}

/// Writes a stack down for the reference, every number once.
class ExactWriter {
public:
    explicit ExactWriter(const HardCase& hard_case) {
        const Stack& stack = hard_case.stack;
        exact_.incident = medium(stack.incident);
        exact_.substrate = medium(stack.substrate);
        exact_.theta_deg = hard_case.theta_deg;
        exact_.wavelength_nm = hard_case.wavelength_nm;
        std::size_t at = 0;
        exact_.nodes = nodes(stack.items, at);
    }
    ExactMultilayer take() { return std::move(exact_); }

private:
    std::size_t medium(RefractiveIndex index) {
        const auto found = std::find(media_.begin(), media_.end(), index);
        if (found != media_.end()) return static_cast<std::size_t>(found - media_.begin());
        media_.push_back(index);
        exact_.media.push_back({index.real(), index.imag()});
        return media_.size() - 1;
    }
    std::size_t thickness(double thickness_nm) {
        const auto found = std::find(thicknesses_.begin(), thicknesses_.end(), thickness_nm);
        if (found != thicknesses_.end()) return static_cast<std::size_t>(found - thicknesses_.begin());
        thicknesses_.push_back(thickness_nm);
        exact_.thicknesses_nm.emplace_back(thickness_nm);
        return thicknesses_.size() - 1;
    }
    /// Up to the end of the group, or of all.
    std::vector<ExactNode> nodes(const std::vector<Stack::Item>& items, std::size_t& at) {
        std::vector<ExactNode> written;
        while (at < items.size()) {
            const Stack::Item& item = items[at++];
            if (item.kind == Stack::Kind::end_group) break;
            ExactNode node;
            node.repeat = item.repeat;
            node.is_incoherent = item.kind == Stack::Kind::incoherent_layer;
            if (item.kind == Stack::Kind::begin_group) {
                node.members = nodes(items, at);
            } else {
                node.medium = medium(item.index);
                node.thickness = thickness(item.thickness_nm);
            }
            written.push_back(std::move(node));
        }
        return written;
    }

    ExactMultilayer exact_;
    std::vector<RefractiveIndex> media_;
    std::vector<double> thicknesses_;
};

using FourWide = std::array<Wide, 4>;

FourWide exact_values(const ExactMultilayer& layers) {
    const ExactResponse exact = reference::exact_response(layers);
    return {exact.reflectance_s, exact.reflectance_p, exact.transmittance_s, exact.transmittance_p};
}

/// Adds the larger of the changes that an input makes, one half-ulp or so up and down.
void add_change(const FourWide& exact, ExactMultilayer& layers, Wide& input, Four& sum) {
    const Wide typed_in = input;
    if (typed_in == 0) return;
    Four larger{};
    for (const double relative : {0x1p-52, -0x1p-52}) {
        if (&input == &layers.theta_deg && typed_in == 90 && relative > 0.0) continue;  // there is nothing beyond
        input = typed_in + typed_in * relative;
        const FourWide changed = exact_values(layers);
        for (std::size_t i = 0; i < 4; ++i) {
            larger[i] = std::max(larger[i], static_cast<double>(abs(changed[i] - exact[i])));
        }
    }
    input = typed_in;
    for (std::size_t i = 0; i < 4; ++i) sum[i] += larger[i];
}

}  // namespace

Four four(const Response& response) {
    return {response.reflectance_s, response.reflectance_p, response.transmittance_s, response.transmittance_p};
}

Four scalar_response(const HardCase& hard_case) {
    return four(multilayer_response(layer_system(hard_case.stack), Incidence::from_degrees(hard_case.theta_deg),
                                    hard_case.wavelength_nm));
}

Four solver_response(const HardCase& hard_case) {
    const double nm = hard_case.wavelength_nm;
    // Eleven: no multiple of any number of lanes, so that the padding is seen as well.
    const std::array<double, 11> wavelengths_nm{nm,       1.3 * nm, 0.7 * nm, 1.9 * nm, 0.9 * nm, nm,
                                                0.4 * nm, 1.1 * nm, 5.0 * nm, 0.8 * nm, nm};
    std::array<Response, 11> all;
    MultilayerSolver(layer_system(hard_case.stack), wavelengths_nm)
        .responses(Incidence::from_degrees(hard_case.theta_deg), all);
    for (const std::size_t same : {5U, 10U}) {
        const Four one = four(all[0]), other = four(all[same]);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(one[i], other[i]) << hard_case.name << ", place " << same << ": " << digits(one[i]) << " and "
                                        << digits(other[i]);
    }
    return four(all[0]);
}

Four exact_four(const HardCase& hard_case) {
    const FourWide exact = exact_values(ExactWriter(hard_case).take());
    Four rounded{};
    for (std::size_t i = 0; i < 4; ++i) rounded[i] = static_cast<double>(exact[i]);
    return rounded;
}

Four conditioning(const HardCase& hard_case) {
    ExactMultilayer layers = ExactWriter(hard_case).take();
    const FourWide exact = exact_values(layers);
    Four sum{};
    for (reference::ExactIndex& index : layers.media) {
        add_change(exact, layers, index.n, sum);
        add_change(exact, layers, index.k, sum);
    }
    for (Wide& thickness_nm : layers.thicknesses_nm) add_change(exact, layers, thickness_nm, sum);
    add_change(exact, layers, layers.theta_deg, sum);
    add_change(exact, layers, layers.wavelength_nm, sum);
    return sum;
}

namespace {

// What is allowed of number i (R_s, R_p, T_s, T_p) before anything is said of conditioning.
double tolerance(const Stack& stack, Measure measure, std::size_t i, double exact) {
    if (i < 2) return base_tolerance;
    const double all = base_tolerance + allowed_per_layer * expanded_layers(layer_system(stack));
    if (measure == Measure::absolute) return all;
    return std::max(exact, 1e-250) * all * (1.0 + std::abs(std::log(std::max(exact, 1e-250))));
}

}  // namespace

Family::~Family() {
    std::ostringstream ratio;
    ratio << std::setprecision(3) << worst_ratio_;
    testing::Test::RecordProperty("worst_error_over_allowed", ratio.str());
    testing::Test::RecordProperty("worst_case", worst_);
}

struct Family::Truth {
    FourWide exact;
    std::optional<Four> condition;
};

void Family::expect_exact(const HardCase& hard_case) {
    Truth truth{exact_values(ExactWriter(hard_case).take()), std::nullopt};
    compare(hard_case, truth, "multilayer_response", scalar_response(hard_case));
    compare(hard_case, truth, "MultilayerSolver", solver_response(hard_case));
}

void Family::expect_solver_exact(const HardCase& hard_case) {
    Truth truth{exact_values(ExactWriter(hard_case).take()), std::nullopt};
    compare(hard_case, truth, "MultilayerSolver", solver_response(hard_case));
}

void Family::compare(const HardCase& hard_case, Truth& truth, const std::string& solver, const Four& got) {
    static constexpr std::array<const char*, 4> names{"R_s", "R_p", "T_s", "T_p"};
    const FourWide& exact = truth.exact;
    for (std::size_t i = 0; i < 4; ++i) {
        const double base = tolerance(hard_case.stack, measure_, i, static_cast<double>(exact[i]));
        const double error = std::isfinite(got[i]) ? static_cast<double>(abs(exact[i] - got[i])) : HUGE_VAL;
        if (error > base && !truth.condition) truth.condition = conditioning(hard_case);
        const double condition = truth.condition ? (*truth.condition)[i] : 0.0;
        const double allowed = base + allowed_ulps * condition;
        EXPECT_LE(error, allowed) << names[i] << " of " << hard_case.name << " at " << digits(hard_case.theta_deg)
                                  << " degrees, " << digits(hard_case.wavelength_nm) << " nm, by " << solver
                                  << "\n  expected " << digits(exact[i]) << "\n  got      " << digits(got[i])
                                  << "\n  conditioning " << condition;
        if (error / allowed <= worst_ratio_) continue;
        worst_ratio_ = error / allowed;
        std::ostringstream text;
        text << names[i] << " of " << hard_case.name << " at " << hard_case.theta_deg << " by " << solver << ": "
             << std::setprecision(3) << error << ", allowed " << allowed;
        worst_ = text.str();
    }
}

void expect_equal(const HardCase& hard_case, const Four& one, const Four& other, const std::string& what) {
    Four condition{};
    bool is_known = false;
    for (std::size_t i = 0; i < 4; ++i) {
        const double difference = std::abs(one[i] - other[i]);
        const double base = tolerance(hard_case.stack, Measure::absolute, i, one[i]);
        if (!(difference <= base) && !is_known) {
            condition = conditioning(hard_case);
            is_known = true;
        }
        EXPECT_LE(difference, base + allowed_ulps * condition[i])
            << what << ": number " << i << " of " << hard_case.name << " at " << digits(hard_case.theta_deg)
            << " degrees, " << digits(hard_case.wavelength_nm) << " nm: " << digits(one[i]) << " and "
            << digits(other[i]) << ", conditioning " << condition[i];
    }
}

std::vector<double> angles_to_grazing() {
    return {0.0, 1e-9, 30.0, 45.0, 56.3, 75.0, 89.9, 89.9999, 89.999999999, 90.0};
}

}  // namespace nacre::hard_cases

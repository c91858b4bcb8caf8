// Colours of gratings by an independent method: lines at even steps of wavelength, or wave by wave where they are many.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "nacre/accuracy/reference.h"
#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

using std::numbers::pi;

}  // namespace

struct Reference::Lines {
    Grating grating;  // in the plane across its grooves
    std::vector<int> orders;
    std::map<std::size_t, std::vector<double>> efficiencies{};  // by the number of wavelengths; orders in a row
    int cells = 0;                                              // to begin with
};

namespace {

// sinc^2(grooves * off). @param sine  its sine, over pi and grooves
double line_at(double off, double grooves, double sine) {
    constexpr double top = 1e-3;  // the next term is below 1e-11
    const double phase = pi * grooves * off;
    return std::abs(phase) < top ? 1.0 - phase * phase / 3.0 : sine * sine / (off * off);
}

// The lines of all orders at one wavelength: their sines are the same.
double lines_at(double x, double grooves, const std::vector<int>& orders, const double* efficiencies) {
    const double sine = std::sin(pi * grooves * (x - std::nearbyint(x))) / (pi * grooves);
    const auto line = [&](double off) { return line_at(off, grooves, sine); };
    double sum = 0.0;
    for (std::size_t i = 0; i < orders.size(); ++i)
        sum += efficiencies[i] * (line(x - orders[i]) + (orders[i] == 0 ? 0.0 : line(x + orders[i])));
    return sum;
}

}  // namespace

Xyz Reference::lines(const Grating& grating, double u) const {
    constexpr double many_waves_per_nm = 4.0;
    constexpr std::size_t many_orders = 64;  // a table of them would be large
    constexpr int most_cells = 1 << 16;      // likewise; of four waves per nanometre that is more than enough
    Grating across = grating;
    across.azimuth_deg = across.groove_length_um = 0.0;
    const double first_nm = job_.light->settings.first_nm;
    if (!lines_ || !(lines_->grating == across))
        lines_ = std::make_shared<Lines>(Lines{across, counted_orders(grating, first_nm)});
    if (std::isinf(azimuth_exponent(grating, u, first_nm))) return {};
    const std::vector<int>& orders = lines_->orders;
    const double path_nm = u * share_across(grating) * grating.period_nm;
    if (grating.grooves * path_nm > many_waves_per_nm * first_nm * first_nm || orders.size() > many_orders)
        return wave_by_wave(grating, orders, u);
    const auto spectrum = [&](const std::vector<double>& nm) {
        std::vector<double>& efficiencies = lines_->efficiencies[nm.size()];
        if (efficiencies.empty()) {
            efficiencies.resize(nm.size() * orders.size());
            for (std::size_t i = 0; i < nm.size(); ++i)
                grating_efficiencies(grating, orders, nm[i],
                                     std::span(efficiencies).subspan(i * orders.size(), orders.size()));
        }
        std::vector<double> seen(nm.size());
        for (std::size_t i = 0; i < seen.size(); ++i)
            seen[i] = grating.grooves * grating.period_nm / nm[i] * std::exp(-azimuth_exponent(grating, u, nm[i])) *
                      lines_at(path_nm / nm[i], grating.grooves, orders, &efficiencies[i * orders.size()]);
        return seen;
    };
    return integral(1.0, lines_->cells, spectrum, most_cells);
}

// Every order's line, wave by wave where it is bright; far away by its mean, 1 / (2 pi^2 t^2).
Xyz Reference::wave_by_wave(const Grating& grating, const std::vector<int>& orders, double u) const {
    constexpr double far = 200.0;  // in widths of a line: what its waves sum to beyond is 2e-7 of it
    constexpr double waves_per_step = 0.5;
    constexpr double least_waves_per_nm = 0.05;  // broader ones are taken all: nothing averages them
    const LightSettings& light = job_.light->settings;
    const double path_nm = u * share_across(grating) * grating.period_nm;
    Xyz sum;
    const auto add_light = [&](int order, double nm, double length_nm, bool is_mean) {
        const double off = path_nm / nm - order;
        const double sine = is_mean ? std::numbers::sqrt2 / 2.0 : std::sin(pi * grating.grooves * off);
        const double density = grating_efficiency(grating, order, nm) * grating.grooves * grating.period_nm / nm *
                               line_at(off, grating.grooves, sine / (pi * grating.grooves)) *
                               std::exp(-azimuth_exponent(grating, u, nm));
        add(sum, length_nm * density, weight_at(nm));
    };
    const auto add_order = [&](int order) {
        for (double left = light.first_nm, right = left; left < light.last_nm; left = right) {
            const double t = grating.grooves * (path_nm / left - order);
            const double waves_per_nm = std::max(grating.grooves * path_nm / (left * left), 1e-9);
            const bool is_far = waves_per_nm > least_waves_per_nm && (t > far + waves_per_nm || t < -far);
            right = std::min(next_kink(left), static_cast<double>(light.last_nm));
            if (!is_far) right = std::min(right, left + waves_per_step / waves_per_nm);
            for (const GaussPoint& point : rule_)
                add_light(order, std::lerp(left, right, point.at), point.weight * (right - left), is_far);
        }
    };
    for (const int magnitude : orders) {
        add_order(magnitude);
        if (magnitude != 0) add_order(-magnitude);
    }
    return sum;
}

}  // namespace nacre

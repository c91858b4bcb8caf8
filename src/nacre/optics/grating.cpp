#include "nacre/optics/grating.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

double square(double x) {
    return x * x;
}

// (sin(pi x) / (pi x))^2, with the argument reduced first: the zeros lie where they belong, however far off.
double sinc_squared(double x) {
    if (std::abs(x) < 1e-9) return 1.0;
    return square(std::sin(pi * (x - std::nearbyint(x))) / (pi * x));
}

double given_efficiency(const std::vector<double>& given, int order) {
    if (order > 0) {
        const auto i = static_cast<std::size_t>(order) - 1;
        return i < given.size() ? given[i] : 0.0;
    }
    double rest = 1.0;
    for (const double efficiency : given) rest -= 2.0 * efficiency;
    return std::max(rest, 0.0);
}

// (sin(pi m D) / (pi m))^2, or D (1 - D) for order 0. m D is reduced before the sine, so that even orders of equal land
// and groove are dark to the last bit.
double lamellar_share(double land, int order) {
    if (order == 0) return land * (1.0 - land);
    const double turns = order * land;
    return square(std::sin(pi * (turns - std::nearbyint(turns))) / (pi * order));
}

// J_m(z)^2 where J_0 is 1 to the last bit: only the first term of the series is left.
void small_bessel_squares(double z, std::span<const int> orders, std::span<double> squares) {
    for (std::size_t i = 0; i < orders.size(); ++i) {
        double term = 1.0;
        for (int k = 1; k <= orders[i] && term > 0.0; ++k) term *= 0.5 * z / k;
        squares[i] = square(term);
    }
}

// Beyond it J_m(z)^2 is below 1e-320: J_m(z) < (e z / (2 m))^m (DLMF 10.14.4 and Stirling).
int last_order_with_light(double z) {
    double m = std::ceil(z) + 20.0;
    while (m * std::log(2.0 * m / (std::numbers::e * z)) < 370.0) m = std::ceil(1.05 * m);
    return static_cast<int>(m);
}

// J_m(z)^2 by Miller's downward recurrence J_(m-1) = (2 m / z) J_m - J_(m+1) (DLMF 10.6.1 and 3.6(v)).
// It is scaled by J_0^2 + 2 J_1^2 + 2 J_2^2 + ... = 1 (DLMF 10.23.3), in which nothing cancels.
void bessel_squares(double z, std::span<const int> orders, std::span<double> squares) {
    if (z < 1e-8) return small_bessel_squares(z, orders, squares);
    const int last = last_order_with_light(z);
    const double most = std::max(z, static_cast<double>(std::min(orders.back(), last)));
    // Beyond order z the wrong solution grows as the right one falls, like Airy functions of (m - z) (2 / z)^(1/3):
    // so far out, what the start has of it is below 1e-17 of every order that is asked for.
    const int start = static_cast<int>(most + 20.0 + 10.0 * std::cbrt(most));
    constexpr double large = 1e100;
    double above = 0.0;
    double here = 1e-100;
    double sum = 0.0;
    std::size_t next = orders.size();  // orders from this one on have their squares, in the scale of `here`
    while (next > 0 && orders[next - 1] > last) squares[--next] = 0.0;
    for (int m = start; m >= 0; --m) {
        if (std::abs(here) > large) {
            above /= large;
            here /= large;
            sum = sum / large / large;
            for (std::size_t i = next; i < orders.size(); ++i) squares[i] = squares[i] / large / large;
        }
        if (next > 0 && orders[next - 1] == m) squares[--next] = square(here);
        sum += (m == 0 ? 1.0 : 2.0) * square(here);
        const double below = 2.0 * m / z * here - above;
        above = here;
        here = below;
    }
    for (double& value : squares) value /= sum;
}

}  // namespace

int largest_visible_order(const Grating& grating, double least_nm) {
    assert(grating.period_nm > 0.0 && least_nm > 0.0);
    return static_cast<int>(std::floor(2.0 * grating.period_nm / least_nm));
}

std::vector<int> counted_orders(const Grating& grating, double least_nm) {
    const int largest = largest_visible_order(grating, least_nm);
    std::vector<int> orders;
    if (grating.orders.empty()) {
        for (int m = 1; m <= largest; ++m) orders.push_back(m);
    } else {
        for (const int m : grating.orders) {
            if (m <= largest) orders.push_back(m);
        }
    }
    return orders;
}

double coat_reflectance(const Grating& grating, double wavelength_nm) {
    if (!grating.coat) return 1.0;
    const RefractiveIndex n = grating.coat->at(wavelength_nm);
    return std::norm((n - 1.0) / (n + 1.0));
}

std::vector<double> order_shares(const Grating& grating, std::span<const int> orders) {
    std::vector<double> shares;
    for (const int order : orders) {
        if (grating.profile == GratingProfile::given) shares.push_back(given_efficiency(grating.efficiency, order));
        if (grating.profile == GratingProfile::lamellar) shares.push_back(lamellar_share(grating.land, order));
    }
    return shares;
}

void grating_efficiencies(const Grating& grating, std::span<const int> orders, std::span<const double> shares,
                          double wavelength_nm, std::span<double> efficiency) {
    assert(wavelength_nm > 0.0 && grating.depth_nm >= 0.0 && efficiency.size() == orders.size());
    assert(grating.profile == GratingProfile::sinusoidal || shares.size() == orders.size());
    if (orders.empty()) return;
    const double half_phase = 2.0 * pi * grating.depth_nm / wavelength_nm;
    switch (grating.profile) {
        case GratingProfile::given:
            std::copy(shares.begin(), shares.end(), efficiency.begin());
            break;
        case GratingProfile::lamellar: {
            const double bright = square(std::sin(half_phase));  // how far top and bottom are out of step
            for (std::size_t i = 0; i < orders.size(); ++i)
                efficiency[i] = orders[i] == 0 ? 1.0 - 4.0 * shares[i] * bright : 4.0 * bright * shares[i];
            break;
        }
        case GratingProfile::sinusoidal:
            bessel_squares(half_phase, orders, efficiency);
            break;
    }
    const double coat = coat_reflectance(grating, wavelength_nm);
    for (double& value : efficiency) value *= coat;
}

void grating_efficiencies(const Grating& grating, std::span<const int> orders, double wavelength_nm,
                          std::span<double> efficiency) {
    grating_efficiencies(grating, orders, order_shares(grating, orders), wavelength_nm, efficiency);
}

double grating_efficiency(const Grating& grating, int order, double wavelength_nm) {
    const int size = std::abs(order);
    double efficiency = 0.0;
    grating_efficiencies(grating, {&size, 1}, wavelength_nm, {&efficiency, 1});
    return efficiency;
}

double share_across(const Grating& grating) {
    return grating.azimuth_deg == 90.0 ? 0.0 : std::cos(grating.azimuth_deg * pi / 180.0);
}

double azimuth_exponent(const Grating& grating, double u, double wavelength_nm) {
    const double along = u * std::sin(grating.azimuth_deg * pi / 180.0);
    if (along == 0.0) return 0.0;
    if (grating.groove_length_um == 0.0) return std::numeric_limits<double>::infinity();
    return pi * square(1000.0 * grating.groove_length_um * along / wavelength_nm);
}

double grating_density(const Grating& grating, const std::vector<int>& orders, double u, double wavelength_nm) {
    assert(u >= 0.0 && u <= 2.0 && grating.grooves >= 1);
    const double n = grating.grooves;
    const double across = u * share_across(grating) * grating.period_nm / wavelength_nm;
    std::vector<double> efficiency(orders.size());
    grating_efficiencies(grating, orders, wavelength_nm, efficiency);
    double sum = 0.0;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const int m = orders[i];
        double line = sinc_squared(n * (across - m));
        if (m != 0) line += sinc_squared(n * (across + m));
        sum += efficiency[i] * line;
    }
    return sum * n * grating.period_nm / wavelength_nm * std::exp(-azimuth_exponent(grating, u, wavelength_nm));
}

}  // namespace nacre

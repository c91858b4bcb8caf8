// The reference against textbooks' closed forms, in its own 100 digits. Where a form is exact, 1e-60 is allowed: the
// forms lose some ten digits, and cases with q near 0 some forty.
#include "reference/exact_multilayer.h"

#include <gtest/gtest.h>

#include <vector>

namespace nacre::reference {
namespace {

const Wide pi = boost::math::constants::pi<Wide>();

Wide radians(const Wide& degrees) {
    return degrees * pi / 180;
}
Wide square(const Wide& value) {
    return value * value;
}
Wide norm_of(const WideComplex& value) {
    return square(value.real()) + square(value.imag());
}

/// Film by film from the front, every layer with numbers of its own.
ExactMultilayer multilayer(const ExactIndex& incident, const std::vector<std::pair<ExactIndex, Wide>>& films,
                           const ExactIndex& substrate, const Wide& theta_deg = 0, const Wide& wavelength_nm = 500) {
    ExactMultilayer layers;
    layers.media = {incident, substrate};
    layers.substrate = 1;
    layers.theta_deg = theta_deg;
    layers.wavelength_nm = wavelength_nm;
    for (const auto& [index, thickness_nm] : films) {
        layers.nodes.push_back({layers.media.size(), layers.thicknesses_nm.size(), false, 0, {}});
        layers.media.push_back(index);
        layers.thicknesses_nm.push_back(thickness_nm);
    }
    return layers;
}

void expect_near(const Wide& number, const Wide& expected, const char* tolerance = "1e-60") {
    EXPECT_LT(abs(number - expected), Wide(tolerance)) << number.str(30) << " and " << expected.str(30);
}

TEST(ExactMultilayer, OneFaceIsFresnelsSinesAndTangents) {
    // Born & Wolf, Principles of Optics, 7th ed., section 1.5, equation (21a).
    for (const char* theta : {"10", "33.3", "60", "89"}) {
        const Wide inside = asin(sin(radians(Wide(theta))) / Wide("1.5")), outside = radians(Wide(theta));
        const ExactResponse glass = exact_response(multilayer({1, 0}, {}, {Wide("1.5"), 0}, Wide(theta)));
        expect_near(glass.reflectance_s, square(sin(outside - inside) / sin(outside + inside)));
        expect_near(glass.reflectance_p, square(tan(outside - inside) / tan(outside + inside)));
        expect_near(glass.transmittance_s, 1 - glass.reflectance_s);
        expect_near(glass.transmittance_p, 1 - glass.reflectance_p);
    }
}

TEST(ExactMultilayer, BrewstersAngleReflectsNothingOfPAndNormalMetalIsTextbook) {
    const Wide n = Wide("1.5"), k = Wide("3.9");
    expect_near(exact_response(multilayer({1, 0}, {}, {n, 0}, atan(n) * 180 / pi)).reflectance_p, 0);
    const ExactResponse metal = exact_response(multilayer({1, 0}, {}, {n, k}));
    // Born & Wolf section 14.2, equation (9), with k = n kappa.
    expect_near(metal.reflectance_s, (square(n - 1) + square(k)) / (square(n + 1) + square(k)));
    expect_near(metal.reflectance_p, metal.reflectance_s);
}

TEST(ExactMultilayer, OneTransparentFilmIsAirysFormula) {
    // Born & Wolf section 1.6, equation (60): R = (r12^2 + r23^2 + 2 r12 r23 cos 2b) / (1 + (r12 r23)^2 + 2 ...).
    const Wide n1("2.3"), n2("1.5"), theta = radians(40), d = 137;
    const Wide cos_1 = sqrt(1 - square(sin(theta) / n1)), cos_2 = sqrt(1 - square(sin(theta) / n2));
    const Wide r12 = (cos(theta) - n1 * cos_1) / (cos(theta) + n1 * cos_1);
    const Wide r23 = (n1 * cos_1 - n2 * cos_2) / (n1 * cos_1 + n2 * cos_2);
    const Wide both = 2 * r12 * r23 * cos(4 * pi * n1 * d * cos_1 / 500);
    const ExactResponse film = exact_response(multilayer({1, 0}, {{{n1, 0}, d}}, {n2, 0}, 40));
    expect_near(film.reflectance_s, (square(r12) + square(r23) + both) / (1 + square(r12 * r23) + both));
    expect_near(film.reflectance_s + film.transmittance_s, 1);
    expect_near(film.reflectance_p + film.transmittance_p, 1);
}

TEST(ExactMultilayer, OneAbsorbingFilmIsItsCharacteristicMatrixAndAGainIsNot) {
    // Heavens, Optical Properties of Thin Solid Films, section 4.8: (B, C) of one film at normal incidence, written
    // with n + ik: B = cos a - i Y/N sin a, C = Y cos a - i N sin a. Complex sines are written out in real ones.
    const Wide d = 40, substrate("1.5"), n("0.8"), k("2.1"), x = 2 * pi * n * d / 500, y = 2 * pi * k * d / 500;
    const WideComplex index(n, k), cosine(cos(x) * cosh(y), -sin(x) * sinh(y)), i(0, 1);
    const WideComplex sine(sin(x) * cosh(y), cos(x) * sinh(y)), y0(1), ys(substrate);
    const WideComplex b = cosine - i * ys * sine / index, c = ys * cosine - i * index * sine;
    const ExactResponse film = exact_response(multilayer({1, 0}, {{{n, k}, d}}, {substrate, 0}));
    const Wide reflectance = norm_of((y0 * b - c) / (y0 * b + c));
    expect_near(film.reflectance_s, reflectance);
    expect_near(film.transmittance_p, 4 * substrate / norm_of(y0 * b + c));
    EXPECT_LT(film.reflectance_s + film.transmittance_s, Wide("0.9"));
    // A slip of the sign of k, in n or in the sine, is no small thing here.
    const ExactResponse gain = exact_response(multilayer({1, 0}, {{{n, -k}, d}}, {substrate, 0}));
    EXPECT_GT(abs(gain.reflectance_s - reflectance), Wide("0.1"));
}

TEST(ExactMultilayer, AQuarterWaveMirrorHasItsClosedForm) {
    // Born & Wolf section 1.6, equation (99): R of (HL)^N on a substrate, all quarter waves.
    const Wide high("2.3"), low("1.38"), substrate("1.52");
    for (const int pairs : {1, 2, 7, 50, 50000}) {
        ExactMultilayer layers = multilayer({1, 0}, {{{high, 0}, 125 / high}, {{low, 0}, 125 / low}}, {substrate, 0});
        layers.nodes = {{0, 0, false, pairs, layers.nodes}};
        const Wide admittance = substrate * pow(high / low, 2 * pairs);
        const ExactResponse mirror = exact_response(layers);
        expect_near(mirror.reflectance_s, square((1 - admittance) / (1 + admittance)));
        expect_near(mirror.transmittance_p / (4 * admittance / square(1 + admittance)), 1);
    }
}

TEST(ExactMultilayer, AGroupIsItsLayersOneByOneAndTheFieldsAreChebyshevs) {
    const Wide high("2.3"), low("1.38"), theta(50), nm(431);
    ExactMultilayer flat =
        multilayer({1, 0}, {{{high, Wide("0.01")}, 60}, {{low, 0}, 90}}, {Wide("1.5"), 0}, theta, nm);
    ExactMultilayer grouped = flat, nested = flat;
    const std::vector<ExactNode> pair = flat.nodes;
    for (int i = 1; i < 12; ++i) flat.nodes.insert(flat.nodes.end(), pair.begin(), pair.end());
    grouped.nodes = {{0, 0, false, 12, pair}};
    nested.nodes = {{0, 0, false, 2, {{0, 0, false, 5, pair}, pair[0], pair[1]}}};
    const ExactResponse one = exact_response(flat);
    for (const ExactMultilayer& layers : {grouped, nested}) {
        const ExactResponse other = exact_response(layers);
        expect_near(other.reflectance_s, one.reflectance_s);
        expect_near(other.reflectance_p, one.reflectance_p);
        expect_near(other.transmittance_s, one.transmittance_s);
        expect_near(other.transmittance_p, one.transmittance_p);
    }
}

TEST(ExactMultilayer, AFrustratedWaveTunnelsAsHallsFormulaSays) {
    // T = 1 / (1 + ((1 + x^2) / 2x)^2 sinh^2 y) for s, x the ratio of the wave's decay to its advance (Born & Wolf
    // leave it as an exercise; the same as a potential barrier, Landau & Lifshitz vol. 3, section 25, problem 2).
    const Wide n("1.5"), theta = radians(60);
    for (const char* gap_nm : {"1", "100", "1000", "1e6"}) {
        const Wide q = n * cos(theta), decay = sqrt(square(n * sin(theta)) - 1), x = decay / q;
        const Wide y = 2 * pi * Wide(gap_nm) * decay / 500;
        const Wide expected = 1 / (1 + square((1 + square(x)) / (2 * x) * sinh(y)));
        const ExactResponse gap = exact_response(multilayer({n, 0}, {{{1, 0}, Wide(gap_nm)}}, {n, 0}, 60));
        expect_near(gap.transmittance_s / expected, 1, "1e-40");
        expect_near(gap.reflectance_s, 1 - expected);
    }
}

TEST(ExactMultilayer, AWaveAlongItsLayerIsTheLimit) {
    // n = 2 at 30 degrees onto a layer of index 1: q = 0, where the layer's matrix is (1, -i g; 0, 1) with
    // g = 2 pi d / wavelength for s, and (1, 0; -i g, 1) of E and H for p.
    const Wide q = 2 * cos(radians(30)), g = 2 * pi * 70 / 500;
    const ExactResponse along = exact_response(multilayer({2, 0}, {{{1, 0}, 70}}, {2, 0}, 30));
    expect_near(along.transmittance_s, 1 / (1 + square(g * q / 2)));
    expect_near(along.transmittance_p, 1 / (1 + square(g * q / 8)));
    expect_near(along.reflectance_s + along.transmittance_s, 1);
}

TEST(ExactMultilayer, GrazingLightSeesAMirrorUnlessNothingIsThere) {
    const ExactResponse glass = exact_response(multilayer({1, 0}, {{{2, 0}, 70}}, {Wide("1.5"), 0}, 90));
    expect_near(glass.reflectance_s, 1, "1e-30");
    expect_near(glass.transmittance_p, 0, "1e-30");
    const ExactResponse air = exact_response(multilayer({1, 0}, {{{1, 0}, 70}}, {1, 0}, 90));
    expect_near(air.reflectance_p, 0);
    expect_near(air.transmittance_s, 1);
}

TEST(ExactMultilayer, AnIncoherentPlateAddsItsReflections) {
    // Two faces and what the glass leaves: R = R1 + T1^2 A^2 R1 / (1 - R1^2 A^2), the textbook's pile of plates.
    const Wide n("1.5"), k("1e-5"), d = 1000000;
    ExactMultilayer plate = multilayer({1, 0}, {{{n, k}, d}}, {1, 0});
    plate.nodes[0].is_incoherent = true;
    const WideComplex index(n, k), one(1);
    const Wide face = norm_of((one - index) / (one + index)), left = exp(-4 * pi * k * d / 500);
    const Wide there_and_back = norm_of(WideComplex(4) * index / ((one + index) * (one + index)));
    const ExactResponse exact = exact_response(plate);
    expect_near(exact.reflectance_s, face + there_and_back * square(left) * face / (1 - square(face * left)));
    expect_near(exact.transmittance_p, there_and_back * left / (1 - square(face * left)));
}

}  // namespace
}  // namespace nacre::reference

#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "nacre/optics/layer_system.h"
#include "nacre/optics/multilayer/multilayer.h"

namespace nacre::hard_cases {

/// A multilayer as it is typed in: for the solvers, and for the reference.
struct Stack {
    Stack(RefractiveIndex incident_index, RefractiveIndex substrate_index)
        : incident(incident_index), substrate(substrate_index) {}

    Stack& layer(RefractiveIndex index, double thickness_nm);
    Stack& incoherent_layer(RefractiveIndex index, double thickness_nm);
    Stack& begin_group(int repeat);
    Stack& end_group();

    /// The same, seen from behind.
    Stack reversed() const;

    enum class Kind { layer, incoherent_layer, begin_group, end_group };
    struct Item {
        Kind kind = Kind::layer;
        RefractiveIndex index;
        double thickness_nm = 0.0;
        int repeat = 0;
    };
    RefractiveIndex incident, substrate;
    std::vector<Item> items;
};

LayerSystem layer_system(const Stack& stack);

/// A multilayer under light.
struct HardCase {
    std::string name;
    Stack stack;
    double theta_deg = 0.0;
    double wavelength_nm = 500.0;
};

/// R_s, R_p, T_s, T_p.
using Four = std::array<double, 4>;
Four four(const Response& response);

Four scalar_response(const HardCase& hard_case);
/// From MultilayerSolver. The wavelength stands among others, so that the SIMD lanes differ, at more than one place;
/// the answers have to be the same bits wherever it stands (a failure of the test if not).
Four solver_response(const HardCase& hard_case);

/// From the reference, rounded.
Four exact_four(const HardCase& hard_case);

/// By how much R and T change if what is typed in changes by a relative 2^-52, up or down: n, k and thickness of
/// whatever layers share them, angle, wavelength; the larger of up and down, summed. No double arithmetic can be
/// expected to be better than this, for it cannot tell such inputs apart.
Four conditioning(const HardCase& hard_case);

/// What is always allowed: some thousand roundings.
inline constexpr double base_tolerance = 1e-12;
/// Of conditioning: a hundred half-ulps of every input.
inline constexpr double allowed_ulps = 100.0;
/// Of T, for each layer that light meets, repeats counted: a layer's rounded matrix has a determinant of 1 +- 2^-52 or
/// so, and T goes as the product of all determinants. No change of an input shows this, for every input has a
/// determinant of 1. R sees it only where a million layers stand at the edge of their band; it is held to the rest.
inline constexpr double allowed_per_layer = 0x1p-52;

enum class Measure {
    absolute,
    /// T, which may be 1e-200, relative to itself; with as many further roundings as its logarithm is larger than 1,
    /// for it is kept as a logarithm. Below 1e-250 it counts as 0.
    relative_in_transmittance,
};

/// Holds both solvers to the reference, case by case, and remembers how near the worst came to what is allowed.
class Family {
public:
    explicit Family(Measure measure = Measure::absolute) : measure_(measure) {}
    Family(const Family&) = delete;
    Family& operator=(const Family&) = delete;
    /// Leaves worst error over allowed, and its case, in the test's XML report.
    ~Family();

    /// Conditioning is asked for only where 1e-12 does not do: it costs a reference per input.
    void expect_exact(const HardCase& hard_case);
    /// For more layers than one can walk through.
    void expect_solver_exact(const HardCase& hard_case);

private:
    struct Truth;  // of a case: the reference, and its conditioning as soon as somebody asks
    void compare(const HardCase& hard_case, Truth& truth, const std::string& solver, const Four& got);

    Measure measure_;
    double worst_ratio_ = 0.0;
    std::string worst_;
};

/// Holds two answers that should be equal to each other, as far as the case can be known.
void expect_equal(const HardCase& hard_case, const Four& one, const Four& other, const std::string& what);

/// Angles from the normal to grazing, the ends and their neighbourhood included.
std::vector<double> angles_to_grazing();

}  // namespace nacre::hard_cases

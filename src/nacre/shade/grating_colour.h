#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/optics/grating.h"
#include "nacre/shade/grating_pieces.h"

namespace nacre {

/// The colour of a grating under a light, prepared for evaluation at many u = |sin theta_i + sin theta_o|.
///
/// XYZ(u) = integral over wavelength of the light's weights times grating_density(). Lines of many grooves are far
/// narrower than the weights' nanometre, so nothing is sampled: over a piece of wavelength what varies slowly is a
/// parabola in 1 / wavelength, and the line itself is integrated in closed form.
/// Accuracy: 2e-7 of every component, or 3e-8 where only the tails of lines are seen and their ripples fall in step
/// with whole nanometres; 2e-6 of profiles so deep that they are cut into pieces of less than a nanometre. Beside the
/// plane across the grooves, 1e-6, and 1e-4 of light that their length dims beyond exp(-5).
class GratingColour {
public:
    /// Keeps what it needs: neither has to outlive it.
    /// @param coarse  pieces of many nanometres, for callers that need thousands of gratings: lines stay as narrow as
    /// they are, but everything that varies slowly is a parabola over that many nanometres. 12 of them err by CIEDE2000
    /// 0.002 in the mean and 0.3 at most; null: the accuracy above
    GratingColour(const Grating& grating, const Light& light, std::shared_ptr<const GratingPieces> coarse = nullptr);

    /// Before adaptation. Per unit of u: a line's colour is that of its efficiencies times the wavelengths that a unit
    /// of u spans, and may exceed 1. With the light's own `wavelengths`, the sum over its nodes.
    /// @param u  in [0, 2]
    Xyz at(double u) const;
    /// Pieces (or nodes) times orders of both signs: how many integrals one colour takes.
    std::uint64_t samples() const;
    /// Of these, those of orders beyond the first that counts.
    std::uint64_t samples_of_higher_orders() const {
        return orders_.size() > 1 ? samples() / orders_.size() * (orders_.size() - 1) : 0;
    }

private:
    struct Sample {  // a point as one u has it
        double x;    // order that is seen exactly here
        Xyz weight;
        const double* efficiency;  // per order of orders_
    };
    struct Far {  // a sum over all orders that are not near, and for which piece's orders it was made
        double sum = 0.0;
        std::size_t first_near = 0;
        std::size_t end_near = 0;
        bool is_valid = false;
    };

    void keep_orders(const std::vector<int>& counted, const Light& light, int step_nm);
    void add_nodes(const Light& light);
    void fill_table();
    const double* efficiencies(std::size_t point, std::vector<double>& scratch) const;
    double far_sum(const Sample& sample, std::size_t first_near, std::size_t end_near) const;
    void add_piece(const std::array<Sample, 3>& samples, double per_nm, Far& shared, Xyz& sum) const;
    void add_split_piece(const std::array<Sample, 3>& samples, std::size_t piece, double azimuth, int parts,
                         Xyz& sum) const;
    Xyz at_nodes(double u) const;

    Grating grating_;
    bool has_nodes_ = false;
    std::shared_ptr<const GratingPieces> pieces_;  // null: the light's own nodes
    std::vector<int> orders_;                      // those that matter
    std::vector<double> order_;
    std::vector<double> shares_;
    std::vector<double> per_nm_;     // of the pieces' points, or the nodes'
    std::vector<Xyz> node_weights_;  // per point, if those are the light's own nodes: divided by wavelength
    std::vector<double> table_;  // a row of efficiencies per point, that of order 0 halved; empty: too large to keep
};

}  // namespace nacre

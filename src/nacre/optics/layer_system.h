#pragma once

#include <cstddef>
#include <vector>

#include "nacre/optics/refractive_index.h"

namespace nacre {

/// What is proportional to the share of a mixture of two materials: its index, as in a layer whose composition changes
/// gradually, or its permittivity n^2, as in structures much finer than the wavelength.
enum class Mixing { index, permittivity };

/// What a layer is made of: a material of the system, or a mixture of two.
struct Medium {
    int curve = 0;       ///< into LayerSystem::curves
    int other = 0;       ///< likewise
    double share = 0.0;  ///< index (or its square) = (1 - share) * curve + share * other, in [0, 1]
    Mixing mixing = Mixing::index;
    friend bool operator==(const Medium&, const Medium&) = default;
};

/// A layer, or the head of a group of layers that repeats.
struct LayerNode {
    int medium = 0;              ///< of a layer: into LayerSystem::media
    double thickness_nm = 0.0;   ///< of a layer, >= 0
    bool is_incoherent = false;  ///< of a layer: too thick, or too uneven, for its two faces to interfere
    int repeat = 0;              ///< 0: a layer. Else a group that is there so many times, >= 1
    int count = 0;               ///< of a group: so many nodes behind this one belong to it, groups within it included
    friend bool operator==(const LayerNode&, const LayerNode&) = default;
};

/// Plane-parallel layers between two half-spaces: everything that the solvers need to know.
struct LayerSystem {
    std::vector<Index> curves;     ///< the different materials
    std::vector<Medium> media;     ///< the different indices
    std::vector<LayerNode> nodes;  ///< in the order in which light meets them; a group before its members
    int incident = 0;              ///< medium of the half-space that light comes from; lossless
    int substrate = 0;             ///< medium behind the last layer

    RefractiveIndex index_at(int medium, double wavelength_nm) const;
    friend bool operator==(const LayerSystem&, const LayerSystem&) = default;
};

/// Layers after all repeats. Counts in double, so that no repeat overflows.
double expanded_layers(const LayerSystem& system);

/// Layer systems that are seen together: what they show is their mean. A perfect one is alone.
struct LayerEnsemble {
    std::vector<LayerSystem> systems;
    std::vector<double> shares;  ///< as many, each > 0; their sum is 1
    friend bool operator==(const LayerEnsemble&, const LayerEnsemble&) = default;
};

/// Writes a LayerSystem down layer by layer; equal materials and media share an entry.
class LayerSystemBuilder {
public:
    LayerSystemBuilder(const Index& incident, const Index& substrate);

    void layer(const Index& index, double thickness_nm, bool is_incoherent = false);
    /// A layer whose index, or permittivity, is between two.
    void graded_layer(const Index& from, const Index& to, double share, double thickness_nm,
                      Mixing mixing = Mixing::index);
    /// Groups may hold groups. @pre repeat >= 1; no incoherent layer between the two calls
    void begin_group(int repeat);
    void end_group();

    /// @pre every group has ended
    LayerSystem take();

private:
    int curve_of(const Index& index);
    int medium_of(const Medium& medium);

    LayerSystem system_;
    std::vector<std::size_t> open_groups_;
};

}  // namespace nacre

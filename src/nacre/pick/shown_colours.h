#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/shade/grating_pieces.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// The accuracy of colours during a search: a table of thousands must be fast, and a report must be exact.
enum class SearchDetail { table, refinement, report };

/// What computes the colours of a mechanism, and of those that differ little from it.
struct SearchSampling {
    SpectralSampling spectra;
    std::shared_ptr<const GratingPieces> pieces;  ///< of gratings; null: as for a bake
};

/// The colours that mechanisms show at a few given places.
class ShownColours {
public:
    /// @param light  has to outlive this
    ShownColours(const Light& light, std::vector<Geometry> places);

    std::size_t count() const { return places_.size(); }
    /// @param times  so many times as many nodes as usual
    SearchSampling sampling_for(const Mechanism& mechanism, SearchDetail detail, int times = 1);
    /// Relative to D65. @param shown  as many as places
    void at(const Mechanism& mechanism, const SearchSampling& sampling, std::span<Xyz> shown) const;

private:
    const Light& light_;
    std::vector<Geometry> places_;
    NodeMaker nodes_;
    std::shared_ptr<const SpectralNodes> grid_nodes_;             // where the scene gives its wavelengths
    std::map<int, std::shared_ptr<const GratingPieces>> pieces_;  // by their nanometres
};

}  // namespace nacre

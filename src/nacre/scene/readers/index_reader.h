#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "nacre/optics/refractive_index.h"
#include "nacre/scene/table.h"

namespace nacre {

/// How the core asks for a material that a scene names: one that nacre brings along, or a file beside the scene.
/// Throws Error for an unknown name, with the nearest known ones, and for anything wrong in a file.
using MaterialReader = std::function<std::shared_ptr<const IndexCurve>(const std::string& name, const Where& where)>;

/// What it takes to read an index.
struct IndexReader {
    const MaterialReader& find_material;
    double first_nm;  ///< the light's range: a material has to be known all over it
    double last_nm;

    /// A number; { n, k }; the name of a material; { material, outside }; { cauchy }, { sellmeier } or { formula,
    /// coefficients }, each with k and range_nm; { wavelength_nm, n, k }; of a substrate { f0, edge_tint }.
    /// Notes mistakes, and then gives air.
    /// @param key  what the value stands behind, for messages
    Index read(const Table& table, std::string_view key, const Value& value) const;
    /// The same for a key that may be missing.
    Index read_or(const Table& table, std::string_view key, const Index& otherwise) const;

private:
    Index read_table(const Table& table, std::string_view key) const;
    IndexCurve read_written_curve(const Table& table, std::string_view key, const Value* n) const;
    Index read_material(const Table& table, std::string_view key, const Value& name, bool holds_outside) const;
    void check_range(const Table& table, const Where& where, const IndexCurve& curve) const;
};

/// As a value in TOML; reads back as the same index. A material that nacre brings along is named, all others are
/// written out.
std::string index_toml(const Index& index);

/// n and k that a scene may give: 0 is no index, and gain is no reflector's.
inline constexpr Allowed allowed_n{1e-6, 1000.0};
inline constexpr Allowed allowed_k{0.0, 1000.0};

}  // namespace nacre

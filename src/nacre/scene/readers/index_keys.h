#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/scene/readers/index_reader.h"

namespace nacre {

// What the readers of mechanisms share: keys that have a refractive index, and the keys of layers.

inline constexpr Allowed allowed_thickness{0.0, 1e8, "nm"};
inline constexpr Allowed allowed_spread{0.0, 1e4, "nm"};

/// An index behind a key that is required. Notes mistakes, and then gives air.
Index read_required_index(const Table& table, std::string_view key, const IndexReader& reader);

/// A medium that light crosses before it meets anything; air if the key is missing. Notes one that absorbs.
/// @param consequence  "no light reaches the particles": for the message
Index read_clear_medium(const Table& table, std::string_view key, const IndexReader& reader,
                        std::string_view consequence);

/// `incident`, in which light and eye are far away.
Index read_incident(const Table& table, const IndexReader& reader);

/// A thickness of a layer, behind a key that is required. Warns of one that is less than 1 nm and not 0.
double read_thickness(const Table& table, std::string_view key);
void warn_of_thin_layer(const Table& table, std::string_view key, const Value& value, double thickness_nm);

/// thickness_spread_nm; 0 if it is missing.
double read_spread(const Table& table);

/// `prefix` + "n" and "k" of an index that is a number, or "f0" of one that is a metal's colour.
void add_index_parameters(const std::string& prefix, const std::string& of_what, const Index& index,
                          const std::function<Index&(Mechanism&)>& find, std::vector<Parameter>& parameters);

/// The largest absorption index over a range, by whole nanometres from its first and at its last.
double largest_k(const Index& index, double first_nm, double last_nm);

/// Up to this k a medium counts as clear. Chosen: tables of glass have 1e-8, which makes no visible difference in
/// anything thinner than a window; 1e-6 takes 2 % of green light in 1 mm.
inline constexpr double transparent_k = 1e-6;

}  // namespace nacre

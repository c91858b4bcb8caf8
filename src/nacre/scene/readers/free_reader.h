#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/readers/index_reader.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Where a number is looked for if the scene does not say.
struct FreeRange {
    double low = 0.0;
    double high = 1.0;
    FreeScale scale = FreeScale::even;
};

/// Indices of transparent things: from porous silica to titania, and to silicon below them.
inline constexpr FreeRange usual_index{1.2, 2.6};
inline constexpr FreeRange usual_substrate{1.0, 4.0};

/// A sub-table { from = ..., to = ... }; null if the value is anything else.
const Table* range_of(const Table& table, std::string_view key, const Value& value);

/// Notes such a sub-table where nothing is searched for.
/// @return whether the value is one
bool refuse_range(const Table& table, std::string_view key, const Value& value);

/// Reads the keys of a mechanism that picks are to lead to: a number, or whatever else the key may have, is fixed;
/// { from, to } bounds the search; a key that is missing is looked for in its usual range.
///
/// All note mistakes, and add to the search what is free.
class FreeReader {
public:
    /// All have to outlive this.
    FreeReader(const Table& table, const IndexReader& index, MechanismSearch& search)
        : table_(table), index_(index), search_(search) {}

    void number(std::string_view key, const Allowed& allowed, const FreeRange& usual,
                const std::function<void(Mechanism&, double)>& set);
    void whole_number(std::string_view key, const Allowed& allowed, const FreeRange& usual,
                      const std::function<void(Mechanism&, int)>& set);
    /// A free index is a number without absorption.
    void index(std::string_view key, const FreeRange& usual, const std::function<void(Mechanism&, const Index&)>& set);
    /// Pairs of keys, read before, that belong to two parts which may change places; those that are free do.
    void exchange(std::initializer_list<std::pair<std::string_view, std::string_view>> keys);

    /// What a sub-table { from, to } says.
    FreeRange bounds(std::string_view key, const Table& range, const Allowed& allowed, FreeScale scale) const;
    /// Leaves a number to the search. The start keeps the number that it has.
    FreeNumber& leave_free(std::string name, const FreeRange& range,
                           const std::function<void(Mechanism&, double)>& set);

private:
    void add(std::string_view key, const FreeRange& range, const std::function<void(Mechanism&, double)>& set);

    const Table& table_;
    const IndexReader& index_;
    MechanismSearch& search_;
};

}  // namespace nacre

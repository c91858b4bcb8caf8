#include "nacre/colour/observer.h"

#include <cassert>
#include <cstddef>

#include "nacre/colour/cie_tables.h"

namespace nacre {

const std::array<double, 3>& colour_matching(Observer observer, int nm) {
    assert(nm >= cie_table_first_nm && nm <= cie_table_last_nm);
    const auto row = static_cast<std::size_t>(nm - cie_table_first_nm);
    return observer == Observer::cie1931_2deg ? cie1931_2deg_table[row] : cie1964_10deg_table[row];
}

}  // namespace nacre

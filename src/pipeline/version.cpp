#include "pipeline/version.h"

#include "nacre_version.h"

namespace nacre {

std::string_view nacre_version() {
    return NACRE_VERSION;
}

}  // namespace nacre

#include "cli/plot_style.h"

#include <string_view>

namespace nacre {

// Compiled in from src/cli.
extern const std::string_view plot_style_gp;

std::string plot_style_script() {
    return std::string(plot_style_gp);
}

}  // namespace nacre

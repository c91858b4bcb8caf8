#include "nacre/pick/picked_colour.h"

#include "nacre/base/text.h"

namespace nacre {

bool PickedColour::is_met() const {
    return lobe ? lobe->miss == LobeMiss::none : de00 <= met_de00;
}

namespace {

constexpr double all_light = 1.0001;  // as Y, and rounding

// Why no structure shows a colour, where physics says so at once.
std::string reason(const PickedColour& picked) {
    constexpr double grazing_deg = 89.99;
    if (picked.mechanism == "grating") {
        if (picked.angle_deg == 0.0)
            return "nothing but the mirror's order 0 comes straight back, and that does not count";
    } else if (picked.angle_deg >= grazing_deg) {
        return "at 90 degrees every face reflects all light: it is white";
    } else if (picked.colour.y > all_light) {
        return "nothing reflects more than all light";
    }
    return "no " + picked.mechanism + " was found that comes nearer, all picks together";
}

}  // namespace

std::string match_text(const PickedColour& picked) {
    std::string away = "CIEDE2000 " + significant_text(picked.de00, 3) + " away";
    if (!picked.lobe) {
        if (picked.is_met()) return "met, CIEDE2000 " + significant_text(picked.de00, 2);
        if (!picked.is_searched) return away;
        return away + ", because " + reason(picked);
    }
    if (picked.lobe->miss != LobeMiss::none) {
        if (picked.colour.y < 0.0) return away + ", because it is darker than black";
        if (picked.colour.y > all_light) return away + ", because nothing reflects more than all light";
    }
    switch (picked.lobe->miss) {
        case LobeMiss::none:
            return "exact";
        case LobeMiss::bright:
            return away + ", because no band that reflects so much is so saturated";
        case LobeMiss::saturated:
            return away +
                   ", because no single band has that chromaticity (purples have none, nor has much that is pale)";
    }
    return {};
}

std::string miss_text(const PickedColour& picked) {
    return (picked.is_searched ? "the nearest " : "this ") + picked.mechanism + " is " + match_text(picked);
}

std::string picked_text(const std::vector<PickedColour>& picked) {
    std::string text;
    for (const PickedColour& one : picked) {
        const bool is_exact = one.lobe && one.is_met();
        text += (text.empty() ? "" : "; ") + one.text + " at " + number_text(one.angle_deg) +
                " deg: " + (is_exact ? "exact" : "dE00 " + significant_text(one.de00, 3));
    }
    return text;
}

}  // namespace nacre

#include "nacre/pick/picked_colour.h"

#include "nacre/base/text.h"

namespace nacre {

bool PickedColour::is_met() const {
    return lobe ? lobe->miss == LobeMiss::none : de00 <= met_de00;
}

namespace {

constexpr double all_light = 1.0001;  // as Y, and rounding

// Why no structure shows a colour, where physics says so at once; else what may come closer.
std::string advice(const PickedColour& picked) {
    constexpr double grazing_deg = 89.99;
    if (picked.mechanism == "grating") {
        if (picked.angle_deg == 0.0)
            return ", because only order 0, the mirror reflection, goes straight back, and it does not count";
    } else if (picked.angle_deg >= grazing_deg) {
        return ", because at 90 degrees every surface reflects all light and is white";
    } else if (picked.colour.y > all_light) {
        return ", because no surface reflects more light than it receives";
    }
    return picked.mechanism == "film" ? "; a stack may come closer (mechanism = \"stack\")" : "";
}

}  // namespace

std::string match_text(const PickedColour& picked) {
    const std::string error = "misses by CIEDE2000 " + significant_text(picked.de00, 3);
    if (!picked.lobe) {
        if (picked.is_met()) return "met, CIEDE2000 " + significant_text(picked.de00, 2);
        return picked.is_searched ? error + advice(picked) : error;
    }
    if (picked.lobe->miss != LobeMiss::none) {
        if (picked.colour.y < 0.0) return error + ", because the colour is darker than black";
        if (picked.colour.y > all_light) return error + ", because no surface reflects more light than it receives";
    }
    switch (picked.lobe->miss) {
        case LobeMiss::none:
            return "exact";
        case LobeMiss::bright:
            return error + ", because no band that is so bright is so saturated";
        case LobeMiss::saturated:
            return error + ", because no single band has this chromaticity (as with purples and many pale colours)";
    }
    return {};
}

std::string miss_text(const PickedColour& picked) {
    if (!picked.is_searched) return "this " + picked.mechanism + " " + match_text(picked);
    return (picked.lobe ? "the nearest band " : "the best " + picked.mechanism + " found ") + match_text(picked);
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

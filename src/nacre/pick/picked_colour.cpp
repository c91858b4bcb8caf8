#include "nacre/pick/picked_colour.h"

#include "nacre/base/text.h"

namespace nacre {

bool PickedColour::is_met() const {
    return lobe ? shown.is_as_picked() : de00 <= met_de00;
}

namespace {

constexpr double all_light = 1.0001;  // as Y, and rounding

constexpr const char* bytes_hint = "; components go from 0 to 1, and these look like 0 to 255";

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

std::string percent_text(double share) {
    constexpr double hardly = 0.001;
    if (share < hardly) return "less than 0.1 %";
    return significant_text(100.0 * share, share < 0.1 ? 1 : share > 0.99 ? 3 : 2) + " %";
}

// What a palette shows instead, and why.
std::string dimmed_text(const PickedColour& picked) {
    const ShownColour& shown = picked.shown;
    const std::string error = "CIEDE2000 is " + significant_text(picked.de00, 3);
    if (shown.luminance == 0.0) return "is shown as black, because the colour is darker than black; " + error;
    std::string text = "is dimmed to " + percent_text(shown.luminance) + " of its luminance";
    if (shown.chroma < 1.0) {
        text += " and made paler, to " + percent_text(shown.chroma) +
                " of its chroma, because it is more saturated than the light of a single wavelength";
    } else if (picked.colour.y > all_light) {
        text += ", because no surface reflects more light than it receives";
    } else {
        text += ", because no reflectance is both so bright and so saturated";
    }
    text += "; the hue stays, and " + error;
    if (picked.looks_like_bytes) text += bytes_hint;
    return text;
}

}  // namespace

std::string match_text(const PickedColour& picked) {
    if (picked.lobe) return picked.is_met() ? "exact" : dimmed_text(picked);
    if (picked.is_met()) return "met, CIEDE2000 " + significant_text(picked.de00, 2);
    const std::string error = "misses by CIEDE2000 " + significant_text(picked.de00, 3);
    if (picked.looks_like_bytes) return error + bytes_hint;
    return picked.is_searched ? error + advice(picked) : error;
}

std::string unmatched_text(const PickedColour& picked) {
    if (picked.lobe) return match_text(picked);
    return (picked.is_searched ? "the best " + picked.mechanism + " found " : "this " + picked.mechanism + " ") +
           match_text(picked);
}

std::string picked_text(const std::vector<PickedColour>& picked) {
    std::string text;
    for (const PickedColour& one : picked) {
        text += (text.empty() ? "" : "; ") + one.text + " at " + number_text(one.angle_deg) + " deg: ";
        if (!one.lobe)
            text += "dE00 " + significant_text(one.de00, 3);
        else if (one.is_met())
            text += "exact";
        else
            text += "dimmed to " + percent_text(one.shown.luminance) + ", dE00 " + significant_text(one.de00, 3);
    }
    return text;
}

}  // namespace nacre

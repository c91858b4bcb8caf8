#include "io/ocio/known_spaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {
namespace {

// ASWF Color Interop Forum, "Color Space Encodings for Texture Assets and CG Rendering" 1.1 and its display ids: those
// of our spaces that it lists.
constexpr std::array<std::string_view, 11> interop_ids{
    "lin_ciexyzd65_scene", "lin_rec709_scene",   "lin_p3d65_scene",   "lin_rec2020_scene",
    "lin_adobergb_scene",  "lin_ap0_scene",      "lin_ap1_scene",     "srgb_rec709_scene",
    "srgb_rec709_display", "srgb_p3d65_display", "g24_rec709_display"};

// What the ACES configs for OpenColorIO 1 (up to ACES 1.2) call our spaces, by the ids above; they have no roles for
// the interchange. Our own config does not list them, because its text decides its hash.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> older_names{
    {{"lin_rec709_scene", "Utility - Linear - Rec.709"},
     {"lin_rec709_scene", "Utility - Linear - sRGB"},
     {"lin_p3d65_scene", "Utility - Linear - P3-D65"},
     {"lin_rec2020_scene", "Utility - Linear - Rec.2020"},
     {"lin_adobergb_scene", "Utility - Linear - Adobe RGB"},
     {"lin_ap0_scene", "ACES - ACES2065-1"},
     {"lin_ap1_scene", "ACES - ACEScg"}}};

constexpr double same_space_tolerance = 1e-4;

KnownSpace known_space(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstColorSpaceRcPtr& space) {
    KnownSpace known;
    known.names.emplace_back(space->getName());
    for (std::size_t i = 0; i < space->getNumAliases(); ++i) known.names.emplace_back(space->getAlias(i));
    for (const std::string& name : known.names) {
        if (std::find(interop_ids.begin(), interop_ids.end(), name) != interop_ids.end()) known.interop_id = name;
    }
    for (const auto& [id, name] : older_names) {
        if (id == known.interop_id) known.names.emplace_back(name);
    }
    known.side = space->getReferenceSpaceType();
    const bool scene = known.side == OCIO::REFERENCE_SPACE_SCENE;
    auto path = OCIO::ColorSpaceTransform::Create();
    path->setSrc(scene ? "lin_ciexyzd65_scene" : "lin_ciexyzd65_display");
    path->setDst(space->getName());
    const Conversion conversion = make_conversion(config, path);
    known.linear = conversion.matrix.has_value();
    known.probes = convert(conversion, probe_colours(), known.names.front());
    return known;
}

}  // namespace

const OCIO::ConstConfigRcPtr& builtin_config() {
    static const OCIO::ConstConfigRcPtr config = [] {
        silence_ocio();
        std::istringstream text{std::string(builtin_ocio_config)};
        return OCIO::Config::CreateFromStream(text);
    }();
    return config;
}

const Image<Xyz>& probe_colours() {
    static const Image<Xyz> probes = [] {
        // XYZ of the primaries: columns of the matrix of Rec.709, IEC 61966-2-1. Only colours, so that digits don't
        // matter.
        const Xyz red{0.4123907992659595, 0.21263900587151036, 0.01933081871559185};
        const Xyz green{0.35758433938387796, 0.7151686787677559, 0.11919477979462599};
        const Xyz blue{0.1804807884018343, 0.07219231536073371, 0.9505321522496606};
        const Xyz mix{0.6 * red.x + 0.3 * green.x, 0.6 * red.y + 0.3 * green.y, 0.6 * red.z + 0.3 * green.z};
        const std::array<Xyz, probe_count> colours{
            red, green, blue, mix, d65_white, {0.18 * d65_white.x, 0.18 * d65_white.y, 0.18 * d65_white.z}};
        Image<Xyz> image(static_cast<int>(probe_count), 1);
        std::copy(colours.begin(), colours.end(), image.begin());
        return image;
    }();
    return probes;
}

double largest_difference(const Image<Rgb>& a, const Image<Rgb>& b) {
    double largest = 0.0;
    for (int x = 0; x < a.width(); ++x) {
        const Rgb& p = a.at(x, 0);
        const Rgb& q = b.at(x, 0);
        largest = std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
    return largest;
}

const std::vector<KnownSpace>& known_spaces() {
    static const std::vector<KnownSpace> spaces = [] {
        const OCIO::ConstConfigRcPtr& config = builtin_config();
        std::vector<KnownSpace> result;
        const int count = config->getNumColorSpaces(OCIO::SEARCH_REFERENCE_SPACE_ALL, OCIO::COLORSPACE_ALL);
        for (int i = 0; i < count; ++i) {
            const auto space = config->getColorSpace(
                config->getColorSpaceNameByIndex(OCIO::SEARCH_REFERENCE_SPACE_ALL, OCIO::COLORSPACE_ALL, i));
            if (!space->isData()) result.push_back(known_space(config, space));
        }
        return result;
    }();
    return spaces;
}

bool changes_nothing(const Conversion& conversion) {
    Image<Rgb> same(static_cast<int>(probe_count), 1);
    std::transform(probe_colours().begin(), probe_colours().end(), same.begin(), [](const Xyz& c) {
        return Rgb{c.x, c.y, c.z};
    });
    return largest_difference(same, convert(conversion, probe_colours(), "probes")) < same_space_tolerance;
}

std::string interop_id_of(const Conversion& conversion, OCIO::ReferenceSpaceType side) {
    const Image<Rgb> probes = convert(conversion, probe_colours(), "probes");
    for (const KnownSpace& known : known_spaces()) {
        if (known.side != side || known.interop_id.empty()) continue;
        if (largest_difference(known.probes, probes) < same_space_tolerance) return known.interop_id;
    }
    return {};
}

}  // namespace nacre

#include "io/ocio/colour_interchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "io/ocio/known_spaces.h"
#include "nacre/base/error.h"
#include "nacre/base/image.h"
#include "nacre/base/names.h"
#include "nacre/colour/colour_types.h"

namespace nacre {
namespace {

constexpr const char* role_xyz = "cie_xyz_d65_interchange";
constexpr const char* role_ap0 = "aces_interchange";

// Between a correct config and a wrong one. Correct ones differ from ours by about 1e-14 if they adapt ACES white by
// Bradford, and by 0.0036 if by CAT02; AP1 taken for AP0 differs by 0.31 (all measured over the probes).
constexpr double interchange_tolerance = 0.01;
constexpr double neutral_tolerance = 1e-3;

std::string advice() {
    return "; correct the config, or name its scene-referred CIE XYZ D65 space as `interchange` or its ACES2065-1 "
           "space as `aces_interchange`";
}

std::string numbers(const Rgb& colour) {
    std::array<char, 96> text{};
    const auto no_minus_zero = [](double value) { return std::abs(value) < 0.0005 ? 0.0 : value; };
    std::snprintf(text.data(), text.size(), "(%.3f, %.3f, %.3f)", no_minus_zero(colour.r), no_minus_zero(colour.g),
                  no_minus_zero(colour.b));
    return text.data();
}

std::optional<Interchange> by_role(const OpenedConfig& opened, const char* role, const std::string& where) {
    if (!opened.config->hasRole(role)) return std::nullopt;
    const auto space = opened.config->getColorSpace(role);
    if (!space || space->isData()) {
        throw Error(where + ": role " + in_quotes(role) + " of config " + in_quotes(opened.description) +
                    " names no colour space" + advice());
    }
    Interchange interchange;
    interchange.space = space->getName();
    interchange.how = "role " + in_quotes(role) + " (" + in_quotes(space->getName()) + ")";
    interchange.takes_ap0 = std::string_view(role) == role_ap0;
    return interchange;
}

// The space that the user names by one of two keys.
Interchange by_name(const OpenedConfig& opened, const std::string& where) {
    const bool takes_ap0 = opened.interchange.empty();
    const std::string key = takes_ap0 ? "aces_interchange" : "interchange";
    const std::string& name = takes_ap0 ? opened.aces_interchange : opened.interchange;
    const auto space = opened.config->getColorSpace(name.c_str());
    if (!space) throw_unknown_space(opened, name, where);
    if (space->isData()) {
        throw Error(where + ": " + key + " " + in_quotes(name) + " is a data space of config " +
                    in_quotes(opened.description) + "; it must be " + (takes_ap0 ? "ACES2065-1" : "CIE XYZ D65"));
    }
    Interchange interchange;
    interchange.space = space->getName();
    interchange.how = key + " " + in_quotes(space->getName());
    interchange.takes_ap0 = takes_ap0;
    return interchange;
}

bool is_named_by_user(const OpenedConfig& opened) {
    return !opened.interchange.empty() || !opened.aces_interchange.empty();
}

// What the config calls the space that our own config has under one of that id's names; empty if it has none.
std::string space_like(const OpenedConfig& opened, const std::string& interop_id) {
    for (const KnownSpace& known : known_spaces()) {
        if (known.interop_id != interop_id) continue;
        for (const std::string& name : known.names) {
            const auto space = opened.config->getColorSpace(name.c_str());
            if (space && !space->isData() && space->getReferenceSpaceType() == known.side) return space->getName();
        }
    }
    return {};
}

// A config that has the space and says nothing of it is common: then the key can be given at once.
[[noreturn]] void throw_no_role(const OpenedConfig& opened, const std::string& where) {
    const std::string xyz = space_like(opened, "lin_ciexyzd65_scene");
    const std::string ap0 = space_like(opened, "lin_ap0_scene");
    throw Error(where + ": config " + in_quotes(opened.description) + " has neither role " + in_quotes(role_ap0) +
                " nor role " + in_quotes(role_xyz) + "; add one, or " +
                (!xyz.empty()   ? "give [colour] interchange = " + in_quotes(xyz)
                 : !ap0.empty() ? "give [colour] aces_interchange = " + in_quotes(ap0)
                                : "name its scene-referred CIE XYZ D65 space as `interchange` or its ACES2065-1 space "
                                  "as `aces_interchange`"));
}

OCIO::ReferenceSpaceType side_of(const OpenedConfig& opened, const std::string& space) {
    return opened.config->getColorSpace(space.c_str())->getReferenceSpaceType();
}

// The order of preference. Of the two roles the one on the target's own side, if there is one.
Interchange choose_interchange(const OpenedConfig& opened, OCIO::ReferenceSpaceType side, const std::string& where) {
    if (is_named_by_user(opened)) return by_name(opened, where);
    const auto xyz = by_role(opened, role_xyz, where);
    if (xyz && side_of(opened, xyz->space) == side) return *xyz;
    const auto ap0 = by_role(opened, role_ap0, where);
    if (ap0 && (side == OCIO::REFERENCE_SPACE_SCENE || !xyz)) return *ap0;
    if (xyz) return *xyz;
    throw_no_role(opened, where);
}

// Between the two sides OpenColorIO runs the default view transform, forwards or backwards.
bool default_view_is_matrix(const OCIO::ConstConfigRcPtr& config) {
    try {
        const auto view = config->getDefaultSceneToDisplayViewTransform();
        if (!view) return false;
        for (const auto direction : {OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE, OCIO::VIEWTRANSFORM_DIR_TO_REFERENCE}) {
            const auto transform = view->getTransform(direction);
            if (transform && !make_conversion(config, transform).matrix) return false;
        }
        return true;
    } catch (const OCIO::Exception&) {
        return false;
    }
}

void check_crossing(const OpenedConfig& opened, const Interchange& interchange, OCIO::ReferenceSpaceType side,
                    const std::string& where) {
    if (side_of(opened, interchange.space) == side || default_view_is_matrix(opened.config)) return;
    const bool to_scene = side == OCIO::REFERENCE_SPACE_SCENE;
    throw Error(where + ": " + interchange.how + " of config " + in_quotes(opened.description) + " is " +
                (to_scene ? "display" : "scene") +
                "-referred, the target is not, and the default view transform between is " + "more than a matrix" +
                (to_scene
                     ? "; give the config role \"aces_interchange\", or name its scene-referred CIE XYZ D65 space as "
                       "`interchange`"
                     : "; choose a scene-referred space, or a display and view"));
}

// A space of the user's config, if it is comparable with one of ours.
OCIO::ConstColorSpaceRcPtr comparable_space(const OpenedConfig& opened, const std::string& name,
                                            OCIO::ReferenceSpaceType side) {
    const auto space = opened.config->getColorSpace(name.c_str());
    return space && !space->isData() && space->getReferenceSpaceType() == side ? space : nullptr;
}

std::optional<Image<Rgb>> probes_in(const OpenedConfig& opened, const Interchange& interchange,
                                    const std::string& space) {
    try {
        return convert(make_conversion(opened.config, path_to_space(interchange, space)), probe_colours(), space);
    } catch (const OCIO::Exception&) {
        return std::nullopt;  // broken (for example a missing table), and not requested by the user
    }
}

// How many of the spaces that both configs name alike were compared.
int compare_known_spaces(const OpenedConfig& opened, const Interchange& interchange, const std::string& where) {
    int compared = 0;
    for (const KnownSpace& known : known_spaces()) {
        // Encoded scene spaces are left out: a config may define "sRGB - Texture" differently.
        const bool display = interchange.leads_to == OCIO::REFERENCE_SPACE_DISPLAY;
        if (known.side != interchange.leads_to || !(known.linear || display)) continue;
        for (const std::string& name : known.names) {
            const auto theirs = comparable_space(opened, name, known.side);
            if (!theirs) continue;
            const std::optional<Image<Rgb>> probes = probes_in(opened, interchange, theirs->getName());
            if (!probes) continue;
            ++compared;
            if (largest_difference(*probes, known.probes) <= interchange_tolerance) continue;
            throw Error(where + ": " + interchange.how + " of config " + in_quotes(opened.description) +
                        " is wrong: it turns Rec.709 red into " + numbers(probes->at(0, 0)) + " in " +
                        in_quotes(theirs->getName()) + ", which should be " + numbers(known.probes.at(0, 0)) +
                        advice());
        }
    }
    return compared;
}

// XYZ in by one role and out by the other is XYZ again, whatever the scale of the view transform between.
void compare_roles(const OpenedConfig& opened, const std::string& where) {
    const auto ap0 = by_role(opened, role_ap0, where);
    const auto xyz = by_role(opened, role_xyz, where);
    if (!ap0 || !xyz) return;
    const Conversion around = make_conversion(opened.config, path_to_space(*ap0, xyz->space));
    if (!around.matrix) return;  // a tone map between them: nothing to compare
    const Image<Rgb> result = convert(around, probe_colours(), xyz->space);
    const double scale = result.at(static_cast<int>(first_neutral_probe), 0).g;
    Image<Rgb> expected(result.width(), 1);
    std::transform(probe_colours().begin(), probe_colours().end(), expected.begin(), [&](const Xyz& c) {
        return Rgb{scale * c.x, scale * c.y, scale * c.z};
    });
    if (largest_difference(result, expected) <= interchange_tolerance * std::abs(scale)) return;
    throw Error(where + ": " + ap0->how + " and " + xyz->how + " of config " + in_quotes(opened.description) +
                " contradict each other" + advice());
}

}  // namespace

Interchange find_interchange(const OpenedConfig& opened, OCIO::ReferenceSpaceType side, const std::string& where) {
    Interchange interchange = choose_interchange(opened, side, where);
    interchange.leads_to = side;
    check_crossing(opened, interchange, side, where);
    interchange.confirmed = compare_known_spaces(opened, interchange, where) > 0;
    if (!interchange.confirmed && !is_named_by_user(opened)) compare_roles(opened, where);
    return interchange;
}

OCIO::GroupTransformRcPtr path_through(const Interchange& interchange, const OCIO::TransformRcPtr& last) {
    auto path = OCIO::GroupTransform::Create();
    if (interchange.takes_ap0) {
        static const glm::dmat3 xyz_to_ap0 = [] {
            auto ours = OCIO::ColorSpaceTransform::Create();
            ours->setSrc("lin_ciexyzd65_scene");
            ours->setDst("lin_ap0");
            return make_conversion(builtin_config(), ours).matrix.value();
        }();
        path->appendTransform(matrix_transform(xyz_to_ap0));
    }
    path->appendTransform(last);
    return path;
}

OCIO::GroupTransformRcPtr path_to_space(const Interchange& interchange, const std::string& space) {
    auto last = OCIO::ColorSpaceTransform::Create();
    last->setSrc(interchange.space.c_str());
    last->setDst(space.c_str());
    return path_through(interchange, last);
}

void check_neutral(const OpenedConfig& opened, const Interchange& interchange, const Conversion& conversion,
                   const std::string& space, const std::string& where) {
    const Image<Rgb> probes = convert(conversion, probe_colours(), space);
    for (int i = static_cast<int>(first_neutral_probe); i < probes.width(); ++i) {
        const Rgb& grey = probes.at(i, 0);
        const auto [low, high] = std::minmax({grey.r, grey.g, grey.b});
        // Relative for spaces in which white is not 1: OpenColorIO computes in float.
        if (high - low <= neutral_tolerance * std::max(1.0, std::abs(high))) continue;
        const std::string what = "D65 white becomes " + numbers(probes.at(static_cast<int>(first_neutral_probe), 0)) +
                                 " in " + in_quotes(space);
        // The interchange is beyond doubt once a well-known space behind it is right: then it is the target.
        if (interchange.confirmed) {
            throw Error(where + ": " + what + " of config " + in_quotes(opened.description) +
                        "; the space must keep white neutral");
        }
        throw Error(where + ": " + interchange.how + " of config " + in_quotes(opened.description) +
                    " is wrong: with it, " + what + advice());
    }
}

}  // namespace nacre

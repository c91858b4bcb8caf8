#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/ocio/colour_transform.h"
#include "nacre/lut/colour_spaces.h"

namespace nacre {

/// An OpenColorIO config, and its interchange space for CIE XYZ under D65. Immutable, cheap to copy.
///
/// The interchange space on the scene side (for scene-referred spaces, displays and views):
///   1. the space named by `interchange`, or by `aces_interchange` after our own XYZ D65 -> ACES2065-1 (Bradford),
///   2. role cie_xyz_d65_interchange, if it is scene-referred,
///   3. role aces_interchange, after the same matrix,
///   4. role cie_xyz_d65_interchange, display-referred, if the config's default view transform is only a matrix.
/// OpenColorIO expects cie_xyz_d65_interchange to be display-referred; from there to the scene it would invert the
/// default view transform, which may be a tone map. Hence the order of 3 and 4, and the condition. For display-referred
/// spaces 2 and 4 change places: neither path contains a view transform, which belongs to to_display() only.
///
/// Published configs exist whose roles are wrong. So before the first conversion (a) the well-known linear spaces that
/// the config names as we do must agree with ours on saturated colours, (b) where there is none but both roles are,
/// they must agree with each other, and (c) white and 18 % grey must come out neutral, within 1e-3, in the target
/// and in role scene_linear.
class ColourConfig {
public:
    /// Opens choice.path; an empty path means $OCIO, and where that is unset or empty too, the
    /// built-in config. Silences OpenColorIO's own logging for the whole process, once.
    /// @throws Error if the file cannot be read or is not a config that this OpenColorIO understands
    static ColourConfig open(const ColourConfigChoice& choice);

    /// "nacre (built in)", or "FILE (NAME)" without the folder.
    const std::string& description() const;
    /// What the config calls itself, else the name of its file; "nacre" for the built-in one.
    const std::string& name() const;
    /// XXH3, 128 bits as 32 hex digits, of the config's text; files that the config refers to do not count.
    const std::string& content_hash() const;
    /// Whether $OCIO named it, and nobody else did.
    bool is_from_environment() const;

    /// The active ones, scene-referred first, otherwise in the config's order; data left out.
    std::vector<std::string> colour_spaces() const;
    /// The name of the colour space that has this name, alias or role; empty if there is none.
    std::string space_called(const std::string& name) const;
    /// The first sentence of what the config says of a colour space; empty if it says nothing, or has no such space.
    std::string about(const std::string& name) const;
    std::vector<std::string> displays() const;
    /// @throws Error for an unknown display
    std::vector<std::string> views(const std::string& display) const;

    /// @param name   a colour space, active or not, one of its aliases, or a role
    /// @param where  for messages
    /// @throws Error for an unknown name (the nearest are offered), a data space, a missing or wrong interchange space
    ColourTransform to_colour_space(const std::string& name, const std::string& where) const;

    /// @param display,view  empty for the config's default
    /// @throws Error for unknown names (the known are listed), a view of data, a missing or wrong interchange space
    ColourTransform to_display(const std::string& display, const std::string& view, const std::string& where) const;

    struct Impl;
    explicit ColourConfig(std::shared_ptr<const Impl> impl);

private:
    std::shared_ptr<const Impl> impl_;
};

}  // namespace nacre

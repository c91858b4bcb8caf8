#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nacre/lut/colour_space.h"

namespace nacre {

/// Which colour configuration to open, and how XYZ gets into it.
struct ColourConfigChoice {
    std::string path;         ///< a config file; empty means the provider's default ($OCIO, else the built-in config)
    std::string interchange;  ///< name of a space of the config that is CIE XYZ D65; wins over the roles. May be empty
    std::string where;        ///< who asked, for messages: "scene.toml:3", "--ocio"
    std::string aces_interchange{};  ///< the same of a space that is ACES2065-1. Only one of the two may be given
};

/// A set of colour spaces and displays that can be named: an OpenColorIO config, or the core's own RGB spaces.
class ColourSpaces {
public:
    virtual ~ColourSpaces() = default;

    /// For headers and messages, without a folder: "nacre (built in)".
    virtual const std::string& description() const = 0;
    /// The same in a word, for lines about a LUT: "nacre".
    virtual const std::string& short_name() const = 0;
    /// Whether the user's environment chose them, and nobody else. Their role scene_linear is then the default space.
    virtual bool is_from_environment() const = 0;
    /// A hash of what the spaces are defined by, 32 hexadecimal digits; empty if they are compiled in.
    virtual const std::string& content_hash() const = 0;

    /// Names of the colour spaces that a scene can be baked in.
    virtual std::vector<std::string> names() const = 0;
    /// The name of the space that has this name, alias or role; empty if there is none.
    virtual std::string space_called(const std::string& name) const = 0;
    /// Half a line about one of them; empty where nothing is known.
    virtual std::string about(const std::string& name) const = 0;
    /// Names of the displays, and of the views of each.
    virtual std::vector<std::string> displays() const = 0;
    /// @throws Error for an unknown display
    virtual std::vector<std::string> views(const std::string& display) const = 0;

    /// @param name   a colour space, one of its aliases, or a role
    /// @param where  for messages
    /// @throws Error for an unknown name, or a space that XYZ cannot be converted to
    virtual std::shared_ptr<const ColourSpace> space(const std::string& name, const std::string& where) const = 0;

    /// @param display,view  empty for the default
    /// @throws Error for unknown names
    virtual std::shared_ptr<const ColourSpace> display_view(const std::string& display, const std::string& view,
                                                            const std::string& where) const = 0;

protected:
    ColourSpaces() = default;
    ColourSpaces(const ColourSpaces&) = default;
    ColourSpaces& operator=(const ColourSpaces&) = default;
};

/// How a front end opens a set of colour spaces.
/// @throws Error if the config cannot be read
using OpenColourSpaces = std::function<std::shared_ptr<const ColourSpaces>(const ColourConfigChoice&)>;

}  // namespace nacre

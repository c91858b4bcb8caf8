#include "io/ocio/opened_config.h"

#include <algorithm>
#include <cstddef>

#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {
namespace {

// Whether its numbers are proportional to light. The config's own word counts; where it has none, what the space is
// made of.
bool is_linear(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstColorSpaceRcPtr& space) {
    if (!space || space->isData()) return false;
    const std::string encoding = space->getEncoding();
    if (!encoding.empty()) return encoding == "scene-linear" || encoding == "display-linear";
    try {
        for (const auto direction : {OCIO::COLORSPACE_DIR_TO_REFERENCE, OCIO::COLORSPACE_DIR_FROM_REFERENCE}) {
            const auto transform = space->getTransform(direction);
            if (transform && !make_conversion(config, transform).matrix) return false;
        }
        return true;
    } catch (const OCIO::Exception&) {
        return false;  // a missing table, for example
    }
}

// Letters of either case are equal, as they are to OpenColorIO.
bool asks_for_linear(const std::string& name) {
    std::string begin = name.substr(0, 3);
    for (char& c : begin) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return begin == "lin";
}

// Every name by which a colour space of the config can be asked for.
std::vector<std::string> all_names(const OCIO::ConstConfigRcPtr& config) {
    std::vector<std::string> all = space_names(config, OCIO::COLORSPACE_ALL);
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto space = config->getColorSpace(all[i].c_str());
        for (std::size_t k = 0; k < space->getNumAliases(); ++k) all.emplace_back(space->getAlias(k));
    }
    for (int i = 0; i < config->getNumRoles(); ++i) all.emplace_back(config->getRoleName(i));
    return all;
}

// Who asks for a linear space would not notice a gamma in the LUT: only linear ones are near.
std::vector<std::string> near_spaces(const OCIO::ConstConfigRcPtr& config, const std::string& name) {
    const std::vector<std::string> all = all_names(config);
    if (!asks_for_linear(name)) return nearest_names(name, all);
    constexpr std::size_t most_offered = 3;
    std::vector<std::string> near = nearest_names(name, all, all.size());
    std::erase_if(near, [&](const std::string& one) { return !is_linear(config, config->getColorSpace(one.c_str())); });
    near.resize(std::min(near.size(), most_offered));
    return near;
}

}  // namespace

std::vector<std::string> space_names(const OCIO::ConstConfigRcPtr& config, OCIO::ColorSpaceVisibility visibility) {
    std::vector<std::string> names;
    for (const auto side : {OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::SEARCH_REFERENCE_SPACE_DISPLAY}) {
        const int count = config->getNumColorSpaces(side, visibility);
        for (int i = 0; i < count; ++i) {
            const char* const name = config->getColorSpaceNameByIndex(side, visibility, i);
            const auto space = config->getColorSpace(name);
            if (space && !space->isData()) names.emplace_back(name);
        }
    }
    return names;
}

void throw_unknown_space(const OpenedConfig& opened, const std::string& name, const std::string& where) {
    const OCIO::ConstConfigRcPtr& config = opened.config;
    const std::vector<std::string> near = near_spaces(config, name);
    const auto linear = config->getColorSpace(OCIO::ROLE_SCENE_LINEAR);
    std::string offer = "; known: " + comma_separated(space_names(config, OCIO::COLORSPACE_ACTIVE));
    if (linear && asks_for_linear(name)) offer = "; its role scene_linear is " + in_quotes(linear->getName());
    if (!near.empty()) offer = "; nearest: " + comma_separated(near);
    throw Error(where + ": unknown colour space " + in_quotes(name) + " in config " + in_quotes(opened.description) +
                offer);
}

}  // namespace nacre

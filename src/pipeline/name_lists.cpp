#include "pipeline/name_lists.h"

#include <algorithm>
#include <memory>

#include "io/scene/shipped_materials.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "pipeline/metal_table.h"

namespace nacre {
namespace {

std::vector<ListedName> spaces_of(const ColourSpaces& colours) {
    std::vector<ListedName> names;
    for (const std::string& name : colours.names()) names.push_back({name, colours.about(name)});
    return names;
}

std::vector<ListedName> displays_of(const ColourSpaces& colours) {
    std::vector<ListedName> names;
    for (const std::string& name : colours.displays())
        names.push_back({name, "views: " + comma_separated(colours.views(name))});
    return names;
}

std::vector<ListedName> metals() {
    std::vector<ListedName> names = shipped_material_list();
    const std::vector<std::string> known = metal_names();
    std::erase_if(
        names, [&](const ListedName& one) { return std::find(known.begin(), known.end(), one.name) == known.end(); });
    return names;
}

}  // namespace

std::vector<ListTitle> list_titles() {
    std::vector<ListTitle> titles;
    for (const NameList& list : name_lists())
        titles.push_back({std::string(list.name), std::string(list.description), std::string(list.where)});
    titles.push_back({"materials", "refractive indices that nacre contains", "an index, in [material.NAME]"});
    titles.push_back({"metals", "metals among the materials, with F0 and F82", "substrate in [material.NAME]"});
    titles.push_back({"spaces", "colour spaces of the OpenColorIO config", "space in [colour]"});
    titles.push_back({"displays", "displays of the OpenColorIO config", "display in [swatch.NAME]"});
    return titles;
}

std::vector<ListedName> listed_names(std::string_view list, const OpenColourSpaces& open_colours,
                                     const ColourConfigChoice& config) {
    for (const NameList& known : name_lists()) {
        if (known.name == list) return known.names();
    }
    if (list == "materials") return shipped_material_list();
    if (list == "metals") return metals();
    if (list == "spaces") return spaces_of(*open_colours(config));
    if (list == "displays") return displays_of(*open_colours(config));
    std::vector<std::string> known;
    for (const ListTitle& title : list_titles()) known.push_back(title.name);
    throw Error("unknown list " + in_quotes(list) + "; known: " + comma_separated(known));
}

}  // namespace nacre
